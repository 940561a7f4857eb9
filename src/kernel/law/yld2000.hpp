// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "kernel/law/barlat_lian.hpp"

namespace nugget::kernel {

/// What tests of a sheet say, of which Yld2000-2d is made: yield stresses over that of the hardening, and ratios of
/// Lankford, of tension along, at 45 degrees to and across axis a; a further stress at yield, over the same, and a
/// tangent to the surface there, with which the flow does no work.
struct SheetTests {
  std::array<double, 3> stress{1.0, 1.0, 1.0}, ratio{1.0, 1.0, 1.0};
  PlaneStress<double> point{1.0, 1.0, 0.0}, tangent{1.0, -1.0, 0.0};
};

/// Yield surface Yld2000-2d of an anisotropic sheet in plane stress (F. Barlat and others, Int. J. Plasticity 19,
/// 2003), in the material axes a, b:
///   2 Y^m = |X1 - X2|^m + |2 Z2 + Z1|^m + |2 Z1 + Z2|^m,
/// X1, X2 and Z1, Z2 principal values of two linear transformations of the stress by alpha1, 2, 7 and alpha3, 4, 5,
/// 6, 8. With all of them 1 it is W.F. Hosford's isotropic surface, with m = 2 that of von Mises.
struct Yld2000 {
  double m = 8.0;                                       ///< exponent, at least 2 [1]
  std::array<double, 8> alpha{1, 1, 1, 1, 1, 1, 1, 1};  ///< alpha1 to alpha8 [1]

  /// The surface that the tests ask for, by Newton's method from the isotropic one on; nullopt: none was found.
  static std::optional<Yld2000> from_tests(double m, const SheetTests& tests);
  /// Yield stress, over that of the hardening, and ratio of Lankford of tension at `angle` to axis a [rad].
  double stress(double angle) const;
  double ratio(double angle) const;
};

/// A surface made ready for the kernels.
class Yld2000Surface {
 public:
  explicit Yld2000Surface(const Yld2000& s) : m_(s.m), power_(s.m - 2.0) {
    const std::array<double, 8>& a = s.alpha;
    // (X1 - X2) / 2 is the root of the squares of d and q; (Z1 + Z2) / 2 and (Z1 - Z2) / 2 alike.
    difference_ = {(2.0 * a[0] + a[1]) / 6.0, -(a[0] + 2.0 * a[1]) / 6.0, a[6]};
    const double aa = (-2.0 * a[2] + 2.0 * a[3] + 8.0 * a[4] - 2.0 * a[5]) / 9.0,
                 ab = (a[2] - 4.0 * a[3] - 4.0 * a[4] + 4.0 * a[5]) / 9.0,
                 ba = (4.0 * a[2] - 4.0 * a[3] - 4.0 * a[4] + a[5]) / 9.0,
                 bb = (-2.0 * a[2] + 8.0 * a[3] + 2.0 * a[4] - 2.0 * a[5]) / 9.0;
    sum_ = {1.5 * (aa + ba), 1.5 * (ab + bb), 0.0};
    other_ = {0.5 * (aa - ba), 0.5 * (ab - bb), a[7]};
  }

  /// At a stress other than zero: with the radii p of X and k of Z, and three times the mean n of Z,
  ///   2 Y^m = |n + k|^m + |n - k|^m + (2 p)^m.
  template <class R>
  [[gnu::always_inline]] inline SurfaceAt<R> operator()(const PlaneStress<R>& s) const {
    Radius<R> p(difference_, s), k(other_, s);
    const R n = sum_[0] * s.aa + sum_[1] * s.bb;
    // In shares of the largest, so that no power is out of range. A radius that is 0 has no direction and no effect:
    // one that is next to nothing serves.
    const R scale = abs(n) + p.value + k.value, share = 1.0 / scale;
    p.turn(difference_, s, R(1e-9 * scale));
    k.turn(other_, s, R(1e-9 * scale));
    const R x = share * n, y = share * k.value, w = 2.0 * share * p.value, u = x + y, v = x - y;
    const R pu = power_(R(abs(u))), pv = power_(R(abs(v))), pw = power_(w);
    const R total = pu * u * u + pv * v * v + pw * w * w;
    const R ratio = map([&](double half) { return std::pow(half, 1.0 / m_); }, R(0.5 * total));
    SurfaceAt<R> at;
    at.effective = scale * ratio;
    // Derivatives of the effective stress by n, k and p.
    const R over = ratio / total;
    const R fn = over * (pu * u + pv * v), fk = over * (pu * u - pv * v), fp = 2.0 * over * pw * w;
    const R more = (m_ - 1.0) * over * share, bend = (m_ - 1.0) / at.effective;
    const R same = more * (pu + pv), mixed = more * (pu - pv), own = 4.0 * more * pw;
    const R curl_k = fk / k.value, curl_p = fp / p.value;
    const R flow[3] = {fn * sum_[0] + fk * k.slope[0] + fp * p.slope[0],
                       fn * sum_[1] + fk * k.slope[1] + fp * p.slope[1], fk * k.slope[2] + fp * p.slope[2]};
    at.flow = {flow[0], flow[1], flow[2]};
    const auto second = [&](int i, int j) {
      R h = same * (sum_[i] * sum_[j] + k.slope[i] * k.slope[j]) +
            mixed * (sum_[i] * k.slope[j] + sum_[j] * k.slope[i]) + own * (p.slope[i] * p.slope[j]) -
            bend * (flow[i] * flow[j]);
      h += curl_k * (square_of(other_, i, j) - k.slope[i] * k.slope[j]);
      return h + curl_p * (square_of(difference_, i, j) - p.slope[i] * p.slope[j]);
    };
    at.aa_aa = second(0, 0);
    at.aa_bb = second(0, 1);
    at.aa_ab = second(0, 2);
    at.bb_bb = second(1, 1);
    at.bb_ab = second(1, 2);
    at.ab_ab = second(2, 2);
    return at;
  }

 private:
  /// Of aa, bb and ab.
  using Row = std::array<double, 3>;

  /// Root of the squares of a normal part, by the first two of a row, and a shear by its last, and its slopes.
  template <class R>
  struct Radius {
    R value, slope[3];
    Radius(const Row& row, const PlaneStress<R>& s) {
      const R d = row[0] * s.aa + row[1] * s.bb, q = row[2] * s.ab;
      value = sqrt(d * d + q * q);
    }
    void turn(const Row& row, const PlaneStress<R>& s, const R& least) {
      value = max(value, least);
      const R over = 1.0 / value, d = over * (row[0] * s.aa + row[1] * s.bb), q = over * (row[2] * s.ab);
      slope[0] = row[0] * d;
      slope[1] = row[1] * d;
      slope[2] = row[2] * q;
    }
  };
  /// Half the second derivative of the square of such a radius.
  static double square_of(const Row& row, int i, int j) {
    return (i < 2 && j < 2) || (i == 2 && j == 2) ? row[i] * row[j] : 0.0;
  }

  Row difference_{}, sum_{}, other_{};
  double m_;
  PowerOf power_;  // of m - 2
};

}  // namespace nugget::kernel
