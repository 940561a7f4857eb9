// SPDX-License-Identifier: Apache-2.0
// The failure functions of MAT_100 through the program, on one weld beam between two sheets: tension, shear, bending,
// torsion and a path that mixes them until it crosses the failure surface; strengths at three strain rates. References
// are worked from the formulas of docs/theory/failure.md by a script of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "experiment.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

using SixDof = std::array<double, 6>;
using weld::FailureMode;

constexpr double step = 2e-7;  // below the stable step of the weld

/// Weld W1 (d = 6, L = 1.5), which does not yield here, along x from sheet 2 (part 2, 1 mm) to sheet 3 (part 3, 1.5
/// mm). Each sheet is one shell; all its nodes follow the same path, and with them the end of the weld.
struct Joint {
  std::string material;   ///< second and third card of *MAT_SPOTWELD_DAMAGE-FAILURE
  std::string more{};     ///< keywords that the material needs
  bool in_sheets = true;  ///< else its own nodes are driven, and it carries torsion
  WeldData weld{.yield = 1e5};
  std::string sheet_material = "*MAT_ELASTIC\n" + fields({2, 7.85e-9, 210000.0, 0.3});

  std::string text(const Path& path, int cycles) const {
    const double end = cycles * step;
    std::string deck = "*KEYWORD\n" + termination(end, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) +
                       "*PART\nwelds\n" + fields({1, 1, 1}) + "*SECTION_BEAM\n" + fields({1, 9, 1, 2, 1}) +
                       fields({weld.diameter, weld.diameter, 0, 0}) + "*MAT_SPOTWELD_DAMAGE-FAILURE\n" +
                       fields({1, weld.density, weld.E, weld.nu, weld.yield, weld.hardening}) + material + more +
                       beam_between(1, 1, 1, {0, 0, 0}, 2, {weld.length, 0, 0});
    if (!in_sheets) return deck + fixed({1}) + driven(2, path, end, 1, 100) + "*END\n";
    for (const int sheet : {2, 3}) {
      const double thickness = 0.5 * sheet;
      const SheetMesh mesh{.first = 100 * sheet,
                           .part = sheet,
                           .corner = {sheet == 2 ? 0.0 : weld.length, -5, -5},
                           .along = {0, 10, 0},
                           .across = {0, 0, 10}};
      deck += "*PART\nsheet\n" + fields({double(sheet), double(sheet), 2}) + "*SECTION_SHELL\n" +
              fields({double(sheet), 2, 0.8333, 3}) + fields({thickness, thickness, thickness, thickness}) +
              mesh.text();
    }
    deck += sheet_material + weld_contact_to_set(1, {2, 3}) + fixed({200, 201, 202, 203});
    for (int i = 0; i < 4; ++i) deck += driven(300 + i, path, end, 1, 100 + 10 * i);
    return deck + "*END\n";
  }
};

/// Displacement of end 2 for given N_rr, N_rs, N_rt, M_rr, M_ss, M_tt.
SixDof elastic(const WeldData& w, const SixDof& r) {
  const double ss = r[4] / w.bending_stiffness(), tt = r[5] / w.bending_stiffness();
  return {r[0] / w.axial_stiffness(),
          r[1] / w.shear_stiffness() + 0.5 * w.length * tt,
          r[2] / w.shear_stiffness() - 0.5 * w.length * ss,
          r[3] / w.torsion_stiffness(),
          ss,
          tt};
}

struct Outcome {
  double factor = 0.0;  ///< share of the load at failure; 0: it did not fail
  FailureMode mode = FailureMode::intact;
  double peak = 0.0, peak_factor = 0.0;  ///< largest failure value, and the share of the load at it
  double rate = 0.0;                     ///< effective strain rate at the end
};

/// Loads the joint in proportion to `load`, up to `up_to` times it.
Outcome pull(const Joint& joint, const SixDof& load, double up_to = 1.25, int cycles = 4000) {
  SixDof end = elastic(joint.weld, load);
  for (double& c : end) c *= up_to;
  const Path path = [&](double s) {
    SixDof u = end;
    for (double& c : u) c *= s;
    return u;
  };
  Experiment run(joint.text(path, cycles));
  run.run([](const impact::Snapshot&) {});
  const weld::History& h = *run.simulation().components().welds.history(0);
  const double scale = up_to / (cycles * step);
  return {scale * h.failure_time(), h.mode(), h.peak_failure_value(), scale * h.peak_failure_time(),
          h.last_load().rate};
}

