// SPDX-License-Identifier: Apache-2.0
// Discrete beams (ELFORM 6): oscillators, driven springs, large rotations, failure, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

/// *SECTION_BEAM of a discrete beam: VOL 1e-3 with density 1, INER 1e-3.
void section(Specimen& s, double scoor, double volume = 1e-3, double inertia = 1e-3) {
  s.text("*SECTION_BEAM\n" + fields({1, 6, 1, 2, 0, scoor}) + fields({volume, inertia}));
  s.part(1, 1, 1);
}

void beam(Specimen& s, int first, int second) {
  s.text("*ELEMENT_BEAM\n" + element_line(1, 1, {first, second}));
}

void hold(Specimen& s, int node) {
  s.card("BOUNDARY_SPC_NODE", {double(node), 0, 1, 1, 1, 1, 1, 1});
}

Specimen& timing(Specimen& s, double end, double step) {
  return s.text(constant_curve(90, step))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 90})
      .card("CONTROL_TERMINATION", {end});
}

std::array<double, 8> resultants(const impact::Snapshot& now) {
  return now.system.groups.at(0)->resultants(0);
}

// MAT_066: a mass of 2 on springs along and about one axis each; all six degrees of freedom swing at their own
// frequency. Sabotage: half of the stiffness; rotations and translations exchanged.
TEST(DiscreteBeams, SixOscillators) {
  Specimen s;
  const std::array<double, 6> k{800.0, 500.0, 300.0, 40.0, 60.0, 90.0};
  s.text("*MAT_LINEAR_ELASTIC_DISCRETE_BEAM\n" + fields({1, 1.0, k[0], k[1], k[2], k[3], k[4], k[5]}) + fields({}) +
         fields({}));
  section(s, 0);
  const int a = s.node({0, 0, 0}), b = s.mass_point({0, 0, 0}, 2.0, 0.1);
  beam(s, a, b);
  hold(s, a);
  s.card("INITIAL_VELOCITY_NODE", {double(b), 1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4});
  timing(s, 6.0, 2e-4);
  Experiment experiment(s.deck());
  std::array<Period, 6> period;
  double drift = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const auto r = resultants(now);
    for (std::size_t i = 0; i < 6; ++i) period[i].add(now.state.time, r[i]);
    drift = std::max(drift, std::abs(now.energy.ratio() - 1.0));
  });
  for (std::size_t i = 0; i < 6; ++i) {
    const double inertia = i < 3 ? 2.0 + 0.5e-3 : 0.1 + 0.5e-3;
    expect_reference("discrete beam", fmt::format("MAT_066, period of degree of freedom {} [s]", i + 1),
                     period[i].mean(), 2.0 * M_PI * std::sqrt(inertia / k[i]), 1e-5);
  }
  EXPECT_NEAR(drift, 0.0, 1e-6);
}

// A long beam that turns freely through a full turn, its preload the centripetal force: nothing changes in its own
// axes. Sabotage: the transverse displacement without the spin's part; the triad left in space.
TEST(DiscreteBeams, LoadedBeamTurnsWithoutChange) {
  for (const double scoor : {2.0, -2.0, 3.0}) {
    const double omega = 2.0, half = 5.0, pull = 1.0005 * omega * omega * half;
    Specimen s;
    s.text("*MAT_066\n" + fields({1, 1.0, 1000.0, 700.0, 500.0, 50.0, 50.0, 50.0}) + fields({}) + fields({pull}));
    section(s, scoor);
    const int a = s.mass_point({-half, 0, 0}, 1.0, 0.2), b = s.mass_point({half, 0, 0}, 1.0, 0.2);
    beam(s, a, b);
    for (const int n : {a, b})
      s.card("INITIAL_VELOCITY_NODE", {double(n), 0, (n == b ? 1 : -1) * omega * half, 0, 0, 0, omega});
    timing(s, 2.0 * M_PI / omega, 2e-4);
    Experiment experiment(s.deck());
    double across = 0.0, moments = 0.0, along = 0.0, ratio = 0.0;
    Vec3d place;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      const auto r = resultants(now);
      along = std::max(along, std::abs(r[0] - pull));
      across = std::max({across, std::abs(r[1]), std::abs(r[2])});
      moments = std::max({moments, std::abs(r[3]), std::abs(r[4]), std::abs(r[5])});
      ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
      place = experiment.position(now, b);
    });
    expect_reference("discrete beam", fmt::format("SCOOR {}, a full turn: largest change of its force of 20", scoor),
                     along, 0.0, 1e-4, 20.0);
    EXPECT_NEAR(across, 0.0, 1e-4) << scoor;
    EXPECT_NEAR(moments, 0.0, 1e-6) << scoor;
    EXPECT_NEAR(ratio, 0.0, 1e-6) << scoor;
    EXPECT_NEAR(place.x, half, 1e-3) << scoor;
    EXPECT_NEAR(place.y, 0.0, 1e-2) << scoor;
  }
}

