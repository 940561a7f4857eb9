// SPDX-License-Identifier: Apache-2.0
// A-10 of the validation suite, and MAT_100 beyond its failure surface on single welds: node 1 held, node 2 driven, so
// that no inertia enters. Closed forms: spotweld-theory.md 4.6.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "experiment.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

constexpr double step = 2e-7;  // below the stable step of the welds here

/// Weld W1 along x with a material card of the test's own; node 2 moves along x by `end`.
class Pulled {
 public:
  struct Sample {
    double u, axial, plastic_strain, work, eroded;
  };

  Pulled(const std::string& material, double end, int cycles) {
    const WeldData w;
    Experiment run("*KEYWORD\n" + termination(cycles * step, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) +
                   "*PART\nwelds\n" + fields({1, 1, 1}) + "*SECTION_BEAM\n" + fields({1, 9, 1, 2, 1}) +
                   fields({w.diameter, w.diameter, 0, 0}) + material +
                   beam_between(1, 1, 1, {0, 0, 0}, 2, {w.length, 0, 0}) + fixed({1}) +
                   driven(
                       2, [&](double s) { return std::array<double, 6>{s * end}; }, cycles * step, 1, 100) +
                   "*END\n");
    run.run([&](const impact::Snapshot& now) {
      const system::System::Seat seat = now.system.beam_seat[0];
      const auto& group = *now.system.groups[static_cast<std::size_t>(seat.group)];
      samples.push_back({run.displacement(now, 2).x, run.weld(now, 1).axial,
                         group.layer(0, 0, now.state).plastic_strain, now.energy.internal + now.energy.eroded,
                         now.energy.eroded});
    });
  }

  /// A value at the moment when `of` first reaches `level`, interpolated.
  double at(double Sample::*of, double level, double Sample::*value) const {
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const double a = samples[i - 1].*of, b = samples[i].*of;
      if (a > level || b < level || a == b) continue;
      const double w = (level - a) / (b - a);
      return (1.0 - w) * samples[i - 1].*value + w * samples[i].*value;
    }
    ADD_FAILURE() << "the level " << level << " is never reached";
    return 0.0;
  }

  std::vector<Sample> samples;
};
using Sample = Pulled::Sample;

std::string damaging(double efail, double rs, int dmgopt, double beta = 0.0) {
  return "*MAT_SPOTWELD_DAMAGE-FAILURE\n" + fields({1, 7.8e-9, 210000, 0.3, 400, 1000}) + fields({efail}) +
         fields({rs, 0, 0, 0, 0, beta, 0, static_cast<double>(dmgopt)});
}

constexpr double area = 28.2743;

// Sabotage to be caught: the return on the damaged stress; EFAIL taken for the strain of rupture; work of the sound
// force booked.
TEST(WeldDamage, A10LinearDamageOverPlasticStrain) {
  const double end = 0.54;
  const Pulled pull(damaging(0.2, 0.3, 0), end, 6000);
  const double table[3][3] = {{0.225, 13253.6, 0.384083}, {0.25, 9189.2, 0.432009}, {0.275, 4771.3, 0.481154}};
  expect_reference("A-10", "N at plastic strain 0.2, where the damage begins [N]",
                   pull.at(&Sample::plastic_strain, 0.2, &Sample::axial), 16964.6, 1e-2);
  for (const auto& [strain, n, u] : table) {
    expect_reference("A-10", fmt::format("N at plastic strain {} [N]", strain),
                     pull.at(&Sample::plastic_strain, strain, &Sample::axial), n, 1e-2);
    expect_reference("A-10", fmt::format("elongation at plastic strain {} [mm]", strain),
                     pull.at(&Sample::plastic_strain, strain, &Sample::u), u, 1e-2);
  }
  double jump = 0.0, broken = 0.0;
  for (std::size_t i = 1; i < pull.samples.size(); ++i) {
    const Sample &before = pull.samples[i - 1], &now = pull.samples[i];
    if (before.plastic_strain > 0.1) jump = std::max(jump, std::abs(now.axial - before.axial));
    if (before.axial > 0.0 && now.axial == 0.0) broken = now.u;
  }
  expect_reference("A-10",
                   "largest jump of N from one cycle to the next beyond plastic strain 0.1, over N at the onset",
                   jump / 16964.6, 0.0, 2e-2, 1.0);
  expect_reference("A-10", "elongation at rupture [mm]", broken, 0.531549, 1e-2);
  const double to_onset = pull.at(&Sample::plastic_strain, 0.2, &Sample::work);
  expect_reference("A-10", "work to the onset [N mm]", to_onset, 4776.5, 2e-2);
  expect_reference("A-10", "work in the damage branch [N mm]", pull.samples.back().eroded - to_onset, 1711.2, 2e-2);
}

