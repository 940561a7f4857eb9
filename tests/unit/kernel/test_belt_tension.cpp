// SPDX-License-Identifier: Apache-2.0
// Tension of belts and retractors along their curves, by hand.
#include <gtest/gtest.h>

#include <string>

#include "kernel/law/belt_tension.hpp"

namespace nugget {
namespace {

using kernel::BeltTension;

Curve curve(std::vector<double> x, std::vector<double> y) {
  Curve made;
  made.x = std::move(x);
  made.y = std::move(y);
  return made;
}

// 500 N at 5 %, 2000 N at 10 %; unloading 50000 N over strain, without force up to 1 %.
const Curve loading = curve({0.0, 0.05, 0.10}, {0.0, 500.0, 2000.0}),
            unloading = curve({0.0, 0.01, 0.05}, {0.0, 0.0, 2000.0});

TEST(BeltTension, FallsAlongTheUnloadingCurveAndRisesAgain) {
  const BeltTension belt(loading, unloading, 0.0);
  BeltTension::State state = belt.start();
  EXPECT_EQ(belt(-0.1, state), 0.0);
  EXPECT_DOUBLE_EQ(belt(0.04, state), 400.0);
  belt.advance(0.04, state);
  EXPECT_DOUBLE_EQ(belt(0.02, state), 200.0) << "up to the first ordinate above 0 both ways are one";
  belt.advance(0.09, state);
  // 1700 N, which the unloading curve has at 4.4 %: moved by 4.6 %.
  EXPECT_DOUBLE_EQ(belt(0.09, state), 1700.0);
  EXPECT_NEAR(belt(0.08, state), 1200.0, 1e-9);
  EXPECT_NEAR(belt(0.056, state), 0.0, 1e-9);
  EXPECT_EQ(belt(0.05, state), 0.0);
  belt.advance(0.07, state);
  EXPECT_NEAR(belt(0.08, state), 1200.0, 1e-9) << "tightening does not move the curve";
  EXPECT_DOUBLE_EQ(belt(0.12, state), 2600.0) << "the last slope goes on";
}

TEST(BeltTension, UnloadsFromAPlateauAndKeepsALeastTension) {
  const BeltTension reel(curve({0.0, 10.0, 50.0}, {200.0, 1200.0, 1200.0}), curve({0.0, 2.0}, {0.0, 1200.0}), 200.0);
  BeltTension::State state = reel.start();
  EXPECT_EQ(reel(-5.0, state), 200.0);
  EXPECT_DOUBLE_EQ(reel(5.0, state), 700.0);
  reel.advance(30.0, state);
  EXPECT_NEAR(reel(29.0, state), 600.0, 1e-9);
  EXPECT_DOUBLE_EQ(reel(28.0, state), 200.0);
  EXPECT_DOUBLE_EQ(reel(0.0, state), 200.0);
  EXPECT_DOUBLE_EQ(reel.steepest(state), 600.0);
}

// The step goes by what a belt has come to, not by where its curves end. Sabotage: all pieces from the start.
TEST(BeltTension, SlopesThatAreNearAtHand) {
  const BeltTension belt(curve({0.0, 0.1, 0.2, 0.3, 0.31}, {0.0, 100.0, 300.0, 600.0, 10600.0}),
                         curve({0.0, 0.25, 0.26}, {0.0, 50.0, 5050.0}), 0.0);
  BeltTension::State state = belt.start();
  EXPECT_NEAR(belt.steepest(state), 5e5, 1e-3) << "the second piece of unloading is the next one";
  const BeltTension alone(curve({0.0, 0.1, 0.2, 0.3, 0.31}, {0.0, 100.0, 300.0, 600.0, 10600.0}), {}, 0.0);
  state = alone.start();
  EXPECT_NEAR(alone.steepest(state), 2000.0, 1e-9);
  alone.advance(0.15, state);
  EXPECT_NEAR(alone.steepest(state), 3000.0, 1e-9);
  alone.advance(0.2001, state);
  EXPECT_NEAR(alone.steepest(state), 1e6, 1e-3) << "the last piece is the next one";
}

TEST(BeltTension, NeverAboveTheLoadingCurve) {
  // Unloading softer than loading.
  const BeltTension belt(loading, curve({0.0, 1.0}, {0.0, 2000.0}), 0.0);
  BeltTension::State state = belt.start();
  belt.advance(0.09, state);
  EXPECT_DOUBLE_EQ(belt(0.06, state), 800.0);
}

TEST(BeltTension, CurvesThatCannotBeThoseOfABelt) {
  EXPECT_EQ(std::string(BeltTension::fault_of_loading(loading)), "");
  EXPECT_NE(std::string(BeltTension::fault_of_loading(curve({0.0, 1.0}, {10.0, 5.0}))), "");
  EXPECT_NE(std::string(BeltTension::fault_of_loading(curve({0.0, 1.0}, {0.0, 0.0}))), "");
  EXPECT_NE(std::string(BeltTension::fault_of_loading(curve({0.0, 1.0}, {-1.0, 1.0}))), "");
  EXPECT_EQ(std::string(BeltTension::fault_of_unloading(unloading)), "");
  EXPECT_NE(std::string(BeltTension::fault_of_unloading(curve({0.0, 1.0}, {5.0, 10.0}))), "");
  EXPECT_NE(std::string(BeltTension::fault_of_unloading(curve({0.0, 1.0, 2.0}, {0.0, 10.0, 10.0}))), "");
}

}  // namespace
}  // namespace nugget
