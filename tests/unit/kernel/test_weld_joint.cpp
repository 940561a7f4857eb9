// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "kernel/element/weld_beam.hpp"
#include "motion.hpp"
#include "one_element.hpp"

// Joints in series with weld beams. Reference answers: Kelvin's and the plate's closed forms by hand, and the
// prototype's measured loads (docs/theory/ties.md#joint).
namespace nugget::kernel {
namespace {

using L = WeldBeamLayout;
constexpr double E = 210000.0, nu = 0.3, length = 1.5, diameter = 6.0, thickness = 1.5, yield = 300.0;
constexpr double axial = 3.95841e6, shear = 1.52246e6, bend = 8.90642e6;  // test_weld_beam.cpp

/// Two like sheets, hardening as those did on which the loads were measured.
WeldJoint joint(double reach, bool plastic = true, double hardening = 4.0 * yield) {
  JointEnd end{E, nu, thickness, diameter, reach, {}, {}};
  if (plastic) end.yield = {.x = {0.0, 1.0}, .y = {yield, yield + hardening}};
  const std::array<JointEnd, 2> ends{end, end};
  return WeldJoint(ends);
}

Spotweld elastic_weld() {
  Spotweld law;
  law.E = E;
  law.nu = nu;
  law.yield = 1e9;
  return law;
}

WeldBeamProperties round_beam(int quadrature) {
  WeldBeamProperties beam;
  beam.density = 7.8e-9;
  beam.fibres = disc_fibres(diameter, 0.0, quadrature);
  return beam;
}

struct Joined {
  WeldBeamProperties beam = round_beam(2);
  LawKernel<Spotweld> law{elastic_weld()};
  NodalMotion<double, 2> nodes;
  NodalForces<double, 2> force{};
  std::vector<double> state;
  WeldBeamLayout layout;

