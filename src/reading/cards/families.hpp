// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reading/builder/builder.hpp"

// Each family of keywords is one file of this folder: its card tables, their readers and the function that lists them.
// A new keyword is a row in its family's list; a new family is one line here and one in keywords.cpp.
namespace nugget::reading {

std::vector<Keyword> text_keywords();                    ///< what the reader of the text takes: includes, parameters
std::vector<Keyword> mesh_keywords();                    ///< nodes, elements, point masses
std::vector<Keyword> move_keywords();                    ///< nodes moved before anything is computed
std::vector<Keyword> node_merge_keywords();              ///< nodes at one place that become one
std::vector<Keyword> stopper_keywords();                 ///< *CONSTRAINED_RIGID_BODY_STOPPERS
std::vector<Keyword> linear_constraint_keywords();       ///< *CONSTRAINED_LINEAR_GLOBAL, _LOCAL
std::vector<Keyword> tied_node_keywords();               ///< *CONSTRAINED_TIED_NODES_FAILURE
std::vector<Keyword> belt_keywords();                    ///< *ELEMENT_SEATBELT..., *MAT_SEATBELT
std::vector<Keyword> sensor_define_keywords();           ///< *SENSOR_DEFINE_...
std::vector<Keyword> sensor_keywords();                  ///< *SENSOR_SWITCH..., *TERMINATION_...
std::vector<Keyword> sensor_control_keywords();          ///< *SENSOR_CONTROL
std::vector<Keyword> part_keywords();                    ///< *PART
std::vector<Keyword> section_keywords();                 ///< *SECTION_..., *HOURGLASS
std::vector<Keyword> material_keywords();                ///< *MAT_...
std::vector<Keyword> orthotropic_material_keywords();    ///< *MAT_ORTHOTROPIC_ELASTIC
std::vector<Keyword> fabric_material_keywords();         ///< *MAT_FABRIC
std::vector<Keyword> composite_material_keywords();      ///< *MAT_COMPOSITE_DAMAGE, *MAT_ENHANCED_COMPOSITE_DAMAGE
std::vector<Keyword> simplified_rubber_keywords();       ///< *MAT_SIMPLIFIED_RUBBER/FOAM
std::vector<Keyword> sheet_material_keywords();          ///< *MAT_... of rolled sheets: 036, 037, 122
std::vector<Keyword> yld2000_keywords();                 ///< *MAT_BARLAT_YLD2000
std::vector<Keyword> plain_law_keywords();               ///< *MAT_... whose cards stand with their laws
std::vector<Keyword> rubber_material_keywords();         ///< *MAT_... of rubber
std::vector<Keyword> viscoelastic_keywords();            ///< *MAT_KELVIN-MAXWELL_, *MAT_GENERAL_VISCOELASTIC
std::vector<Keyword> polymer_material_keywords();        ///< *MAT_PLASTICITY_POLYMER, _COMPRESSION_TENSION
std::vector<Keyword> laminated_glass_keywords();         ///< *MAT_LAMINATED_GLASS
std::vector<Keyword> honeycomb_material_keywords();      ///< *MAT_..._HONEYCOMB
std::vector<Keyword> foam_material_keywords();           ///< *MAT_... of foam
std::vector<Keyword> cohesive_material_keywords();       ///< *MAT_COHESIVE_...
std::vector<Keyword> erosion_keywords();                 ///< *MAT_ADD_EROSION
std::vector<Keyword> element_death_keywords();           ///< *DEFINE_ELEMENT_DEATH_...
std::vector<Keyword> gissmo_keywords();                  ///< *MAT_ADD_DAMAGE_GISSMO
std::vector<Keyword> friction_keywords();                ///< *DEFINE_FRICTION
std::vector<Keyword> plastic_material_keywords();        ///< *MAT_... of metals beside 003 and 024
std::vector<Keyword> johnson_cook_keywords();            ///< *MAT_... of Johnson and Cook
std::vector<Keyword> modified_johnson_cook_keywords();   ///< *MAT_MODIFIED_JOHNSON_COOK
std::vector<Keyword> tabulated_johnson_cook_keywords();  ///< *MAT_TABULATED_JOHNSON_COOK
std::vector<Keyword> laminated_fabric_keywords();        ///< *MAT_LAMINATED_COMPOSITE_FABRIC
std::vector<Keyword> viscoplastic_material_keywords();   ///< *MAT_ANISOTROPIC_VISCOPLASTIC
std::vector<Keyword> weld_material_keywords();           ///< *MAT_SPOTWELD
std::vector<Keyword> weld_table_keywords();              ///< the *DEFINE_ cards that belong to it
std::vector<Keyword> heat_zone_keywords();               ///< sheets softened around welds
std::vector<Keyword> weld_brick_keywords();              ///< welds of bricks, weld beams replaced by bricks
std::vector<Keyword> weld_tie_keywords();                ///< *NUGGET_WELD_TIE
std::vector<Keyword> discrete_beam_keywords();           ///< *MAT_... of discrete beams
std::vector<Keyword> spring_keywords();                  ///< springs and dampers, their sections, lines and laws
std::vector<Keyword> curve_keywords();                   ///< curves and tables
std::vector<Keyword> frame_keywords();                   ///< coordinate systems, vectors, boxes
std::vector<Keyword> set_keywords();                     ///< *SET_...
std::vector<Keyword> control_keywords();                 ///< *CONTROL_..., *TITLE
std::vector<Keyword> subcycle_keywords();                ///< *CONTROL_SUBCYCLE
std::vector<Keyword> implicit_keywords();                ///< *CONTROL_IMPLICIT_...
std::vector<Keyword> frequency_keywords();               ///< *FREQUENCY_DOMAIN_FRF, *DAMPING_STRUCTURAL
std::vector<Keyword> steady_state_keywords();            ///< *FREQUENCY_DOMAIN_SSD
std::vector<Keyword> interpolation_spotweld_keywords();  ///< *CONSTRAINED_INTERPOLATION_SPOTWELD

std::vector<Keyword> database_keywords();               ///< *DATABASE_...
std::vector<Keyword> cross_section_keywords();          ///< *DATABASE_CROSS_SECTION_..., *DATABASE_NODAL_FORCE_GROUP
std::vector<Keyword> boundary_keywords();               ///< *BOUNDARY_...
std::vector<Keyword> initial_keywords();                ///< *INITIAL_VELOCITY_...
std::vector<Keyword> initial_state_keywords();          ///< *INITIAL_STRESS_..., _STRAIN_..., _AXIAL_FORCE_BEAM
std::vector<Keyword> damping_keywords();                ///< *DAMPING_...
std::vector<Keyword> load_keywords();                   ///< *LOAD_...
std::vector<Keyword> airbag_keywords();                 ///< *AIRBAG_...
std::vector<Keyword> blast_keywords();                  ///< *LOAD_BLAST_...
std::vector<Keyword> generalized_body_load_keywords();  ///< *LOAD_BODY_GENERALIZED
std::vector<Keyword> rigidwall_keywords();              ///< *RIGIDWALL_...
std::vector<Keyword> seam_weld_keywords();              ///< *CONSTRAINED_GENERALIZED_WELD_... of fillets and butts
std::vector<Keyword> constrained_keywords();            ///< *CONSTRAINED_...
std::vector<Keyword> coarsening_keywords();             ///< *CONTROL_COARSEN and what belongs to it
std::vector<Keyword> joint_keywords();                  ///< *CONSTRAINED_JOINT_...
std::vector<Keyword> joint_stiffness_keywords();        ///< *CONSTRAINED_JOINT_STIFFNESS_...
std::vector<Keyword> contact_keywords();                ///< *CONTACT_...
std::vector<Keyword> other_keywords();                  ///< what is ignored or refused, and why

}  // namespace nugget::reading
