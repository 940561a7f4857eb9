// SPDX-License-Identifier: Apache-2.0
// Keywords that are read past because they change nothing here, and keywords of physics that this program does not
// have. Each with its reason: the first for the table of keywords, the second for the user who has to do something
// about it.
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

Keyword ignored(std::string_view name, std::string_view why) {
  return {.name = name, .status = KeywordStatus::ignored, .why = why};
}
Keyword refused(std::string_view name, std::string_view why) {
  return {.name = name, .status = KeywordStatus::refused, .why = why};
}

using Rows = std::vector<Keyword>;

constexpr std::string_view of_many_sensors =
    "measures something that nothing here asks for; sets (_SET) and _UPDATE are not built, single ones are";

/// Nothing of the run depends on them.
Rows without_effect() {
  return {
      ignored("COMMENT", "a comment"),
      ignored("CONTROL_CPU", "a limit of processor time; interrupt the run, or give --max-cycles"),
      ignored("CONTROL_PARALLEL", "threads are given on the command line (-j); results do not depend on their number"),
      ignored("CONTROL_MPP_*", "distribution over processes; results do not depend on it"),
      ignored("CONTROL_STRUCTURED*", "writes a structured copy of the deck; no result depends on it"),
      ignored("CONTROL_DEBUG", "messages of LS-DYNA for its developers"),
      ignored("CONTROL_REQUIRE_REVISION", "a demand on the release of LS-DYNA"),
      ignored("CONTROL_NONLOCAL", "storage for nonlocal laws, which are not built"),
      ignored("ELEMENT_PLOTEL", "lines for pictures only"),
      ignored("SET_DISCRETE*", "no card that is obeyed takes a set of springs and dampers; deforc has each of them"),
      ignored("SENSOR_DEFINE_NODE_*", of_many_sensors),
      ignored("SENSOR_DEFINE_FORCE_*", of_many_sensors),
      ignored("SENSOR_DEFINE_ELEMENT_*", of_many_sensors),
      ignored("SENSOR_DEFINE_MISC_*", of_many_sensors),
      ignored("SENSOR_DEFINE_CALC-MATH_*", of_many_sensors),
      ignored("SENSOR_DEFINE_FUNCTION_*", of_many_sensors),
      ignored("SENSOR_DEFINE_*",
              "measures something that nothing here asks for; _NODE, _FORCE, _ELEMENT, _MISC, _CALC-MATH and _FUNCTION "
              "are built"),
      ignored("INTERFACE_SPRINGBACK_*", "asks for a file of the final state (dynain); d3plot holds it"),
  };
}

/// Other solution methods than the explicit run.
Rows other_solutions() {
  return {
      refused("CONTROL_IMPLICIT_*", "this part of implicit solutions is not built; modes and linear statics are"),
      refused("CONTROL_THERMAL_*", "heat conduction is not built"),
      refused("CONTROL_ADAPTIVE*", "adaptive remeshing is not built; refine the mesh in advance"),
      refused("CONTROL_ADAPSTEP", "adaptive remeshing is not built; refine the mesh in advance"),
      refused("CONTROL_REMESHING*", "remeshing is not built"),
      refused("CONTROL_FORMING_*", "sheet forming is not built"),
      refused("CONTROL_SUBCYCLE_MASS_SCALED_PART*",
              "mass scaling of parts in sub-cycling is not built; *CONTROL_SUBCYCLE without it is, or DT2MS of "
              "*CONTROL_TIMESTEP"),
      refused("CONTROL_COUPLING", "coupling to other programs is not built"),
      refused("CONTROL_STAGED_CONSTRUCTION", "construction in stages is not built"),
      refused("CASE*", "this form of *CASE is not built; *CASE, *CASE_BEGIN_n and *CASE_END_n are"),
      refused("RESTART*", "LS-DYNA's restart decks are not read; use nugget run --resume"),
      refused("STRESS_INITIALIZATION*", "LS-DYNA's full restart is not built"),
      refused("CHANGE_*", "changes at a restart are not built"),
      refused("DELETE_*", "deletions at a restart are not built"),
      refused("TERMINATION_*", "ends by contact, curve or deleted elements are not built"),
      refused("DEFORMABLE_TO_RIGID_*",
              "parts are rigid from the start (*DEFORMABLE_TO_RIGID) or never: switching during a run is not built"),
      refused("RIGID_DEFORMABLE*",
              "parts are rigid from the start (*DEFORMABLE_TO_RIGID) or never: switching during a run is not built"),
      refused("INTERFACE_*", "interfaces between runs are not built"),
      refused("PERTURBATION*", "random imperfections are not built; move the nodes in the deck"),
      refused("USER_*", "user subroutines are not built"),
      refused("MODULE_*", "user subroutines are not built"),
      refused("SENSOR_SWITCH_*", "this form of a switch is not built; *SENSOR_SWITCH and _SWITCH_CALC-LOGIC are"),
      refused("SENSOR_*", "this kind of sensor is not built"),
  };
}

