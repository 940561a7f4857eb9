// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/curve.hpp"
#include "base/period_mean.hpp"
#include "base/row.hpp"
#include "contact/held_nodes.hpp"
#include "contact/step.hpp"
#include "contact/wall_penalty.hpp"
#include "kernel/contact/wall.hpp"
#include "model/loads.hpp"
#include "system/gathered_lists.hpp"

namespace nugget::system {
class Share;
class Parcel;
}  // namespace nugget::system

namespace nugget::contact {

/// *RIGIDWALL_PLANAR and _GEOMETRIC_FLAT, _PRISM, _CYLINDER, _SPHERE: stops nodes by changing their velocities,
/// perfectly plastic.
///
/// A node whose position at the end of the step would be behind the wall gets the velocity along the wall's normal that
/// brings it to the wall, or, when it stands there already, the wall's own; that is LS-DYNA's constraint method with
/// the last step before the impact shortened to end on the surface. It is free again as soon as its own velocity takes
/// it off. On a round wall the condition is on the position too, so a node that slides along it follows the curve and
/// carries the centripetal force without chatter.
///
/// Friction (FRIC): 0 none; 1 the node sticks while it touches; between: Coulomb's law on the impulses. 2 and 3: a node
/// that hits the wall faster than WVEL stays on it for good, sliding freely (2) or not at all (3); others see no
/// friction (2) or stick (3).
///
/// Motion: a plane with `mass` moves along its normal, its velocity following from the momentum of the nodes (plastic
/// collision: the total is kept to round-off); any wall with a motion curve moves as the curve says; others stand.
/// None moves before its birth time, from which the curve counts. Nodes of rigid bodies are stopped by penalty, if at
/// all: WallPenalty, whose forces, work and push on a wall with mass count with those of the other nodes. Results are
/// the same bits for any number of threads.
///
/// Supports and prescribed motions go before (docs/decisions/0178): the wall pushes a node where these leave it free,
/// as far as it takes for the wall's condition to hold, too; they take up what of the wall's impulse is along them. A
/// node that is held along the normal is left alone.
class RigidWall {
 public:
  /// A node that supports hold along the normal, or within 6 degrees of it (what of the normal is free, squared), is
  /// left alone: it would be shot aside.
  static constexpr double least_free = 0.01;

  /// `nodes`: the tracked nodes, numbered as in the arrays of `constrain`. `motion`: the curve that
  /// `wall.motion_curve` names, or null. `bodies`: stops the nodes of rigid bodies.
  RigidWall(const model::RigidWall& wall, std::vector<int> nodes, const Curve* motion = nullptr,
            std::optional<WallPenalty> bodies = {});

  /// From now on forces are summed up apart, too: of these nodes (of the system, ascending), or of those that are
  /// stopped on a part of the face, a polygon of three or four corners (of three the last stands twice), which moves
  /// with the wall. A node on the edge of two areas counts with the first one. Gives its number.
  std::size_t sum_apart(std::vector<int> nodes);
  std::size_t sum_apart(const std::array<Vec3d, 4>& area);
  /// Force of the wall on these at `time` [force].
  const Vec3d& force_apart(std::size_t which) const { return apart_[which].force; }

  /// From the next call on it stops nodes, or none (*SENSOR_CONTROL); nodes that stayed on it are free then. It moves
  /// all the same.
  void turn(bool on);
  /// Adds the forces on nodes of rigid bodies at the end of the step to `f`.
  void press(const contact::Step& step, std::span<Row> f);

  /// Call when the velocities of the middle of the step are known, v(t + dt/2), and before nodes move to x(t + dt). `x`
  /// at `time`. `dt_previous`: the step that led to `time`; forces are impulses over the time between the two middles,
  /// (dt + dt_previous)/2. `skip` (by node; may be empty) marks nodes that the wall leaves alone: dependent ones, and
  /// those of rigid bodies. `f`: the other forces on the nodes at `time`. `fastest`: a speed that no node exceeds;
  /// nodes that cannot reach the wall for a while are then not looked at. `share`: in a run over several ranks, of
  /// which each looks at nodes that it follows. `supports`: what holds nodes beside the wall; null: nothing does.
  void constrain(double time, double dt, double dt_previous, std::span<const Row> x, std::span<Row> v,
                 std::span<const Row> f, std::span<const double> mass, std::span<const unsigned char> skip,
                 double fastest = std::numeric_limits<double>::infinity(), const system::Share* share = nullptr,
                 HeldNodes* supports = nullptr);
  /// Over several ranks: what is known of the nodes for which one answers, on its way to another one.
  void carry(int rank, const system::Share& share, system::Parcel& parcel);
  std::size_t tracked() const { return nodes_.size(); }  ///< nodes
  std::size_t awake() const;                             ///< of these, those that the last step looked at

  /// Force of the wall on the nodes at `time` [force], and the sum of its normal parts.
  /// In sub-cycling: the forces that results show are means over a period, of which this step may be the first.
  void average(double time, bool begins);
  const Vec3d& force() const { return force_; }
  double normal_force() const { return normal_force_; }
  /// Time integrals of these since the start [force*time]; differences give the mean force between two outputs.
  const Vec3d& impulse() const { return impulse_; }
  double normal_impulse() const { return normal_impulse_; }

