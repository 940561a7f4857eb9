// SPDX-License-Identifier: Apache-2.0
// Factors of *CONTROL_SPOTWELD_BEAM on the strength of a weld: LCT and LCS over the size of the shells that it is tied
// to, on beams and on the bricks in their place, T_ORT and T_ORS over the place of a beam on its shells. A factor T
// divides a squared term of the failure value, so a strength becomes sqrt(T) of itself. See
// docs/theory/failure.md#size-of-the-shell and docs/manual/weld_factors.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "experiment.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

constexpr double length = 1.5, step = 1e-7;

/// Axial or shear force at failure of a weld with NRR 8000 and NRS = NRT 4000 at (x, y), between one shell of 10 mm and
/// one of 8 mm, both around the origin, that are pulled apart or sheared; `control` has *CONTROL_SPOTWELD_BEAM.
double force_at_failure(const std::string& control, bool pulled, double x = 0.0, double y = 0.0) {
  const double end = 3000 * step;
  std::string deck = "*KEYWORD\n" + termination(end, 0.9, 0.0, 99) + curve(99, {{0.0, step}, {1.0, step}}) +
                     weld_part(1, {.yield = 1e6, .strength = {8000, 4000, 4000}}) +
                     beam_between(1, 1, 1, {x, y, 0}, 2, {x, y, length}) + sheet_part(2, 1.0) + sheet_part(3, 1.5) +
                     weld_contact_to_set(1, {2, 3}) + control;
  const SheetMesh low{.first = 200, .part = 2, .corner = {-5, -5, 0}};
  const SheetMesh high{.first = 300, .part = 3, .corner = {-4, -4, length}, .along = {8, 0, 0}, .across = {0, 8, 0}};
  deck += low.text() + high.text() + fixed({200, 201, 202, 203});
  for (int i = 0; i < 4; ++i)
    deck += driven(
        300 + i,
        [=](double s) {
          return pulled ? std::array<double, 6>{0, 0, 4e-3 * s} : std::array<double, 6>{1e-2 * s};
        },
        end, 1, 100 + 10 * i);
  Experiment run(deck + "*END\n");
  double last = 0.0;
  run.run([&](const impact::Snapshot& now) {
    const weld::History& h = *now.components.welds.history(0);
    if (!h.failed()) last = pulled ? h.resultants().axial : h.resultants().shear();
  });
  EXPECT_TRUE(run.simulation().components().welds.history(0)->failed());
  return last;
}

// LCT 2 at 8 mm, 0.5 at 10 mm; LCS 4 at both. The worse end counts: f = (N/NRR)^2 / 0.5, (V/NRS)^2 / 4.
// Sabotage to be caught: factors of beams only; the size of one node's shell alone where the ends differ.
TEST(ShellFactors, BySizeOnBeamsAndOnBricksForBeams) {
  for (const int bricks : {0, 1, 8}) {
    const std::string control = curve(70, {{8.0, 2.0}, {10.0, 0.5}}) + curve(71, {{8.0, 4.0}, {10.0, 4.0}}) +
                                "*CONTROL_SPOTWELD_BEAM\n" + fields({70, 71, 0, 0, 0, double(bricks)});
    expect_reference("weld strength by place on the shells",
                     fmt::format("RPBHX {}: N at failure, LCT 0.5 at the worse end [N]", bricks),
                     force_at_failure(control, true), 8000 * std::sqrt(0.5), 5e-3);
    expect_reference("weld strength by place on the shells", fmt::format("RPBHX {}: V at failure, LCS 4 [N]", bricks),
                     force_at_failure(control, false), 2 * 4000, 5e-3);
  }
}

// At (3, 1) a beam stands at xi 0.6, eta 0.2 of the lower shell and at 0.75, 0.25 of the upper one, so at the places
// 0.6 and 0.75, towards the angle a = atan(1/3). T_ORT, curves over the angle at the places 0 and 1, is
// 1 + p (c(a) - 1) with c from 0.5 at 0 degrees to 0.75 at 45: less at the upper end. T_ORS, curves over the place at
// the angles 0 and 45, is (1 + 3 p)(1 - a/90): less at the lower end.
// Sabotage to be caught: the angle in radians; the smaller coordinate for the place; T_ORT for shear too; the axes of a
// table over angles taken as those of one over places.
TEST(ShellFactors, ByThePlaceOfABeamOnItsShells) {
  const std::string tables = "*DEFINE_TABLE_2D\n80\n0.0,81\n1.0,82\n" + curve(81, {{0.0, 1.0}, {45.0, 1.0}}) +
                             curve(82, {{0.0, 0.5}, {45.0, 0.75}}) + "*DEFINE_TABLE_2D\n90\n0.0,91\n45.0,92\n" +
                             curve(91, {{0.0, 1.0}, {1.0, 4.0}}) + curve(92, {{0.0, 0.5}, {1.0, 2.0}});
  const auto control = [&](int in_shear) {
    return tables + "*CONTROL_SPOTWELD_BEAM\n" + fields({0, 0, 80, 0, double(in_shear)});
  };
  const double angle = std::atan(1.0 / 3.0) * 180.0 / std::numbers::pi;
  const double tension = 1.0 + 0.75 * (0.5 + 0.25 * angle / 45.0 - 1.0),
               shear = (1.0 + 3.0 * 0.6) * (1.0 - angle / 90.0);
  expect_reference("weld strength by place on the shells", "N at failure, T_ORT at place 0.75, angle 18.4 [N]",
                   force_at_failure(control(90), true, 3, 1), 8000 * std::sqrt(tension), 5e-3);
  expect_reference("weld strength by place on the shells", "V at failure, T_ORS at place 0.6, angle 18.4 [N]",
                   force_at_failure(control(90), false, 3, 1), 4000 * std::sqrt(shear), 5e-3);
  expect_reference("weld strength by place on the shells", "V at failure, T_ORT for shear too (T_ORS 0) [N]",
                   force_at_failure(control(0), false, 3, 1), 4000 * std::sqrt(tension), 5e-3);
  expect_reference("weld strength by place on the shells", "N at failure, T_ORT in the middle of the shells [N]",
                   force_at_failure(control(90), true), 8000, 5e-3);
}

}  // namespace
}  // namespace nugget::verify
