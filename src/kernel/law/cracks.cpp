// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/cracks.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::kernel {
namespace {

enum Place { xx, yy, xy, w1, w2, nx, ny };

/// f s f with f = diag(f1, f2, 1) in the axes n1 and across.
LayerTensor<double> scaled(const LayerTensor<double>& s, double c, double t, double f1, double f2) {
  const double s11 = f1 * f1 * (c * c * s.xx + t * t * s.yy + 2.0 * c * t * s.xy);
  const double s22 = f2 * f2 * (t * t * s.xx + c * c * s.yy - 2.0 * c * t * s.xy);
  const double s12 = f1 * f2 * (c * t * (s.yy - s.xx) + (c * c - t * t) * s.xy);
  const double s13 = f1 * (c * s.xz + t * s.yz), s23 = f2 * (c * s.yz - t * s.xz);
  return {c * c * s11 + t * t * s22 - 2.0 * c * t * s12, t * t * s11 + c * c * s22 + 2.0 * c * t * s12,
          c * t * (s11 - s22) + (c * c - t * t) * s12, c * s13 - t * s23, t * s13 + c * s23};
}

}  // namespace

bool Cracks::advance(const SolidTensor<double>& s, double increment, double* h, int stride) const {
  const auto at = [&](Place i) -> double& { return h[i * stride]; };
  if (increment > 0.0) {
    const double effective =
        std::sqrt(s.xx * s.xx + s.yy * s.yy - s.xx * s.yy + 3.0 * (s.xy * s.xy + s.yz * s.yz + s.zx * s.zx));
    const double flow = increment / effective;
    at(xx) += flow * (s.xx - 0.5 * s.yy);
    at(yy) += flow * (s.yy - 0.5 * s.xx);
    at(xy) += 1.5 * flow * s.xy;
  }
  if (at(nx) == 0.0 && at(ny) == 0.0) {
    const double half = 0.5 * (at(xx) - at(yy)), radius = std::hypot(half, at(xy));
    if (0.5 * (at(xx) + at(yy)) + radius < law_.onset) return false;
    const double angle = 0.5 * std::atan2(at(xy), half);
    at(nx) = std::cos(angle);
    at(ny) = std::sin(angle);
  }
  const double c = at(nx), t = at(ny), cross = 2.0 * c * t * at(xy);
  at(w1) = std::max(at(w1), law_.at(c * c * at(xx) + t * t * at(yy) + cross));
  at(w2) = std::max(at(w2), law_.at(t * t * at(xx) + c * c * at(yy) - cross));
  return std::max(at(w1), at(w2)) >= 1.0;
}

LayerTensor<double> Cracks::weakened(const LayerTensor<double>& s, const double* h, int stride) {
  const double a = h[w1 * stride], b = h[w2 * stride];
  if (a == 0.0 && b == 0.0) return s;
  return scaled(s, h[nx * stride], h[ny * stride], std::sqrt(1.0 - a), std::sqrt(1.0 - b));
}

LayerTensor<double> Cracks::undamaged(const LayerTensor<double>& s, const double* h, int stride) {
  const double a = h[w1 * stride], b = h[w2 * stride];
  if ((a == 0.0 && b == 0.0) || std::max(a, b) >= 1.0) return s;
  return scaled(s, h[nx * stride], h[ny * stride], 1.0 / std::sqrt(1.0 - a), 1.0 / std::sqrt(1.0 - b));
}

}  // namespace nugget::kernel
