// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/parts.hpp"

namespace nugget::model {

/// T_ORT, T_ORS: factor over where a weld stands on its shell. The place is 0 in the middle of the shell and 1 on its
/// border, the angle 0 on the way to the middle of a side and 45 degrees on the way to a corner.
struct PlaceFactor {
  CurveTable table;
  bool curves_over_angle = true;  ///< and the table's values are places; false: the other way round

  double at(double place, double angle) const {
    if (!table.given()) return 1.0;
    return curves_over_angle ? table.at(place, angle) : table.at(angle, place);
  }
};

/// *CONTROL_SPOTWELD_BEAM.
struct WeldBeamControl {
  Index tension_curve = none, shear_curve = none;  ///< LCT, LCS: factor over the size of the shell tied to
  PlaceFactor tension_place, shear_place;          ///< T_ORT, T_ORS
  bool list = false;                               ///< PRTFLG
  int bricks = 0;                                  ///< RPBHX: bricks in place of a weld beam; 0: beams stay
  bool only_listed = false;                        ///< BMSID is given: only `beams` are replaced
  std::vector<Index> beams;                        ///< of BMSID, before any is replaced
  int part_offset = 0;                             ///< ID_OFF
  Place place;
};

/// *CONTROL_DYNAMIC_RELAXATION: before the run the model is brought to rest under the loads whose curves have SIDR 1 or
/// 2, by a factor on all velocities in every cycle.
struct Relaxation {
  bool asked = false;        ///< IDRFLG = 1, or a curve with SIDR 1 or 2
  bool forbidden = false;    ///< IDRFLG = -999
  int check_cycles = 250;    ///< NRCYCK
  double tolerance = 0.001;  ///< DRTOL, on the kinetic energy over the largest so far
  double factor = 0.995;     ///< DRFCTR
  double end_time = 0.0;     ///< DRTERM; 0: none
  double step_scale = 0.0;   ///< TSSFDR in place of TSSFAC; 0: TSSFAC
  bool on() const { return asked && !forbidden; }
};

/// ESORT of *CONTROL_SHELL: what collapsed quads are computed as.
enum class SortTriangles : unsigned char {
  no,         ///< collapsed quads of their section's formulation
  c0,         ///< ELFORM 4
  kirchhoff,  ///< ELFORM 17
};

/// How the ends of welds are tied to their sheets (*NUGGET_WELD_TIE, --weld-tie).
enum class WeldTie : unsigned char {
  segment,  ///< by the shape functions of the element under them
  area,     ///< by the nugget's disc
  joint,    ///< so, and a joint in series with the weld carries what the sheet's mesh lacks
};
/// Whether all welds are tied by discs.
constexpr bool by_area(WeldTie tie) {
  return tie != WeldTie::segment;
}

/// *CONTROL_SUBCYCLE, or --subcycle: elements with a long stable step have their forces less often than each cycle.
struct Subcycling {
  static constexpr int usual = 16, most = 64;  ///< K
  int ratio = 1;                               ///< K: at most every so many cycles; 1: all elements in each
  int contact_period = 1;                      ///< L: cycles from one time at which contacts have forces to the next
  Place place;                                 ///< where the card stands; no line: it was asked for by --subcycle
  bool on() const { return ratio > 1; }
};

/// The *CONTROL_... cards that this program obeys, in words; defaults are LS-DYNA's.
struct Control {
  // *CONTROL_TERMINATION
  double end_time = 0.0;
  Place end_time_place;           ///< where ENDTIM stands; no line: nowhere
  long end_cycle = 0;             ///< 0: none
  double smallest_step = 0.0;     ///< DTMIN, as a share of the first step; 0: none
  double energy_limit = 0.0;      ///< ENDENG, percent change of the energy ratio; 0: none
  double added_mass_limit = 1e8;  ///< ENDMAS, percent of the physical mass

