// SPDX-License-Identifier: Apache-2.0
// Elastic stiffness, plasticity and failure of a weld beam, and the closed forms of
// docs/theory/weld.md#reference-values that belong to a single weld beam: node 1 held, node 2 driven in all six degrees
// of freedom, so that no inertia enters.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "experiment.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

using weld::Resultants;
using SixDof = std::array<double, 6>;

constexpr double step = 2e-7;  // below the stable step of all welds here

/// Weld 1 along x: node 1 at the origin, node 2 on its path over `cycles` steps of equal length. Its axes r, s, t are
/// x, y, z.
class Driven {
 public:
  Driven(const WeldData& weld, const Path& path, int cycles, int points = 1)
      : cycles_(cycles),
        run_("*KEYWORD\n" + termination(cycles * step, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) +
             weld_part(1, weld) + beam_between(1, 1, 1, {0, 0, 0}, 2, {weld.length, 0, 0}) + fixed({1}) +
             driven(2, path, cycles * step, points, 100) + "*END\n") {}

  struct Sample {
    double s;  ///< share of the path
    Resultants r;
    double plastic_strain;  ///< largest of the section points
    double failure;
  };
  /// Runs, and returns what was seen in every cycle.
  const std::vector<Sample>& samples() {
    if (!samples_.empty()) return samples_;
    run_.run([&](const impact::Snapshot& now) {
      const system::System::ElementLocation location = now.system.beam_location[0];
      const auto& group = *now.system.groups[location.group];
      double plastic = 0.0;
      for (int k = 0; k < group.layers(); ++k) plastic = std::max(plastic, group.layer(0, k, now.state).plastic_strain);
      samples_.push_back(
          {now.state.time / (cycles_ * step), run_.weld(now, 1), plastic, run_.history(now, 1).failure_value()});
      failed_ = run_.history(now, 1).failed();
      failure_time_ = run_.history(now, 1).failure_time();
      mode_ = run_.history(now, 1).mode();
    });
    return samples_;
  }
  Resultants end() { return samples().back().r; }
  bool failed() { return samples(), failed_; }
  /// Share of the path at which the weld failed.
  double failure() { return failed() ? failure_time_ / (cycles_ * step) : 0.0; }
  weld::FailureMode mode() { return samples(), mode_; }

  /// A value at the moment when `of` reaches `level`, interpolated.
  template <class Of, class Value>
  double at(Of of, double level, Value value) {
    const auto& all = samples();
    for (std::size_t i = 1; i < all.size(); ++i) {
      const double a = of(all[i - 1]), b = of(all[i]);
      if (a > level || b < level || a == b) continue;
      const double w = (level - a) / (b - a);
      return (1.0 - w) * value(all[i - 1]) + w * value(all[i]);
    }
    ADD_FAILURE() << "the level " << level << " is never reached";
    return 0.0;
  }

 private:
  int cycles_;
  Experiment run_;
  std::vector<Sample> samples_;
  bool failed_ = false;
  double failure_time_ = 0.0;
  weld::FailureMode mode_ = weld::FailureMode::intact;
};

Path proportional(const SixDof& end) {
  return [end](double s) {
    SixDof u = end;
    for (double& c : u) c *= s;
    return u;
  };
}

/// Elastic displacement of node 2 for given N_rr, N_rs, N_rt, M_rr, M_ss, M_tt. Bending without shear needs u = L theta
/// / 2.
SixDof elastic(const WeldData& w, const SixDof& r) {
  const double ss = r[4] / w.bending_stiffness(), tt = r[5] / w.bending_stiffness();
  return {r[0] / w.axial_stiffness(),
          r[1] / w.shear_stiffness() + 0.5 * w.length * tt,
          r[2] / w.shear_stiffness() - 0.5 * w.length * ss,
          r[3] / w.torsion_stiffness(),
          ss,
          tt};
}

