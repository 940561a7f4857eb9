// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/stack_joints.hpp"

#include <array>
#include <span>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::impact {
namespace {

using Freedoms = kernel::WeldJoint::Freedoms;

/// Freedoms of a weld in the axes of its stack: r' runs from the first sheet to the last, s' lies as the first weld's s
/// does. A weld that runs the other way has its ends changed.
class InStack {
 public:
  InStack(const Frame3d& axes, bool reversed, const Vec3d& side) {
    const double sign = reversed ? -1.0 : 1.0;
    const Vec3d along = sign * axes.e1, s = unit(side - dot(side, along) * along), t = cross(along, s);
    across_ = {sign * dot(s, axes.e2), sign * dot(s, axes.e3), sign * dot(t, axes.e2), sign * dot(t, axes.e3)};
  }
  Freedoms to(const Freedoms& own) const {
    return {own[0], across_[0] * own[1] + across_[1] * own[2], across_[2] * own[1] + across_[3] * own[2],
            across_[0] * own[3] + across_[1] * own[4], across_[2] * own[3] + across_[3] * own[4]};
  }
  Freedoms from(const Freedoms& stack) const {
    return {stack[0], across_[0] * stack[1] + across_[2] * stack[2], across_[1] * stack[1] + across_[3] * stack[2],
            across_[0] * stack[3] + across_[2] * stack[4], across_[1] * stack[3] + across_[3] * stack[4]};
  }

 private:
  std::array<double, 4> across_;
};

}  // namespace

StackJoints::StackJoints(system::System& system, BrickJoints& bricks) : bricks_(bricks) {
  for (const weld::Stack& source : system.weld_stacks) {
    Stack& stack = stacks_.emplace_back(Stack{kernel::StackJoint(source.sheets), {}, {}});
    stack.state.resize(stack.law.sheets());
    for (const weld::Stack::Member& member : source.welds) {
      const weld::Weld& weld = system.ties.welds[member.weld];
      Member& own = stack.members.emplace_back(Member{member.reversed});
      if (weld.of_bricks()) {
        own.element = bricks.of(member.weld).value();
        continue;
      }
      const system::System::ElementLocation location = system.location_of(weld, weld.element);
      own.beams = dynamic_cast<system::JoinedBeams*>(system.groups[location.group].get());
      own.element = at(location.element);
    }
  }
}

void StackJoints::flow(const system::State& state) {
  if (state.dt == 0.0) return;
  parallel_for(stacks_.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) flow(stacks_[i], state);
  });
}

void StackJoints::flow(Stack& stack, const system::State& state) {
  std::array<kernel::WeldTrial, kernel::StackJoint::most_welds> met;
  std::array<kernel::StackJoint::Weld, kernel::StackJoint::most_welds> welds;
  std::array<Freedoms, kernel::StackJoint::most_welds> flow{};
  const std::size_t count = stack.members.size();
  Vec3d side;
  for (std::size_t w = 0; w < count; ++w) {
    const Member& member = stack.members[w];
    if (member.beams != nullptr)
      member.beams->joint_trial(member.element, state, met[w]);
    else
      met[w] = bricks_.trial(member.element);
    welds[w] = {{}, met[w].holds};
    if (!met[w].holds) continue;
    if (norm(side) == 0.0) side = met[w].axes.e2;
    const InStack axes(met[w].axes, member.reversed, side);
    welds[w].trial = {axes.to(met[w].trial.force), met[w].trial.stiffness};
  }
  stack.law.advance(stack.state, std::span(welds).first(count), state.dt, std::span(flow).first(count));
  for (std::size_t w = 0; w < count; ++w) {
    if (!met[w].holds) continue;
    const Member& member = stack.members[w];
    const Freedoms own = InStack(met[w].axes, member.reversed, side).from(flow[w]);
    if (member.beams != nullptr)
      member.beams->set_joint_flow(member.element, own);
    else
      bricks_.set_flow(member.element, own);
  }
}

void StackJoints::Stack::archive(Archive& a) {
  a(state);
  a.built(law, members);
}

void StackJoints::archive(Archive& a) {
  a(stacks_);
  a.built(bricks_);
}

}  // namespace nugget::impact
