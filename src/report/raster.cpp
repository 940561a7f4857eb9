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
  for (int v = first(top); v < end(bottom, height_); ++v)
    for (int u = first(left); u < end(right, width_); ++u) {
      const double x = u + 0.5, y = v + 0.5;
      const double a = doubled_area(p[1], p[2], x, y) / area, b = doubled_area(p[2], p[0], x, y) / area,
                   c = 1.0 - a - b;
      if (a < 0.0 || b < 0.0 || c < 0.0) continue;
      const auto near = static_cast<float>(a * p[0].near + b * p[1].near + c * p[2].near);
      if (near < near_[place(u, v)]) continue;
      near_[place(u, v)] = near;
      marks_[place(u, v)] = mark;
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
  std::vector<std::uint32_t> half;
  half.reserve(marks_.size() / 4);
  for (int v = 0; v + 1 < height_; v += 2)
    for (int u = 0; u + 1 < width_; u += 2) {
      std::array<double, 4> sum{};  // opacity, red, green, blue
      for (const Mark mark :
           {marks_[place(u, v)], marks_[place(u + 1, v)], marks_[place(u, v + 1)], marks_[place(u + 1, v + 1)]}) {
        if (mark == nothing) continue;
        sum[0] += 255.0;
        for (std::size_t k = 0; k < 3; ++k) sum[k + 1] += palette[mark][k];
      }
      std::uint32_t mean = 0;
      for (const double part : sum)
        mean = mean << 8U | static_cast<std::uint32_t>(std::lround(std::clamp(0.25 * part, 0.0, 255.0)));
      half.push_back(mean);
    }
  return half;
}

}  // namespace nugget::report
