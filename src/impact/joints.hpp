// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/archive.hpp"
#include "impact/joint_springs.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Joints between rigid bodies, by penalty (what LS-DYNA does by default). A joint is made of up to three pieces,
/// each a spring with a damper:
///     point      f = -k P u - c P u',  u the distance of B's point from A's, P: all of it, its part across the axis a
///                of A (cylindrical, translational) or its part along a (planar)
///     axis       M = k (a . b) a x b, which lets the axes a of A and b of B be parallel; a universal joint's are to be
///                perpendicular: M = -k (a . b) a x b
///     lock       the same as `axis`, for a second direction off the first (translational, locking)
/// Forces act on both bodies at the place of B's point and moments are opposite, so momentum and angular momentum are
/// kept to round-off. What resists in a joint's free directions are JointSprings.
///
/// Stiffness: with G the inverse mass that a piece's relative motion meets, when each body shares its mass evenly among
/// the pieces at it, k = RPS beta / (dt^2 tr(G)), beta = 1/4: all pieces together have omega dt <= 1/2, well
/// inside the 2 of central differences. dt is the longest step so far, so k never rises in a run. Damping ratio 0.1
/// DAMP. Both are PROJECT: LS-DYNA documents that its stiffness follows from masses and step, not how.
class Joints {
 public:
  explicit Joints(const system::System& system);

  bool empty() const { return joints_.empty() && springs_.empty(); }
  /// Adds the forces at state.time to the bodies, and books their work over the step that ends there.
  void apply(system::State& state);
  /// Stored in joints and lost in them: minus the work of their forces [energy].
  double energy() const;
  /// The longest step that stiffnesses of joints bear; the joints themselves follow the step [time].
  double stable_step() const { return springs_.stable_step(); }

  std::size_t size() const { return joints_.size(); }
  /// On body B at the joint, global axes.
  const Vec3d& force(std::size_t joint) const { return joints_[joint].force; }
  const Vec3d& moment(std::size_t joint) const { return joints_[joint].moment; }
  double energy(std::size_t joint) const { return joints_[joint].energy; }
  const JointSprings& springs() const { return springs_; }
  /// Distance of B's point from A's, in the directions that the joint holds, and the largest so far.
  double opening(std::size_t joint) const { return joints_[joint].opening; }
  double largest_opening(std::size_t joint) const { return joints_[joint].largest_opening; }

  void archive(Archive& a);

 private:
  enum class Held { all, across, along };  ///< of the distance between the points
  /// A direction of each body, in its own axes at time 0.
  struct Directions {
    Vec3d a, b;
    bool perpendicular = false;
  };
  struct Load {
    Vec3d force, moment;
  };
  struct Joint {
    const model::Joint* source = nullptr;
    std::array<const system::RigidBody*, 2> body{};
    std::array<Vec3d, 2> arm;  ///< of the point, in body axes
    Vec3d axis;                ///< a, in A's axes
    Held held = Held::all;
    std::vector<Directions> directions;
    double bound = 0.0, rotary_bound = 0.0;      ///< k dt^2
    double damping = 0.0, rotary_damping = 0.0;  ///< c dt
    Vec3d force, moment;                         ///< on B, at its point
    std::array<Load, 2> load;                    ///< on the bodies' centres
    double energy = 0.0, opening = 0.0, largest_opening = 0.0;
    void archive(Archive& a);
  };
  void find_bounds();
  void apply(Joint& joint, system::State& state, double longest_step);

  const system::System& system_;
  std::vector<Joint> joints_;
  JointSprings springs_;
  double longest_step_ = 0.0;
};

}  // namespace nugget::impact