// Cantilever effect of a long beam: a transverse force at one node is balanced by couples at both. Free in space,
// driven by opposite transverse forces, its angular momentum grows with the couple F L alone. Sabotage: no couples.
TEST(DiscreteBeams, LongBeamKeepsTheBalanceOfMoments) {
  Specimen s;
  s.text("*MAT_066\n" + fields({1, 1.0, 1e4, 1e4, 1e4, 1e4, 1e4, 1e4}) + fields({}) + fields({}));
  section(s, 2);
  const int a = s.mass_point({0, 0, 0}, 1.0, 0.5), b = s.mass_point({4, 0, 0}, 1.0, 0.5);
  beam(s, a, b);
  s.text(curve(1, {{0.0, 1.0}, {10.0, 1.0}}));
  s.card("LOAD_NODE_POINT", {double(a), 7, 1, 3.0}).card("LOAD_NODE_POINT", {double(b), 7, 1, 3.0});
  timing(s, 0.2, 2e-4);
  Experiment experiment(s.deck());
  double momentum = 0.0, time = 0.0, linear = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.dt != now.state.dt_previous) return;  // the mean velocity stands at t only between equal steps
    momentum = 0.0;
    Vec3d sum;
    for (const int n : {a, b}) {
      const double m = 1.0 + 0.5e-3, j = 0.5 + 0.5e-3;
      momentum +=
          m * cross(experiment.position(now, n), experiment.velocity(now, n)).z + j * now.spin(experiment.node(n)).z;
      sum += experiment.velocity(now, n);
    }
    linear = norm(sum);
    time = now.state.time;
  });
  expect_reference("discrete beam", "SCOOR 2: angular momentum by two moments of 3 over 0.2 s", momentum, 6.0 * time,
                   1e-4);
  EXPECT_NEAR(linear, 0.0, 1e-9);
}

/// Force of a spring along r over its displacement, driven by a curve of its speed up to `end`.
std::vector<std::pair<double, double>> driven(const std::string& material,
                                              std::initializer_list<std::pair<double, double>> speed, double end) {
  Specimen s;
  s.text(material);
  section(s, 0);
  const int a = s.node({0, 0, 0}), b = s.node({0, 0, 0});
  beam(s, a, b);
  hold(s, a);
  s.text(curve(80, speed)).card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(b), 1, 0, 80, 1.0});
  timing(s, end, 1e-3);
  Experiment experiment(s.deck());
  std::vector<std::pair<double, double>> path;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    path.emplace_back(experiment.displacement(now, b).x, resultants(now)[0]);
  });
  return path;
}

/// At a constant speed of 1 there and back.
std::vector<std::pair<double, double>> driven(const std::string& material, double amplitude) {
  return driven(material, {{0.0, 1.0}, {amplitude - 1e-9, 1.0}, {amplitude + 1e-9, -1.0}, {9.0, -1.0}},
                2.0 * amplitude);
}