/// Fluids, fields, particles.
Rows other_physics() {
  return {
      refused("AIRBAG_WANG_NEFSKE_*", "jets, and inflators that a sensor starts, are not built; _WANG_NEFSKE alone is"),
      refused("AIRBAG_*", "this gas of airbags is not built"),
      refused("ALE_*", "fluids and large distortions by ALE are not built"),
      refused("CONTROL_ALE", "fluids and large distortions by ALE are not built"),
      refused("INITIAL_VOLUME_FRACTION*", "fluids and large distortions by ALE are not built"),
      refused("BOUNDARY_ALE_*", "fluids and large distortions by ALE are not built"),
      refused("EM_*", "electromagnetics are not built"),
      refused("ICFD_*", "fluid flow is not built"),
      refused("CESE_*", "fluid flow is not built"),
      refused("DUALCESE_*", "fluid flow is not built"),
      refused("CHEMISTRY_*", "chemistry is not built"),
      refused("STOCHASTIC_*", "particles are not built"),
      refused("PARTICLE_*", "particles are not built"),
      refused("BATTERY_*", "batteries are not built"),
      refused("MESH_*", "automatic volume meshes are not built"),
      refused("CONTROL_SPH*", "particles (SPH) are not built"),
      refused("CONTROL_DISCRETE_ELEMENT", "particles (DES) are not built"),
      refused("CONTROL_EFG", "meshfree elements are not built"),
      refused("IGA_*", "isogeometric elements are not built; mesh the part with shells"),
      refused("EOS_*", "this equation of state is not built"),
      refused("RAIL_*", "rail tracks are not built"),
  };
}

Rows other_elements() {
  return {
      refused("ELEMENT_DISCRETE_*", "this form of a spring is not built; write *ELEMENT_DISCRETE"),
      refused("SET_TSHELL*", "sets of thick shells are not built; name their parts, or write *DATABASE_HISTORY_TSHELL"),
      refused("ELEMENT_TSHELL_*",
              "thick shells with angles or layers of their own (_BETA, _COMPOSITE) are not built; *ELEMENT_TSHELL is"),
      refused("ELEMENT_SPH*", "particles (SPH) are not built"),
      refused("SECTION_SPH*", "particles (SPH) are not built"),
      refused("ELEMENT_DISCRETE_SPHERE*", "particles (DES) are not built"),
      refused("ELEMENT_MASS_MATRIX*", "mass matrices are not built; use *ELEMENT_MASS"),
      refused("ELEMENT_DIRECT_MATRIX_INPUT*", "superelements are not built"),
      refused("ELEMENT_*", "this element is not built"),
      refused("SECTION_*", "this section is not built"),
      refused("INTEGRATION_*", "this integration rule of the user is not built"),
      refused("PART_COMPOSITE_*", "this form of *PART_COMPOSITE is not built; LONG and CONTACT are"),
      refused("PART_*", "this form of *PART is not built"),
      refused("NODE_*", "this form of *NODE is not built"),
      refused("COMPONENT_*", "dummies are not built"),
  };
}

Rows other_laws() {
  constexpr std::string_view weld_forms =
      "this form of *MAT_SPOTWELD is not built; the plain one, _DAMAGE-FAILURE and _DAIMLERCHRYSLER are, each with "
      "_UNIAXIAL";
  constexpr std::string_view discrete_beam_laws =
      "this law of discrete beams is not built; *MAT_066, 067, 068, 074, 119, 121 and 196 are";
  constexpr std::string_view cohesive_laws =
      "this law of adhesive is not built; *MAT_138, 169, 184, 185, 186 and 240 are, in bricks of ELFORM 19 and 20, and "
      "glue between "
      "two "
      "surfaces is *CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK";
  return {
      refused("MAT_SPOTWELD_*", weld_forms),
      refused("MAT_100_*", weld_forms),
      refused("MAT_SPRING_*", "this law of springs is not built"),
      refused("MAT_S1*", "this law of springs is not built; *MAT_S01 to *MAT_S08 are"),
      refused("MAT_GENERAL_NONLINEAR_*", discrete_beam_laws),
      refused("MAT_GENERAL_SPRING_*", discrete_beam_laws),
      refused("MAT_GENERAL_JOINT_*", discrete_beam_laws),
      refused("MAT_NONLINEAR_PLASTIC_DISCRETE_BEAM*", discrete_beam_laws),
      refused("MAT_SEATBELT_2D", "belts of shells are not built; belts of two nodes (*MAT_SEATBELT) are"),
      refused("MAT_B01*", "this form of belts is not built; belts of two nodes (*MAT_SEATBELT) are"),
      refused("MAT_THERMAL_*", "heat conduction is not built"),
      refused("MAT_T0*", "heat conduction is not built"),
      refused("MAT_ALE_*", "fluids are not built"),
      refused("MAT_ELASTIC_FLUID*", "fluids are not built"),
      refused("MAT_COHESIVE_*", cohesive_laws),
      refused("MAT_ARUP_ADHESIVE_*", cohesive_laws),
      refused("MAT_ADD_*", "this addition to a law is not built"),
      refused("MAT_*", "this material is not built"),
  };
}

