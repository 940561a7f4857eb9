// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nvh/reach.hpp"
#include "nvh/sparse.hpp"
#include "system/system.hpp"

namespace nugget::nvh {

/// A joint between two rigid bodies at rest: the relative motions that it holds, each as a row over the twelve freedoms
/// of the bodies' virtual nodes. Displacements of B's point against that of A, all of them, across an axis of A or
/// along it; rotations that would turn directions of the two bodies off each other. The same as in impact
/// (impact/joints.hpp), to first order.
struct JointRows {
  using Row = std::array<double, 12>;
  std::array<int, 2> node{};
  std::vector<Row> displacements, rotations;
  double scale = 1.0;  ///< RPS
  double reach = 0.0;  ///< size of the larger body, seen from the joint
};
std::vector<JointRows> joint_rows(const system::System& system);

/// Adds the joints to the stiffness of all elements, as springs that are `joint_share` times as stiff as what already
/// holds the stiffer of the two bodies (rotations: at least those displacements times reach^2), or as the stiffest of
/// all where nothing holds them: the compliance of a joint is a hundred-thousandth of that of the structure around it.
/// The pattern must contain the unknowns of each joint's nodes.
void add_joints(const std::vector<JointRows>& joints, const Equations& equations, Symmetric& stiffness);
inline constexpr double joint_share = 1e5;

}  // namespace nugget::nvh