// MAT_066, 067 and 068 out to 1, to -1 and back: K d, both sides of a curve, and 50 + 20 q with K = 400. Sabotage:
// each step hardens from q = 0.
TEST(DiscreteBeams, CyclesOfTheSimpleLaws) {
  const auto cycle = [](const std::string& material) {
    return driven(
        material,
        {{0.0, 1.0}, {1.0 - 1e-9, 1.0}, {1.0 + 1e-9, -1.0}, {3.0 - 1e-9, -1.0}, {3.0 + 1e-9, 1.0}, {9.0, 1.0}}, 4.0);
  };
  const auto expect = [&](const std::string& what, const std::string& material, auto force) {
    double worst = 0.0;
    for (const auto& [d, f] : cycle(material)) worst = std::max(worst, std::abs(f - force(d)));
    expect_reference("discrete beam", what + ", cycle: largest error of the force, of 50", worst, 0.0, 1e-6, 50.0);
  };
  expect("MAT_066", "*MAT_066\n" + fields({1, 1.0, 50.0}) + fields({}) + fields({}), [](double d) { return 50.0 * d; });
  expect("MAT_067",
         "*MAT_067\n" + fields({1, 1.0, 7}) + fields({}) + fields({}) + fields({}) + fields({}) +
             curve(7, {{-1.0, -60.0}, {-0.2, -20.0}, {0.0, 0.0}, {0.3, 30.0}, {1.0, 50.0}}),
         [](double d) {
           if (d < -0.2) return -20.0 + 50.0 * (d + 0.2);
           return d < 0.3 ? 100.0 * d : 30.0 + 20.0 / 0.7 * (d - 0.3);
         });
  double plastic = 0.0, hardened = 0.0;  // displacement that stays, and all of it that was plastic
  expect("MAT_068",
         "*MAT_068\n" + fields({1, 1.0, 400.0}) + fields({}) + fields({7}) + fields({}) + fields({}) + fields({}) +
             curve(7, {{0.0, 50.0}, {4.0, 130.0}}),
         [&](double d) {
           const double elastic = 400.0 * (d - plastic), beyond = std::abs(elastic) - (50.0 + 20.0 * hardened);
           if (beyond <= 0.0) return elastic;
           hardened += beyond / 420.0;
           plastic += std::copysign(beyond / 420.0, elastic);
           return 400.0 * (d - plastic);
         });
}

// MAT_196, elastoplastic: F = 50 + 20 q, K = 400; out to 1 and back. Sabotage: yield over the whole displacement.
TEST(DiscreteBeams, GeneralSpringYieldsAndUnloads) {
  const auto path = driven("*MAT_GENERAL_SPRING_DISCRETE_BEAM\n" + fields({1, 1.0}) + fields({1, 1, 400.0}) +
                               fields({7, 0, 0, 0, 1.0}) + curve(7, {{0.0, 50.0}, {2.0, 90.0}}),
                           1.0);
  double worst = 0.0, turning = 0.0, after = 0.0;
  for (const auto& [d, f] : path) {
    if (d >= turning) {
      turning = d;
      // q from 400 (d - q) = 50 + 20 q.
      const double q = std::max(0.0, (400.0 * d - 50.0) / 420.0);
      worst = std::max(worst, std::abs(f - (q > 0.0 ? 50.0 + 20.0 * q : 400.0 * d)));
      after = f;
    } else if (turning - d < 0.3) {
      worst = std::max(worst, std::abs(f - (after - 400.0 * (turning - d))));
    }
  }
  expect_reference("discrete beam", "MAT_196, yield and unloading: largest error of the force, of 66.7", worst, 0.0,
                   1e-6, 66.7);
}