std::string cards(std::initializer_list<double> second, std::initializer_list<double> third) {
  return fields(second) + fields(third);
}

const SixDof tension{4000}, shear{0, 4000}, bending{0, 0, 0, 0, 0, 3000}, torsion{0, 0, 0, 4000},
    mixed{2000, 1500, 0, 0, 0, 1500};

void expect_factor(const Joint& joint, const std::string& opt, const std::string& what, const SixDof& load,
                   double factor, FailureMode mode) {
  const Outcome out = pull(joint, load, 1.25 * factor);
  expect_reference(opt, fmt::format("factor on {} at failure", what), out.factor, factor, 5e-3);
  EXPECT_EQ(out.mode, mode) << opt << ", " << what;
}

// Sabotage to be caught: Z for 2 Z in torsion; A of the radius; the root of the sum of squares taken twice.
TEST(WeldFailureFunctions, BeamStress) {
  const Joint joint{.material = cards({0, 320, 190}, {0, 1}), .in_sheets = false};
  // N 4000, V 2500, T 2000, M 3000; shear between s and t, bending about both.
  expect_factor(joint, "weld failure by stresses", "N 4000, V 2500, T 2000, M 3000",
                {4000, 1500, 2000, 2000, 1800, 2400}, 0.88012, FailureMode::normal_stress);
  expect_factor(joint, "weld failure by stresses", "N = 4000 (OPT 1)", tension, 2.26195, FailureMode::normal_stress);
  expect_factor(joint, "weld failure by stresses", "V = 4000 (OPT 1)", shear, 1.34303, FailureMode::shear_stress);
  expect_factor(joint, "weld failure by stresses", "M = 3000 (OPT 1)", bending, 2.26195, FailureMode::normal_stress);
  expect_factor(joint, "weld failure by stresses", "T = 4000 (OPT 1)", torsion, 2.01455, FailureMode::shear_stress);
  EXPECT_EQ(pull(joint, {-4000}, 10.0).factor, 0.0);
}

// Sabotage to be caught: alpha_i on the wrong term; t and d exchanged; sheet 2's thickness taken (t = 1 is sheet 1's).
TEST(WeldFailureFunctions, Opt3NotchStress) {
  const Joint joint{.material = cards({0, 0, 0, 1, 1, 1, 0.25}, {0, 3, 1500})};
  expect_factor(joint, "weld failure functions", "N = 4000 (OPT 3)", tension, 1.180873, FailureMode::axial);
  expect_factor(joint, "weld failure functions", "V = 4000 (OPT 3)", shear, 0.950532, FailureMode::shear);
  expect_factor(joint, "weld failure functions", "M = 3000 (OPT 3)", bending, 0.682083, FailureMode::bending);
  expect_factor(joint, "weld failure functions", "N 2000, V 1500, M 1500 (OPT 3)", mixed, 0.644754,
                FailureMode::bending);
  const Joint weighted{.material = cards({0, 0, 0, 2, 1.25, 1.5, 0.25}, {0, 3, 1500})};  // each divides its own factor
  expect_factor(weighted, "weld failure functions", "N = 4000, ZALP3 1.5 (OPT 3)", tension, 1.180873 / 1.5,
                FailureMode::axial);
  expect_factor(weighted, "weld failure functions", "V = 4000, ZALP1 2 (OPT 3)", shear, 0.950532 / 2.0,
                FailureMode::shear);
  expect_factor(weighted, "weld failure functions", "M = 3000, ZALP2 1.25 (OPT 3)", bending, 0.682083 / 1.25,
                FailureMode::bending);
}