TEST(WeldDamage, StressLimitAfterTheOnset) {
  const Pulled pull(damaging(0.05, 0.1, 1), 0.2, 4000);
  expect_reference("theory 4.6", "N at half damage with the yield stress held (DMGOPT 1) [N]",
                   pull.at(&Sample::plastic_strain, 0.075, &Sample::axial), 0.5 * 450.0 * area, 1e-2);
}

TEST(WeldDamage, ExponentialDamage) {
  const Pulled pull(damaging(0.05, 0.1, 0, 3.0), 0.2, 4000);
  expect_reference("theory 4.6", "N at w = 0.5 with BETA = 3 [N]",
                   pull.at(&Sample::plastic_strain, 0.075, &Sample::axial), std::exp(-1.5) * 475.0 * area, 1e-2);
}

TEST(WeldDamage, DamageOverTime) {
  const int cycles = 4000, fading = 1000;
  const Pulled pull(damaging(0.05, fading * step, 2), 0.2, cycles);
  std::size_t onset = 0;
  while (pull.samples[onset].plastic_strain <= 0.05) ++onset;
  expect_reference("theory 4.6", "N a quarter of RS after the onset (DMGOPT 2) [N]",
                   pull.samples[onset + fading / 4].axial, 0.75 * 450.0 * area, 1e-2);
  EXPECT_GT(pull.samples[onset + fading - 3].axial, 0.0);
  EXPECT_EQ(pull.samples[onset + fading + 2].axial, 0.0);
}

// One weld, three rates of a yield table (SIGY < 0): the stress of each rate's own curve.
TEST(WeldDamage, YieldTableOverStrainRate) {
  const std::string table = "*MAT_SPOTWELD\n" + fields({1, 7.8e-9, 210000, 0.3, -5}) + fields({0}) + "*DEFINE_TABLE\n" +
                            fields({5}) + fields({1.0}) + fields({100.0}) + fields({10000.0}) +
                            curve(6, {{0.0, 400.0}, {0.5, 600.0}}) + curve(7, {{0.0, 500.0}, {0.5, 700.0}}) +
                            curve(8, {{0.0, 700.0}, {0.5, 800.0}});
  // Plastic strain 0.05 is reached at about u = 0.08 of 1.5 mm; the path is straight, so that the rate is u' / L.
  const double rate[3] = {30.0, 100.0, 300.0};
  for (int i = 0; i < 3; ++i) {
    const double end = 0.1, time = end / (1.555 * rate[i]);
    const double expected = i == 0   ? 420.0 + 100.0 * (30.0 - 1.0) / 99.0
                            : i == 1 ? 520.0
                                     : 520.0 + 190.0 * 200.0 / 9900.0;
    const Pulled pull(table, end, static_cast<int>(time / step));
    expect_reference("theory 2.4",
                     fmt::format("N at plastic strain 0.05 and rate {:g}, table of yield curves [N]", rate[i]),
                     pull.at(&Sample::plastic_strain, 0.05, &Sample::axial), expected * area, 5e-3);
  }
}

}  // namespace
}  // namespace nugget::verify