// MAT_119 with IUNLD 2: dissipates the loop between its curves. Closed form of the path in each leg.
TEST(DiscreteBeams, GeneralNonlinearBeamUnloadsByItsStiffness) {
  const auto path = driven("*MAT_119\n" + fields({1, 1.0, 200.0, 0, 2}) + fields({7}) + fields({8}) + fields({}) +
                               fields({}) + fields({}) + fields({}) + fields({}) +
                               curve(7, {{0.0, 0.0}, {1.0, 100.0}}) + curve(8, {{0.0, 0.0}, {1.0, 20.0}}),
                           1.0);
  double worst = 0.0, turning = 0.0;
  for (const auto& [d, f] : path) {
    if (d >= turning) {
      turning = d;
      worst = std::max(worst, std::abs(f - 100.0 * d));
    } else {
      worst = std::max(worst, std::abs(f - std::max(20.0 * d, 100.0 * turning - 200.0 * (turning - d))));
    }
  }
  expect_reference("discrete beam", "MAT_119, IUNLD 2: largest error of the force, of 100", worst, 0.0, 1e-6, 100.0);
}

// MAT_074 and 121 act between two points: K times the change of their distance, along their line, which node 2 leads
// through a right angle and away; no third node, no CID. Sabotage: the r axis where the triad has it.
TEST(DiscreteBeams, SpringBetweenTwoPoints) {
  for (const std::string& law : {"*MAT_074\n" + fields({1, 1.0, 100.0}) + fields({}),
                                 "*MAT_121\n" + fields({1, 1.0}) + fields({7}) + fields({})})
    for (const double scoor : {0.0, -1.0}) {
      Specimen s;
      s.text(law + curve(7, {{0.0, 0.0}, {1.0, 100.0}}));
      section(s, scoor);
      const int a = s.node({1, 1, 1}), b = s.node({4, 5, 1});
      beam(s, a, b);
      hold(s, a);
      // From (3, 4) to (-6, 8) as seen from node 1, with its own way in each direction, and off the plane.
      s.text(curve(80, {{0.0, 0.0}, {0.6, -5.0}, {1.0, -9.0}})).text(curve(81, {{0.0, 0.0}, {0.4, -1.0}, {1.0, 4.0}}));
      s.text(curve(82, {{0.0, 0.0}, {0.5, 2.0}, {1.0, 1.0}}));
      for (const int dof : {1, 2, 3})
        s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(b), double(dof), 2, 79.0 + dof, 1.0});
      timing(s, 1.0, 1e-3);
      Experiment experiment(s.deck());
      double worst = 0.0, askew = 0.0;
      run_to_end(experiment, [&](const impact::Snapshot& now) {
        const Vec3d line = experiment.position(now, b) - experiment.position(now, a);
        const auto r = resultants(now);
        worst = std::max(worst, std::abs(r[0] - 100.0 * (norm(line) - 5.0)));
        for (std::size_t i = 1; i < 6; ++i) askew = std::max(askew, std::abs(r[i]));
      });
      expect_reference("discrete beam", fmt::format("spring between two points, SCOOR {}: error of its force", scoor),
                       worst, 0.0, 1e-4, 500.0);
      EXPECT_EQ(askew, 0.0);
    }
}

// MAT_119 with IUNLD 1, out to 1, back to 0.5 and held there: it stays on the curve of unloading. Sabotage: a spring
// that stands still taken for one that loads.
TEST(DiscreteBeams, StandsOnTheCurveThatItCameAlong) {
  Specimen s;
  s.text("*MAT_119\n" + fields({1, 1.0, 0, 0, 1}) + fields({7}) + fields({8}) + fields({}) + fields({}) + fields({}) +
         fields({}) + fields({}) + curve(7, {{0.0, 0.0}, {1.0, 100.0}}) + curve(8, {{0.0, 0.0}, {1.0, 20.0}}));
  section(s, 0);
  const int a = s.node({0, 0, 0}), b = s.node({0, 0, 0});
  beam(s, a, b);
  hold(s, a);
  s.text(curve(80, {{0.0, 1.0}, {1.0, 1.0}, {1.0001, -1.0}, {1.5, -1.0}, {1.5001, 0.0}, {9.0, 0.0}}));
  s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(b), 1, 0, 80, 1.0});
  timing(s, 2.0, 1e-3);
  Experiment experiment(s.deck());
  double worst = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time > 1.01)
      worst = std::max(worst, std::abs(resultants(now)[0] - 20.0 * experiment.displacement(now, b).x));
  });
  expect_reference("discrete beam", "MAT_119, IUNLD 1, held: largest error of the force, of 20", worst, 0.0, 1e-6,
                   20.0);
}