TEST(WeldFailureFunctions, Opt4StressIntensity) {
  const Joint joint{.material = cards({0, 6, 1, 1, 1, 1}, {0, 4, 300})};
  expect_factor(joint, "weld failure functions", "N = 4000 (OPT 4)", tension, 0.599789, FailureMode::axial);
  expect_factor(joint, "weld failure functions", "V = 4000 (OPT 4)", shear, 0.648658, FailureMode::shear);
  expect_factor(joint, "weld failure functions", "M = 3000 (OPT 4)", bending, 0.544140, FailureMode::bending);
  expect_factor(joint, "weld failure functions", "N 2000, V 1500, M 1500 (OPT 4)", mixed, 0.487331,
                FailureMode::bending);
}

// Small loads: sheared by more, the weld gets longer, and these stresses are 33 times as sensitive to N as to V.
TEST(WeldFailureFunctions, Opt5StructuralStress) {
  const Joint joint{.material = cards({0}, {0, 5, 4})};  // both thicknesses are the sheets'
  expect_factor(joint, "weld failure functions", "N = 4 (OPT 5)", {4}, 0.573394, FailureMode::sheet_1);
  expect_factor(joint, "weld failure functions", "V = 60 (OPT 5)", {0, 60}, 1.256637, FailureMode::sheet_1);
  expect_factor(joint, "weld failure functions", "M = 15 (OPT 5)", {0, 0, 0, 0, 0, 15}, 0.854701, FailureMode::sheet_1);
  expect_factor(joint, "weld failure functions", "N 2, V 15, M 8 (OPT 5)", {2, 15, 0, 0, 0, 8}, 0.589990,
                FailureMode::sheet_1);
  const Joint thick{.material = cards({0, 6, 3, 3}, {0, 5, 4})};
  expect_factor(thick, "weld failure functions", "V = 60, t = 3 (OPT 5, nugget)", {0, 60}, 1.413717,
                FailureMode::nugget);
}

/// Steel with a Cowper-Symonds factor of 1 + (rate / 40)^(1/5).
const std::string rated_sheets =
    "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + fields({2, 7.85e-9, 210000.0, 0.3, 1e6}) + fields({40, 5}) + "\n\n";

// The load comes at a constant strain rate, so the strength is known. Sabotage to be caught: strengths of the stronger
// sheet; the factor left out (1.5 here).
TEST(WeldFailureFunctions, Opt6RuptureStressOfTheWeakerSheet) {
  Joint joint{.material = cards({0}, {0, 6}),
              .more = "*DEFINE_SPOTWELD_RUPTURE_STRESS\n" + fields({2, 400, 240}) + fields({3, 300, 250}),
              .sheet_material = rated_sheets};
  const WeldData& w = joint.weld;
  const double area = w.area(), modulus = area * w.diameter / 8.0, up_to = 4.0;
  const int cycles = 4000;
  // Effective rate of a strain that grows to `strain` over the run.
  const auto factor = [&](double strain) { return 1.0 + std::pow(strain / (cycles * step) / 40.0, 0.2); };
  const double pulled = up_to * 4000 / w.axial_stiffness() / w.length;
  expect_reference("weld failure functions", "factor on N = 4000 at failure (OPT 6, weaker sheet, rate factor)",
                   pull(joint, tension, up_to, cycles).factor, 300 * factor(pulled) * area / 4000, 5e-3);
  const double sheared = up_to * 4000 / w.shear_stiffness() / w.length / std::sqrt(3.0);
  expect_reference("weld failure functions", "factor on V = 4000 at failure (OPT 6, weaker sheet, rate factor)",
                   pull(joint, shear, up_to, cycles).factor, 240 * factor(sheared) * area / 4000, 5e-3);
  // Bending: all four points lie at d/4 from the axis.
  const double bent = up_to * 3000 / w.bending_stiffness() / w.length * w.diameter / 4.0;
  expect_reference("weld failure functions", "factor on M = 3000 at failure (OPT 6, weaker sheet, rate factor)",
                   pull(joint, bending, up_to, cycles).factor, 300 * factor(bent) * modulus / 3000, 5e-3);
}

