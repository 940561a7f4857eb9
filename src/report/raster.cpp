// SPDX-License-Identifier: Apache-2.0
#include "report/raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nugget::report {
namespace {

/// Twice the area of a triangle, with its sense of rotation.
double doubled_area(const PicturePoint& a, const PicturePoint& b, double u, double v) {
  return (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
}

}  // namespace

Raster::Raster(int width, int height)
    : width_(width),
      height_(height),
      near_(place(0, height), -std::numeric_limits<float>::infinity()),
      marks_(near_.size(), nothing) {}

void Raster::triangle(const std::array<PicturePoint, 3>& p, Mark mark) {
  const double area = doubled_area(p[0], p[1], p[2].u, p[2].v);
  if (area == 0.0 || !std::isfinite(area)) return;
  const auto [left, right] = std::minmax({p[0].u, p[1].u, p[2].u});
  const auto [top, bottom] = std::minmax({p[0].v, p[1].v, p[2].v});
  const auto first = [](double low) { return static_cast<int>(std::max(0.0, std::floor(low))); };
  const auto end = [](double high, int size) {
    return static_cast<int>(std::min<double>(size, std::ceil(high) + 1.0));
  };
  if (left > width_ || top > height_ || right < 0.0 || bottom < 0.0) return;
  const double whole = 1.0 / area;
  const double a_by_x = (p[1].v - p[2].v) * whole, b_by_x = (p[2].v - p[0].v) * whole;
  const int begin = first(left), past = end(right, width_);
  for (int v = first(top); v < end(bottom, height_); ++v) {
    const double y = v + 0.5;
    const double a0 = doubled_area(p[1], p[2], 0.0, y) * whole, b0 = doubled_area(p[2], p[0], 0.0, y) * whole;
    for (int u = begin; u < past; ++u) {
      const double x = u + 0.5, a = a0 + a_by_x * x, b = b0 + b_by_x * x, c = 1.0 - a - b;
      if (a < 0.0 || b < 0.0 || c < 0.0) continue;
      const auto near = static_cast<float>(a * p[0].near + b * p[1].near + c * p[2].near);
      if (near < near_[place(u, v)]) continue;
      near_[place(u, v)] = near;
      marks_[place(u, v)] = mark;
    }
  }
}

void Raster::line(const PicturePoint& a, const PicturePoint& b, double slack, Mark mark) {
  const double length = std::max(std::abs(b.u - a.u), std::abs(b.v - a.v));
  if (!std::isfinite(length)) return;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::min(length, 4.0 * (width_ + height_)))));
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    const PicturePoint p{a.u + s * (b.u - a.u), a.v + s * (b.v - a.v), a.near + s * (b.near - a.near)};
    if (!(p.u >= 0.0 && p.v >= 0.0 && p.u < width_ && p.v < height_) || hides(p, slack)) continue;
    marks_[place(static_cast<int>(p.u), static_cast<int>(p.v))] = mark;
  }
}

bool Raster::hides(const PicturePoint& p, double slack) const {
  if (!(p.u >= 0.0 && p.v >= 0.0 && p.u < width_ && p.v < height_)) return false;
  return near_[place(static_cast<int>(p.u), static_cast<int>(p.v))] > p.near + slack;
}

std::vector<std::uint32_t> Raster::halved(const std::vector<Colour>& palette) const {
  // Four numbers side by side, opacity, red, green, blue, with room for the sum of four.
  std::vector<std::uint64_t> colours(palette.size(), 0);
  for (std::size_t m = nothing + 1; m < palette.size(); ++m) {
    colours[m] = 1;
    for (const double part : palette[m])
      colours[m] = colours[m] << 16U | static_cast<std::uint64_t>(std::lround(std::clamp(part, 0.0, 255.0)));
  }
  const auto mean = [](std::uint64_t sum) {
    const auto count = static_cast<std::uint32_t>(sum >> 48U);
    if (count == 0) return std::uint32_t{0};
    std::uint32_t pixel = (255U * count + 2U) / 4U;
    for (const unsigned shift : {32U, 16U, 0U})
      pixel = pixel << 8U | (static_cast<std::uint32_t>(sum >> shift & 0xffffU) + count / 2U) / count;
    return pixel;
  };
  std::vector<std::uint32_t> half;
  half.reserve(marks_.size() / 4);
  std::uint64_t before = 0;  // pixels beside each other are alike
  std::uint32_t pixel = 0;
  for (int v = 0; v + 1 < height_; v += 2) {
    const Mark *upper = &marks_[place(0, v)], *lower = &marks_[place(0, v + 1)];
    for (int u = 0; u + 1 < width_; u += 2) {
      const std::uint64_t sum = colours[upper[u]] + colours[upper[u + 1]] + colours[lower[u]] + colours[lower[u + 1]];
      if (sum != before) pixel = mean(before = sum);
      half.push_back(pixel);
    }
  }
  return half;
}

}  // namespace nugget::report
