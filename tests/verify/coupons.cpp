// SPDX-License-Identifier: Apache-2.0
#include "coupons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "specimen.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

using Line = std::vector<double>;

/// Mesh lines from a to b, b left out, about `size` apart.
void spread(Line& to, double a, double b, double size) {
  const int count = std::max(1, static_cast<int>(std::lround(std::abs(b - a) / size)));
  for (int i = 0; i < count; ++i) to.push_back(a + i * (b - a) / count);
}
Line patch(double side, int cells) {
  Line x;
  for (int i = 0; i <= cells; ++i) x.push_back(-0.5 * side + i * side / cells);
  return x;
}
template <class Place>
std::vector<Vec3d> places(const Line& line, const Place& place) {
  std::vector<Vec3d> x;
  for (const double v : line) x.push_back(place(v));
  return x;
}

}  // namespace

template <class Grip>
void Coupon::sheet(int part, const std::vector<Vec3d>& path, const std::vector<Vec3d>& across, const Grip& grip) {
  const auto id = [&](std::size_t i, std::size_t j) {
    return 10000 * part + 1 + static_cast<int>(i * across.size() + j);
  };
  for (std::size_t i = 0; i < path.size(); ++i)
    for (std::size_t j = 0; j < across.size(); ++j) {
      const Vec3d x = path[i] + across[j];
      nodes_ += node_line(id(i, j), x.x, x.y, x.z);
      if (i + 1 < path.size() && j + 1 < across.size())
        shells_ += element_line(++last_shell_, part, {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
      if (grip(path[i])) (part == 2 ? driven_ : held_).push_back(id(i, j));
    }
}

std::string Coupon::text() const {
  std::string text = "*NODE\n" + nodes_ + "*ELEMENT_SHELL\n" + shells_;
  text += beam_between(90001, 3, 90001, {0, 0, -thickness / 2}, 90002, {0, 0, thickness / 2}) + "*BOUNDARY_SPC_NODE\n";
  for (const int n : held_) text += fields({1.0 * n, 0, 1, 1, 1, 1, 1, 1});
  for (const int n : driven_) text += fields({1.0 * n, 0, pull_ == 1 ? 0.0 : 1, 1, pull_ == 3 ? 0.0 : 1, 1, 1, 1});
  return text;
}

Coupon Coupon::lap_shear(int cells) {
  constexpr double t = thickness;
  Coupon c(1);
  Line x;
  const Line middle = patch(40.0, cells);
  spread(x, -80.0, -50.0, 40.0 / cells);
  spread(x, -50.0, -20.0, 40.0 / cells);
  x.insert(x.end(), middle.begin(), middle.end());
  const auto grip = [](const Vec3d& p) { return std::abs(p.x) > 50.0 - 1e-6; };
  c.sheet(1,
          places(x,
                 [](double v) {
                   return Vec3d{v, 0, -t / 2};
                 }),
          places(middle,
                 [](double v) {
                   return Vec3d{0, v, 0};
                 }),
          grip);
  c.sheet(2,
          places(x,
                 [](double v) {
                   return Vec3d{-v, 0, t / 2};
                 }),
          places(middle,
                 [](double v) {
                   return Vec3d{0, -v, 0};
                 }),
          grip);
  return c;
}

Coupon Coupon::coach_peel(int cells) {
  constexpr double t = thickness;
  Coupon c(3);
  Line arm;
  const Line middle = patch(40.0, cells);
  spread(arm, -60.0, 0.0, 40.0 / cells);
  std::vector<Vec3d> lower = places(arm, [](double h) { return Vec3d{-20.0, 0, h - t / 2}; });
  std::vector<Vec3d> upper = places(arm, [](double h) { return Vec3d{-20.0, 0, t / 2 - h}; });
  for (const double v : middle) lower.push_back({v, 0, -t / 2}), upper.push_back({v, 0, t / 2});
  const auto grip = [](const Vec3d& p) { return std::abs(p.z) > 60.0; };
  c.sheet(1, lower, places(middle, [](double v) { return Vec3d{0, v, 0}; }), grip);
  c.sheet(2, upper, places(middle, [](double v) { return Vec3d{0, -v, 0}; }), grip);
  return c;
}

Coupon Coupon::cross_tension(int cells) {
  constexpr double t = thickness;
  Coupon c(3);
  Line s;
  const Line middle = patch(48.0, cells);
  spread(s, -60.0, -40.0, 48.0 / cells);
  spread(s, -40.0, -24.0, 48.0 / cells);
  const Line wing = s;
  s.insert(s.end(), middle.begin(), middle.end());
  for (std::size_t i = wing.size(); i-- > 0;) s.push_back(-wing[i]);
  const auto grip = [](const Vec3d& p) { return std::max(std::abs(p.x), std::abs(p.y)) > 40.0 - 1e-6; };
  c.sheet(1,
          places(s,
                 [](double v) {
                   return Vec3d{v, 0, -t / 2};
                 }),
          places(middle,
                 [](double v) {
                   return Vec3d{0, v, 0};
                 }),
          grip);
  c.sheet(2,
          places(s,
                 [](double v) {
                   return Vec3d{0, v, t / 2};
                 }),
          places(middle,
                 [](double v) {
                   return Vec3d{-v, 0, 0};
                 }),
          grip);
  return c;
}

}  // namespace nugget::verify
