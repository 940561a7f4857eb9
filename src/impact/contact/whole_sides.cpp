// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/whole_sides.hpp"

#include <algorithm>
#include <limits>

namespace nugget::impact {
namespace {

/// Longest side squared over twice the area: the larger, the more slender.
double slenderness(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double area = norm(cross(b - a, c - a));
  const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
  // Corners on one line: the last digits of their places are no area.
  return area > 1e-9 * longest ? longest / area : std::numeric_limits<double>::infinity();
}

/// The triangles of a closed outline whose most slender one is the least so (G. T. Klincsek, Annals of Discrete
/// Mathematics 9, 1980, with another measure): of the stretch from i to j the best one with the side i j is known from
/// those of shorter stretches.
class LeastSlender {
 public:
  LeastSlender(const std::vector<model::Index>& outline, const std::vector<Vec3d>& x)
      : outline_(outline), count_(outline.size()), worst_(count_ * count_, 0.0), apex_(count_ * count_, 0) {
    for (std::size_t length = 2; length < count_; ++length)
      for (std::size_t i = 0; i + length < count_; ++i) {
        const std::size_t j = i + length;
        double best = std::numeric_limits<double>::infinity();
        apex_[i * count_ + j] = i + 1;
        for (std::size_t k = i + 1; k < j; ++k) {
          const double own = slenderness(x[outline[i]], x[outline[k]], x[outline[j]]);
          const double worst = std::max({own, worst_[i * count_ + k], worst_[k * count_ + j]});
          if (worst < best) {
            best = worst;
            apex_[i * count_ + j] = k;
          }
        }
        worst_[i * count_ + j] = best;
      }
  }

  void append(std::size_t i, std::size_t j, std::vector<WholeSides::Corners>& triangles) const {
    if (j < i + 2) return;
    const std::size_t k = apex_[i * count_ + j];
    append(i, k, triangles);
    triangles.push_back({outline_[i], outline_[k], outline_[j], outline_[j]});
    append(k, j, triangles);
  }

 private:
  const std::vector<model::Index>& outline_;
  std::size_t count_;
  std::vector<double> worst_;      // by ends of a stretch
  std::vector<std::size_t> apex_;  // third corner of the triangle with these ends
};

}  // namespace

WholeSides::WholeSides(const model::Model& model) {
  for (const model::HangingNode& h : model.hanging_nodes) hanging_[side(h.ends[0], h.ends[1])].push_back(h.node);
}

void WholeSides::append(model::Index from, model::Index to, const std::vector<Vec3d>& x,
                        std::vector<model::Index>& outline) const {
  std::vector<std::pair<double, model::Index>> between;
  if (const auto found = hanging_.find(side(from, to)); found != hanging_.end()) {
    const Vec3d along = x[to] - x[from];
    // Strictly between the ends: so the sides that are left are shorter, and this comes to an end on any deck.
    for (const model::Index n : found->second)
      if (const double way = dot(x[n] - x[from], along); way > 0.0 && way < dot(along, along))
        between.emplace_back(way, n);
  }
  if (between.empty()) {
    outline.push_back(from);
    return;
  }
  std::sort(between.begin(), between.end());
  for (const auto& [way, n] : between) {
    append(from, n, x, outline);
    from = n;
  }
  append(from, to, x, outline);
}

std::vector<WholeSides::Corners> WholeSides::pieces(const Corners& shell, const std::vector<Vec3d>& x) const {
  if (hanging_.empty()) return {shell};
  const std::size_t corners = shell[3] == shell[2] ? 3 : 4;
  std::vector<model::Index> outline;
  for (std::size_t c = 0; c < corners; ++c) append(shell[c], shell[(c + 1) % corners], x, outline);
  if (outline.size() == corners) return {shell};
  std::vector<Corners> triangles;
  LeastSlender(outline, x).append(0, outline.size() - 1, triangles);
  return triangles;
}

}  // namespace nugget::impact