// MAT_119 with IUNLD 2, displaced by IUR at time 0: it has been loaded there. Sabotage: no force at the start.
TEST(DiscreteBeams, StartsLoadedWhereItStands) {
  Specimen s;
  s.text("*MAT_119\n" + fields({1, 1.0, 200.0, 0, 2}) + fields({7}) + fields({8}) + fields({}) + fields({}) +
         fields({}) + fields({}) + fields({0.5}) + curve(7, {{0.0, 0.0}, {1.0, 100.0}}) +
         curve(8, {{0.0, 0.0}, {1.0, 20.0}}));
  section(s, 0);
  const int a = s.node({0, 0, 0}), b = s.node({0, 0, 0});
  beam(s, a, b);
  hold(s, a);
  s.text(curve(80, {{0.0, -1.0}, {9.0, -1.0}}));
  s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(b), 1, 0, 80, 1.0});
  timing(s, 0.4, 1e-3);
  Experiment experiment(s.deck());
  double worst = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double d = 0.5 + experiment.displacement(now, b).x;
    worst = std::max(worst, std::abs(resultants(now)[0] - std::max(20.0 * d, 50.0 - 200.0 * (0.5 - d))));
  });
  expect_reference("discrete beam", "MAT_119, IUNLD 2 from IUR: largest error of the force, of 50", worst, 0.0, 1e-6,
                   50.0);
}

// MAT_067 fails by force: (F_r/30)^2 + (F_s/40)^2 = 1 on a path at 45 degrees; its energy is then eroded, not lost.
TEST(DiscreteBeams, FailureByForce) {
  Specimen s;
  s.text("*MAT_067\n" + fields({1, 1.0, 7, 7}) + fields({}) + fields({}) + fields({30.0, 40.0}) + fields({}) +
         curve(7, {{0.0, 0.0}, {1.0, 100.0}}));
  section(s, 0);
  const int a = s.node({0, 0, 0}), b = s.node({0, 0, 0});
  beam(s, a, b);
  hold(s, a);
  s.text(curve(80, {{0.0, 1.0}, {9.0, 1.0}}));
  for (const int dof : {1, 2}) s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(b), double(dof), 0, 80, 1.0});
  timing(s, 0.4, 1e-4);
  Experiment experiment(s.deck());
  double failed_at = 0.0, ratio = 0.0, eroded = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (failed_at == 0.0 && !now.system.groups.at(0)->alive(0)) failed_at = now.state.time;
    ratio = now.energy.ratio();
    eroded = now.energy.eroded;
  });
  // 100 d at both: d = 1/sqrt((100/30)^2 + (100/40)^2) = 0.24.
  expect_reference("discrete beam", "MAT_067, displacement at failure by force", failed_at, 0.24, 1e-3);
  EXPECT_NEAR(ratio, 1.0, 2e-3);
  EXPECT_NEAR(eroded, 100.0 * 0.24 * 0.24, 0.02);
}

// Its own step: 0.9 sqrt(RO VOL / k), and the nodes' other masses do not change it.
TEST(DiscreteBeams, TimeStep) {
  Specimen s;
  s.text("*MAT_066\n" + fields({1, 1.0, 1000.0}) + fields({}) + fields({}));
  section(s, 0, 0.004);
  const int a = s.node({0, 0, 0}), b = s.mass_point({1, 0, 0}, 5.0);
  beam(s, a, b);
  hold(s, a);
  s.card("CONTROL_TERMINATION", {0.1});
  Experiment experiment(s.deck());
  run_to_end(experiment, [](const impact::Snapshot&) {});
  expect_reference("discrete beam", "first time step, 0.9 sqrt(m/k) [s]", experiment.simulation().first_step(),
                   0.9 * std::sqrt(0.004 / 1000.0), 1e-10);
}

}  // namespace
}  // namespace nugget::verify
