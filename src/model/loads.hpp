// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "kernel/law/blast_wave.hpp"
#include "model/control_volume.hpp"
#include "model/parts.hpp"

namespace nugget::model {

inline constexpr double forever = 1e20;

/// One node held. Sets are resolved: one entry a node.
struct SinglePointConstraint {
  int id = 0;      ///< of the *BOUNDARY_SPC_..., 0 where none was given
  int set_id = 0;  ///< user id of the node set it came from, 0 for single nodes
  Index node = none;
  Index system = none;  ///< local axes, or none (global)
  unsigned fixed = 0;   ///< bits 0..2 translations, 3..5 rotations
  double birth = 0.0, death = forever;
  Index control = none;  ///< *SENSOR_CONTROL that turns it on and off
  /// Whether it holds all the time from the start on to `end`.
  bool holds_until(double end) const { return control == none && birth <= 0.0 && death >= end; }
};

/// *BOUNDARY_PRESCRIBED_MOTION_...
struct PrescribedMotion {
  enum class Target { nodes, rigid_body, rigid_body_local };
  enum class Quantity { velocity, acceleration, displacement };
  int id = 0;
  Target target = Target::nodes;
  std::vector<Index> nodes;
  Index rigid_body = none;
  bool rotation = false;       ///< DOF 5..8
  Vec3d direction;             ///< unit vector of the motion, global axes (of the body at time 0 when local)
  bool only_direction = true;  ///< false (DOF -4, -8): motion normal to `direction` is held too
  /// DOF 9 to 11, -9 to -11: nodes go around the axis along `direction` through `center`; the curve is the angle [rad]
  /// of each, or its rate. `rotation` is false: spins of nodes are left alone.
  bool circular = false;
  Vec3d center;
  bool radius_fixed = true;  ///< DOF 9 to 11; below 0 nodes are free to move to the axis and away from it
  Quantity quantity = Quantity::velocity;
  Index curve = none;
  double scale = 1.0;
  double birth = 0.0, death = forever;
  Index control = none;      ///< *SENSOR_CONTROL that turns it on and off
  bool from_switch = false;  ///< TIMEOFF: the curve begins when that turns it on
  /// Whether it drives all the time from the start on to `end`.
  bool drives_until(double end) const { return control == none && birth <= 0.0 && death >= end; }
  Place place;
};

/// A force or a moment on each of `nodes`.
struct NodalLoad {
  std::vector<Index> nodes;
  Index rigid_body = none;  ///< *LOAD_RIGID_BODY: on the body's centre instead
  bool moment = false;
  Vec3d direction;                                        ///< unit vector; unused for a follower
  std::array<Index, 3> follower_nodes{none, none, none};  ///< DOF 4, 8: along the normal of these three nodes
  Index curve = none;
  double scale = 1.0;
  Place place;
};

/// Base acceleration: each node feels the inertial force -m a (a positive value in z pulls down, LS-DYNA's way).
struct BodyLoad {
  Vec3d direction;  ///< unit vector
  /// *LOAD_BODY_RX, _RY, _RZ: the curve is an angular velocity w about `direction` through `center`, and each node
  /// feels the centrifugal force m w x (w x r) outwards, at its place of the moment.
  bool centrifugal = false;
  Vec3d center;
  bool own_parts = false;  ///< *LOAD_GRAVITY_PART, *LOAD_BODY_GENERALIZED: *LOAD_BODY_PARTS does not change `parts`
  Index curve = none;
  Index relaxation_curve = none;  ///< in dynamic relaxation, whatever its SIDR; none: `curve` as its SIDR says
  double scale = 1.0;
  std::vector<Index> parts;  ///< empty: all
  std::vector<Index> nodes;  ///< only these (*LOAD_BODY_GENERALIZED); empty: all of `parts`
};

/// Pressure on segments; positive pushes onto the face, against its right-hand normal.
struct PressureLoad {
  int id = 0;  ///< of _ID
  std::vector<Segment> segments;
  std::vector<CornerShares> share;  ///< of each segment's force, by its corners; see share_pressure
  Index curve = none;
  double scale = 1.0;
  double arrival = 0.0;
  Index control = none;      ///< *SENSOR_CONTROL that turns it on and off
  bool from_switch = false;  ///< TIMEOFF: the curve begins when that turns it on
  Place place;
};

/// Traction on segments along a fixed direction, on their present area: force over area, linear between the corners.
struct TractionLoad {
  std::string keyword;
  Place place;
  std::vector<Segment> segments;
  std::vector<std::array<double, 4>> factor;  ///< of each segment's corners
  Vec3d direction;                            ///< unit vector
  Index curve = none;
  double scale = 1.0;
  double birth = 0.0, death = forever;  ///< the curve begins at `birth`
};

/// Units of a deck, in those of the data of blasts.
struct BlastUnits {
  double mass = 1.0;      ///< [kg]
  double length = 1.0;    ///< [m]
  double time = 1.0;      ///< [ms]
  double pressure = 1.0;  ///< [kPa]
};

/// *LOAD_BLAST_ENHANCED on segments, whose right-hand normals look to the charge. `mass`, `centre` and `time` in the
/// deck's units.
struct BlastLoad {
  std::string keyword;
  Place place;
  kernel::Burst burst = kernel::Burst::sphere;
  BlastUnits units;
  double mass = 0.0;  ///< of TNT
  Vec3d centre;
  double time = 0.0, death = forever;  ///< of the burst; after which nothing presses
  bool negative_phase = true;          ///< NEGPHS = 0
  double scale = 1.0;                  ///< SCALEP
  std::vector<Segment> segments;
  std::vector<CornerShares> share;  ///< of each segment's force, by its corners
};
/// Of a segment's middle to the charge [length].
double distance_to(const BlastLoad& load, const Segment& segment, const std::vector<Vec3d>& x);

/// The loads of a model, a list for each kind. A new kind is a list here and a name in `kinds`; impact and linear
/// statics go through these, and do not compile, or refuse the load by name, where they lack it.
struct LoadLists {
  std::vector<NodalLoad> nodal_loads;
  std::vector<PressureLoad> pressure_loads;
  std::vector<TractionLoad> traction_loads;
  std::vector<BlastLoad> blast_loads;
  std::vector<ControlVolume> control_volumes;
  std::vector<BodyLoad> body_loads;

