// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/curve.hpp"
#include "base/finding.hpp"
#include "base/index.hpp"
#include "base/vec3.hpp"
#include "model/belt.hpp"
#include "model/body_stopper.hpp"
#include "model/coarsening.hpp"
#include "model/contact.hpp"
#include "model/control.hpp"
#include "model/damping.hpp"
#include "model/discrete.hpp"
#include "model/element_death.hpp"
#include "model/frequency.hpp"
#include "model/heat_zone.hpp"
#include "model/implicit.hpp"
#include "model/initial_state.hpp"
#include "model/interpolation.hpp"
#include "model/interpolation_spotweld.hpp"
#include "model/joint.hpp"
#include "model/linear_constraint.hpp"
#include "model/loads.hpp"
#include "model/parts.hpp"
#include "model/requests.hpp"
#include "model/rigid_weld.hpp"
#include "model/run_ends.hpp"
#include "model/sensors.hpp"
#include "model/tied_nodes.hpp"
#include "model/user_function.hpp"
#include "model/weld_law.hpp"
#include "model/weld_library.hpp"

// The checked, immutable meaning of a deck. Inside, everything is an index (position in its array, from 0); the user's
// ids stand beside, in arrays `id`. Values are in the deck's own units.
namespace nugget::model {

/// Where each of many things was defined: a line and a file number, so that a million elements carry no strings.
class Places {
 public:
  /// `files`: the names that file numbers count into, e.g. Deck::files.
  explicit Places(std::vector<std::string> files = {}) : files_(std::move(files)) {}
  void push_back(int file, int line) { entries_.push_back({file, line}); }
  void reserve(std::size_t count) { entries_.reserve(count); }
  std::size_t size() const { return entries_.size(); }
  /// One more, its file new or not.
  void push_back(const Place& place) {
    const auto file = std::find(files_.begin(), files_.end(), place.file);
    entries_.push_back({static_cast<int>(file - files_.begin()), place.line});
    if (file == files_.end()) files_.push_back(place.file);
  }
  /// One more, as place i of `from`, whose files are the same.
  void append(const Places& from, std::size_t i) { entries_.push_back(from.entries_[i]); }
  /// No place, in the same files.
  Places none_of_them() const { return Places(files_); }
  Place operator[](std::size_t i) const {
    const auto file = at(entries_[i].file);
    return {file < files_.size() ? files_[file] : std::string{}, entries_[i].line, 0};
  }