// FVAL of OPT 6 counts cycles at or beyond the surface.
TEST(WeldFailureFunctions, Opt6FailsAfterItsCycles) {
  Joint joint{.material = cards({0}, {0, 6}), .more = "*DEFINE_SPOTWELD_RUPTURE_STRESS\n" + fields({2, 300, 0})};
  const double at_once = pull(joint, tension, 2.5, 4000).factor;
  joint.material = cards({0}, {0, 6, 400});
  expect_reference("weld failure functions", "cycles beyond the surface before failure (OPT 6, FVAL = 400)",
                   (pull(joint, tension, 2.5, 4000).factor - at_once) / 2.5 * 4000 + 1.0, 400, 5e-3);
}

// Sabotage to be caught: the default in place of the pair's strengths, which are given in the other order.
TEST(WeldFailureFunctions, Opt7StrengthsOfThePair) {
  const Joint joint{.material = cards({0}, {0, 7}),
                    .more = "*DEFINE_SPOTWELD_FAILURE_RESULTANTS\n" + fields({1, 900, 900}) + fields({3, 2, 320, 190})};
  expect_factor(joint, "weld failure functions", "N = 4000 (OPT 7)", tension, 2.26195, FailureMode::normal_stress);
  expect_factor(joint, "weld failure functions", "V = 4000 (OPT 7)", shear, 1.34303, FailureMode::shear_stress);
  expect_factor(joint, "weld failure functions", "M = 3000 (OPT 7)", bending, 2.26195, FailureMode::normal_stress);
  expect_factor(joint, "weld failure functions", "N 2000, V 1500, M 1500 (OPT 7)", mixed, 1.91245,
                FailureMode::normal_stress);
}

// DC4 of 1e30: so slow that strengths are static. d t = 6 (sheet 1).
TEST(WeldFailureFunctions, Opt10NominalStress) {
  Joint joint{.material = cards({0}, {0, 10, 5}),
              .more = "*DEFINE_SPOTWELD_FAILURE\n" + fields({5, 0, 0, 0, 0, 1e30}) + fields({0, 900, 900}) +
                      fields({2, 800, 600})};
  expect_factor(joint, "weld failure functions", "N = 4000 (OPT 10)", tension, 1.2, FailureMode::normal_stress);
  expect_factor(joint, "weld failure functions", "V = 4000 (OPT 10)", shear, 0.9, FailureMode::shear_stress);
  expect_factor(joint, "weld failure functions", "N = 2000, V = 1500 (OPT 10)", {2000, 1500},
                1.0 / std::hypot(2.0 / 4.8, 1.5 / 3.6), FailureMode::normal_stress);
  // Force rate 1e4 N a millisecond, a thousand times DC4: strengths 4.462375 times the static ones.
  const double rate = 4.462375 * 1.25 * 4800 / (4000 * step);
  joint.more = "*DEFINE_SPOTWELD_FAILURE\n" + fields({5, 0, 0, 0, 0, rate / 1000}) + fields({8, 900, 900}) +
               fields({2, 800, 600});
  expect_reference("weld failure functions", "factor on N = 4800 at failure (OPT 10, dynamic)",
                   pull(joint, {4800}, 4.462375 * 1.25).factor, 4.462375, 5e-3);
}

TEST(WeldFailureFunctions, Opt11ForceOverDirection) {
  const Joint joint{.material = cards({0, 70, 71}, {0, 11}),
                    .more = curve(70, {{0, 6000}, {90, 8000}}) + curve(71, {{0, 6000}, {90, 20000}})};
  expect_factor(joint, "weld failure functions", "N = 4000 (OPT 11)", tension, 2.0, FailureMode::tension);
  expect_factor(joint, "weld failure functions", "N = -4000 (OPT 11)", {-4000}, 5.0, FailureMode::compression);
  expect_factor(joint, "weld failure functions", "N = V = 3000, at 45 degrees (OPT 11)", {3000, 0, 3000},
                7000.0 / (3000.0 * std::sqrt(2.0)), FailureMode::tension);
  EXPECT_EQ(pull(joint, bending, 5.0).factor, 0.0);  // moments do not count
}

