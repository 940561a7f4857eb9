// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/element/weld_joint.hpp"
#include "weld/tie/ties.hpp"

// The joints that welds get with --weld-tie joint: what the sheet around each end lacks on its mesh
// (docs/theory/ties.md#joint).
namespace nugget::weld {

/// What is known of the sheets of a weld: one an end that is tied by area to shells that deform, in their order. Of
/// bricks an end is a face, its nodes on one disc.
std::vector<kernel::JointEnd> joint_ends(const model::Model& model, const Ties& ties, const Weld& weld);

/// The joint of a weld.
struct Joint {
  kernel::WeldJoint law;
  /// Of a weld of bricks: how much of the joint's motion there is between the face of each end and its sheet. A half
  /// each; all at one where the other's nodes do not follow a disc by a constraint, or belong to another weld as well.
  std::array<double, 2> share{0.5, 0.5};
  /// Of both ends; nothing where the end is no sheet that deforms.
  std::array<std::optional<kernel::JointEnd>, 2> end;
};
/// The joints of all welds. Nothing where Control::weld_tie asks for none, for welds that are neither beam nor bricks
/// of spot-weld material, where no end is tied by area to shells that deform, and for the bricks that `report_joints`
/// names.
std::vector<std::optional<Joint>> joints_of(const model::Model& model, const Ties& ties);

/// Welds that follow each other through a stack of sheets: at each sheet between, two of them end at one place, from
/// either side.
struct Stack {
  struct Member {
    std::size_t weld;  ///< in Ties::welds
    bool reversed;     ///< its first end is at the later of its two sheets
  };
  std::vector<Member> welds;  ///< from the first sheet to the last
  /// The sheets, one more; nothing where an end is no sheet that deforms.
  std::vector<std::optional<kernel::JointEnd>> sheets;
};
/// Of welds with joints that flow. Their joints flow by what the stack says (kernel::StackJoint).
struct JointStacks {
  std::vector<Stack> stacks;
  std::vector<std::size_t> crowded;  ///< welds at a nugget of more than two, or in a stack too high; each on its own
};
JointStacks stacks_of(const model::Model& model, const Ties& ties, const std::vector<std::optional<Joint>>& joints);

/// A note of what the joints of all welds come to, a warning of welds of bricks that get none, by the reason.
void report_joints(const model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld
