// SPDX-License-Identifier: Apache-2.0
#include "report/colours.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::report {
namespace {

constexpr std::array<Colour, 7> stops{
    {{205, 211, 217}, {110, 156, 196}, {70, 170, 150}, {150, 200, 90}, {250, 205, 70}, {236, 120, 50}, {190, 30, 45}}};
constexpr Colour failed{198, 40, 40}, near_failure{230, 145, 0}, safe{46, 125, 50}, plain{110, 120, 135};

Colour between(const Colour& low, const Colour& high, double share) {
  Colour colour{};
  for (std::size_t k = 0; k < 3; ++k) colour[k] = low[k] + share * (high[k] - low[k]);
  return colour;
}

}  // namespace

Colour ramp(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return between(stops[i], stops[i + 1], place - static_cast<double>(i));
}

Colour colour_of_part(int index) {
  constexpr double saturation = 0.32, lightness = 0.68;
  const double hue = std::fmod(210.0 + 137.508 * index, 360.0);
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue / 30.0, 12.0);
    return 255.0 * (lightness - saturation * std::min(lightness, 1.0 - lightness) * 1.6 *
                                    std::max(-1.0, std::min({k - 3.0, 9.0 - k, 1.0})));
  };
  return {channel(0.0), channel(8.0), channel(4.0)};
}

Colour colour_of_failure(double value) {
  if (!(value > 0.0)) return plain;
  if (value >= 1.0) return failed;
  constexpr double near_from = 0.8;
  return value < near_from ? between(safe, near_failure, std::pow(value / near_from, 3))
                           : between(near_failure, failed, 0.6 * (value - near_from) / (1.0 - near_from));
}

}  // namespace nugget::report
