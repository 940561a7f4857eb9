// SPDX-License-Identifier: Apache-2.0
// Bolts that are preloaded while they move: force and stress are the curve's in every cycle, and elastic when it ends.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "base/index.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double pi = std::numbers::pi, E = 210000.0, density = 7.85e-9;

std::array<double, 8> resultants(const impact::Snapshot& now) {
  const system::System::ElementLocation location = now.system.beam_location.at(0);
  return now.system.groups[location.group]->resultants(at(location.element));
}

/// A bolt of one beam between nodes at 0 and at (0, 0, length).
struct Bolt {
  static constexpr double length = 10.0, diameter = 6.0, area = 0.25 * pi * diameter * diameter;
  Specimen s;
  int root, head;

  Bolt(int elform, double end, double mass, double scale = 0.9) {
    if (elform == 9)
      s.card("MAT_SPOTWELD", {1, density, E, 0.3, 5000, 1000}).text("\n");
    else
      s.card("MAT_ELASTIC", {1, density, E, 0.3});
    s.card("SECTION_BEAM", {1, double(elform), 1, 2, elform == 9 ? 1.0 : 0.0})
        .text(elform == 3   ? fields({area})
              : elform == 9 ? fields({diameter, diameter, 0, 0})
                            : fields({4, 4, 5, 5}))
        .card("CONTROL_TIMESTEP", {0, scale})
        .card("CONTROL_TERMINATION", {end})
        .part(1, 1, 1);
    root = s.node({0, 0, 0});
    head = mass > 0.0 ? s.mass_point({0, 0, length}, mass) : s.node({0, 0, length});
    s.text(fmt::format("*ELEMENT_BEAM\n{:8d}{:8d}{:8d}{:8d}{:8d}\n", 1, 1, root, head, s.node({5, 0, 0})))
        .text("*SET_BEAM\n" + fields({7}) + fields({1}))
        .node_set(1, {root})
        .card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  }
};

// The head, a mass on a spring, is pulled in by a force that grows as F t/T: u = -F/(k T) (t - sin(w t)/w). Then the
// beam's own stiffness E A/l joins the spring's. Before, the force lagged behind the curve by E A dt times the strain
// rate. Sabotage: the stress set before the step; the energy of the law's own stress booked.
TEST(Bolt, PulledInFastFollowsItsCurve) {
  const double k = 20000.0, mass = 1e-3, F = 500.0, T = 4e-4, end = 6e-4;
  Bolt b(9, end, mass);
  const int anchor = b.s.node({0, 0, 30});
  b.s.card("MAT_SPRING_ELASTIC", {2, k})
      .text("*SECTION_DISCRETE\n" + fields({2, 0}) + fields({0, 0}))
      .part(2, 2, 2)
      .text(fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}{:8}{:16g}{:8}{:16g}\n", 1, 2, b.head, anchor, 0, 1.0, 0,
                        0.0))
      .node_set(2, {b.head})
      .card("BOUNDARY_SPC_SET", {2, 0, 1, 1, 0, 1, 1, 1})
      .node_set(3, {anchor})
      .card("BOUNDARY_SPC_SET", {3, 0, 1, 1, 1, 1, 1, 1})
      .text(curve(1, {{0.0, 0.0}, {T, 1.0}}))
      .card("INITIAL_AXIAL_FORCE_BEAM", {7, 1, F});
  Experiment experiment(b.s.deck());
  // Half of the beam's mass goes with the head.
  const double m = mass + 0.5 * density * Bolt::area * Bolt::length, w = std::sqrt(k / m);
  const auto pulled = [&](double t) { return -F / (k * T) * (t - std::sin(w * t) / w); };
  const auto work = [&](double t) {
    return -F * F / (k * T * T) * (0.5 * t * t - t * std::sin(w * t) / w + (1.0 - std::cos(w * t)) / (w * w));
  };
  double off = 0.0, way = 0.0, way_now = 0.0, energy = 0.0, energy_now = 0.0, drift = 0.0, after = 0.0;
  std::optional<double> released, elongation, speed;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double t = now.state.time, n = resultants(now)[0], u = experiment.displacement(now, b.head).z;
    drift = std::max(drift, std::abs(now.energy.total() - now.energy.external));
    if (t <= T) {
      off = std::max(off, std::abs(n - F * t / T));
      way = u, way_now = pulled(t);
      const system::System::ElementLocation location = now.system.beam_location.at(0);
      energy = now.system.groups[location.group]->internal_energy(at(location.element));
      energy_now = work(t);
      released = t, elongation = u, speed = experiment.velocity(now, b.head).z;
      return;
    }
    // Elastic from the last state under the curve on: about the new rest, with both springs.
    const double own = E * Bolt::area / (Bolt::length + *elongation), both = k + own, rate = std::sqrt(both / m);
    const double rest = (own * *elongation - F * *released / T) / both, s = t - *released;
    const double x = rest + (*elongation - rest) * std::cos(rate * s) + *speed / rate * std::sin(rate * s);
    after = std::max(after, std::abs(n - (F * *released / T + own * (x - *elongation))));
  });
  expect_reference("preload", "bolt that pulls a mass on a spring: force off its curve, of 500 N", off, 0.0, 1e-9, F);
  expect_reference("preload", "the same: way of the mass [mm]", way, way_now, 1e-4);
  expect_reference("preload", "the same: energy taken up by the bolt [N mm]", energy, energy_now, 1e-3);
  expect_reference("preload", "when the curve has ended: force off that of the two springs, of 500 N", after, 0.0, 0.02,
                   F);
  EXPECT_NEAR(drift, 0.0, 1e-4 * F * std::abs(way));
}

