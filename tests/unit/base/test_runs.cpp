// SPDX-License-Identifier: Apache-2.0
#include "base/runs.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/zeroed.hpp"

namespace nugget {
namespace {

TEST(Runs, GiveTheNumbersThatWereAdded) {
  EXPECT_TRUE(Runs().empty());
  EXPECT_EQ(Runs().begin(), Runs().end());
  for (const std::vector<int>& numbers :
       {std::vector<int>{0}, {7}, {0, 1, 2}, {3, 4, 9, 11, 12}, {0, 2, 4, 6}, {5, 6, 7, 100000}}) {
    Runs runs;
    for (const int n : numbers) runs.add(n);
    EXPECT_EQ(runs.size(), numbers.size());
    EXPECT_TRUE(std::ranges::equal(runs, numbers));
    int sum = 0, expected = 0;
    for (const int n : runs) sum += n;
    for (const int n : numbers) expected += n;
    EXPECT_EQ(sum, expected);
  }
}

bool resident(const void* p) {
  unsigned char is = 0;
  EXPECT_EQ(::mincore(const_cast<void*>(p), 1, &is), 0);
  return (is & 1) != 0;
}

// Sabotage to be caught: -0.0 taken for 0; a page that is given back with its neighbour.
TEST(Zeroed, PagesOfZerosTakeNoRoom) {
  const std::size_t in_a_page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) / sizeof(double);
  ZeroedVector<double> list(40 * in_a_page + 3);
  ASSERT_GE(list.size() * sizeof(double), zeroed_by_pages);
  std::fill(list.begin(), list.end(), 0.0);
  list[2 * in_a_page] = -0.0;
  list[5 * in_a_page - 1] = 3.0;
  list[6 * in_a_page] = 4.0;
  list[40 * in_a_page + 1] = 5.0;
  forget_zeros(list);
  for (std::size_t page = 0; page < 40; ++page)
    EXPECT_EQ(resident(&list[page * in_a_page]), page == 2 || page == 4 || page == 6) << page;
  EXPECT_TRUE(std::signbit(list[2 * in_a_page]));
  EXPECT_EQ(list[5 * in_a_page - 1], 3.0);
  EXPECT_EQ(list[6 * in_a_page], 4.0);
  EXPECT_EQ(list[40 * in_a_page + 1], 5.0);
  EXPECT_EQ(std::ranges::count(list, 0.0), static_cast<std::ptrdiff_t>(list.size() - 3));
  ZeroedVector<double> all(40 * in_a_page), few(3);
  std::fill(all.begin(), all.end(), 0.0);
  forget_zeros(all);
  forget_zeros(few);
  EXPECT_FALSE(resident(all.data()) || resident(&all[20 * in_a_page]) || resident(&all[39 * in_a_page]));
}

}  // namespace
}  // namespace nugget
