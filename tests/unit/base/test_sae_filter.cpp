// SPDX-License-Identifier: Apache-2.0
// The filter against the corridor of SAE J211-1 (-3 dB at 5/3 of the class, flat below, falling by 24 dB an octave) and
// against the response of the Butterworth filter in closed form.
#include "base/sae_filter.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace nugget {
namespace {

using std::numbers::pi;

/// Amplitude in the middle of a long sine of 1.
double gain(int channel_class, double hertz, double second = 1.0) {
  const double step = 1.0 / (40.0 * std::max<double>(hertz, channel_class));
  std::vector<double> times, values;
  for (int i = 0; i <= 8000; ++i) {
    times.push_back(second * i * step);
    values.push_back(std::sin(2.0 * pi * hertz * i * step));
  }
  const TimeHistory out = sae_filtered(times, values, channel_class, second);
  double largest = 0.0;
  for (std::size_t i = 3000; i < 5000; ++i) largest = std::max(largest, std::abs(out.values[i]));
  return largest;
}

double decibels(double ratio) {
  return 20.0 * std::log10(ratio);
}

TEST(SaeFilter, KeepsTheCorridorOfEachClass) {
  for (const auto& [channel_class, corner] : {std::pair{60, 100.0}, {180, 300.0}, {600, 1000.0}, {1000, 1650.0}}) {
    EXPECT_NEAR(decibels(gain(channel_class, corner)), -3.0, 0.5) << channel_class;
    EXPECT_NEAR(gain(channel_class, 0.1 * corner), 1.0, 0.01) << channel_class;
    EXPECT_NEAR(decibels(gain(channel_class, 8.0 * corner) / gain(channel_class, 4.0 * corner)), -24.0, 1.5)
        << channel_class;
  }
}

// Gain 1/(1 + (W/Wc)^4) of the pass forwards and backwards, W = tan(pi f T), Wc at 2.0775 of the class.
TEST(SaeFilter, HasTheResponseOfTwoButterworthFilters) {
  for (const int channel_class : channel_classes)
    for (const double share : {0.2, 1.0, 5.0 / 3.0, 3.0, 8.0}) {
      const double hertz = share * channel_class, step = 1.0 / (40.0 * std::max<double>(hertz, channel_class));
      const double ratio = std::tan(pi * hertz * step) / std::tan(pi * 2.0775 * channel_class * step);
      EXPECT_NEAR(gain(channel_class, hertz), 1.0 / (1.0 + std::pow(ratio, 4)), 0.004) << channel_class << ' ' << hertz;
    }
}

TEST(SaeFilter, TakesTimesInMilliseconds) {
  EXPECT_NEAR(gain(180, 300.0, 1000.0), gain(180, 300.0), 1e-9);
}

TEST(SaeFilter, ShiftsNoPhaseOfUnevenSamples) {
  std::vector<double> times, values;
  for (int i = 0; i <= 2000; ++i) {
    times.push_back(i * 1e-4 + (i % 3 == 1 ? 5e-5 : 0.0));
    values.push_back(std::sin(2.0 * pi * 20.0 * times.back()));
  }
  const TimeHistory out = sae_filtered(times, values, 180, 1.0);
  for (std::size_t i = 200; i < 1800; ++i) EXPECT_NEAR(out.values[i], std::sin(2.0 * pi * 20.0 * out.times[i]), 0.01);
}

// A blow of one cycle, then a half sine of 90 that peaks at 6 ms: the blow was no force that had long been there.
TEST(SaeFilter, TakesTheSignalBeforeItsStartAsNothing) {
  std::vector<double> times, values;
  for (int i = 0; i <= 2000; ++i) {
    times.push_back(i * 1e-5);
    values.push_back(times.back() < 0.012 ? 90.0 * std::sin(pi * times.back() / 0.012) : 0.0);
  }
  values.front() = 316.0;
  const TimeHistory out = sae_filtered(times, values, 60, 1.0);
  const auto peak = std::max_element(out.values.begin(), out.values.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
  EXPECT_NEAR(out.times[static_cast<std::size_t>(peak - out.values.begin())], 0.006, 1e-4);
  EXPECT_NEAR(*peak, 90.0, 2.5);
  const std::vector<double> steady(times.size(), 5.0);
  for (const double value : sae_filtered(times, steady, 60, 1.0, 5.0).values) EXPECT_NEAR(value, 5.0, 1e-9);
}

void expect_refusal(const std::vector<double>& times, const char* reason) {
  const std::vector<double> values(times.size(), 1.0);
  try {
    sae_filtered(times, values, 60, 1.0);
    ADD_FAILURE() << "taken";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(reason));
  }
}

TEST(SaeFilter, RefusesWhatCannotBeFiltered) {
  expect_refusal({0.0, 0.001, 0.001, 0.002}, "ascend");
  expect_refusal({0.0, 0.002, 0.001, 0.003}, "ascend");
  expect_refusal({0.0, 0.01, 0.02}, "closer than");
  expect_refusal({0.0, 0.01}, "fewer than three");
}

}  // namespace
}  // namespace nugget
