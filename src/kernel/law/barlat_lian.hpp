// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "base/batch.hpp"

namespace nugget::kernel {

/// Yield surface of an anisotropic sheet in plane stress (F. Barlat and J. Lian, Int. J. Plasticity 5, 1989), in the
/// material axes a, b:
///   2 Y^m = A |K1 + K2|^m + A |K1 - K2|^m + C |2 K2|^m,
///   K1 = (saa + H sbb) / 2,  K2^2 = ((saa - H sbb) / 2)^2 + P^2 sab^2.
/// With m = 2 it is that of R. Hill (1948), with all of A, C, H, P 1 besides that of von Mises.
struct BarlatLian {
  double m = 2.0;                             ///< exponent, at least 2 [1]
  double A = 1.0, C = 1.0, H = 1.0, P = 1.0;  ///< [1]

  /// From the ratios of Lankford of tension along, at 45 degrees to and across axis a: plastic strain across the
  /// tension over that through the thickness. All above 0.
  static BarlatLian from_ratios(double m, double r00, double r45, double r90);
  /// Ratio of Lankford of tension at `angle` to axis a [rad].
  double ratio(double angle) const;
};

/// A stress in the plane and in material axes: aa, bb, ab [stress].
template <class R>
struct PlaneStress {
  R aa{}, bb{}, ab{};
};

/// Effective stress of a surface, its gradient and its curvature. The gradient is the direction of plastic flow, with
/// engineering shear, for which stress times flow is the effective stress.
template <class R>
struct SurfaceAt {
  R effective{};                                           ///< [stress]
  PlaneStress<R> flow{};                                   ///< [1]
  R aa_aa{}, aa_bb{}, aa_ab{}, bb_bb{}, bb_ab{}, ab_ab{};  ///< [1/stress]
};

/// x^n for x >= 0; products where n is a small whole number, which the exponents of metals (6, 8) are.
class PowerOf {
 public:
  explicit PowerOf(double n) : n_(n), whole_(n == std::floor(n) && n >= 0.0 && n <= 64.0 ? static_cast<int>(n) : -1) {}
  template <class R>
  R operator()(const R& x) const {
    if (whole_ < 0) return map([&](double one) { return std::pow(one, n_); }, x);
    R product = R(1.0), square = x;
    for (int n = whole_; n > 0; n /= 2) {
      if (n % 2 == 1) product = product * square;
      square = square * square;
    }
    return product;
  }

 private:
  double n_;
  int whole_;
};

/// A surface made ready for the kernels.
class BarlatLianSurface {
 public:
  explicit BarlatLianSurface(const BarlatLian& surface) : s_(surface), power_(surface.m - 2.0) {}

  const BarlatLian& parameters() const { return s_; }

  /// At a stress other than zero.
  template <class R>
  [[gnu::always_inline]] inline SurfaceAt<R> operator()(const PlaneStress<R>& s) const {
    const R k1 = 0.5 * (s.aa + s_.H * s.bb), d = 0.5 * (s.aa - s_.H * s.bb);
    const double p2 = s_.P * s_.P, m = s_.m;
    // In shares of the largest term, so that no power is out of range. K2 of equal biaxial tension is 0, where its
    // gradient has no direction and no effect: a K2 that is next to nothing serves.
    const R root = sqrt(d * d + p2 * (s.ab * s.ab)), scale = abs(k1) + root, share = 1.0 / scale;
    const R k2 = max(root, 1e-9 * scale), x = share * k1, y = share * k2;
    const R u = x + y, v = x - y, w = 2.0 * y;
    const R pu = power_(R(abs(u))), pv = power_(R(abs(v))), pw = power_(w);
    const R sum = s_.A * (pu * u * u + pv * v * v) + s_.C * (pw * w * w);
    const R ratio = map([&](double half) { return std::pow(half, 1.0 / m); }, R(0.5 * sum));
    SurfaceAt<R> at;
    at.effective = scale * ratio;
    // Derivatives of the effective stress by K1 and K2: those of the sum times `over`.
    const R over = ratio / sum;
    const R au = s_.A * pu, av = s_.A * pv, cw = 4.0 * s_.C * pw;
    const R f1 = over * (au * u + av * v), f2 = over * (au * u - av * v + 0.5 * cw * w);
    const R more = (m - 1.0) * over * share, bend = (m - 1.0) / at.effective;
    const R f11 = more * (au + av) - bend * f1 * f1, f12 = more * (au - av) - bend * f1 * f2,
            f22 = more * (au + av + cw) - bend * f2 * f2;
    // K1 and K2 by the stresses.
    const double h = s_.H;
    const R over_k2 = 1.0 / k2, q = 0.5 * d * over_k2, t = p2 * s.ab * over_k2;
    at.flow = {0.5 * f1 + f2 * q, h * (0.5 * f1 - f2 * q), f2 * t};
    const R curl = f2 * over_k2;
    const R both = 0.25 * f11, mixed = 0.5 * f12, quarter = curl * (0.25 - q * q), own = f22 * q * q;
    at.aa_aa = both + 2.0 * mixed * q + own + quarter;
    at.bb_bb = (h * h) * (both - 2.0 * mixed * q + own + quarter);
    at.aa_bb = h * (both - own - quarter);
    at.aa_ab = t * (mixed + f22 * q - curl * q);
    at.bb_ab = h * t * (mixed - f22 * q + curl * q);
    at.ab_ab = f22 * t * t + curl * (p2 - t * t);
    return at;
  }

 private:
  BarlatLian s_;
  PowerOf power_;  // of m - 2
};

}  // namespace nugget::kernel