  explicit Joined(const WeldJoint& joint) {
    beam.joints = {joint};
    layout = weld_beam_layout(beam, law);
    state.resize(at(layout.size()));
    nodes.x[1] = {0.0, 0.0, length};
    start_weld_beam(layout, {}, {0, 0, length}, {1, 0, 0}, state.data(), 1, 0);
  }
  void step(double dt) {
    advance(nodes, dt);
    force = one_element(nodes, state,
                        [&](const auto& all, double* store) { return weld_beam_cycle(beam, law, all, dt, store); });
  }
  double resultant(int i) const { return state[at(L::resultant + i)]; }
  double work() const { return state[at(layout.joint_work())]; }
};

TEST(WeldJoint, FlexibilitiesAreThoseOfAPlate) {
  const WeldJoint j = joint(2.8);
  // ln 2 = 0.693147; (2.7)(1.3) / (4 pi 210000 1.5) = 8.867204e-7, twice; D = 64903.85, 1 / (4 pi D) = 1.2260825e-6,
  // twice.
  EXPECT_NEAR(j.in_plane(), 2.0 * 8.867204e-7 * 0.693147, 1e-11);
  EXPECT_NEAR(j.bending(), 2.0 * 1.2260825e-6 * 0.693147, 1e-11);
  EXPECT_EQ(joint(1.3).in_plane(), 0.0);
  EXPECT_EQ(joint(1.3).bending(), 0.0);
}

TEST(WeldJoint, ElasticInSeriesWithTheBeam) {
  const WeldJoint j = joint(3.0, false);
  Joined pulled(j), slid(j), bent(j);
  const double u = 1e-7;
  pulled.nodes.v[1].z = u;
  pulled.step(1.0);
  EXPECT_NEAR(pulled.resultant(0) / u, axial, 1e-5 * axial);
  slid.nodes.v[1].x = u;
  slid.step(1.0);
  EXPECT_NEAR(slid.resultant(1) / u, 1.0 / (1.0 / shear + j.in_plane()), 1e-5 * shear);
  bent.nodes.w[0].x = -0.5 * u;
  bent.nodes.w[1].x = 0.5 * u;
  bent.step(1.0);
  EXPECT_NEAR(bent.resultant(4) / u, 1.0 / (1.0 / bend + j.bending()), 1e-5 * bend);
  // Forces in balance.
  EXPECT_EQ(norm(slid.force.f[0] + slid.force.f[1]), 0.0);
  const Vec3d moment = slid.force.m[0] + slid.force.m[1] + cross(slid.nodes.x[1] - slid.nodes.x[0], slid.force.f[1]);
  EXPECT_NEAR(norm(moment), 0.0, 1e-9 * norm(slid.force.m[1]));
}

// On a mesh that shows nothing of it the whole measured slip is the joint's: 2.368 d t s at 0.0006 d an end, and
// 1.3 t^2 d s at 0.01 of both ends.
TEST(WeldJoint, PureLoadsAreTheMeasuredOnes) {
  constexpr double far = 50.0;
  const WeldJoint j = joint(far);
  Joined slid(j);
  const double force = 2.368 * diameter * thickness * yield, slip = 2.0 * 0.0006 * diameter,
               elastic = force * (1.0 / shear + j.in_plane());
  slid.nodes.v[1].x = 1e-5;
  double moved = 0.0;
  while (moved < slip + elastic) {
    slid.step(1.0);
    slid.nodes.x[1].z = length;
    moved += 1e-5;
  }
  EXPECT_NEAR(slid.resultant(1), force, 0.005 * force);

  Joined bent(j);
  const double moment = 1.3 * thickness * thickness * diameter * yield,
               angle = 0.01 + moment * (1.0 / bend + j.bending());
  bent.nodes.w[0].x = -5e-6;
  bent.nodes.w[1].x = 5e-6;
  for (double turned = 0.0; turned < angle; turned += 1e-5) bent.step(1.0);
  EXPECT_NEAR(bent.resultant(4), moment, 0.005 * moment);
}

TEST(WeldJoint, AResolvedNuggetDoesNotFlow) {
  const WeldJoint j = joint(1.1);
  EXPECT_GT(j.limits(0.0)[1], 1e20);
  EXPECT_GT(j.limits(0.0)[2], 1e20);
  EXPECT_NEAR(j.limits(0.0)[0], std::numbers::pi / std::sqrt(3.0) * diameter * thickness * yield, 1.0);
}

TEST(WeldJoint, HardensWithItsSheet) {
  const double soft = joint(3.0, true, 0.0).limits(5000.0)[1], hard = joint(3.0, true, 8.0 * yield).limits(5000.0)[1];
  EXPECT_GT(hard, 1.02 * soft);
  EXPECT_NEAR(joint(3.0, true, 0.0).limits(0.0)[1], joint(3.0, true, 8.0 * yield).limits(0.0)[1], 1e-9 * hard);
}

// Twice the yield stress at any rate: twice the force after the same slip.
TEST(WeldJoint, ARateRaisesAllLimits) {
  JointEnd end{E, nu, thickness, diameter, 3.0, {.x = {0.0, 1.0}, .y = {yield, 5.0 * yield}}, {}};
  const WeldJoint slow(std::array{end, end});
  end.rate_factor = {.x = {0.0, 1e-30}, .y = {2.0, 2.0}};
  const WeldJoint fast(std::array{end, end});
  const auto plastic_work = [](const WeldJoint& joint, double force) {
    WeldJoint::State state;
    WeldJoint::Freedoms last{};
    const WeldJoint::Freedoms stiffness{1e6, 1e6, 1e6, 1e6, 1e6};
    while (last[1] < force) {
      const WeldJoint::Freedoms beam = joint.advance(state, {0, 1e-5, 0, 0, 0}, stiffness, last, 1.0);
      last[1] += 1e6 * beam[1];
    }
    return state.work;
  };
  EXPECT_NEAR(plastic_work(fast, 14000.0), plastic_work(slow, 7000.0), 0.02 * plastic_work(slow, 7000.0));
}

TEST(WeldJoint, YieldConditionHoldsAndWorkGrows) {
  Random random;
  const WeldJoint j = joint(3.0);
  Joined d(j);
  int flowed = 0;
  for (int cycle = 0; cycle < 400; ++cycle) {
    for (int a = 0; a < 2; ++a) {
      d.nodes.v[a] = random.vector(0.004);
      d.nodes.w[a] = random.vector(0.004);
    }
    const double before = d.work();
    d.step(1.0);
    const auto [normal, in_plane, moment] = j.limits(d.work());
    const double n = std::max(0.0, d.resultant(0)) / normal, v = std::hypot(d.resultant(1), d.resultant(2)) / in_plane,
                 m = std::hypot(d.resultant(4), d.resultant(5)) / moment, used = std::sqrt(n * n + v * v + m * m);
    EXPECT_GE(d.work(), before);
    if (d.work() > before) {
      EXPECT_NEAR(used, 1.0, 1e-9);
      ++flowed;
    } else {
      EXPECT_LE(used, 1.0 + 1e-9);
    }
  }
  EXPECT_GT(flowed, 20);
}

TEST(WeldJoint, UnloadsElastically) {
  const WeldJoint j = joint(3.0);
  Joined d(j);
  d.nodes.v[1].x = 1e-4;
  for (int i = 0; i < 300; ++i) {
    d.step(1.0);
    d.nodes.x[1].z = length;
  }
  ASSERT_GT(d.work(), 0.0);
  const double force = d.resultant(1), work = d.work();
  d.nodes.v[1].x = -1e-4;
  d.step(1.0);
  EXPECT_EQ(d.work(), work);
  EXPECT_NEAR((force - d.resultant(1)) / 1e-4, 1.0 / (1.0 / shear + j.in_plane()), 1e-3 * shear);
}

TEST(WeldJoint, BatchHasTheSameBits) {
  const WeldJoint j = joint(3.0);
  std::vector<Joined> each(native_width, Joined(j));
  const WeldBeamLayout layout = each[0].layout;
  std::vector<double> together(at(layout.size() * native_width));
  for (int l = 0; l < native_width; ++l)
    start_weld_beam(layout, {}, {0, 0, length}, {1, 0, 0}, together.data(), native_width, l);
  Random random;
  for (int cycle = 0; cycle < 60; ++cycle) {
    NodalMotion<NativeBatch, 2> nodes;
    for (int l = 0; l < native_width; ++l) {
      Joined& one = each[l];
      for (int a = 0; a < 2; ++a) {
        one.nodes.v[a] = random.vector(0.004);
        one.nodes.w[a] = random.vector(0.004);
      }
      one.step(1.0);
      put(nodes, l, one.nodes);
    }
    weld_beam_cycle(each[0].beam, each[0].law, nodes, 1.0, together.data());
  }
  for (int l = 0; l < native_width; ++l)
    for (int i = 0; i < layout.size(); ++i) EXPECT_EQ(together[i * native_width + l], each[l].state[i]);
  EXPECT_GT(each[0].work(), 0.0);
}

}  // namespace
}  // namespace nugget::kernel
