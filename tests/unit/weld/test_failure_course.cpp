// SPDX-License-Identifier: Apache-2.0
// The failure value over time in a fixed number of intervals. Sabotage: merge() without the larger of two.
#include "weld/failure/failure_course.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nugget::weld {
namespace {

TEST(FailureCourse, IsAsFineAsTheStepsWhileTheyFit) {
  FailureCourse course;
  for (int n = 1; n <= 4; ++n) course.add(0.5 * n, 0.1 * n);
  EXPECT_EQ(course.interval(), 0.5);
  EXPECT_THAT(course.largest(), testing::ElementsAre(0.0, 0.1, 0.2, 0.1 * 3, 0.4));
}

TEST(FailureCourse, KeepsPeaksAndTheirTimesHoweverLongTheRun) {
  for (const int steps : {31, 32, 33, 1000, 12345}) {
    FailureCourse course;
    const int peak = steps / 3 + 1;
    for (int n = 1; n <= steps; ++n) course.add(0.25 * n, n == peak ? 0.9 : 0.1);
    const auto largest = course.largest();
    EXPECT_LE(largest.size(), 32u) << steps;
    EXPECT_GE(largest.size(), 16u) << steps;
    const auto of_peak = static_cast<std::size_t>(0.25 * peak / course.interval());
    for (std::size_t i = 0; i < largest.size(); ++i) {
      const bool nothing_yet = i == 0 && course.interval() == 0.25;
      EXPECT_EQ(largest[i], i == of_peak ? 0.9 : nothing_yet ? 0.0 : 0.1) << steps << ' ' << i;
    }
    EXPECT_EQ(std::floor(0.25 * steps / course.interval()) + 1.0, static_cast<double>(largest.size())) << steps;
  }
}

TEST(FailureCourse, BeginsAnew) {
  FailureCourse course;
  course.add(3.0, 0.7);
  course.restart();
  EXPECT_TRUE(course.largest().empty());
  course.add(1.0, 0.2);
  EXPECT_THAT(course.largest(), testing::ElementsAre(0.0, 0.2));
}

}  // namespace
}  // namespace nugget::weld
