// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "base/archive.hpp"
#include "impact/connections/joint_springs.hpp"
#include "impact/energy/energy.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Joints between rigid bodies, by penalty (what LS-DYNA does by default). A joint is made of up to three pieces,
/// each a spring with a damper:
///     point      f = -k P u - c P u',  u the distance of B's point from A's, P: all of it, its part across the axis a
///                of A (cylindrical, translational) or its part along a (planar)
///     axis       M = k (a . b) a x b, which lets the axes a of A and b of B be parallel; a universal joint's are to be
///                perpendicular: M = -k (a . b) a x b
///     lock       the same as `axis`, for a second direction off the first (translational, locking)
/// A joint that transmits is one piece more, which keeps a ratio: with the rate
///     gears            g = w_A.a / rho + w_B.b     the spins in space about the axes of A and B; rho = R2/R1. Where
///     the
///                                                  axes point against each other, w_A.a counts with the other sign
///     pulley           g = -w_A.a / rho + w_B.b    likewise
///     rack and pinion  g = (v_B - v_A).b - h w_A.a of the two points; b the rack's way
///     screw            g = (v_B - v_A).a - p (w_A - w_B).a, of the two bodies at the place of B's point
/// and phi its integral over time, lambda = k phi + c g, the load on each velocity is -lambda dg/d(velocity).
/// Forces act on both bodies at the place of B's point and moments are opposite, so momentum and angular momentum are
/// kept to round-off. What resists in a joint's free directions are JointSprings.
///
/// A joint with *_FAILURE is released permanently from TFAIL on, or from when the load that it would carry in the axes
/// of CID reaches sum (N_i / N_iF)^2 + sum (M_i / M_iF)^2 >= 1, both sums together (COUPL up to 0) or each apart. What
/// it stored by then stays in its energy, as lost. Ours: components count with both signs.
///
/// Stiffness: with G the inverse mass that a piece's relative motion meets, when each body shares its mass evenly among
/// the pieces at it, k = RPS beta / (dt^2 tr(G)), beta = 1/4: all pieces together have omega dt <= 1/2, well
/// inside the 2 of central differences. dt is the longest step so far, so k never rises in a run. Damping ratio 0.1
/// DAMP. Both are ours: LS-DYNA documents that its stiffness follows from masses and step, not how. In a model without
/// deformable elements the step is shortened while joints open too far (`follow`), and their stiffness rises with it.
///
/// Becoming stiffer makes no energy: with E what the springs would hold at the new stiffness, a joint's springs have a
/// share s of their forces, such that s^2 E is what the joint has taken so far, until s reaches 1. That is a spring
/// from where it could hold what it took, and as that counts what damping took as well, the points come together by it.
class Joints {
 public:
  explicit Joints(const system::System& system);

  bool empty() const { return joints_.empty() && springs_.empty(); }
  /// Adds the forces at state.time to the bodies, and books their work over the step that ends there.
  void apply(system::State& state);
  /// Stored in joints and lost in them: minus the work of their forces [energy].
  double energy() const;
  /// The longest step at which stiffnesses of joints are stable; the joints themselves follow the step [time].
  double stable_step() const { return springs_.stable_step(); }
  /// From now on the joints are as stiff as a step allows that is shorter than those before.
  void follow(double step) { longest_step_ = std::min(longest_step_, step); }
  /// The step at which joints open by the share `opening` of their bodies' size under what accelerates the bodies apart
  /// now: loads, and their spins; infinite where nothing does [time].
  double step_for(double opening, const system::State& state) const;
  /// The largest opening now over the size of the joint's bodies: the smaller of their levers to the joint, or radii of
  /// gyration where these are more [1]; of a joint that is becoming stiffer the share of it that its springs see.
  /// Joints that transmit do not count.
  double relative_opening() const;
  /// The same of one joint, its largest so far.
  double largest_relative_opening(std::size_t joint) const;

