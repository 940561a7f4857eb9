// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

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

  model::Material& steel = m.materials.emplace_back();
  steel.id = 1;
  steel.keyword = "MAT_ELASTIC";
  steel.density = 7.85e-9;
  steel.law = kernel::Elastic{210e3, 0.3};
  model::SectionShell& section = m.shell_sections.emplace_back();
  section.id = 1;
  section.thickness = 1.0;
  model::Part& part = m.parts.emplace_back();
  part.id = 1;
  part.kind = model::ElementKind::shell;
  part.section = part.material = 0;
  m.shells.id = {1};
  m.shells.part = {0};
  m.shells.node = {{0, 1, 2, 3}};
  m.shells.thickness = {1.0};
  m.shells.place.push_back(0, 0);

  Curve& curve = m.curves.emplace_back();
  curve.x = {0.0, 1.0};
  curve.y = {gravity, gravity};
  model::BodyLoad& load = m.body_loads.emplace_back();
  load.direction = {0.0, 0.0, 1.0};
  load.curve = 0;
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
  for (const int n : system.node_of) EXPECT_NEAR(simulation.state().x[n].z, -0.5 * g * t * t, 1e-9 * g * t * t);
  EXPECT_NEAR(simulation.energy().internal, 0.0, 1e-12);
}

}  // namespace
}  // namespace nugget::impact