  /// Energy that the nodes gave to the wall [energy]: minus the sum of J . (v_before + v_after)/2 over all impulses J,
  /// with the nodes' velocities in the middles of the steps before and after. For a node without other forces this is
  /// exactly its loss of kinetic energy; with other forces at work it is what is missing when each of them, too, is
  /// accounted with f . (v_before + v_after)/2 dt, so that the total closes. Includes what a moving wall gained as
  /// kinetic energy.
  double energy() const { return energy_ + (bodies_ ? bodies_->energy() : 0.0); }
  /// The same up to `time` of the last `constrain`, which stands between the two middles: the impulses of that step
  /// only with the share of their work that the kinetic energy at `time` contains (impact::kinetic_energy;
  /// docs/decisions/0002).
  double energy_at_time() const { return energy() - pending_energy_; }
  /// Kinetic energy of a wall with mass, 0 for others.
  double kinetic_energy() const { return 0.5 * mass_ * velocity_ * velocity_; }

  /// Reference point at the end of the last step (tail of the normal, point on the axis, centre).
  const Vec3d& origin() const { return origin_; }
  /// Velocity along the normal of a wall with mass, in the middle of the last step.
  double velocity() const { return velocity_; }
  int touching() const { return touching_; }  ///< nodes stopped in the last step
  /// Sum over the nodes of the other forces times what the wall changed in their velocities in the last step [power].
  double power_on_change() const { return power_on_change_; }

  void archive(Archive& a);

 private:
  struct Sum {
    Vec3d impulse;
    double normal = 0.0;
    double opening = 0.0, closing = 0.0;  // halves of the energy: with the velocities before and after
    double power_on_change = 0.0;
    int touching = 0;
    void add(const Sum& more);
  };
  /// A node that a wall with mass catches up with.
  struct Caught {
    int tracked = 0;
    kernel::WallAttachment attachment = kernel::WallAttachment::none;
    double mass = 0.0;  ///< that resists along the normal: of a held node more than its own
    Vec3d from, v;      ///< its place off the reference point, its velocity
  };
  /// What the wall does to one node in a step.
  struct Stopped {
    int tracked = 0;
    int area = model::none;  ///< in areas_
    Sum sum;
  };
  struct Step {
    double dt;
    double between_middles;  ///< of the steps before and after
    std::span<const Row> x;
    std::span<Row> v;
    std::span<const Row> f;
    std::span<const double> mass;
    std::span<const unsigned char> skip;
    Vec3d wall_velocity;
    double fastest;              ///< of the nodes
    const system::Share* share;  ///< null: one process
    HeldNodes* supports;         ///< null: none

    HeldNodes::Held held(int node) const { return supports != nullptr ? supports->held(node) : HeldNodes::Held{}; }
  };
  /// Tracked nodes side by side in the list, whose impulses are summed up together.
  struct Group {
    double asleep_until = 0.0;  ///< before `travelled_` gets here none of them can touch the wall [length]
    bool slept = false;         ///< was not looked at in the step before
    std::vector<Vec3d> last;    ///< velocities of its nodes when the wall had done with them in the step before; empty
                                ///< where it slept, or is about to
    void archive(Archive& a) { a(asleep_until, slept, last); }
  };
  /// What a step finds in a group that is awake.
  struct Found {
    double clear = std::numeric_limits<double>::infinity();  ///< way that all of its nodes have to the wall [length]
    bool attached = false;
    std::vector<Stopped> stopped;
  };

  /// A sum of its own.
  struct Apart {
    std::vector<int> nodes;  ///< of the system; empty: of an area
    int area = model::none;  ///< in areas_
    Vec3d force;
    PeriodMean mean;
    void archive(Archive& a) {
      a(force, mean);
      a.built(nodes, area);
    }
  };

  Vec3d prescribed_velocity(double time, double dt) const;
  int area_at(const Vec3d& place) const;
  void sum_up_apart(double between_middles, bool active);
  template <class Shape>
  void collide(const Shape& shape, Step& step);
  template <class Shape>
  std::vector<Caught> find_caught(const Shape& shape, const Step& step) const;
  template <class Shape>
  Sum stop(const Shape& shape, const Step& step);
  template <class Shape>
  void look_at_group(const Shape& shape, std::size_t group, const Step& step);
  template <class Shape>
  void stop(const Shape& shape, int index, Group& group, bool begins, const Step& step, std::vector<Stopped>& stopped);
  /// Over several ranks, once: the tracked nodes that this one follows.
  void list_followed(const system::Share& share);
  void share_found(const system::Share& share);
  Vec3d friction(const Vec3d& slip, double normal_change) const;

  bool acts(double time) const { return on_ && time >= birth_ && time < death_; }

  kernel::WallShape shape_;
  Vec3d origin_, normal_;
  double friction_ = 0.0, weld_velocity_ = 0.0;
  double mass_ = 0.0, velocity_ = 0.0;
  std::optional<Curve> motion_;
  bool motion_is_displacement_ = false;
  Vec3d motion_direction_;
  Vec3d wall_velocity_;  // in the last step
  double birth_ = 0.0, death_ = 0.0;
  bool on_ = true;

  std::vector<int> nodes_;                          // tracked
  std::vector<kernel::WallAttachment> attachment_;  // of each of them
  std::vector<Group> groups_;                       // of tracked nodes
  std::vector<Found> found_;                        // by group
  std::vector<int> followed_;                       // over several ranks: tracked nodes, and
  std::vector<std::size_t> first_followed_;         // where those of each group begin and the last one's end
  system::GatheredLists<Stopped> stopped_of_ranks_;
  double travelled_ = 0.0;  // by how much a node can have come closer to the wall since the start, at most
  bool started_ = false;    // Group::last holds
  std::optional<WallPenalty> bodies_;

  std::vector<Apart> apart_;
  std::vector<std::array<Vec3d, 4>> areas_;  ///< corners off the reference point

  PeriodMean mean_force_, mean_normal_;
  Vec3d force_, impulse_;
  double normal_force_ = 0.0, normal_impulse_ = 0.0, energy_ = 0.0, pending_energy_ = 0.0, power_on_change_ = 0.0;
  int touching_ = 0;
};

}  // namespace nugget::contact
