// SPDX-License-Identifier: Apache-2.0
// Against closed forms. Sabotage: the smaller root left out of the rotations, damping that is never taken back, a
// column's scale left out of the step.
#include "weld/coupon/least_squares.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace nugget::weld {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(LeastSquares, SingularValuesAndTheirDirections) {
  // [3 0; 4 5]: A^T A = [25 20; 20 25], whose values are 45 and 5 along (1, 1) and (1, -1).
  const SingularParts parts = singular_parts({{3.0, 4.0}, {0.0, 5.0}});
  EXPECT_THAT(parts.value, ElementsAre(DoubleNear(std::sqrt(45.0), 1e-14), DoubleNear(std::sqrt(5.0), 1e-14)));
  EXPECT_NEAR(parts.right[0][0], parts.right[0][1], 1e-14);
  EXPECT_NEAR(parts.right[1][0], -parts.right[1][1], 1e-14);
  EXPECT_NEAR(std::abs(parts.right[0][0]), std::sqrt(0.5), 1e-14);
}

TEST(LeastSquares, SmallSingularValuesKeepTheirDigits) {
  // Läuchli: columns (1, e, 0) and (1, 0, e) have the values sqrt(2 + e^2) and e, which A^T A has lost for e = 1e-9.
  const double e = 1e-9;
  const SingularParts parts = singular_parts({{1.0, e, 0.0}, {1.0, 0.0, e}});
  EXPECT_NEAR(parts.value[0], std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(parts.value[1] / e, 1.0, 1e-6);
}

TEST(LeastSquares, LineThroughPoints) {
  // y = 1, 2, 4 at x = 0, 1, 2: slope 3/2, intercept 5/6. Damped: (A^T A + d) x = A^T b with d = 1.
  const SingularParts parts = singular_parts({{1.0, 1.0, 1.0}, {0.0, 1.0, 2.0}});
  const std::vector<double> b{1.0, 2.0, 4.0};
  EXPECT_THAT(least_squares(parts, b), ElementsAre(DoubleNear(5.0 / 6.0, 1e-14), DoubleNear(1.5, 1e-14)));
  // [4 3; 3 6] x = (7, 10): x = (12, 19) / 15.
  EXPECT_THAT(least_squares(parts, b, 1.0), ElementsAre(DoubleNear(0.8, 1e-14), DoubleNear(19.0 / 15.0, 1e-14)));
}

SquareSum rosenbrock(double width) {
  return {.residuals = [=](const std::vector<double>& x) -> std::vector<double> {
            return {10.0 * (x[1] / width - x[0] * x[0]), 1.0 - x[0]};
          },
          .derivatives = [=](const std::vector<double>& x, const std::vector<double>&) -> Columns {
            return {{-20.0 * x[0], -1.0}, {10.0 / width, 0.0}};
          }};
}

TEST(LeastSquares, CurvedValleyIsFollowedWhateverItsUnits) {
  for (const double width : {1.0, 1e6}) {
    const std::vector<double> x = minimized(rosenbrock(width), {-1.2, width});
    EXPECT_NEAR(x[0], 1.0, 1e-9);
    EXPECT_NEAR(x[1] / width, 1.0, 1e-9);
  }
}

TEST(LeastSquares, StepsThatOvershootAreDamped) {
  // Gauss-Newton steps on atan x go away from 0 from |x| > 1.3917 on.
  const SquareSum sum{
      .residuals = [](const std::vector<double>& x) -> std::vector<double> { return {std::atan(x[0])}; },
      .derivatives = [](const std::vector<double>& x, const std::vector<double>&) -> Columns {
        return {{1.0 / (1.0 + x[0] * x[0])}};
      }};
  EXPECT_NEAR(minimized(sum, {20.0})[0], 0.0, 1e-12);
}

TEST(LeastSquares, AsManyEvaluationsAsAllowed) {
  int evaluations = 0;
  SquareSum sum = rosenbrock(1.0);
  sum.residuals = [&, of = sum.residuals](const std::vector<double>& x) {
    ++evaluations;
    return of(x);
  };
  sum.evaluations = 5;
  minimized(sum, {-1.2, 1.0});
  EXPECT_EQ(evaluations, 5);
}

}  // namespace
}  // namespace nugget::weld
