// SPDX-License-Identifier: Apache-2.0
#include "base/intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace nugget {
namespace {

/// The answer by looking at all.
std::size_t plainly(const std::vector<double>& starts, double value) {
  std::size_t i = 0;
  while (i + 1 < starts.size() && value >= starts[i + 1]) ++i;
  return i;
}

TEST(Intervals, FindWhereANumberLies) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const std::size_t count : {1u, 2u, 3u, 10u, 100u, 700u})
    for (const double crowded : {1.0, 5.0, 40.0}) {  // most of them close to the first
      std::vector<double> starts;
      for (std::size_t i = 0; i < count; ++i)
        starts.push_back(0.01 + std::pow(static_cast<double>(i) / static_cast<double>(count), crowded));
      starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
      const Intervals intervals(starts);
      for (const double at : starts)
        for (const double value : {at, std::nextafter(at, 2.0), std::nextafter(at, -1.0)})
          EXPECT_EQ(intervals.at(value), plainly(starts, value)) << value;
      for (int i = 0; i < 1000; ++i) {
        const double value = -0.1 + 1.3 * std::pow(share(generator), crowded);
        EXPECT_EQ(intervals.at(value), plainly(starts, value)) << value;
      }
      EXPECT_EQ(intervals.at(1e300), starts.size() - 1);
      EXPECT_EQ(intervals.at(-1e300), 0u);
      EXPECT_EQ(intervals.at(std::nan("")), 0u);
    }
}

}  // namespace
}  // namespace nugget
