// SPDX-License-Identifier: Apache-2.0
// Modes of spot-welded sheets against three-dimensional models by CalculiX (docs/verification/cases.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "linear.hpp"
#include "nvh/eigen/weld_drop.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

const char* const solution =
    "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n        20\n";

double closest_to(double wanted, const std::vector<double>& found) {
  double closest = 0.0;
  for (const double f : found)
    if (std::abs(f - wanted) < std::abs(closest - wanted)) closest = f;
  return closest;
}

/// Two strips 300 x 20 x 1.5 with five welds on their middle line; `share` of the stiffness and mass of steel in the
/// welds.
std::string strips(int along, int across, double share = 1.0) {
  std::string deck = "*KEYWORD\n" + std::string(solution) + sheet_part(1, 1.5) + sheet_part(2, 1.5);
  WeldData weld;
  weld.length = 1.5;
  weld.E *= share;
  weld.density = share * 7.85e-9;
  deck += weld_part(3, weld) + weld_contact_to_set(3, {1, 2});
  for (int sheet = 0; sheet < 2; ++sheet) {
    SheetMesh mesh;
    mesh.first = 1 + 10000 * sheet;
    mesh.part = 1 + sheet;
    mesh.corner = {0.0, 0.0, 1.5 * sheet};
    mesh.nx = along;
    mesh.ny = across;
    mesh.along = {300.0 / along, 0, 0};
    mesh.across = {0, 20.0 / across, 0};
    deck += mesh.text();
  }
  for (int w = 0; w < 5; ++w) {
    const double x = 30.0 + 60.0 * w;
    deck += beam_between(90001 + w, 3, 90001 + 2 * w, {x, 10.0, 0.0}, 90002 + 2 * w, {x, 10.0, 1.5});
  }
  return deck + "*END\n";
}

// Sabotage: the weld nodes tied without rotations.
TEST(WeldedModes, TwoStripsOnTheGuidelineMesh) {
  const LinearExperiment experiment(strips(45, 3));
  const std::vector<double> f = experiment.elastic_frequencies(8);
  for (const double expected : {167.60, 410.77, 713.82})
    expect_reference("two welded strips",
                     fmt::format("two strips, 5 welds in the middle of shells, bending at {} [Hz]", expected),
                     closest_to(expected, f), expected, 1.5e-2);
  expect_reference("two welded strips", "two strips, 5 welds in the middle of shells, torsion [Hz]",
                   closest_to(813.94, f), 813.94, 5e-2);
}

// A weld on a node holds fewer shells and is softer; shells wider than the weld make it stiffer.
TEST(WeldedModes, TwoStripsOnOtherMeshes) {
  const double on_a_node = closest_to(161.4, LinearExperiment(strips(30, 2)).elastic_frequencies(4));
  const double wide = closest_to(170.5, LinearExperiment(strips(15, 1)).elastic_frequencies(4));
  expect_reference("two welded strips", "two strips, welds on nodes, h = 10: bending at 167.6 [Hz]", on_a_node, 167.60,
                   0.1);
  expect_reference("two welded strips", "two strips, welds in the middle of shells, h = 20: bending at 167.6 [Hz]",
                   wide, 167.60, 0.1);
  EXPECT_LT(on_a_node, 167.60);
  EXPECT_GT(wide, 167.60);
}

/// Hat and closing plate with shells of 6 mm; welds at every `step`-th place.
std::string hat(int step) {
  std::string deck = "*KEYWORD\n" + std::string(solution) + sheet_part(1, 1.2) + sheet_part(2, 1.2);
  WeldData weld;
  weld.length = 1.2;
  weld.density = 7.85e-9;
  deck += weld_part(3, weld) + weld_contact_to_set(3, {1, 2});
  constexpr double h = 6.0, gap = 1.2;
  constexpr int along = 93;
  std::vector<std::pair<double, double>> profile;
  const auto line = [&](double y, double z, double dy, double dz, int cells) {
    for (int i = 0; i < cells; ++i) profile.emplace_back(y + i * dy, z + i * dz);
  };
  line(0, gap, h, 0, 3);
  line(18, gap, 0, h, 8);
  line(18, gap + 48, h, 0, 10);
  line(78, gap + 48, 0, -h, 8);
  line(78, gap, h, 0, 4);
  const int points = static_cast<int>(profile.size());
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j < points; ++j) nodes += node_line(1 + j + i * points, i * h, profile[j].first, profile[j].second);
  for (int i = 0; i < along; ++i)
    for (int j = 0; j + 1 < points; ++j) {
      const int n = 1 + j + i * points;
      shells += element_line(1 + j + i * (points - 1), 1, {n, n + points, n + points + 1, n + 1});
    }
  SheetMesh plate;
  plate.first = 20001;
  plate.part = 2;
  plate.nx = along;
  plate.ny = 16;
  plate.along = {h, 0, 0};
  plate.across = {0, h, 0};
  deck += nodes + shells + plate.text();
  int id = 90001;
  for (int w = 0; w < 15; w += step)
    for (const double y : {9.0, 87.0}) {
      const double x = 27.0 + 36.0 * w;
      deck += beam_between(id, 3, id, {x, y, 0.0}, id + 1, {x, y, gap});
      id += 2;
    }
  return deck + "*END\n";
}

