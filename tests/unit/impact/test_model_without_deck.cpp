// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "base/index.hpp"
#include "impact/simulation/simulation.hpp"
#include "model/model.hpp"
#include "weld/tie/ties.hpp"

// A model is plain data: built here in C++, without a deck and without src/reading, tied, and run.
namespace nugget::impact {
namespace {

class Nobody : public Recorder {
 public:
  bool due(const system::State&) override { return false; }
  void write(const Snapshot&, bool) override {}
};

/// A square steel shell, 10 x 10 x 1 mm, in mm, t, s, that falls freely.
model::Model falling_shell(double gravity, double end_time) {
  model::Model m;
  m.control.end_time = end_time;
  m.nodes.id = {1, 2, 3, 4};
  m.nodes.x = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  m.materials.push_back({.id = 1, .keyword = "MAT_ELASTIC", .density = 7.85e-9, .law = kernel::Elastic{210e3, 0.3}});
  m.shell_sections.push_back({.id = 1, .thickness = 1.0});
  m.parts.push_back({.id = 1, .kind = model::ElementKind::shell, .section = 0, .material = 0});
  m.shells.id = {1};
  m.shells.part = {0};
  m.shells.node = {{0, 1, 2, 3}};
  m.shells.thickness = {1.0};
  m.shells.offset = {0.0};
  m.shells.place.push_back(0, 0);
  m.curves.push_back({.id = 1, .x = {0.0, 1.0}, .y = {gravity, gravity}});
  m.body_loads.push_back({.direction = {0.0, 0.0, 1.0}, .curve = 0});
  return m;
}

TEST(ModelWithoutDeck, AShellFallsAsGravityAsks) {
  const double g = 9810.0, end = 1e-3;
  const model::Model model = falling_shell(g, end);
  Findings findings;
  const weld::Ties ties = weld::tie(model, findings);
  system::System system(model, ties, findings);
  Simulation simulation(system, findings);
  for (const Finding& f : findings.all()) EXPECT_NE(f.severity, Severity::error) << to_string(f);

  Nobody nobody;
  EXPECT_EQ(simulation.run({}, nobody, {}).termination, Termination::normal);

  // -g t^2 / 2; central differences are exact under a constant acceleration.
  const double t = simulation.state().time;
  EXPECT_GE(t, end);
  for (const int n : system.node_of) EXPECT_NEAR(simulation.state().x[at(n)].z, -0.5 * g * t * t, 1e-9 * g * t * t);
  EXPECT_NEAR(simulation.energy().internal, 0.0, 1e-12);
}

}  // namespace
}  // namespace nugget::impact