  std::size_t size() const { return joints_.size(); }
  /// On body B at the joint, global axes.
  const Vec3d& force(std::size_t joint) const { return joints_[joint].force; }
  const Vec3d& moment(std::size_t joint) const { return joints_[joint].moment; }
  double energy(std::size_t joint) const { return joints_[joint].energy; }
  bool failed(std::size_t joint) const { return joints_[joint].failed; }
  double failure_time(std::size_t joint) const { return joints_[joint].failure_time; }
  const JointSprings& springs() const { return springs_; }
  /// Distance of B's point from A's, in the directions that the joint holds, and the largest so far.
  double opening(std::size_t joint) const { return joints_[joint].opening; }
  double largest_opening(std::size_t joint) const { return joints_[joint].largest_opening; }

  void add_energy(Energy& sum) const { sum.internal += energy(); }
  void archive(Archive& a);

 private:
  enum class ConstrainedDirections { all, across, along };  ///< of the distance between the points
  /// A direction of each body, in its own axes at time 0.
  struct Directions {
    Vec3d a, b;
    bool perpendicular = false;
  };
  struct Load {
    Vec3d force, moment;
  };
  /// Where a joint's bodies are and how they move: of each its lever to its point in space, the point, its velocity and
  /// the body's spin.
  struct Motion {
    std::array<Vec3d, 2> arm, point, velocity, spin;
    Vec3d axis, gap, sliding, turning;  ///< a; B against A: points, velocity at B's point, spin
  };
  struct Joint {
    const model::Joint* source = nullptr;
    std::array<const system::RigidBody*, 2> body{};
    std::array<Vec3d, 2> arm;  ///< of the point, in body axes
    Vec3d axis, other;         ///< a, in A's axes; b of joints that transmit, in B's
    ConstrainedDirections constrained = ConstrainedDirections::all;
    std::vector<Directions> directions;
    std::array<int, 2> pieces{};  ///< at each body, of all joints
    double give = 0.0;            ///< trace of the inverse mass of A where the force meets it, by which it is bounded
    double bound = 0.0, rotary_bound = 0.0;      ///< k dt^2
    double damping = 0.0, rotary_damping = 0.0;  ///< c dt
    Vec3d force, moment;                         ///< on B, at its point
    std::array<Load, 2> load;                    ///< on the bodies' centres
    double size = 0.0;                           ///< of the smaller body; 0 of joints that transmit
    double slip = 0.0;                           ///< phi of a joint that transmits
    double step = 0.0;                           ///< for which it is stiff [time]
    bool stiffening = false;                     ///< its springs have a share of their forces only
    double share = 1.0;                          ///< which
    double most_energy = 0.0;                    ///< that it ever had taken
    double energy = 0.0, opening = 0.0, largest_opening = 0.0;
    bool failed = false;
    double failure_time = 0.0;
    void archive(Archive& a);
  };
  void find_bounds();
  /// Bounds and damping, by `pieces` and `give`.
  static void set_bounds(Joint& joint);
  /// Softens a joint whose bodies slide apart: its force meets A farther out.
  static void follow_slide(Joint& joint, const Motion& motion);
  /// Lever of the place where the joint's force meets a body, in body axes, at time 0.
  static Vec3d met_at(const Joint& joint, std::size_t side);
  void apply(Joint& joint, system::State& state);
  /// Takes up the step and finds the share of the springs' forces. `squared`: twice E times the square of the step;
  /// `giving`: what the springs would give in a step with all of their forces [energy].
  static void take_step(Joint& joint, double squared, double step, double giving);
  /// Whether a joint fails now, under its force and moment.
  bool fails(const Joint& joint, const system::State& state) const;
  // Loads on the bodies' centres; they leave force, moment and opening in the joint.
  static std::array<Load, 2> constraint_load(Joint& joint, const Motion& motion, double longest_step, double dt);
  static std::array<Load, 2> transmit(Joint& joint, const Motion& motion, double longest_step, double dt);

  const system::System& system_;
  std::vector<Joint> joints_;
  JointSprings springs_;
  double longest_step_ = 0.0;
};

}  // namespace nugget::impact
