// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "system/system.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::system {
namespace {

/// A free strip of steel shells, 10 mm wide and 1 mm thick, in mm, t, s: 8 of 10 mm, 8 of 1.25 mm, 8 of 10 mm, all
/// nodes thrown in some direction.
model::Model thrown_strip() {
  model::Model m;
  std::vector<double> places{0.0};
  for (const double size : {10.0, 1.25, 10.0})
    for (int i = 0; i < 8; ++i) places.push_back(places.back() + size);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (const double y : {0.0, 10.0}) {
      m.nodes.id.push_back(static_cast<int>(m.nodes.id.size()) + 1);
      m.nodes.x.push_back({places[i], y, 0.0});
      const double k = static_cast<double>(m.nodes.id.size());
      m.initial_velocity.push_back({1e3 * std::sin(k), 1e3 * std::sin(2.0 * k), 1e3 * std::sin(3.0 * k)});
    }
  m.initial_spin.resize(m.nodes.id.size());

  model::Material& steel = m.materials.emplace_back();
  steel.keyword = "MAT_ELASTIC";
  steel.density = 7.85e-9;
  steel.law = kernel::Elastic{210e3, 0.3};
  m.shell_sections.emplace_back().thickness = 1.0;
  model::Part& part = m.parts.emplace_back();
  part.kind = model::ElementKind::shell;
  part.section = part.material = 0;
  for (int i = 0; i + 1 < static_cast<int>(places.size()); ++i) {
    m.shells.id.push_back(i + 1);
    m.shells.part.push_back(0);
    m.shells.node.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    m.shells.thickness.push_back(1.0);
    m.shells.place.push_back(0, 0);
  }
  return m;
}

struct Strip {
  model::Model model = thrown_strip();
  Findings findings;
  weld::Ties ties = weld::tie(model, findings);

  ElementPeriods periods(int ratio) {
    System all(model, ties, findings);
    all.compute_at_rest();
    return periods_by_step(all, ratio);
  }
};

TEST(Subcycles, PeriodsGoByTheStepAndReachOneElementFurther) {
  Strip strip;
  const ElementPeriods periods = strip.periods(16);
  for (std::size_t e = 0; e < 24; ++e) {
    // 10 mm allow 8 times the step of 1.25 mm, of which a share of 0.9 is taken: 4 is the power of two below.
    const bool small_or_beside = e >= 7 && e <= 16;
    EXPECT_EQ(periods.of(model::ElementKind::shell, static_cast<model::Index>(e)), small_or_beside ? 1 : 4) << e;
  }
  EXPECT_EQ(strip.periods(2).of(model::ElementKind::shell, 0), 2);
}

TEST(Subcycles, MomentumIsKeptToRoundOff) {
  Strip strip;
  System system(strip.model, strip.ties, strip.findings, strip.periods(16));
  ASSERT_EQ(system.period(), 4);
  State state = system.initial_state();
  const auto momentum = [&] {
    Vec3d sum;
    for (std::size_t k = 0; k < system.nodes; ++k) sum += system.mass[k] * vec(state.v[k]);
    return sum;
  };
  const auto angular = [&] {
    Vec3d sum;
    for (std::size_t k = 0; k < system.nodes; ++k)
      sum += system.mass[k] * cross(vec(state.x[k]), vec(state.v[k])) + system.inertia[k] * vec(state.w[k]);
    return sum;
  };
  double size = 0.0;
  for (std::size_t k = 0; k < system.nodes; ++k) size += system.mass[k] * norm(vec(state.v[k]));

  system.internal_force(state);  // all steps, with dt 0
  state.dt = system.controlling().step;
  const Vec3d p = momentum(), l = angular();
  double most = 0.0;
  for (int cycle = 0; cycle < 400; ++cycle) {
    for (std::size_t k = 0; k < system.nodes; ++k) {
      set(state.v[k], vec(state.v[k]) + (state.dt / system.mass[k]) * vec(state.f[k]));
      set(state.w[k], vec(state.w[k]) + (state.dt / system.inertia[k]) * vec(state.m[k]));
      set(state.x[k], vec(state.x[k]) + state.dt * vec(state.v[k]));
      most = std::max(most, norm(state.dt * vec(state.f[k])));
    }
    ++state.cycle;
    system.internal_force(state);
  }
  EXPECT_GT(most, 1e-3 * size) << "the elements act";
  EXPECT_LT(norm(momentum() - p), 1e-13 * size);
  EXPECT_LT(norm(angular() - l), 1e-4 * norm(l)) << "to the order of the step";
}

}  // namespace
}  // namespace nugget::system