 private:
  struct Entry {
    int file = 0, line = 0;
  };
  std::vector<std::string> files_;
  std::vector<Entry> entries_;
};

/// Nodes in ascending order of user id.
struct Nodes {
  std::vector<int> id;
  std::vector<Vec3d> x;  ///< initial coordinates [length]
  std::size_t size() const { return id.size(); }
};

/// Four-node shells in ascending order of user id; a triangle repeats its third node.
struct Shells {
  std::vector<int> id;
  std::vector<Index> part;
  std::vector<std::array<Index, 4>> node;
  std::vector<double> thickness;  ///< initial, mean of the nodal ones [length]
  std::vector<double> offsets;    ///< empty: all are 0; see `offset`
  std::vector<double> angle;      ///< BETA of single shells, NaN where blank; empty: none has one [rad]
  Places place;
  std::size_t size() const { return id.size(); }
  std::span<const Index> nodes(std::size_t e) const { return node[e]; }
  bool triangle(std::size_t e) const { return node[e][3] == node[e][2]; }
  /// Of the reference surface from the nodes, along the normal [length]; see SectionShell::nloc.
  double offset(Index e) const { return offsets.empty() ? 0.0 : offsets[e]; }
  std::optional<double> own_angle(Index e) const {
    return angle.empty() || std::isnan(angle[e]) ? std::nullopt : std::optional(angle[e]);
  }
};

/// Eight-node bricks in ascending order of user id; wedges and tetrahedra repeat nodes (LS-DYNA's rule). A tetrahedron
/// of ten nodes stands in `node` with its corners, like one of four nodes.
struct Solids {
  std::vector<int> id;
  std::vector<Index> part;
  std::vector<std::array<Index, 8>> node;
  std::vector<std::array<Index, 10>> ten_nodes;  ///< of the tetrahedra of ten nodes; see kernel::quadratic_tetrahedron
  std::vector<Index> ten_row;                    ///< of a solid in `ten_nodes`, or none; may end before the last solid
  Places place;
  std::size_t size() const { return id.size(); }
  bool quadratic(std::size_t e) const { return e < ten_row.size() && ten_row[e] != none; }
  const std::array<Index, 10>& ten(std::size_t e) const { return ten_nodes[ten_row[e]]; }
  /// All nodes of a solid: the ten of a quadratic tetrahedron, else eight, of which some may be the same.
  std::span<const Index> nodes(std::size_t e) const {
    if (quadratic(e)) return ten(e);
    return node[e];
  }
  /// The different corners of a solid in the order of its card: eight of a brick, six of a wedge, four of a
  /// tetrahedron.
  std::vector<Index> corners(std::size_t e) const;
  /// All different nodes: the corners, after them those amid the edges of a quadratic tetrahedron.
  std::vector<Index> different_nodes(std::size_t e) const;
};

/// Two-node beams in ascending order of user id.
struct Beams {
  std::vector<int> id;
  std::vector<Index> part;
  std::vector<std::array<Index, 2>> node;
  std::vector<Index> orientation;  ///< third node, or none
  std::vector<Vec3d> direction;    ///< of _ORIENTATION, instead of a third node; or zero
  std::vector<std::array<Index, 2>>
      tied_parts;  ///< *ELEMENT_BEAM_PID: parts that end 1 and end 2 are to be tied to, or none
  Places place;
  std::size_t size() const { return id.size(); }
  std::span<const Index> nodes(std::size_t e) const { return node[e]; }
  /// Direction from the first node to where the section's s axis points; zero if the deck gives none. `x`: of all
  /// nodes.
  Vec3d side(std::size_t e, const std::vector<Vec3d>& x) const {
    const Index third = orientation[e];
    return third == none ? direction[e] : x[third] - x[node[e][0]];
  }
};

/// *DEFINE_HEX_SPOTWELD_ASSEMBLY: bricks that make up one weld.
struct HexAssembly {
  int id = 0;
  std::vector<Index> solids;
  Vec3d orientation;                            ///< direction of its s axis; zero: by rule
  std::array<Index, 2> tied_parts{none, none};  ///< of the beam that it replaces; see Beams
  Place place;
};

struct PointMass {
  int id = 0;
  Index node = none;
  double mass = 0.0;
};
struct PointInertia {
  int id = 0;
  Index node = none;
  double mass = 0.0;
  std::array<double, 6> inertia{};  ///< Ixx Ixy Ixz Iyy Iyz Izz about the node, global axes [mass length^2]
};

/// What became of a keyword of the deck.
enum class KeywordStatus { used, ignored, refused };
struct KeywordUse {
  std::string keyword;  ///< as written, upper case, without its star
  int count = 0;
  KeywordStatus status = KeywordStatus::used;
  std::string why;  ///< for ignored and refused
  Place first;
};

/// Copied, moved and taken down in one place: it has a hundred lists.
struct Model : LoadLists {
  Model();
  Model(const Model&);
  Model(Model&&) noexcept;
  Model& operator=(const Model&);
  Model& operator=(Model&&) noexcept;
  ~Model();

  std::string title;
  std::string deck;   ///< path of the master file as given
  std::string units;  ///< name of the units that the user gave (model/units.hpp); empty: as recognised
  Control control;
  CoarsenControl coarsen;
  Implicit implicit;
  std::optional<FrequencyResponse> frequency_response;
  std::optional<SteadyState> steady_state;
  StructuralDamping structural_damping;
  Requests requests;
  std::vector<KeywordUse> keyword_uses;