// Sabotage to be caught: the cross-section of d/2; G = E / 2; the polar moment for the axial one; sign of the bending
// lever.
TEST(WeldBeam, ElasticStiffness) {
  const WeldData w;
  const auto end = [&](const SixDof& motion) { return Driven(w, proportional(motion), 200).end(); };
  expect_reference("weld beam: elastic stiffness", "axial stiffness [N/mm]", end({1e-5}).axial / 1e-5, 3.95841e6, 5e-3);
  expect_reference("weld beam: elastic stiffness", "shear stiffness along s [N/mm]", end({0, 1e-5}).shear_s / 1e-5,
                   1.52246e6, 5e-3);
  expect_reference("weld beam: elastic stiffness", "shear stiffness along t [N/mm]", end({0, 0, 1e-5}).shear_t / 1e-5,
                   1.52246e6, 5e-3);
  expect_reference("weld beam: elastic stiffness", "torsional stiffness [N mm/rad]",
                   end({0, 0, 0, 1e-5}).torsion / 1e-5, 6.85109e6, 2e-2);
  const Resultants about_t = end({0, 0.75e-5, 0, 0, 0, 1e-5}), about_s = end({0, 0, -0.75e-5, 0, 1e-5, 0});
  expect_reference("weld beam: elastic stiffness", "bending stiffness about t [N mm/rad]", about_t.moment_t / 1e-5,
                   8.90642e6, 2e-2);
  expect_reference("weld beam: elastic stiffness", "bending stiffness about s [N mm/rad]", about_s.moment_s / 1e-5,
                   8.90642e6, 2e-2);
  expect_reference("weld beam: elastic stiffness", "shear force in pure bending about t [N]", about_t.shear_s, 0.0,
                   1e-3, about_t.moment_t / w.length);
  expect_reference("weld beam: elastic stiffness", "shear force in pure bending about s [N]", about_s.shear_t, 0.0,
                   1e-3, about_s.moment_s / w.length);
}

// docs/theory/weld.md#reference-values.
TEST(WeldBeam, ClosedFormsOfA5mmWeld) {
  const WeldData w{.diameter = 5.0, .length = 1.0};
  expect_reference("weld beam of 5 mm", "axial stiffness of d = 5, L = 1 [N/mm]",
                   Driven(w, proportional({1e-5}), 200).end().axial / 1e-5, 4.1233e6, 1e-3);
  expect_reference("weld beam of 5 mm", "torsional stiffness of d = 5, L = 1 [N mm/rad]",
                   Driven(w, proportional({0, 0, 0, 1e-5}), 200).end().torsion / 1e-5, 4.9559e6, 1e-3);
  WeldData perfect = w;
  perfect.hardening = 0.0;
  expect_reference("weld beam of 5 mm", "yield force at 400 MPa [N]",
                   Driven(perfect, proportional({0.01}), 400).end().axial, 7853.98, 1e-4);
}

// Sabotage to be caught: EH taken for the tangent modulus (12 % of N at 0.2); engineering in place of logarithmic
// strain; a section that thins with Poisson's ratio.
TEST(WeldBeam, AxialPlasticity) {
  const auto plastic = [](const Driven::Sample& s) { return s.plastic_strain; };
  const auto force = [](const Driven::Sample& s) { return s.r.axial; };
  const double end = 0.345;
  const auto elongation = [&](const Driven::Sample& s) { return end * s.s; };
  Driven pull({}, proportional({end}), 6000);
  const double table[5][3] = {{0.01, 11592.5, 0.018036},
                              {0.02, 11875.2, 0.033366},
                              {0.05, 12723.5, 0.080289},
                              {0.10, 14137.2, 0.161708},
                              {0.20, 16964.6, 0.337346}};
  for (const auto& [strain, n, u] : table) {
    expect_reference("weld beam: axial plasticity", fmt::format("N at plastic strain {} [N]", strain),
                     pull.at(plastic, strain, force), n, 2e-3);
    expect_reference("weld beam: axial plasticity", fmt::format("elongation at plastic strain {} [mm]", strain),
                     pull.at(plastic, strain, elongation), u, 2e-3);
  }
  const double yield = 2.8571e-3;
  const auto share = [&](const Driven::Sample& s) { return s.s * 2.0 * yield; };
  Driven onset({}, proportional({2.0 * yield}), 2000);
  expect_reference("weld beam: axial plasticity", "N at first yield [N]", onset.at(share, yield, force), 11309.7, 2e-3);
}