Rows other_conditions() {
  return {
      refused("BOUNDARY_PRESCRIBED_MOTION_*",
              "this target of a prescribed motion is not built; nodes, node sets and rigid bodies are"),
      refused("BOUNDARY_PRESCRIBED_ACCELEROMETER_RIGID",
              "motions out of accelerometer records are not built; give a velocity curve"),
      refused("BOUNDARY_SPC_SYMMETRY_PLANE*", "symmetry planes are not built; use *BOUNDARY_SPC_SET"),
      refused("BOUNDARY_NON_REFLECTING*", "non-reflecting boundaries are not built"),
      refused("BOUNDARY_CYCLIC*", "cyclic symmetry is not built"),
      refused("BOUNDARY_SLIDING_PLANE", "sliding planes are not built; use *BOUNDARY_SPC_SET with a coordinate system"),
      refused("BOUNDARY_TEMPERATURE*", "heat conduction is not built"),
      refused("BOUNDARY_CONVECTION*", "heat conduction is not built"),
      refused("BOUNDARY_FLUX*", "heat conduction is not built"),
      refused("BOUNDARY_RADIATION*", "heat conduction is not built"),
      refused("BOUNDARY_*", "this boundary condition is not built"),
      refused("INITIAL_STRESS_*", "this form of initial stresses is not built"),
      refused("INITIAL_STRAIN_*", "this form of initial strains is not built"),
      refused("INITIAL_TEMPERATURE*", "heat conduction is not built"),
      refused("INITIAL_*", "this initial condition is not built"),
      refused("LOAD_THERMAL_*", "heat and thermal strains are not built"),
      refused(
          "LOAD_BLAST*",
          "this form of blast loads is not built; *LOAD_BLAST_ENHANCED with *LOAD_BLAST_SEGMENT or _SEGMENT_SET is"),
      refused("LOAD_*", "this load is not built"),
      refused("DAMPING_*", "this damping is not built"),
      refused("RIGIDWALL_*", "this wall is not built"),
      refused("CONTROL_*", "this control card is not known here, so what it asks for cannot be obeyed"),
  };
}

Rows other_definitions() {
  return {
      refused("DEFINE_SPOTWELD_*", "this table of weld strengths is not built"),
      refused("DEFINE_SPG_*", "particles (SPG) are not built"),
      refused("DEFINE_CURVE_*", "this form of curve is not built; give its points with *DEFINE_CURVE"),
      refused("DEFINE_TABLE_*", "this form of table is not built; use *DEFINE_TABLE or *DEFINE_TABLE_2D"),
      refused("DEFINE_FRICTION_*", "friction by direction or scaled is not built; use *DEFINE_FRICTION"),
      refused("DEFINE_DEATH_TIMES_*", "motions that end by position are not built; give a death time"),
      refused("DEFINE_CONSTRUCTION_STAGES", "construction in stages is not built"),
      refused("DEFINE_ELEMENT_DEATH*", "deletion at a time is built for shells, solids and beams and their sets only"),
      refused("DEFINE_*", "this definition is not built"),
  };
}

/// The reader of the text has taken these before a model is built; they are here to be listed.
Keyword of_the_text(std::string_view name, std::vector<std::string_view> options = {}) {
  return {.name = name, .options = std::move(options), .read = [](Builder&, const deck::Block&, const Options&) {}};
}

}  // namespace

std::vector<Keyword> text_keywords() {
  return {
      of_the_text("KEYWORD"),
      of_the_text("END"),
      of_the_text("PARAMETER", {"EXPRESSION", "LOCAL", "GLOBAL", "MUTABLE", "NOECHO", "DUPLICATION"}),
      of_the_text("CASE"),
      of_the_text("CASE_BEGIN"),
      of_the_text("CASE_END"),
      of_the_text("INCLUDE"),
      of_the_text("INCLUDE_PATH"),
      of_the_text("INCLUDE_PATH_RELATIVE"),
      of_the_text("INCLUDE_TRANSFORM"),
      of_the_text("DEFINE_TRANSFORMATION", {"TITLE"}),
  };
}

std::vector<Keyword> other_keywords() {
  Rows all;
  for (const auto group : {without_effect, other_solutions, other_physics, other_elements, other_laws, other_conditions,
                           other_definitions}) {
    Rows rows = group();
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace nugget::reading