  Nodes nodes;
  Shells shells;
  Solids solids;
  Beams beams;
  std::vector<Discrete> discretes;
  std::vector<HexAssembly> hex_assemblies;
  std::vector<ElementDeath> element_deaths;
  std::vector<PointMass> masses;
  std::vector<PointInertia> inertias;

  /// What cards name one by one, in the order in which it is looked up, some more than once; and what lists of sets
  /// name.
  std::vector<Index> named_nodes, named_shells, listed_nodes, listed_shells;

  std::vector<Part> parts;  ///< in deck order
  std::vector<SectionShell> shell_sections;
  std::vector<SectionSolid> solid_sections;
  std::vector<SectionBeam> beam_sections;
  std::vector<SectionDiscrete> discrete_sections;
  std::vector<Material> materials;
  std::vector<Hourglass> hourglass;

  std::vector<WeldLaw> weld_laws;                   ///< what the *MAT_SPOTWELD of `materials` say of welds as a whole
  std::shared_ptr<const WeldLibrary> weld_library;  ///< of OPT 2, 12, 22; null: none is given
  std::vector<RuptureStress> rupture_stresses;
  std::vector<PairStrengths> pair_strengths;
  std::vector<LoadRateStrengths> load_rate_strengths;
  std::vector<ConnectionProperties> connections;

  std::vector<HeatZone> heat_zones;
  std::vector<WeldSeam> weld_seams;

  std::vector<Curve> curves;  ///< offsets and scales applied
  std::vector<Table> tables;
  std::vector<UserFunction> functions;
  std::vector<PartFriction> part_friction;
  std::vector<CoordinateSystem> systems;
  std::vector<SpringOrientation> spring_orientations;
  Sets sets;

  std::vector<RigidBody> rigid_bodies;  ///< MAT_RIGID parts (merged), nodal rigid bodies, rigid welds
  std::vector<RigidWeld> rigid_welds;
  std::vector<Interpolation> interpolations;
  std::vector<HangingNode> hanging_nodes;
  std::vector<TiedNodes> tied_nodes;
  std::vector<InterpolationSpotweld> interpolation_spotwelds;
  std::vector<Joint> joints;
  std::vector<Accelerometer> accelerometers;
  std::vector<SinglePointConstraint> spcs;
  std::vector<PrescribedMotion> motions;
  std::vector<Vec3d> initial_velocity;  ///< per node; empty: all zero [length/time]
  std::vector<Vec3d> initial_spin;      ///< per node; empty: all zero [1/time]
  Damping damping;
  Belts belts;
  std::vector<Sensor> sensors;
  std::vector<SensorSwitch> sensor_switches;
  std::vector<SensorControl> sensor_controls;
  std::vector<RunEnd> run_ends;
  bool holds_at_start(const SinglePointConstraint& spc) const {
    return spc.birth <= 0.0 && (spc.control == none || sensor_controls[spc.control].starts_on);
  }
  std::vector<BodyStopper> body_stoppers;
  std::vector<LinearConstraint> linear_constraints;
  InitialState initial_state;
  std::vector<RigidWall> walls;
  std::vector<WallTransducer> wall_transducers;
  std::vector<Contact> contacts;  ///< penalty contacts and ties, in deck order
  std::vector<InteriorContact> interiors;
  std::vector<JointStiffness> joint_stiffnesses;

  /// Index of a user id, or none.
  Index node_index(int id) const;
  Index part_index(int id) const;
  Index curve_index(int id) const;
  /// Whether a part's elements are membranes: shells without bending, neither rigid nor for contact alone (MAT_NULL).
  bool has_membranes(Index part) const;
  /// Whether a part's section is that of thick shells, whatever its material.
  bool has_thick_shells(Index part) const;
};

}  // namespace nugget::model
