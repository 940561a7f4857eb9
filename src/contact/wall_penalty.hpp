// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/row.hpp"
#include "contact/step.hpp"
#include "kernel/contact/penalty.hpp"
#include "kernel/contact/wall.hpp"
#include "model/loads.hpp"
#include "system/system.hpp"

namespace nugget::contact {

/// A rigid wall against the nodes of rigid bodies, by penalty (keyword manual, *CONTROL_CONTACT, RWPNAL > 0: nodes of
/// rigid bodies by a penalty method with that scale, all others by the constraint method).
///
/// Each node that has come through the face draws a spring between itself and its place on the face: where it would
/// stand if the wall had stopped it, as kernel::push() has it for all shapes. The manual names no stiffness; ours:
///     k_i = c M/dt^2 w_i/(1 + R),   c = RWPNAL/10, at most 1/2,
/// M the mass of the body, w_i shares of the nodes that the wall sees, with sum 1: by their own masses, but between a
/// tenth and all of the mean one. R bounds how much more the springs turn the body than they shift it: a bound of the
/// largest eigenvalue of M I^-1 sum w_i (r_i^2 1 - r_i r_i^t), system::Mobility::largest(), the same however the body
/// lies in the global axes. So all springs together have w^2 dt^2 <= c, whatever is touching;
/// the stability limit of central differences is 4. A wall with mass adds (M of all bodies)/(mass of the wall) to 1 +
/// R. A node keeps its stiffness as long as it touches. The springs give back what they took: kernel::spring_force(),
/// with the mass that the body shows at that point, 1/m = 1/M + (r x n) I^-1 (r x n).
///
/// Friction (FRIC): Coulomb's law, at most what ends the node's sliding within a cycle, shared by all nodes
/// of the body that touch; 1 and 3 the latter alone; 2 none. A node is not welded to the wall (WVEL).
class WallPenalty {
 public:
  /// Takes those of `nodes` (of the system) that rigid bodies carry. The system must outlive it.
  WallPenalty(const system::System& system, const model::RigidWall& wall, const std::vector<int>& nodes, double scale);

  bool empty() const { return touches_.empty(); }

  /// Adds forces on nodes at the end of the step to `f` [force]. `origin`: the wall's reference point then;
  /// `velocity`: that of the wall in the step.
  void apply(const Step& step, const kernel::WallShape& shape, const Vec3d& origin, const Vec3d& velocity,
             std::span<Row> f);
  /// The wall does not act: no node touches, forces are 0.
  void release();

  /// Force on the nodes [force], and the sum of its normal parts.
  const Vec3d& force() const { return force_; }
  double normal_force() const { return normal_force_; }
  /// Energy that the nodes gave to springs, friction and the wall's motion so far [energy].
  double energy() const { return energy_; }
  int touching() const { return touching_; }
  /// f(node, its place on the face from the wall's reference point, the force on it), of all that are pressed.
  template <class F>
  void for_each_force(const F& f) const {
    for (const Touch& t : touches_)
      if (dot(t.force, t.force) > 0.0) f(t.node, t.place, t.force);
  }

  void archive(Archive& a);

 private:
  struct Touch {
    int node = 0, body = 0;  ///< the latter in System::bodies
    double share = 0.0;      ///< of M/dt^2, before c
    bool touching = false;
    double depth = 0.0, stiffness = 0.0;
    Vec3d place;  ///< on the face, from the wall's reference point
    Vec3d normal, force;
    kernel::PairMemory memory;
  };

  void share_out(double wall_mass);
  template <class Shape>
  void find(const Step& step, const Shape& shape, const Vec3d& origin, const Vec3d& velocity);
  void press(Touch& touch, const Step& step, const Vec3d& velocity) const;

  const system::System& system_;
  double scale_, friction_, inverse_wall_mass_;
  std::vector<Touch> touches_;
  std::vector<int> touching_of_;  ///< by body: nodes that touch
  Vec3d force_;
  double normal_force_ = 0.0, energy_ = 0.0;
  int touching_ = 0;
};

}  // namespace nugget::contact
