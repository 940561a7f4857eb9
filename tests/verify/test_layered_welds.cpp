// SPDX-License-Identifier: Apache-2.0
// Welds of several layers of bricks between two sheets.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/index.hpp"
#include "brick_decks.hpp"
#include "experiment.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

/// Axial stiffness of a weld of d = 6 in `layers` of bricks between two sheets of 1.5 that are moved apart; nu = 0.
double stiffness_in_layers(int layers, int n) {
  WeldData weld;
  weld.nu = 0.0;
  weld.yield = 1e6;
  Prism prism = square_prism(std::sqrt(weld.area()), weld.length, n);
  prism.z.clear();
  for (int k = 0; k <= layers; ++k) prism.z.push_back(weld.length * k / layers);
  const double end = 2e-4, pull = 1e-4;
  std::string deck = "*KEYWORD\n" + termination(end) + brick_part(1, weld) + sheet_part(2, 1.5) + prism.text() +
                     SheetMesh{1001, 2, {-5, -5, 0}}.text() + SheetMesh{2001, 2, {-5, -5, weld.length}}.text() +
                     fixed({1001, 1002, 1003, 1004}) + weld_contact(1, 2);
  for (int i = 0; i < 4; ++i)
    deck += driven(
        2001 + i, [=](double s) { return std::array{0.0, 0.0, pull * smooth(s), 0.0, 0.0, 0.0}; }, end, 60,
        100 + 10 * i);
  Experiment run(deck + "*END\n");
  EXPECT_EQ(run.ties().ties.size(), at(2 * (n + 1) * (n + 1)));
  double force = 0.0;
  run_to_end(run, [&](const impact::Snapshot& now) {
    force = 0.0;
    for (const auto& r : now.components.supports.motion_reactions()) force += r.force.z;
  });
  return std::abs(force) / pull;
}

// Nodes between layers are in reach of the sheets and belong to none; tied, they turn the brick below inside out.
// Sabotage: all nodes in reach are tied.
TEST(LayeredWelds, PullAsOneBrick) {
  const double exact = WeldData{}.axial_stiffness();
  for (const int layers : {1, 2, 3})
    for (const int n : {1, 2, 5})
      expect_reference("weld bricks in layers",
                       fmt::format("{} layers of {} x {} bricks: axial stiffness [N/mm]", layers, n, n),
                       stiffness_in_layers(layers, n), exact, 0.01);
}

}  // namespace
}  // namespace nugget::verify