  /// All lists, in the order in which they act.
  auto kinds() const {
    return std::tie(nodal_loads, pressure_loads, traction_loads, blast_loads, control_volumes, body_loads);
  }
};
static_assert(sizeof(LoadLists) == std::tuple_size_v<decltype(LoadLists{}.kinds())> * sizeof(std::vector<NodalLoad>),
              "kinds() lacks a list");

/// Calls `visit(load)` for every load, kind after kind.
template <class Visit>
void for_each_load(const LoadLists& loads, Visit visit) {
  const auto each = [&](const auto& list) {
    for (const auto& load : list) visit(load);
  };
  std::apply([&](const auto&... list) { (each(list), ...); }, loads.kinds());
}

/// *RIGIDWALL_...
struct RigidWall {
  enum class Shape { plane, cylinder, sphere, prism };
  int id = 0;
  std::string title;
  Shape shape = Shape::plane;
  std::vector<Index> nodes;  ///< tracked nodes, ascending
  Vec3d origin;              ///< tail point; on the wall's face (plane), on the axis (cylinder), centre (sphere)
  Vec3d normal;              ///< unit: outward normal (plane), axis (cylinder)
  double radius = 0.0;       ///< cylinder, sphere
  double length = 0.0;       ///< cylinder: 0 infinite, else from the tail along the axis
  bool finite = false;       ///< plane: bounded by edges l and m
  Vec3d edge_l, edge_m;      ///< unit vectors
  double length_l = 0.0, length_m = 0.0;  ///< 0 infinite
  double depth = 0.0;                     ///< prism: extent against the normal, from the face inwards; 0 infinite
  double friction = 0.0;                  ///< 0 none, 1 stick, between: Coulomb
  double weld_velocity = 0.0;             ///< WVEL, for friction 2 and 3
  double mass = 0.0;                      ///< of a moving wall; 0: fixed
  double velocity = 0.0;                  ///< initial, along the normal (moving wall)
  Index motion_curve = none;              ///< geometric walls with _MOTION: along `motion_direction`
  bool motion_is_displacement = false;
  Vec3d motion_direction;
  int soft = 0;  ///< SOFT of _FORCES: cycles to bring the relative velocity to zero
  double birth = 0.0, death = forever;
  Index control = none;        ///< *SENSOR_CONTROL that turns it on and off
  std::vector<Segment> areas;  ///< SSID of _FORCES: parts of the face whose forces are listed apart
  Place place;
};

/// *RIGIDWALL_FORCE_TRANSDUCER: the force of a wall on some of its nodes.
struct WallTransducer {
  int id = 0;
  std::string title;
  Index wall = none;
  int set = 0;               ///< user id of the node set
  std::vector<Index> nodes;  ///< ascending
  Place place;
};

}  // namespace nugget::model