/// Node 2 on an arc about node 1, so that the beam does not get longer; without spin it is sheared by the angle of the
/// arc.
Path arc(const WeldData& w, double angle) {
  return [=](double s) { return SixDof{w.length * (std::cos(s * angle) - 1.0), w.length * std::sin(s * angle)}; };
}

// Sabotage to be caught: tau_y = SIGY / 2 (Tresca); shear counted once in the equivalent stress.
TEST(WeldBeam, ShearPlasticity) {
  const WeldData w;
  const double end = 0.04;
  Driven shear(w, arc(w, end), 4000, 4000);
  const auto angle = [&](const Driven::Sample& s) { return end * s.s; };
  const auto force = [](const Driven::Sample& s) { return s.r.shear_s; };
  const auto plastic = [](const Driven::Sample& s) { return s.plastic_strain; };
  expect_reference("weld beam: plasticity in shear, torsion and bending", "V at half the yield displacement [N]",
                   shear.at(angle, 0.5 * 4.28889e-3 / 1.5, force), 0.5 * 6529.68, 2e-2);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "V at first yield [N]",
                   shear.at(angle, 4.28889e-3 / 1.5, force), 6529.68, 2e-2);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "V at plastic strain 0.01 [N]",
                   shear.at(plastic, 0.01, force), 6692.9, 1e-2);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "shear angle at plastic strain 0.01",
                   shear.at(plastic, 0.01, angle), 0.020251, 1e-2);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "V at plastic strain 0.02 [N]",
                   shear.at(plastic, 0.02, force), 6856.2, 1e-2);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "shear angle at plastic strain 0.02",
                   shear.at(plastic, 0.02, angle), 0.037643, 1e-2);
}

// Sabotage to be caught: points on the rim (elastic torsion twice too stiff) or weights that do not add up to the area.
TEST(WeldBeam, TorsionPlasticity) {
  WeldData w{.hardening = 0.0};
  const double yield = 1.42963e-3, end = 10.0 * yield;
  const auto angle = [&](const Driven::Sample& s) { return end * s.s; };
  const auto torque = [](const Driven::Sample& s) { return s.r.torsion; };
  Driven coarse(w, proportional({0, 0, 0, end}), 2000);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "T at first yield [N mm]",
                   coarse.at(angle, 0.999 * yield, torque), 0.999 * 9794.5, 2e-2);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "limit torque, 4 points (QR 2) [N mm]",
                   coarse.end().torsion, 13852.0, 1e-2);
  w.quadrature = 4;
  Driven fine(w, proportional({0, 0, 0, end}), 2000);
  expect_reference("weld beam: plasticity in shear, torsion and bending",
                   "T/T_y at twice the yield angle, 48 points (QR 4)", fine.at(angle, 2.0 * yield, torque) / 9794.5,
                   1.2917, 8e-2);
  expect_reference("weld beam: plasticity in shear, torsion and bending",
                   "T/T_y at ten times the yield angle, 48 points (QR 4)", fine.end().torsion / 9794.5, 1.3330, 8e-2);
}

// Sabotage to be caught: moments about the wrong axis' lever; the same as for torsion.
TEST(WeldBeam, BendingPlasticity) {
  WeldData w{.hardening = 0.0};
  const double yield = 8482.3 / w.bending_stiffness(), end = 12.0 * yield;
  const auto angle = [&](const Driven::Sample& s) { return end * s.s; };
  const auto moment = [](const Driven::Sample& s) { return s.r.moment_t; };
  const Path bend = [&](double s) {
    const double half = 0.5 * s * end;
    return SixDof{w.length * (std::cos(half) - 1.0), w.length * std::sin(half), 0, 0, 0, 2.0 * half};
  };
  Driven coarse(w, bend, 2000, 2000);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "M at first yield [N mm]",
                   coarse.at(angle, 0.999 * yield, moment), 0.999 * 8482.3, 2e-2);
  expect_reference("weld beam: plasticity in shear, torsion and bending", "limit moment, 4 points (QR 2) [N mm]",
                   coarse.end().moment_t, 16965.0, 1e-2);
  w.quadrature = 4;
  expect_reference("weld beam: plasticity in shear, torsion and bending", "limit moment, 48 points (QR 4) [N mm]",
                   Driven(w, bend, 2000, 2000).end().moment_t, 14400.0, 8e-2);
}

