// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/contact/friction.hpp"
#include "kernel/law/cohesive.hpp"
#include "model/loads.hpp"

namespace nugget::model {

/// One side of a contact, resolved. `everything`: type 5, or type 2 with id 0.
struct Surface {
  bool everything = false;
  std::vector<Index> parts;
  std::vector<Index> nodes;       ///< type 4
  std::vector<Segment> segments;  ///< type 0, and shell sets (type 1)
  /// Of all these only what lies in the box, corners included: nodes, segments with all their nodes.
  bool boxed = false;
  Vec3d box_low, box_high;
  bool holds(const Vec3d& x) const {
    return !boxed || (x.x >= box_low.x && x.x <= box_high.x && x.y >= box_low.y && x.y <= box_high.y &&
                      x.z >= box_low.z && x.z <= box_high.z);
  }
  bool empty() const { return !everything && parts.empty() && nodes.empty() && segments.empty(); }
};

/// What _TIEBREAK asks for.
struct Glue {
  kernel::Cohesion law;
  bool bonds_later = false;        ///< OPTION 1, 3: also what comes to touch in the run
  bool slides = false;             ///< OPTION 4: holds along the normal alone
  double slip_stress = 0.0;        ///< of glue that slides: its friction, whatever the pressure; 0: Coulomb's [stress]
  bool by_force = false;           ///< the strengths are forces of a node, not stresses
  bool without_thickness = false;  ///< what touches is judged as for ties: the sheets may be meshed at any distance
  bool alone = false;              ///< _ONLY: no contact besides the glue
  bool moments = false;            ///< OPTION -1, -2, -3: the lever between node and segment counts
  double reach = 0.0;              ///< how far from a segment a node may stand; 0: by the thicknesses [length]
};

/// *CONTACT_...: the cards, in words. Penalty contacts and ties alike; `kind` says what is done with it.
/// *DEFINE_FRICTION: friction between parts.
struct PartFriction {
  struct Pair {
    std::vector<Index> one, other;  ///< parts
    kernel::Friction friction;
  };
  int id = 0;
  kernel::Friction otherwise;  ///< of parts that no pair has
  std::vector<Pair> pairs;     ///< the last one counts of those that parts have
};

struct Contact {
  /// A surface against itself; two surfaces, each node against the other side; nodes of `a` against segments of `b`; a
  /// transducer, which sums up the forces of other contacts; ties, the last one where parts of `a` touch each other.
  enum class Kind {
    single_surface,
    two_surfaces,
    one_way,
    transducer,
    spotweld,
    tied_nodes,
    tied_surface,
    tied_shell_edge,
    tied_shell_edge_to_solid,
    tied_single_surface
  };
  /// What a tie does about the gap between node and segment. `projected`: the node is moved onto the segment;
  /// `constrained`: the gap turns with the segment; `penalty`: springs, whose force acts at the segment without the
  /// gap's lever; `beam`: springs, with the lever.
  enum class Offset { projected, constrained, penalty, beam };
  int id = 0;
  std::string title;
  std::string keyword;
  Kind kind = Kind::single_surface;
  std::optional<Glue> glue;           ///< _TIEBREAK
  Offset offset = Offset::projected;  ///< ties
  bool torsion = false;               ///< _WITH_TORSION: twist of a weld becomes in-plane forces
  bool penalty_fallback = false;      ///< IPBACK: springs where a constraint meets another one
  bool parts_apart = false;           ///< CPARM8 1, 2: beams of one and the same part do not press each other
  bool takes_welds = false;           ///< CPARM8 2: weld beams take part, against edges and beams
  Surface a;                          ///< tracked (SURFA, slave)
  Surface b;                          ///< reference (SURFB, master)
  kernel::Friction friction;
  Index friction_table = none;     ///< FS = -2: in Model::part_friction; `friction` holds the factors on it
  bool friction_by_part = false;   ///< FS = -1: of *PART_CONTACT; `friction` holds the factors on it
  bool balances_friction = false;  ///< FTORQ
  double damping = 0.0;            ///< VDC, percent of critical
  double birth = 0.0, death = forever;
  Index control = none;                                     ///< *SENSOR_CONTROL that turns it on and off
  double stiffness_scale_a = 1.0, stiffness_scale_b = 1.0;  ///< SFSA, SFSB
  double thickness_a = 0.0, thickness_b = 0.0;              ///< SAST, SBST; negative: tie tolerance
  double thickness_scale_a = 1.0, thickness_scale_b = 1.0;  ///< SFSAT, SFSBT
  int soft = 0;
  double soft_scale = 0.1;
  double soft_step = 0.0;   ///< DTSTIF: the step that a stiffness by masses is for; 0: that of the run [time]
  int depth = 2;            ///< DEPTH: what SOFT = 2 checks
  double deepest = 0.0;     ///< PENMAX: a node deeper than so many thicknesses is released; 0: none
  int search_interval = 0;  ///< BSORT; 0: chosen by the program
  double close = 0.0;       ///< CLOSE: surfaces closer than this are tied; 0: by the mesh [length]
  int ignore = 0;           ///< IGNORE of optional card D, or the control card's
  bool prints_a = false, prints_b = false;  ///< SAPR, SBPR: ncforc has the forces on the nodes of this side
  Place place;

  /// By penalty forces; else it is a tie or a transducer.
  bool slides() const { return kind == Kind::single_surface || kind == Kind::two_surfaces || kind == Kind::one_way; }
  bool tie() const { return !slides() && kind != Kind::transducer; }
  /// Ties what touches, once everything else is tied (weld::tie_touching).
  bool ties_what_touches() const { return kind == Kind::tied_single_surface; }
  bool tie_by_springs() const { return offset == Offset::penalty || offset == Offset::beam; }
  /// Whether the tie hands over rotations and moments as well.
  bool ties_rotations() const { return tie() && kind != Kind::tied_nodes && kind != Kind::tied_surface; }
};

/// A part whose bricks *CONTACT_INTERIOR keeps from being squeezed flat.
struct InteriorPart {
  Index part = none;
  double scale = 1.0;       ///< PSF, on the stiffness that follows from Young's modulus
  double activation = 0.1;  ///< Fa: share of its first thickness at which a brick begins to push back
  double modulus = 0.0;     ///< ED; 0: Young's modulus times `scale` and SLSFAC [stress]
};

/// *CONTACT_INTERIOR: bricks of soft parts that are squeezed nearly flat push back.
struct InteriorContact {
  int id = 0;
  std::string title;
  std::vector<InteriorPart> parts;
  Place place;
};

}  // namespace nugget::model
