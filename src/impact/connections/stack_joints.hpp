// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "base/archive.hpp"
#include "impact/connections/brick_joints.hpp"
#include "kernel/element/weld_stack.hpp"
#include "system/joined_beams.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The joints of welds that follow each other through a stack of sheets, while the model moves: how their sheets flow
/// by the forces of all of them. The welds may be beams or bricks.
class StackJoints {
 public:
  /// Both must outlive it.
  StackJoints(system::System& system, BrickJoints& bricks);

  bool empty() const { return stacks_.empty(); }
  /// Once a cycle, between BrickJoints::meet and BrickJoints::slide.
  void flow(const system::State& state);
  void archive(Archive& a);

 private:
  struct Member {
    bool reversed;
    system::JoinedBeams* beams = nullptr;  ///< the group of a weld beam, else
    std::size_t element = 0;               ///< of the group, or the joint in BrickJoints
  };
  struct Stack {
    kernel::StackJoint law;
    std::vector<Member> members;
    std::vector<kernel::StackJoint::SheetState> state;
    void archive(Archive& a);
  };
  void flow(Stack& stack, const system::State& state);

  BrickJoints& bricks_;
  std::vector<Stack> stacks_;
};

}  // namespace nugget::impact