// EFAIL in bending, 2 radii x 8 angles (docs/theory/beam.md#section-points): the points fail from the outside in, four
// at a time, and the weld goes with the last. Sabotage to be caught: the weld deleted with its first point; failed
// points that still pull.
TEST(WeldBeam, PointsFailOneByOneInBending) {
  const WeldData w{.hardening = 0.0, .failure_strain = 0.01, .quadrature = 3};
  std::array<double, 4> lever{};  // of four points each, from the outside in
  for (std::size_t i = 0; i < 4; ++i) {
    const double square = 0.5 * (1.0 + (i < 2 ? 1.0 : -1.0) / std::sqrt(3.0));
    lever[i] = 0.5 * w.diameter * std::sqrt(square) * std::cos((i % 2 == 0 ? 1 : 3) * std::numbers::pi / 8.0);
  }
  std::sort(lever.rbegin(), lever.rend());
  const auto angle_of_failure = [&](std::size_t i) { return w.length * (w.failure_strain + w.yield / w.E) / lever[i]; };
  const double end = 1.1 * angle_of_failure(3);
  Driven run(
      w,
      [&](double s) {
        const double half = 0.5 * s * end;
        return SixDof{w.length * (std::cos(half) - 1.0), w.length * std::sin(half), 0, 0, 0, 2.0 * half};
      },
      2000, 2000);
  for (std::size_t i = 0; i < 4; ++i) {  // midway between the failures of two groups
    const double angle = 0.5 * (angle_of_failure(i) + (i == 0 ? 0.5 * angle_of_failure(0) : angle_of_failure(i - 1)));
    double moment = 0.0;
    for (std::size_t k = i; k < 4; ++k)
      moment += 0.25 * w.area() * lever[k] * std::min(w.yield, w.E * lever[k] * angle / w.length);
    expect_reference("weld failure by plastic strain",
                     fmt::format("EFAIL in bending, {} of 16 points left: M [N mm]", 16 - 4 * i),
                     run.at([&](const Driven::Sample& x) { return end * x.s; }, angle,
                            [](const Driven::Sample& x) { return x.r.moment_t; }),
                     moment, 5e-3);
  }
  EXPECT_EQ(run.mode(), weld::FailureMode::plastic_strain);
  expect_reference("weld failure by plastic strain", "EFAIL in bending, angle at which the last points fail [rad]",
                   end * run.failure(), angle_of_failure(3), 5e-3);
}

const SixDof capacities{8000, 6000, 6000, 9000, 7000, 7000};

WeldData failing() {
  return {.yield = 2000.0, .strength = capacities};
}

/// Share of `load` at which the weld fails, loaded in proportion to it.
double failure_factor(const WeldData& w, const SixDof& load, double up_to = 1.25, int cycles = 4000) {
  SixDof end = elastic(w, load);
  for (double& c : end) c *= up_to;
  return up_to * Driven(w, proportional(end), cycles).failure();
}

