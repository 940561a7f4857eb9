// SPDX-License-Identifier: Apache-2.0
#include "model/weld_section.hpp"

#include <cmath>
#include <numbers>

namespace nugget::model {
namespace {

WeldSection square(double area) {
  const double h = 0.5 * std::sqrt(area);
  return {{{-h, -h}, {h, -h}, {h, h}, {-h, h}}, {{0, 1, 2, 3}}};
}

WeldSection octagon(double area) {
  const double radius = std::sqrt(area / (2.0 * std::numbers::sqrt2));
  WeldSection section{{{0.0, 0.0}}, {}};
  for (int k = 0; k < 8; ++k)
    section.point.push_back(
        {radius * std::cos(0.25 * std::numbers::pi * k), radius * std::sin(0.25 * std::numbers::pi * k)});
  for (int k = 0; k < 8; k += 2) section.quad.push_back({0, 1 + k, 2 + k, 1 + (k + 2) % 8});
  return section;
}

/// A ring of quadrilaterals around the first `count` points, which go counter-clockwise around all others: its outer
/// points stand on the same rays, on a circle that gives the whole its area.
void add_ring(WeldSection& section, int count, double area) {
  const auto begin = section.point.begin();
  std::vector<double> angle;
  for (auto p = begin; p != begin + count; ++p) angle.push_back(std::atan2((*p)[1], (*p)[0]));
  double sines = 0.0;  // area of the ring's polygon = R^2/2 sum sin(angle between neighbours)
  for (std::size_t i = 0; i < angle.size(); ++i) sines += std::sin(angle[(i + 1) % angle.size()] - angle[i]);
  const double radius = std::sqrt(2.0 * area / sines);
  const int first = static_cast<int>(section.point.size());
  for (const double w : angle) section.point.push_back({radius * std::cos(w), radius * std::sin(w)});
  for (int i = 0; i < count; ++i) section.quad.push_back({first + i, first + (i + 1) % count, (i + 1) % count, i});
}

/// 0.60 d by 0.34 d inside, d the diameter of a circle of this area.
WeldSection rectangle_in_hexagon(double area) {
  const double d = std::sqrt(4.0 * area / std::numbers::pi), a = 0.30 * d, b = 0.17 * d;
  WeldSection section{{{-a, -b}, {0, -b}, {a, -b}, {a, b}, {0, b}, {-a, b}}, {{0, 1, 4, 5}, {1, 2, 3, 4}}};
  add_ring(section, 6, area);
  return section;
}

/// 0.54 d by 0.36 d inside: six squares.
WeldSection rectangle_in_decagon(double area) {
  const double h = 0.18 * std::sqrt(4.0 * area / std::numbers::pi), a = 0.5 * h, b = 1.5 * h;
  WeldSection section{{{-b, -h},
                       {-a, -h},
                       {a, -h},
                       {b, -h},
                       {b, 0.0},
                       {b, h},
                       {a, h},
                       {-a, h},
                       {-b, h},
                       {-b, 0.0},
                       {-a, 0.0},
                       {a, 0.0}},
                      {{0, 1, 10, 9}, {1, 2, 11, 10}, {2, 3, 4, 11}, {9, 10, 7, 8}, {10, 11, 6, 7}, {11, 4, 5, 6}}};
  add_ring(section, 10, area);
  return section;
}

}  // namespace

WeldSection weld_section(int quads, double area) {
  switch (quads) {
    case 1: return square(area);
    case 4: return octagon(area);
    case 8: return rectangle_in_hexagon(area);
    case 16: return rectangle_in_decagon(area);
    default: return {};
  }
}

}  // namespace nugget::model
