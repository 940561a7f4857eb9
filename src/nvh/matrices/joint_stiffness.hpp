// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nvh/matrices/dof_map.hpp"
#include "nvh/matrices/sparse.hpp"
#include "system/system.hpp"

namespace nugget::nvh {

/// A relative motion of two rigid bodies at rest against which something between them resists.
struct ConstrainedMotion {
  using Row = std::array<double, 12>;
  Row row{};  ///< over the freedoms of the bodies' virtual nodes: how much of it is in a motion of these
  Vec3d direction;
  bool rotation = false;
  double spring = 0.0;   ///< [force/length], [force length]
  double dashpot = 0.0;  ///< [force time/length], [force length time]
  double start = 0.0;    ///< internal force at time 0, which a spring has that does not begin at 0
};

/// What holds two rigid bodies together. Of *CONSTRAINED_JOINT_...: displacements of B's point against that of A, all
/// of them, across an axis of A or along it; rotations that would turn directions of the two bodies off each other. The
/// same as in impact (impact/joints.hpp), to first order. Of *CONSTRAINED_JOINT_STIFFNESS: displacements of B's origin
/// and rotations along the axes, with the slopes of the curves at rest (those of dampers too), and the stiffness of
/// friction, which sticks.
struct BodyLink {
  std::array<int, 2> node{};
  std::array<Vec3d, 2> arm;  ///< from the centres of the bodies to where its forces act
  std::vector<ConstrainedMotion> constrained;
  bool rigid = false;      ///< a joint: springs by `stiffen_joints`
  double scale = 1.0;      ///< RPS
  double body_size = 0.0;  ///< size of the larger body, seen from the joint

  /// Of the twelve freedoms, row-major.
  std::vector<double> stiffness() const;
  std::vector<double> viscosity() const;
  bool damps() const;
  /// Force and moment on B at its point, in a motion of the twelve freedoms.
  SixDof on_second(const ConstrainedMotion::Row& motion) const;
  double energy(const ConstrainedMotion::Row& motion) const;  ///< elastic, in such a motion
};
/// Joints in the order of the model, then the stiffnesses of joints.
std::vector<BodyLink> body_links(const system::System& system);

/// Gives joints their springs, which are `joint_share` times as stiff as what already holds the stiffer of the two
/// bodies (rotations: at least those displacements times reach^2), or as the stiffest of all where nothing holds them:
/// the compliance of a joint is a hundred-thousandth of that of the structure around it. `stiffness`: of all elements.
void stiffen_joints(std::vector<BodyLink>& links, const Equations& equations, const Symmetric& stiffness);
inline constexpr double joint_share = 1e5;

}  // namespace nugget::nvh