// Sabotage to be caught: any term left out or taken twice; failure at f = 1 of the root; a strength of 0 read as no
// strength at all.
TEST(WeldFailure, SingleComponents) {
  const WeldData w = failing();
  constexpr const char* name[6] = {"N_rr", "N_rs", "N_rt", "M_rr", "M_ss", "M_tt"};
  for (std::size_t i = 0; i < 6; ++i)
    for (const double sign : {1.0, -1.0}) {
      if (i == 0 && sign < 0.0) continue;
      SixDof load{};
      load[i] = sign * capacities[i];
      expect_reference("weld failure by resultants", fmt::format("factor on {} = {} at failure", name[i], load[i]),
                       failure_factor(w, load), 1.0, 5e-3);
    }
  // The displacements at failure, against the stiffnesses that `elastic` uses.
  const double displacement[4] = {2.02102e-3, 3.94098e-3, 1.31366e-3, 7.85950e-4};
  const double used[4] = {elastic(w, {8000})[0], elastic(w, {0, 6000})[1], elastic(w, {0, 0, 0, 9000})[3],
                          elastic(w, {0, 0, 0, 0, 7000})[4]};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(used[i], displacement[i], 1e-5 * displacement[i]);
}

// Sabotage to be caught: |N_rr| in place of max(N_rr, 0).
TEST(WeldFailure, CompressionDoesNotFail) {
  const WeldData w = failing();
  Driven press(w, proportional(elastic(w, {-24000})), 4000);
  EXPECT_FALSE(press.failed());
  expect_reference("weld failure by resultants", "N under three times the capacity in compression [N]",
                   press.end().axial, -24000.0, 5e-3);
  EXPECT_LT(press.samples().back().failure, 1e-20);  // round-off in the shear forces
  expect_reference("weld failure by resultants", "factor on V = 6000 under equal compression",
                   failure_factor(w, {-6000, 6000}), 1.0, 5e-3);
}

TEST(WeldFailure, ForceAtAnAngle) {
  const WeldData w = failing();
  const double table[7][2] = {{0, 8000.0},  {15, 7799.4}, {30, 7319.9}, {45, 6788.2},
                              {60, 6357.8}, {75, 6089.9}, {90, 6000.0}};
  for (const auto& [degrees, force] : table) {
    const double a = degrees * std::numbers::pi / 180.0;
    // The shear runs between s and t, so that both terms count.
    const double v = 1e4 * std::sin(a) / std::sqrt(2.0);
    expect_reference("weld failure by resultants", fmt::format("failure force at {} degrees [N]", degrees),
                     1e4 * failure_factor(w, {1e4 * std::cos(a), v, v}), force, 5e-3);
  }
}

TEST(WeldFailure, AllComponents) {
  const WeldData w = failing();
  expect_reference("weld failure by resultants", "factor on N 4000, V 3000, T 4000, M 3000",
                   failure_factor(w, {4000, 3000, 0, 4000, 3000, 0}), 1.06527, 5e-3);
}

// Sabotage to be caught: a filter applied twice. (Its first values: tests/unit/weld/test_failure.cpp.)
TEST(WeldFailure, FilterOnlyDelays) {
  const int cycles = 6000;
  for (const SixDof& load : {SixDof{8000}, SixDof{0, 6000}, SixDof{4000, 3000, 0, 4000, 3000, 0}}) {
    WeldData w = failing();
    const double plain = failure_factor(w, load, 1.25, cycles);
    w.filter = 40;
    const double filtered = failure_factor(w, load, 1.25, cycles);
    EXPECT_GT(filtered, plain);
    // The mean of the last 40 values lags by 19.5 steps.
    EXPECT_NEAR((filtered - plain) / 1.25 * cycles, 19.5, 1.5);
    expect_reference("weld failure by resultants",
                     fmt::format("failure factor with NF = 40 over that without, N = {:g}", load[0]), filtered / plain,
                     1.0, 1e-2);
  }
}

// docs/theory/weld.md#reference-values.
TEST(WeldFailure, ClosedFormsOfTheResultantSurface) {
  WeldData w{.yield = 2000.0, .strength = {8000}};
  expect_reference("weld failure by resultants", "factor on N = 8000, NRR only", failure_factor(w, {8000}), 1.0, 5e-3);
  EXPECT_EQ(failure_factor(w, {-8000}, 3.0), 0.0);
  EXPECT_EQ(failure_factor(w, {0, 8000, 0, 8000, 8000}), 0.0);  // strengths of 0 are not considered
  w.strength = {8000, 6000};
  expect_reference("weld failure by resultants", "factor on N = NRR/sqrt 2, V = NRS/sqrt 2",
                   failure_factor(w, {8000 / std::sqrt(2.0), 6000 / std::sqrt(2.0)}), 1.0, 5e-3);
}

