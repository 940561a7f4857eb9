// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "base/dual.hpp"
#include "base/index.hpp"
#include "base/row.hpp"

namespace nugget {
namespace {

template <int W, class Number>
Batch<W, Number> ramp(double first, double step) {
  Batch<W, Number> a;
  for (int l = 0; l < W; ++l) set_lane(a, l, first + l * step);
  return a;
}

template <int W, class Number = double>
void lanes_behave_as_numbers() {
  using R = Batch<W, Number>;
  const R a = ramp<W, Number>(-1.51, 1.0), b = ramp<W, Number>(2.03, -0.75);
  for (int l = 0; l < W; ++l) {
    const auto x = static_cast<Number>(lane(a, l)), y = static_cast<Number>(lane(b, l));
    EXPECT_EQ(lane(a + b, l), x + y);
    EXPECT_EQ(lane(a - 1.0, l), x - 1);
    EXPECT_EQ(lane(2.0 * a, l), 2 * x);
    EXPECT_EQ(lane(a / b, l), x / y);
    EXPECT_EQ(lane(-a, l), -x);
    EXPECT_EQ(lane(abs(a), l), std::abs(x));
    EXPECT_EQ(lane(sqrt(abs(a)), l), std::sqrt(std::abs(x)));
    EXPECT_EQ(lane(min(a, b), l), std::min(x, y));
    EXPECT_EQ(lane(max(a, b), l), std::max(x, y));
    EXPECT_EQ((a < b)[l], x < y);
    EXPECT_EQ((a < b && !(a < 0.0))[l], x < y && x >= 0);
    EXPECT_EQ((a >= b || a <= -1.0)[l], x >= y || x <= -1);
    EXPECT_EQ(lane(select(a > b, a, b), l), x > y ? x : y);
    EXPECT_EQ(lane(map([](double v) { return std::exp(v); }, a), l), static_cast<Number>(std::exp(double{x})));
    EXPECT_EQ(lane(map([](double v, double u) { return v * u; }, a, b), l), static_cast<Number>(double{x} * y));
  }
  EXPECT_TRUE(any(a > lane(a, W - 1) - 0.5));
  EXPECT_FALSE(any(a > lane(a, W - 1)));
  Number store[W + 1] = {};
  real_store(store + 1, a);  // need not be aligned
  EXPECT_EQ(lane(real_load<R>(store + 1), W - 1), lane(a, W - 1));
  double sums[W] = {};
  store_as_doubles(sums, a);
  add_as_doubles(sums, b);
  for (int l = 0; l < W; ++l) EXPECT_EQ(sums[l], lane(a, l) + lane(b, l));  // as doubles, not rounded again
}

TEST(Batch, LanesBehaveAsNumbers) {
  lanes_behave_as_numbers<2>();
  lanes_behave_as_numbers<native_width>();
  lanes_behave_as_numbers<4, float>();
  lanes_behave_as_numbers<2 * native_width, float>();
}

template <class R>
void rows_come() {
  std::vector<Row> rows(20);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto n = static_cast<double>(i);
    rows[i] = {n, 100.0 + n, 200.0 + n, 9.0};
  }
  const int id[8] = {7, 3, 19, 0, 5, 5, 1, 12};
  const Vec3<R> v = gather<R>(rows.data(), id);
  for (int l = 0; l < lanes<R>; ++l) {
    EXPECT_EQ(lane(v.x, l), id[l]);
    EXPECT_EQ(lane(v.y, l), 100.0 + id[l]);
    EXPECT_EQ(lane(v.z, l), 200.0 + id[l]);
  }
}

TEST(Row, Gather) {
  rows_come<double>();
  rows_come<Batch<2>>();
  rows_come<NativeBatch>();
}

TEST(Row, RoundedToFloats) {
  constexpr int W = lanes<SingleBatch>;
  std::vector<Row> rows(20);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto n = static_cast<double>(i);
    rows[i] = {1e6 + n / 3.0, n, -n, 9.0};
  }
  int id[W], from[W];
  for (int l = 0; l < W; ++l) id[l] = 19 - l, from[l] = (7 * l) % 20;
  const Vec3<SingleBatch> rounded = gather_single<W>(rows.data(), id),
                          difference = gather_differences<SingleBatch>(rows.data(), id, from);
  for (int l = 0; l < W; ++l) {
    EXPECT_EQ(lane(rounded.x, l), static_cast<float>(rows[at(id[l])].x));
    EXPECT_EQ(lane(rounded.z, l), -id[l]);
    // No digit goes into where the rows are: rounded first, the difference would be wrong by a hundredth.
    EXPECT_EQ(lane(difference.x, l), static_cast<float>(rows[at(id[l])].x - rows[at(from[l])].x));
    EXPECT_EQ(lane(difference.y, l), id[l] - from[l]);
  }
}

TEST(Dual, Derivatives) {
  const auto x = Dual<2>::variable(3.0, 0), y = Dual<2>::variable(5.0, 1);
  const auto f = sqrt(x * y + 1.0) / (y - x) - x;
  const double root = 4.0;
  EXPECT_DOUBLE_EQ(f.value, root / 2.0 - 3.0);
  EXPECT_DOUBLE_EQ(f.d[0], 5.0 / (2 * root) / 2.0 + root / 4.0 - 1.0);
  EXPECT_DOUBLE_EQ(f.d[1], 3.0 / (2 * root) / 2.0 - root / 4.0);
  EXPECT_EQ(abs(-x).d[0], 1.0);
  EXPECT_EQ(max(x, y).d[1], 1.0);
  EXPECT_EQ(select(x > y, x, y).d[0], 0.0);
}

}  // namespace
}  // namespace nugget
