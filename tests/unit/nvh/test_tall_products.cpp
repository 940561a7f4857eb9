// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.hpp"
#include "nvh/matrices/dense.hpp"
#include "nvh/matrices/tall_products.hpp"

namespace nugget::nvh {
namespace {

Columns waves(std::size_t rows, std::size_t count, double pace) {
  Columns c(rows, count);
  for (std::size_t k = 0; k < c.value.size(); ++k) c.value[k] = std::sin(pace * static_cast<double>(k) + 1.0);
  return c;
}

/// Rows that fill no register, no block, no chunk; columns that fill no tile.
struct Shape {
  std::size_t rows, many, first, few;
};
constexpr Shape shapes[] = {{2048, 1, 0, 1},  {2049, 4, 0, 4},   {5003, 7, 3, 8},
                            {8192, 12, 0, 5}, {8193, 13, 2, 16}, {20011, 9, 1, 3}};

/// Reads in long double, term by term.
long double sum_of(const Columns& a, std::size_t i, const Columns& b, std::size_t j) {
  long double sum = 0.0L;
  for (std::size_t r = 0; r < a.rows; ++r) sum += static_cast<long double>(a[i][r]) * b[j][r];
  return sum;
}

TEST(TallProducts, InnerProductsAreSumsOverAllRows) {
  for (const Shape& s : shapes) {
    ASSERT_TRUE(tall::pays(s.rows, s.few));
    const Columns a = waves(s.rows, s.many + s.first, 0.7), b = waves(s.rows, s.few, 1.3);
    const Columns c = inner(a, s.many, b, s.first);
    ASSERT_EQ(c.rows, s.many);
    ASSERT_EQ(c.count, s.few);
    for (std::size_t j = 0; j < s.few; ++j)
      for (std::size_t i = 0; i < s.many; ++i)
        EXPECT_NEAR(c[j][i], static_cast<double>(sum_of(a, s.first + i, b, j)), 1e-15 * static_cast<double>(s.rows))
            << s.rows << " rows, " << i << ", " << j;
  }
}

TEST(TallProducts, ColumnsAreAddedWithTheirShares) {
  for (const Shape& s : shapes)
    for (const double beta : {0.0, 1.0, -0.5}) {
      const Columns a = waves(s.rows, s.many + s.first, 0.7), b = waves(s.many, s.few, 1.3),
                    before = waves(s.rows, s.few, 0.3);
      Columns c = before;
      if (beta == 0.0) c.value[1] = std::nan("");  // as BLAS has it: what was there does not count
      add_product(-2.0, a, s.many, b, beta, c, s.first);
      for (std::size_t j = 0; j < s.few; ++j)
        for (std::size_t r = 0; r < s.rows; ++r) {
          double sum = beta * before[j][r];
          for (std::size_t i = 0; i < s.many; ++i) sum -= 2.0 * a[s.first + i][r] * b[j][i];
          ASSERT_NEAR(c[j][r], sum, 1e-13) << s.rows << " rows, " << r << ", " << j << ", beta " << beta;
        }
    }
}

TEST(TallProducts, TheBitsDoNotDependOnThreads) {
  const Columns a = waves(100003, 11, 0.7), b = waves(100003, 8, 1.3);
  Columns alone_sum = b, many_sum = b;
  set_threads(1);
  const Columns alone = inner(a, a.count, b);
  add_product(1.0, a, a.count, alone, 1.0, alone_sum);
  set_threads(4);
  const Columns many = inner(a, a.count, b);
  add_product(1.0, a, a.count, many, 1.0, many_sum);
  set_threads(1);
  EXPECT_EQ(alone.value, many.value);
  EXPECT_EQ(alone_sum.value, many_sum.value);
}

}  // namespace
}  // namespace nugget::nvh
