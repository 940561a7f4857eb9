// SPDX-License-Identifier: Apache-2.0
#include "model/weld_section.hpp"

#include <cmath>
#include <numbers>

namespace nugget::model {
namespace {

/// Points at these angles on the circle whose polygon has the area of a circle of `diameter`.
std::vector<std::array<double, 2>> ring(const std::vector<double>& angle, double diameter) {
  double sines = 0.0;
  for (std::size_t i = 0; i < angle.size(); ++i) sines += std::sin(angle[(i + 1) % angle.size()] - angle[i]);
  const double radius = std::sqrt(0.5 * std::numbers::pi / sines) * diameter;
  std::vector<std::array<double, 2>> points;
  for (const double a : angle) points.push_back({radius * std::cos(a), radius * std::sin(a)});
  return points;
}

WeldSection square(double diameter) {
  const double half = 0.25 * std::sqrt(std::numbers::pi) * diameter;
  return {{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, {{0, 1, 2, 3}}};
}

WeldSection octagon(double diameter) {
  std::vector<double> angle;
  for (int k = 0; k < 8; ++k) angle.push_back(0.25 * std::numbers::pi * k);
  WeldSection section{ring(angle, diameter), {}};
  section.point.push_back({0.0, 0.0});
  for (int k = 0; k < 8; k += 2) section.quad.push_back({8, k, k + 1, (k + 2) % 8});
  return section;
}

WeldSection rectangle_in_hexagon(double diameter) {
  const double a = 0.30 * diameter, b = 0.17 * diameter;
  // Inner points counter-clockwise from the lower right; the outer ones stand radially before them.
  const std::vector<std::array<double, 2>> inner{{a, -b}, {a, b}, {0.0, b}, {-a, b}, {-a, -b}, {0.0, -b}};
  std::vector<double> angle;
  for (const auto& [s, t] : inner) angle.push_back(std::atan2(t, s));
  WeldSection section{ring(angle, diameter), {{6, 7, 8, 11}, {8, 9, 10, 11}}};
  section.point.insert(section.point.end(), inner.begin(), inner.end());
  for (int k = 0; k < 6; ++k) section.quad.push_back({6 + k, k, (k + 1) % 6, 6 + (k + 1) % 6});
  return section;
}

}  // namespace

WeldSection weld_section(int quads, double diameter) {
  switch (quads) {
    case 1: return square(diameter);
    case 4: return octagon(diameter);
    case 8: return rectangle_in_hexagon(diameter);
    default: return {};
  }
}

}  // namespace nugget::model