// The initialization stops where the load decreases from its maximum: what was reached stays. Beams of each kind.
TEST(Bolt, IsReleasedWhenTheCurveFalls) {
  for (const int elform : {9, 1, 3}) {
    Bolt b(elform, 5e-5, 0.0);
    b.s.node_set(2, {b.head})
        .card("BOUNDARY_SPC_SET", {2, 0, 1, 1, 1, 1, 1, 1})
        .text(curve(1, {{0.0, 0.0}, {1e-5, 1.0}, {2e-5, 1.0}, {3e-5, 0.0}}))
        .card("INITIAL_AXIAL_FORCE_BEAM", {7, 1, 5000});
    Experiment experiment(b.s.deck());
    double during = 0.0, after = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      if (now.state.time >= 1e-5 && now.state.time <= 2e-5) during = resultants(now)[0];
      after = resultants(now)[0];
    });
    const std::string what = fmt::format("beam of ELFORM {}: axial force ", elform);
    expect_reference("preload", what + "under the curve [N]", during, 5000.0, 1e-9);
    expect_reference("preload", what + "when the curve has fallen [N]", after, 5000.0, 1e-9);
  }
}

// The head turns by 1 mrad: E I theta / L in the section where the gradient is kept (KBEND 1), nothing where it is not.
TEST(Bolt, KeepsItsBendingWhereItIsAsked) {
  const double theta = 1e-3, second = pi * std::pow(Bolt::diameter, 4) / 64.0;
  for (const double kbend : {0.0, 1.0}) {
    Bolt b(9, 1e-4, 0.0);
    b.s.node_set(2, {b.head})
        .card("BOUNDARY_SPC_SET", {2, 0, 1, 1, 1, 0, 1, 1})
        .text(curve(1, {{0.0, 0.0}, {2e-5, 1.0}, {1e-3, 1.0}}))
        .text(smooth_ramp(2, 8e-5, theta))
        .card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(b.head), 5, 2, 2})
        .card("INITIAL_AXIAL_FORCE_BEAM", {7, 1, 800, kbend});
    Experiment experiment(b.s.deck());
    double force = 0.0, moment = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      const auto r = resultants(now);
      force = r[0];
      moment = std::hypot(r[4], r[5]);
    });
    expect_reference("preload", fmt::format("KBEND {:g}: axial force [N]", kbend), force, 800.0, 1e-9);
    const double whole = E * second * theta / Bolt::length;
    expect_reference("preload", fmt::format("KBEND {:g}: bending moment [N mm]", kbend), moment, kbend * whole, 1e-3,
                     whole);
  }
}