  // *CONTROL_TIMESTEP
  double first_step = 0.0;                  ///< DTINIT; 0: computed
  double step_scale = 0.9;                  ///< TSSFAC
  bool step_scale_given = false;            ///< TSSFAC is a number of the deck
  Place step_scale_place;                   ///< where it stands; no line: nowhere
  int length_basis = 0;                     ///< ISDO
  double mass_step = 0.0;                   ///< DT2MS, sign as in the deck; 0: none
  double weight_of_added_mass = 0.0;        ///< EMSCL, share of the mass added by scaling on which body loads act [1]
  Index step_curve = none;                  ///< LCTM
  int erode_small_steps = 0;                ///< ERODE
  bool mass_scaling_at_start_only = false;  ///< MS1ST

  // *CONTROL_SHELL
  double warp_warning = 20.0;  ///< WRPANG [degrees]
  SortTriangles sort_triangles = SortTriangles::no;
  bool sort_solids = false;               ///< ESORT of solids: tetrahedra become ELFORM 10, wedges ELFORM 15
  int thickness_update = 0;               ///< ISTUPD
  int default_shell = 2;                  ///< THEORY
  bool warping_stiffness = false;         ///< BWC = 1
  bool lobatto = false;                   ///< INTGRD = 1
  bool laminated_shear = false;           ///< LAMSHT: layers given by cards have transverse shear strains of their own
  int distorted_shells = 0;               ///< NFAIL1, of shells with one in-plane point; see impact::Erosion
  int distorted_full_shells = 0;          ///< NFAIL4, of fully integrated shells
  std::vector<Index> parts_of_distorted;  ///< PSNFAIL: parts that these are about; empty: all

  // *CONTROL_HOURGLASS, *CONTROL_BULK_VISCOSITY
  Hourglass hourglass;
  int bulk_viscosity_type = 1;  ///< TYPE: 1 solids, -1/-2 shells too

  // *CONTROL_ENERGY
  bool hourglass_energy = false;  ///< HGEN = 2: a line of glstat

  // *CONTROL_CONTACT
  double penalty_scale = 0.1;         ///< SLSFAC
  int ignore_penetration = 0;         ///< IGNORE
  bool full_thickness = false;        ///< SSTHK = 1: single surface contact sees shells as thick as they are
  int keep_nodes_of_deleted = 0;      ///< ENMASS: 1 nodes of deleted bricks stay in the contact, 2 of shells too
  kernel::Friction part_friction;     ///< SFRIC, DFRIC, EDC, VFC: of parts that give none
  bool list_ties = false;             ///< OUTSEG
  double wall_penalty = 0.0;          ///< RWPNAL, its size: rigid walls against rigid bodies; 0: they do not touch
  int untied_weld = 0;                ///< SPOTSTP
  Place untied_weld_place;            ///< where it stands; no line: nowhere
  int weld_of_deleted_shell = 0;      ///< SPOTDEL
  double weld_thinning = 0.0;         ///< SPOTHIN; 0: none
  double weld_thinning_radius = 0.0;  ///< SWRADF, radii of the weld; 0: the shells that it is tied to
  bool keep_tied_gap = false;         ///< TIEDPRJ = 1
  WeldTie weld_tie = WeldTie::segment;

  WeldBeamControl weld_beams;
  Relaxation relaxation;

  bool second_order_stress = false;   ///< OSU = 1 of *CONTROL_ACCURACY; else rates of ELFORM 2 are those of the end
  bool invariant_shell_axes = false;  ///< INN of *CONTROL_ACCURACY, for output: else x of a shell goes from N1 to N2

  // *CONTROL_OUTPUT, *CONTROL_SOLID
  bool average_accelerations = false;  ///< IACCOP = 1
  std::vector<Index> eroding_parts;    ///< PSFAIL: only their bricks are deleted at negative volume; empty: all

  Subcycling subcycling;
  bool single_precision = false;  ///< --precision single: elements that are built for it (docs/manual/precision.md)
};

}  // namespace nugget::model
