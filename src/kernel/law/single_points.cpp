// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/single_points.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/law/tensor_algebra.hpp"

namespace nugget::kernel {
using namespace tensor;

namespace {

/// c b c, both symmetric.
Tensor congruent(const Tensor& c, const Tensor& b) {
  const Frame3d rows{{c.xx, c.xy, c.zx}, {c.xy, c.yy, c.yz}, {c.zx, c.yz, c.zz}};
  return rotated(rows, b);
}

}  // namespace

bool is_linear(const Tensor& e) {
  return std::max({std::abs(e.xx), std::abs(e.yy), std::abs(e.zz), std::abs(e.xy), std::abs(e.yz), std::abs(e.zx)}) <
         1e-8;
}

PointUpdate linear_point(double E, double nu, const Tensor& e) {
  const ElasticConstants c(E, nu);
  return {plus(c.shear * e, 0.5 * c.lambda * trace(e)), c.bulk_wave(), c.plane};
}

Principal principal_axes(const Tensor& tensor) {
  double a[3][3] = {
      {tensor.xx, tensor.xy, tensor.zx}, {tensor.xy, tensor.yy, tensor.yz}, {tensor.zx, tensor.yz, tensor.zz}};
  double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int sweep = 0; sweep < 30; ++sweep) {
    const double off = std::abs(a[0][1]) + std::abs(a[1][2]) + std::abs(a[0][2]);
    if (off <= 1e-16 * (std::abs(a[0][0]) + std::abs(a[1][1]) + std::abs(a[2][2]))) break;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0.0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (int k = 0; k < 3; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (int k = 0; k < 3; ++k) {
          const double pk = a[p][k], qk = a[q][k], vp = v[k][p], vq = v[k][q];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
          v[k][p] = c * vp - s * vq;
          v[k][q] = s * vp + c * vq;
        }
      }
  }
  int order[3] = {0, 1, 2};
  std::sort(order, order + 3, [&](int i, int j) { return a[i][i] < a[j][j]; });
  Principal p;
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = order[i];
    p.value[i] = a[k][k];
    p.direction[i] = {v[0][k], v[1][k], v[2][k]};
  }
  return p;
}

Tensor with_values(const Principal& axes, const std::array<double, 3>& value) {
  Tensor t{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& n = axes.direction[i];
    t = t + value[i] * Tensor{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
  }
  return t;
}

void stretch(Tensor& b_less_one, const Tensor& d, double dt) {
  // With g = c - 1 = (1 - d dt/2)^-1 d dt: c b c - 1 = 2 g + g g + c (b - 1) c. Nothing is subtracted from 1, so that
  // the smallest steps count (docs/decisions/0017).
  const Tensor change = dt * tensorial(d);
  const Tensor g = times(inverse(plus(-0.5 * change, 1.0)), change);
  b_less_one = 2.0 * g + times(g, g) + congruent(plus(g, 1.0), b_less_one);
}

}  // namespace nugget::kernel