// A bar of bricks that is released to be pulled together: each cut brick has the curve's stress in every cycle, with
// each form of brick and of IZSHEAR. Sabotage: as above.
TEST(Bolt, OfBricksFollowsItsCurveInMotion) {
  for (const int elform : {1, 2})
    for (const int izshear : {0, 1, 2}) {
      Specimen s;
      s.card("MAT_ELASTIC", {1, density, E, 0.3})
          .card("SECTION_SOLID", {1, double(elform)})
          .card("CONTROL_TERMINATION", {2e-4})
          .part(1, 1, 1);
      const Grid bar = s.bricks(1, {}, {100, 10, 10}, {10, 2, 2});
      s.node_set(1, bar.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
      s.node_set(2, bar.across(10)).card("BOUNDARY_SPC_SET", {2, 0, 0, 1, 1});
      s.text("*DATABASE_CROSS_SECTION_PLANE_ID\n         3bolt\n" + fields({0, 45, 0, 0, 46, 0, 0}) + fields({0, 0, 0}))
          .text(curve(1, {{0.0, 0.0}, {5e-5, 300.0}, {1e-4, 300.0}}))
          .card("INITIAL_STRESS_SECTION", {1, 3, 1, 0, 0, double(izshear)});
      Experiment experiment(s.deck());
      double off = 0.0, drift = 0.0;
      run_to_end(experiment, [&](const impact::Snapshot& now) {
        drift = std::max(drift, std::abs(now.energy.total() - now.energy.external));
        if (now.state.time > 1e-4) return;
        const double stress = 300.0 * std::min(1.0, now.state.time / 5e-5);
        for (std::size_t e = 0; e < now.system.solid_location.size(); ++e) {
          const Vec3d first = now.system.model.nodes.x[now.system.model.solids.node[e][0]];
          if (first.x != 40.0) continue;
          const system::System::ElementLocation location = now.system.solid_location[e];
          const auto layer = now.system.groups[location.group]->layer(at(location.element), 0, now.state);
          off = std::max(off, std::abs(layer.stress[0] - stress));
        }
      });
      expect_reference(
          "preload", fmt::format("bricks of ELFORM {}, IZSHEAR {}: stress off its curve, of 300 MPa", elform, izshear),
          off, 0.0, 1e-9, 300.0);
      EXPECT_NEAR(drift, 0.0, 2.0) << elform << ' ' << izshear;  // of some 300 N mm
    }
}

// Stress that a tetrahedron starts with; those with nodal pressure have no place for it and say so. Before, both lost
// it.
TEST(InitialStress, OfTetrahedra) {
  const auto deck = [](int elform) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, density, E, 0.3})
        .card("SECTION_SOLID", {1, double(elform)})
        .card("CONTROL_TERMINATION", {1e-6})
        .part(1, 1, 1);
    const int a = s.node({0, 0, 0}), b = s.node({10, 0, 0}), c = s.node({0, 10, 0}), d = s.node({0, 0, 10});
    s.brick(1, {a, b, c, d, d, d, d, d});
    s.node_set(1, {a, b, c, d}).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
    s.text("*INITIAL_STRESS_SOLID\n" + fields({1, 1}) + fields({70, 20, 30, 5, 6, 7, 0}));
    return s.deck();
  };
  Experiment experiment(deck(10));
  system::ElementGroup::Layer layer;
  run_to_end(experiment, [&](const impact::Snapshot& now) { layer = brick_layer(experiment, now, 1); });
  expect_reference("initial stress", "tetrahedron of ELFORM 10: stress xx [MPa]", layer.stress[0], 70.0, 1e-9);
  expect_reference("initial stress", "tetrahedron of ELFORM 10: stress zx [MPa]", layer.stress[5], 7.0, 1e-9);
  EXPECT_THROW(Experiment(deck(13)), std::runtime_error);
}

}  // namespace
}  // namespace nugget::verify
