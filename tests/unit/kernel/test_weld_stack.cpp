// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/weld_stack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion.hpp"

// Sheets of a stack that flow by all its welds. Reference answers: a rigid disc in a plate by CalculiX (C3D20R,
// docs/theory/ties.md#joints-of-stacks), the law of a single weld, and the yield condition written out again.
namespace nugget::kernel {
namespace {

constexpr double E = 210000.0, nu = 0.3, diameter = 6.0, thickness = 1.5, yield = 300.0, stiffness = 1.5e6;
constexpr double unit_force = diameter * thickness * yield;
using Freedoms = WeldJoint::Freedoms;

JointEnd sheet(double hardening, double reach = 50.0) {
  return {E, nu, thickness, diameter, reach, {.x = {0.0, 1.0}, .y = {yield, yield + hardening}}, {}};
}

/// A stack whose welds are springs of one stiffness.
struct Stack {
  explicit Stack(std::vector<std::optional<JointEnd>> sheets)
      : law(sheets), state(law.sheets()), force(law.welds()), slipped(law.welds()), holds(law.welds(), true) {}
  void step(const std::vector<Freedoms>& moved) {
    std::vector<StackJoint::Weld> welds(law.welds());
    for (std::size_t w = 0; w < welds.size(); ++w) {
      welds[w].trial = {force[w], {stiffness, stiffness, stiffness, stiffness, stiffness}};
      for (std::size_t i = 0; i < WeldJoint::size; ++i) welds[w].trial.force[i] += stiffness * moved[w][i];
      welds[w].holds = holds[w];
    }
    std::vector<Freedoms> flow(law.welds());
    law.advance(state, welds, 1.0, flow);
    for (std::size_t w = 0; w < welds.size(); ++w)
      for (std::size_t i = 0; i < WeldJoint::size; ++i) {
        if (holds[w]) force[w][i] = welds[w].trial.force[i] - stiffness * flow[w][i];
        slipped[w][i] += flow[w][i];
      }
  }
  StackJoint law;
  std::vector<StackJoint::SheetState> state;
  std::vector<Freedoms> force, slipped;
  std::vector<bool> holds;
};

// Rigid disc of 6 mm in a plate of 1.5 mm: forces over d t yield stress at slips over d, of plates that harden by 0.1,
// 1, 4 and 10 yield stresses a unit of plastic strain.
TEST(WeldStack, PulledTheSameWayASheetYieldsAsAroundARigidDisc) {
  struct Case {
    double hardening, slip, force;
  };
  for (const Case& c : {Case{0.1, 0.0223, 3.414},
                        {1.0, 0.0341, 3.772},
                        {1.0, 0.0893, 4.234},
                        {4.0, 0.0311, 4.631},
                        {4.0, 0.0823, 5.831},
                        {10.0, 0.0365, 5.978},
                        {10.0, 0.0855, 7.908}}) {
    Stack stack({std::nullopt, sheet(c.hardening * yield), std::nullopt});
    while (stack.slipped[0][1] < c.slip * diameter) stack.step({{0, 2e-4, 0, 0, 0}, {0, -2e-4, 0, 0, 0}});
    const double force = stack.force[0][1] - stack.force[1][1];
    EXPECT_NEAR(force / unit_force, c.force, 0.04 * c.force) << c.hardening << " at " << c.slip;
    EXPECT_NEAR(stack.slipped[0][1], -stack.slipped[1][1], 1e-12);
  }
}

// One weld alone, or one whose other has failed, free to turn as the eccentric pull wants: as WeldJoint with that end
// only, elastic part and all.
TEST(WeldStack, ASheetThatOneWeldPullsIsThatOfASingleWeld) {
  const JointEnd end = sheet(4.0 * yield);
  const WeldJoint single(std::array{end});
  WeldJoint in_stack = single;
  in_stack.flow_from_outside();
  const Freedoms k{stiffness, stiffness, stiffness, 1e-6, 1e-6}, moved{1e-5, 2e-4, 1e-4, 0, 0};
  for (const bool has_failed : {false, true}) {
    const StackJoint law(has_failed ? std::vector<std::optional<JointEnd>>{std::nullopt, end, std::nullopt}
                                    : std::vector<std::optional<JointEnd>>{std::nullopt, end});
    std::vector<StackJoint::SheetState> sheets(law.sheets());
    WeldJoint::State alone, state;
    Freedoms force_alone{}, force{};
    for (int i = 0; i < 400; ++i) {
      const Freedoms beam_alone = single.advance(alone, moved, k, force_alone, 1.0);
      std::vector<StackJoint::Weld> welds(law.welds());
      welds[0].trial = in_stack.trial(state, moved, k, force);
      if (has_failed) welds[1] = {.trial = {{1e6, 1e6, 1e6, 1e6, 1e6}, k}, .holds = false};
      std::vector<Freedoms> flow(law.welds());
      law.advance(sheets, welds, 1.0, flow);
      state.flow = flow[0];
      const Freedoms beam = in_stack.advance(state, moved, k, force, 1.0);
      for (std::size_t j = 0; j < WeldJoint::size; ++j) {
        force_alone[j] += k[j] * beam_alone[j];
        force[j] += k[j] * beam[j];
      }
    }
    EXPECT_GT(alone.work, 100.0);
    EXPECT_NEAR(force[1], force_alone[1], 1e-8 * force_alone[1]);
    EXPECT_NEAR(sheets[1].work, alone.work, 1e-8 * alone.work);
  }
}

// What goes through from outside to outside does not load a free sheet between: the couple of the shear forces over its
// thickness is that of the moments, with the other sign. 1.5 d t yield stress, near where a lap yields.
TEST(WeldStack, LoadThatGoesThroughSparesTheMiddle) {
  const auto worked = [](double moment) {
    Stack stack({std::nullopt, sheet(4.0 * yield), std::nullopt});
    for (int i = 0; i < 28; ++i) stack.step({{0, 1e-4, 0, 0, moment * 1e-4}, {0, 1e-4, 0, 0, -moment * 1e-4}});
    return stack.state[1].work;
  };
  EXPECT_EQ(worked(0.5 * thickness), 0.0);
  EXPECT_GT(worked(-0.5 * thickness), 1.0);
}

// Three welds between four sheets of which all flow, loads of all kinds: the yield condition written out again.
TEST(WeldStack, YieldConditionsHold) {
  Random random;
  const std::vector<JointEnd> ends{sheet(1000.0, 3.0), sheet(300.0, 2.0), sheet(2000.0, 4.0), sheet(500.0, 3.0)};
  Stack stack({ends[0], ends[1], ends[2], ends[3]});
  int flowed = 0;
  for (int cycle = 0; cycle < 500; ++cycle) {
    std::vector<Freedoms> moved(3);
    for (Freedoms& m : moved) {
      const Vec3d a = random.vector(0.003), b = random.vector(0.003);
      m = {a.x, a.y, a.z, b.x, b.y};
    }
    const std::vector<StackJoint::SheetState> before = stack.state;
    stack.step(moved);
    for (std::size_t s = 0; s < 4; ++s) {
      const WeldJoint law(std::span(&ends[s], 1));
      const auto [n0, v0, m0] = law.limits(stack.state[s].work);
      const double u0 = YieldCurve(unbent_shear_over_work(ends[s]))(stack.state[s].work);
      const double d0 = 1.0 / std::sqrt(1.0 / (v0 * v0) - 1.0 / (u0 * u0));
      Freedoms sum{};
      double couple_s = 0.0, couple_t = 0.0;
      for (std::size_t w = 0; w < 3; ++w) {
        if (w != s && w + 1 != s) continue;
        const double sign = w == s ? -1.0 : 1.0;
        const Freedoms& f = stack.force[w];
        sum[0] += sign * std::max(0.0, f[0]) / n0;
        sum[1] += sign * f[1] / u0;
        sum[2] += sign * f[2] / u0;
        couple_s += sign * f[3] / m0 + f[2] / d0;
        couple_t += sign * f[4] / m0 - f[1] / d0;
      }
      const double used =
          std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2] + couple_s * couple_s + couple_t * couple_t);
      EXPECT_GE(stack.state[s].work, before[s].work);
      EXPECT_LE(used, 1.0 + 1e-8) << s << " in " << cycle;
      if (stack.state[s].work > before[s].work) {
        EXPECT_NEAR(used, 1.0, 1e-8) << s << " in " << cycle;
        ++flowed;
      }
    }
  }
  EXPECT_GT(flowed, 100);
}

}  // namespace
}  // namespace nugget::kernel