// The mode that is reported is the largest term's.
TEST(WeldFailure, ModeIsTheLargestTerm) {
  const WeldData w = failing();
  const auto mode = [&](const SixDof& load) { return Driven(w, proportional(elastic(w, load)), 1000).mode(); };
  EXPECT_EQ(mode({9600, 1000}), weld::FailureMode::axial);
  EXPECT_EQ(mode({1000, 5000, 5000}), weld::FailureMode::shear);
  EXPECT_EQ(mode({0, 0, 0, 9600}), weld::FailureMode::torsion);
  EXPECT_EQ(mode({0, 0, 0, 1000, 5400, 5400}), weld::FailureMode::bending);
}

// A free mass on the weld, pulled by a constant force; after TFAIL the mass is alone.
// Sabotage to be caught: the energy of the deleted weld left in the internal one, or forgotten; its mass taken away;
// the last force left in the slots.
TEST(WeldFailure, FailureTime) {
  const double force = 2000.0, added = 1e-4, tfail = 1e-3;
  WeldData w;
  w.failure_time = tfail;
  Experiment run("*KEYWORD\n" + termination(1.2e-3, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) +
                 weld_part(1, w) + beam_between(1, 1, 1, {0, 0, 0}, 2, {w.length, 0, 0}) + fixed({1}) +
                 "*ELEMENT_MASS\n" + fmt::format("{:8d}{:8d}{:16.8g}\n", 2, 2, added) +
                 curve(1, {{0, 0}, {2e-4, 1}, {1, 1}}) + "*LOAD_NODE_POINT\n" + fields({2, 1, 1, force}) + "*END\n");
  const double mass = added + 3.308097e-7 / 2.0;
  const std::size_t end = run.node(2);
  double last_force = 0.0, stored = 0.0, worst_balance = 0.0, acceleration = 0.0, last_time = 0.0;
  impact::Energy energy;
  run.run([&](const impact::Snapshot& now) {
    worst_balance = std::max(worst_balance, std::abs(now.energy.total() - now.energy.external));
    energy = now.energy;
    EXPECT_NEAR(now.system.mass[end], mass, 1e-6 * mass);
    if (!run.history(now, 1).failed()) {
      last_force = run.weld(now, 1).axial;
      last_time = now.state.time;
      stored = now.energy.internal;
      EXPECT_EQ(now.energy.eroded, 0.0);
    } else {
      EXPECT_EQ(run.weld(now, 1).axial, 0.0);
      acceleration = now.acceleration(end).x;
    }
  });
  EXPECT_NEAR(last_time, tfail, 3e-7);
  expect_reference("weld failure at a time", "time of failure, TFAIL = 1e-3 [s]",
                   run.simulation().components().welds.history(0)->failure_time(), tfail, 3e-4);
  // The load came slowly enough that the weld follows it within the oscillation that the ramp leaves (a few percent).
  expect_reference("weld failure at a time", "force just before TFAIL [N]", last_force, force, 5e-2);
  expect_reference("weld failure at a time", "eroded energy over F^2/2k [N mm]", energy.eroded,
                   0.5 * last_force * last_force / w.axial_stiffness(), 1e-2);
  EXPECT_EQ(energy.internal, 0.0);
  expect_reference("weld failure at a time", "eroded energy over the internal one before", energy.eroded / stored, 1.0,
                   5e-2);
  expect_reference("weld failure at a time", "acceleration of the free end afterwards [mm/s2]", acceleration,
                   force / mass, 1e-4);
  expect_reference("weld failure at a time", "energy balance, worst error over the energy that eroded",
                   worst_balance / energy.eroded, 0.0, 1e-3, 1.0);
}

}  // namespace
}  // namespace nugget::verify
