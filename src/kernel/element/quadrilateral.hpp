// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "kernel/element/shell.hpp"

// Geometry of a four-node shell, common to its formulations. Included by their .cpp files only.
namespace nugget::kernel {

/// Frame and gradients of a four-node shell. The gradient of a nodal field f is
///   (f,x, f,y) = ( bx13 (f1 - f3) + bx24 (f2 - f4), by13 (f1 - f3) + by24 (f2 - f4) ).
template <class R>
struct Quadrilateral {
  Frame<R> frame;
  R area;
  R bx13, bx24, by13, by24;
  Vec3<R> h;  ///< h . x with h = (1, -1, 1, -1), in the frame

  [[gnu::always_inline]] explicit Quadrilateral(const Vec3<R> (&x)[4]) {
    const Vec3<R> a = x[2] - x[0], b = x[3] - x[1];
    // With the diagonals' lengths p, q and half the angle between them, everything follows from four roots and two
    // divisions.
    const R p = sqrt(dot(a, a)), q = sqrt(dot(b, b)), pq = p * q;
    const R over_pq = 1.0 / pq, over_p = q * over_pq, over_q = p * over_pq;
    R over_2s, over_2c;
    if constexpr (is_single<R>) {
      // A slender shell has diagonals of nearly one direction: sides, added up, give their small differences to all of
      // the digits that a float has; 1 - cosine would leave half of them.
      const Vec3<R> along = (x[1] - x[0]) + (x[2] - x[3]), across = (x[3] - x[0]) + (x[2] - x[1]);  // a - b, a + b
      const R mean = 0.5 * (over_p + over_q), half_difference = -0.5 * over_pq * dot(along, across) / (p + q);
      const Vec3<R> u = mean * along + half_difference * across, w = half_difference * along + mean * across;
      const R two_s = sqrt(dot(u, u)), two_c = sqrt(dot(w, w)), over = 1.0 / (two_s * two_c);
      over_2s = two_c * over;
      over_2c = two_s * over;
      frame.e1 = over_2s * u;
      frame.e2 = over_2c * w;
      area = 0.25 * pq * two_s * two_c;
    } else {
      const R cosine = dot(a, b);
      const R s = sqrt(0.5 * over_pq * (pq - cosine)), c = sqrt(0.5 * over_pq * (pq + cosine));
      const R over_sc = 0.5 / (s * c);
      over_2s = c * over_sc;
      over_2c = s * over_sc;
      const Vec3<R> along_a = over_p * a, along_b = over_q * b;
      frame.e1 = over_2s * (along_a - along_b);
      frame.e2 = over_2c * (along_a + along_b);
      area = pq * s * c;
    }
    frame.e3 = cross(frame.e1, frame.e2);
    bx13 = -over_p * over_2s;
    bx24 = over_q * over_2s;
    by13 = -over_p * over_2c;
    by24 = -over_q * over_2c;
    h = frame.local((x[0] + x[2]) - (x[1] + x[3]));
  }

  R dx(const R& f13, const R& f24) const { return bx13 * f13 + bx24 * f24; }
  R dy(const R& f13, const R& f24) const { return by13 * f13 + by24 * f24; }
  /// gamma . f for a field with h . f = `fh` and the gradient given.
  R gamma(const R& fh, const R& fx, const R& fy) const { return fh - h.x * fx - h.y * fy; }
};

/// What a nodal field is made of: f1 - f3, f2 - f4, f1 - f2 + f3 - f4.
template <class R>
struct Differences {
  Vec3<R> d13, d24, dh;
  explicit Differences(const Vec3<R> (&f)[4]) : d13(f[0] - f[2]), d24(f[1] - f[3]), dh((f[0] + f[2]) - (f[1] + f[3])) {}
  [[gnu::always_inline]] Differences in(const Frame<R>& frame) const {
    Differences r = *this;
    r.d13 = frame.local(d13);
    r.d24 = frame.local(d24);
    r.dh = frame.local(dh);
    return r;
  }
};

template <class R>
R largest_side2(const Vec3<R> (&x)[4]) {
  R longest = R(0.0);
  for (int i = 0; i < 4; ++i) {
    const Vec3<R> side = x[(i + 1) % 4] - x[i];
    longest = max(longest, dot(side, side));
  }
  return longest;
}

/// Square of the length over which the stable step is taken, on the speed c or, for the ISDO 2 branch, sqrt(E / rho).
template <class R>
[[gnu::always_inline]] inline R length2(const Vec3<R> (&x)[4], const R& area, ShellLength length, double nu) {
  if (length == ShellLength::area_over_diagonal) {
    const Vec3<R> a = x[2] - x[0], b = x[3] - x[1];
    return area * area / max(dot(a, a), dot(b, b));
  }
  const R l2 = area * area / largest_side2(x);
  if (length == ShellLength::area_over_side) return l2;
  R shortest = R(std::numeric_limits<double>::infinity());
  for (int i = 0; i < 4; ++i) {
    const Vec3<R> side = x[(i + 1) % 4] - x[i];
    shortest = min(shortest, dot(side, side));
  }
  return max(l2, shortest) * (1.0 / (1.0 - nu * nu));  // a bar's wave is slower than a plate's by sqrt(1 - nu^2)
}

/// A nodal vector field built as: +-a13 on nodes 1, 3; +-a24 on nodes 2, 4; h times hourglass; the same `common` on
/// all.
template <class R>
void spread(const Vec3<R>& a13, const Vec3<R>& a24, const Vec3<R>& hourglass, const Vec3<R>& common, Vec3<R> (&f)[4]) {
  const Vec3<R> odd = common + hourglass, even = common - hourglass;
  f[0] = odd + a13;
  f[1] = even + a24;
  f[2] = odd - a13;
  f[3] = even - a24;
}

}  // namespace nugget::kernel
