// SPDX-License-Identifier: Apache-2.0
#include "weld/coupon/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace nugget::weld {
namespace {

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Turns two columns in their plane: a' = c a - s b, b' = s a + c b.
void turn(std::vector<double>& a, std::vector<double>& b, double c, double s) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double was = a[i];
    a[i] = c * was - s * b[i];
    b[i] = s * was + c * b[i];
  }
}

/// Makes the columns p and q perpendicular; false: they are.
bool straighten(Columns& image, Columns& right, std::size_t p, std::size_t q) {
  const double pp = product(image[p], image[p]), qq = product(image[q], image[q]), pq = product(image[p], image[q]);
  if (std::abs(pq) <= std::numeric_limits<double>::epsilon() * std::sqrt(pp * qq)) return false;
  const double z = (qq - pp) / (2.0 * pq);
  const double t = std::copysign(1.0, z) / (std::abs(z) + std::sqrt(1.0 + z * z));
  const double c = 1.0 / std::sqrt(1.0 + t * t);
  turn(image[p], image[q], c, c * t);
  turn(right[p], right[q], c, c * t);
  return true;
}

/// Lengths of the columns; of one without length the number 1, by which it can be divided.
std::vector<double> lengths(const Columns& matrix) {
  std::vector<double> length;
  for (const std::vector<double>& column : matrix) {
    const double own = std::sqrt(product(column, column));
    length.push_back(own > 0.0 ? own : 1.0);
  }
  return length;
}

}  // namespace

SingularParts singular_parts(Columns matrix) {
  const std::size_t n = matrix.size();
  Columns right(n, std::vector<double>(n, 0.0));
  for (std::size_t k = 0; k < n; ++k) right[k][k] = 1.0;
  constexpr int most_sweeps = 60;  // a handful is enough
  bool turned = true;
  for (int sweep = 0; turned && sweep < most_sweeps; ++sweep) {
    turned = false;
    for (std::size_t p = 0; p + 1 < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) turned = straighten(matrix, right, p, q) || turned;
  }
  std::vector<double> value(n);
  for (std::size_t k = 0; k < n; ++k) value[k] = std::sqrt(product(matrix[k], matrix[k]));
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value[a] > value[b]; });
  SingularParts parts;
  for (const std::size_t k : order) {
    parts.value.push_back(value[k]);
    parts.image.push_back(std::move(matrix[k]));
    parts.right.push_back(std::move(right[k]));
  }
  return parts;
}

std::vector<double> least_squares(const SingularParts& of, const std::vector<double>& b, double damping) {
  std::vector<double> x(of.value.size(), 0.0);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double weight = of.value[k] * of.value[k] + damping;
    if (!(weight > 0.0)) continue;
    const double share = product(of.image[k], b) / weight;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += share * of.right[k][i];
  }
  return x;
}

std::vector<double> minimized(const SquareSum& sum, std::vector<double> x) {
  std::vector<double> here = sum.residuals(x), scale(x.size(), 0.0);
  double square = product(here, here), damping = 0.0;
  for (int evaluations = 1; evaluations < sum.evaluations && square > 0.0;) {
    Columns slope = sum.derivatives(x, here);
    // Parameters count by what they do; damping is of columns of length 1.
    const std::vector<double> length = lengths(slope);
    for (std::size_t k = 0; k < x.size(); ++k) {
      scale[k] = std::max(scale[k], length[k]);
      for (double& entry : slope[k]) entry /= scale[k];
    }
    const SingularParts parts = singular_parts(std::move(slope));
    for (bool taken = false; !taken;) {
      if (evaluations++ == sum.evaluations) return x;
      const std::vector<double> step = least_squares(parts, here, damping);
      std::vector<double> next = x;
      double of_step = 0.0, of_x = 0.0;
      for (std::size_t k = 0; k < x.size(); ++k) {
        next[k] -= step[k] / scale[k];
        of_step += step[k] * step[k];
        of_x += std::pow(scale[k] * x[k], 2);
      }
      const bool small = of_step <= sum.least_step * sum.least_step * of_x;
      const std::vector<double> there = sum.residuals(next);
      const double change = square - product(there, there);
      taken = change > 0.0;
      if (taken) {
        const bool last = change <= sum.least_change * square;
        x = next;
        here = there;
        square -= change;
        damping = damping > 1e-6 ? 0.1 * damping : 0.0;
        if (last) return x;
      }
      if (small || change == 0.0) return x;
      if (!taken) damping = std::max(1e-3, 10.0 * damping);
    }
  }
  return x;
}

}  // namespace nugget::weld
