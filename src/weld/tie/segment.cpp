// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/segment.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nugget::weld {
namespace {

struct Parameters {
  double xi = 0.0, eta = 0.0;
};

/// The bilinear patch as a + b xi + c eta + d xi eta.
struct Patch {
  Vec3d a, b, c, d;
  explicit Patch(const Corners& k)
      : a(0.25 * (k[0] + k[1] + k[2] + k[3])),
        b(0.25 * (k[1] + k[2] - k[0] - k[3])),
        c(0.25 * (k[2] + k[3] - k[0] - k[1])),
        d(0.25 * (k[0] + k[2] - k[1] - k[3])) {}
};

/// Newton's method for the foot of the perpendicular from the origin; nothing where it does not settle near the patch.
std::optional<Parameters> perpendicular_foot(const Patch& patch) {
  constexpr int most_steps = 50;
  constexpr double converged = 1e-12;
  constexpr double far_away = 10.0;
  Parameters p;
  for (int step = 0; step < most_steps; ++step) {
    const Vec3d x_xi = patch.b + p.eta * patch.d;
    const Vec3d x_eta = patch.c + p.xi * patch.d;
    const Vec3d x = patch.a + p.xi * patch.b + p.eta * x_eta;
    const double f1 = dot(x, x_xi), f2 = dot(x, x_eta);
    const double h11 = dot(x_xi, x_xi), h22 = dot(x_eta, x_eta);
    double h12 = dot(x_xi, x_eta) + dot(x, patch.d);
    double determinant = h11 * h22 - h12 * h12;
    if (determinant <= 1e-6 * h11 * h22) {
      // Not convex here (a node far off a warped patch): leave the curvature out, which always descends.
      h12 = dot(x_xi, x_eta);
      determinant = h11 * h22 - h12 * h12;
    }
    if (determinant <= 1e-12 * h11 * h22) return std::nullopt;
    const double d_xi = (h12 * f2 - h22 * f1) / determinant;
    const double d_eta = (h12 * f1 - h11 * f2) / determinant;
    p.xi += d_xi;
    p.eta += d_eta;
    if (std::abs(p.xi) > far_away || std::abs(p.eta) > far_away) return std::nullopt;
    if (std::abs(d_xi) + std::abs(d_eta) < converged) return p;
  }
  return std::nullopt;
}

/// Area coordinates of corners 2 and 3 at the foot of the perpendicular from the origin.
std::optional<Parameters> perpendicular_foot_on_triangle(const Corners& k) {
  const Vec3d b = k[1] - k[0], c = k[2] - k[0];
  const double bb = dot(b, b), cc = dot(c, c), bc = dot(b, c);
  const double determinant = bb * cc - bc * bc;
  if (determinant <= 1e-12 * bb * cc) return std::nullopt;
  const double fb = -dot(k[0], b), fc = -dot(k[0], c);
  return Parameters{(cc * fb - bc * fc) / determinant, (bb * fc - bc * fb) / determinant};
}

/// `excess` 0: within the segment itself.
bool within(const Parameters& p, bool triangle, double excess) {
  if (!triangle) return std::max(std::abs(p.xi), std::abs(p.eta)) <= 1.0 + excess;
  // An area coordinate runs over half the length of a bilinear one.
  return std::min({p.xi, p.eta, 1.0 - p.xi - p.eta}) >= -0.5 * excess;
}

Parameters on_edge(int edge, double along, bool triangle) {
  if (triangle) {
    constexpr std::array<Parameters, 3> corner{{{0, 0}, {1, 0}, {0, 1}}};
    const Parameters& from = corner[edge];
    const Parameters& to = corner[(edge + 1) % 3];
    return {from.xi + along * (to.xi - from.xi), from.eta + along * (to.eta - from.eta)};
  }
  const double s = 2.0 * along - 1.0;
  switch (edge) {
    case 0: return {s, -1.0};
    case 1: return {1.0, s};
    case 2: return {-s, 1.0};
    default: return {-1.0, -s};
  }
}

/// The point of the border that is closest to the origin; edges of a bilinear patch are straight.
Parameters closest_on_border(const Corners& k, bool triangle) {
  const int edges = triangle ? 3 : 4;
  Parameters best;
  double shortest = std::numeric_limits<double>::infinity();
  for (int edge = 0; edge < edges; ++edge) {
    const Vec3d& from = k[edge];
    const Vec3d side = k[(edge + 1) % edges] - from;
    const double length_squared = dot(side, side);
    const double along = length_squared > 0.0 ? std::clamp(-dot(from, side) / length_squared, 0.0, 1.0) : 0.0;
    const double distance = norm(from + along * side);
    if (distance >= shortest) continue;
    shortest = distance;
    best = on_edge(edge, along, triangle);
  }
  return best;
}

std::array<double, 4> weights(const Parameters& p, bool triangle) {
  if (triangle) return {1.0 - p.xi - p.eta, p.xi, p.eta, 0.0};
  return shape_functions(p.xi, p.eta);
}

Vec3d weighted(const std::array<double, 4>& weight, const Corners& k) {
  return weight[0] * k[0] + weight[1] * k[1] + weight[2] * k[2] + weight[3] * k[3];
}

}  // namespace

std::array<double, 4> shape_functions(double xi, double eta) {
  return {0.25 * (1.0 - xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 + eta),
          0.25 * (1.0 - xi) * (1.0 + eta)};
}

Foot project(const Corners& corner, bool triangle, const Vec3d& x) {
  // With the node in the origin, the small differences that Newton ends on keep their digits far from the global
  // origin.
  const Corners k{corner[0] - x, corner[1] - x, corner[2] - x, corner[3] - x};
  const std::optional<Parameters> foot = triangle ? perpendicular_foot_on_triangle(k) : perpendicular_foot(Patch(k));
  const bool inside = foot && within(*foot, triangle, 0.0);
  const bool over = foot && within(*foot, triangle, parametric_extension - 1.0);
  const Parameters closest = inside ? *foot : closest_on_border(k, triangle);
  const Parameters& tied = over ? *foot : closest;

  Foot result;
  result.xi = tied.xi;
  result.eta = tied.eta;
  result.weight = weights(tied, triangle);
  result.point = weighted(result.weight, corner);
  result.gap = norm(weighted(result.weight, k));
  result.distance = norm(weighted(weights(closest, triangle), k));
  result.over = over;
  return result;
}

Vec3d normal(const Corners& corner) {
  const Vec3d n = cross(corner[2] - corner[0], corner[3] - corner[1]);
  const double length = norm(n);
  return length > 0.0 ? (1.0 / length) * n : Vec3d{};
}

double shorter_diagonal(const Corners& corner) {
  return std::min(norm(corner[2] - corner[0]), norm(corner[3] - corner[1]));
}

}  // namespace nugget::weld