// Three speeds, at which the curve of NRR (NRS) has its points. Sabotage to be caught: the rate of the engineering
// shear (sqrt 3 too high); the elongation in place of the strain; the first value of the curve at all rates.
TEST(WeldFailureFunctions, StrengthsAtThreeStrainRates) {
  const Joint joint{.material = cards({0, -70, -71}, {0}),
                    .more = curve(70, {{0.5, 6000}, {1, 8000}, {5, 9000}, {20, 10000}, {40, 15000}}) +
                            curve(71, {{0.5, 4000}, {1, 6000}, {5, 7000}, {20, 9000}, {40, 12000}})};
  const WeldData& w = joint.weld;
  for (const auto& [rate, n, v] : {std::array{1.0, 8000.0, 6000.0}, {5.0, 9000.0, 7000.0}, {20.0, 10000.0, 9000.0}}) {
    const double axial = 1.25 * n / w.axial_stiffness() / w.length;
    const int cycles = static_cast<int>(std::lround(axial / rate / step));
    const Outcome in_tension = pull(joint, {n}, 1.25, cycles);
    expect_reference("weld failure by resultants", fmt::format("effective strain rate in tension at {} 1/s", rate),
                     in_tension.rate, rate, 5e-3);
    expect_reference("weld failure by resultants", fmt::format("N at failure over NRR({} 1/s)", rate),
                     in_tension.factor, 1.0, 5e-3);
    const double sheared = 1.25 * v / w.shear_stiffness() / w.length / std::sqrt(3.0);
    expect_reference("weld failure by resultants", fmt::format("V at failure over NRS({} 1/s)", rate),
                     pull(joint, {0, v}, 1.25, static_cast<int>(std::lround(sheared / rate / step))).factor, 1.0, 5e-3);
  }
}

// OPT -1 and -2 compute the value of OPT 0 and hold; the largest is kept with its time.
TEST(WeldFailureFunctions, OptMinus1AndMinus2Hold) {
  for (const double option : {-1.0, -2.0}) {
    const Outcome out = pull({.material = cards({0, 8000, 6000}, {0, option})}, tension, 4.0);
    EXPECT_EQ(out.factor, 0.0);
    expect_reference("weld failure by resultants", fmt::format("largest failure value at N = 2 NRR (OPT {})", option),
                     out.peak, 4.0, 5e-3);
    EXPECT_NEAR(out.peak_factor, 4.0, 1e-2);
  }
}

// A weld between rigid plates, pulled along its axis at a lever: N = F, M = F e at every section. Sabotage to be
// caught: the moment taken at one end of a sheared weld; bending left out of the surface.
TEST(WeldFailureFunctions, RigidCoachPeel) {
  const struct { double lever, force; } peels[] = {{2, 3206.6}, {5, 1379.0}, {10, 697.3}, {20, 349.7}};
  for (const auto& [lever, force] : peels) {
    WeldData w;
    w.yield = 2000.0;
    w.strength = {8000, 6000, 6000, 9000, 7000, 7000};
    const double end = 2e-3, most = 1.2 * force;  // a thousand periods of the plate on its weld
    Experiment run(
        "*KEYWORD\n" + termination(end) + weld_part(2, w) + "*PART\nplate\n" + fields({1, 1, 1}) + "*SECTION_SHELL\n" +
        fields({1, 2, 1, 2}) + fields({1, 1, 1, 1}) + "*MAT_RIGID\n" + fields({1, 7.85e-9, 210000, 0.3}) + fields({0}) +
        fields({0}) + "*CONSTRAINED_EXTRA_NODES_NODE\n" + fields({1, 6}) + fields({1, 7}) +
        SheetMesh{.corner = {-5, -5, 1.5}, .along = {30, 0, 0}, .across = {0, 10, 0}}.text() +
        beam_between(11, 2, 5, {0, 0, 0}, 6, {0, 0, 1.5}) + "*NODE\n" + node_line(7, lever, 0, 1.5) + fixed({5}) +
        curve(1, {{0.0, 0.0}, {end, most}}) + "*LOAD_NODE_POINT\n" + fields({7, 3, 1, 1}) + "*END\n");
    run.run([](const impact::Snapshot&) {});
    const weld::History& history = *run.simulation().components().welds.history(0);
    ASSERT_TRUE(history.failed());
    expect_reference("peel of rigid sheets at a lever", fmt::format("force at failure, lever {} [N]", lever),
                     most * history.failure_time() / end, force, 1e-2);
  }
}

}  // namespace
}  // namespace nugget::verify