// Sabotage: the weld nodes tied without rotations.
TEST(WeldedModes, HatWithClosingPlate) {
  const LinearExperiment whole(hat(1)), half(hat(2));
  const std::vector<double> all = whole.elastic_frequencies(10), fewer = half.elastic_frequencies(4);
  const double expected[] = {428.96, 438.86, 723.84, 752.36, 801.33, 845.20, 890.64, 918.26, 932.54, 963.68};
  for (std::size_t i = 0; i < 10; ++i)
    expect_reference("hat and closing plate",
                     fmt::format("hat and plate, 30 welds, shells of 6 mm: mode {} [Hz]", i + 1), all[i], expected[i],
                     5e-2);
  const double shift[] = {408.31 / 428.96 - 1.0, 411.17 / 438.86 - 1.0};
  for (std::size_t i = 0; i < 2; ++i)
    expect_reference("hat and closing plate, every second weld",
                     fmt::format("the same with every second weld: shift of mode {} [%]", i + 1),
                     100.0 * (fewer[i] / all[i] - 1.0), 100.0 * shift[i], 2.0, 1.0);
}

// From one solution of the whole structure: the modes without half of its welds, against the deck without them and the
// three-dimensional shifts. Sabotage: no answers to the inertia of the static answers; the mass of the welds left in.
TEST(WeldedModes, HatWithoutHalfOfItsWelds) {
  const LinearExperiment whole(hat(1)), half(hat(2));
  const nvh::Modes modes = whole.modes(16), fewer = half.modes(10);
  nvh::WeldGroup odd;
  for (std::size_t w = 2; w < 30; w += 4) odd.insert(odd.end(), {w, w + 1});  // two at each place along the hat
  const nvh::WeldDrop drop = nvh::drop_welds(whole.matrices(), modes, {odd}).front();
  const double shift[] = {408.31 / 428.96 - 1.0, 411.17 / 438.86 - 1.0};
  for (std::size_t i = 6; i < 8; ++i) {
    const double estimate = std::sqrt(drop.eigenvalue[i] / modes.eigenvalue[i]) - 1.0;
    expect_reference("hat and closing plate, every second weld",
                     fmt::format("the same from one solution: shift of mode {} [%]", i - 5), 100.0 * estimate,
                     100.0 * shift[i - 6], 2.0, 1.0);
    EXPECT_NEAR(drop.eigenvalue[i] / fewer.eigenvalue[i], 1.0, 1e-5);
    EXPECT_GT(drop.mac[i], 0.99);
    EXPECT_NEAR(drop.first_order[i] / modes.eigenvalue[i], 1.0, 2e-3);  // perturbation does not see it
  }
}

// Perturbation is right for small changes: two thousandths of the stiffness and mass of all welds. Sabotage: the sign
// of either term.
TEST(WeldedModes, PerturbationBySofterWelds) {
  const LinearExperiment whole(strips(45, 3));
  const nvh::Modes modes = whole.modes(12);
  const std::vector<nvh::WeldDrop> drop = nvh::drop_welds(whole.matrices(), modes, {{0, 1, 2, 3, 4}});
  const nvh::Modes weak = LinearExperiment(strips(45, 3, 0.998)).modes(12);
  for (std::size_t i = 6; i < 12; ++i) {
    const double expected = 0.002 * (drop[0].first_order[i] - modes.eigenvalue[i]);
    EXPECT_NEAR(weak.eigenvalue[i] - modes.eigenvalue[i], expected,
                0.03 * std::abs(expected) + 1e-9 * weak.eigenvalue[i])
        << "mode " << i;
  }
}

}  // namespace
}  // namespace nugget::verify
