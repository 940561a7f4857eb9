// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/uniform_gradient.hpp"

// The 2 x 2 x 2 points of an eight-node brick and the fields that its shape functions make there. Included by .cpp
// files only.
namespace nugget::kernel {

/// Natural coordinates of a point of the 2 x 2 x 2 rule.
struct GaussPoint {
  static constexpr double place = 0.57735026918962576;
  double xi, eta, zeta;
};
constexpr GaussPoint gauss_point(int p) {
  constexpr double place = GaussPoint::place;
  return {p & 1 ? place : -place, p & 2 ? place : -place, p & 4 ? place : -place};
}

/// The eight points of Gauss's rule.
struct GaussRule {
  static constexpr bool weighted = false;
  static constexpr GaussPoint point(int p) { return gauss_point(p); }
};

/// Eight points of a brick that is collapsed to a wedge, its edges 5-6 and 7-8 to points: on two levels along eta four
/// points of the triangle, which have the same share of it: its middle and one towards each corner, such that a field
/// of second order is integrated exactly. No corner of the triangle differs from the others.
struct WedgeRule {
  static constexpr bool weighted = true;
  static constexpr GaussPoint point(int p) {
    constexpr double third = 1.0 / 3.0, less = (1.0 - GaussPoint::place) / 3.0, more = 1.0 - 2.0 * less,
                     aside = 2.0 * more / (1.0 - less) - 1.0;
    const double height = p & 4 ? GaussPoint::place : -GaussPoint::place;
    switch (p & 3) {
      case 0: return {0.0, height, 2.0 * third - 1.0};
      case 1: return {-aside, height, 2.0 * less - 1.0};
      case 2: return {aside, height, 2.0 * less - 1.0};
      default: return {0.0, height, 2.0 * more - 1.0};
    }
  }
  /// In place of one, the weight of Gauss's points: the brick's Jacobian falls to nothing where it is collapsed.
  static constexpr double weight(int p) { return 1.0 / (1.0 - point(p).zeta); }
};

/// Derivatives of a nodal field by xi, eta and zeta at a point.
template <class R>
struct Slopes {
  Vec3<R> xi, eta, zeta;
  [[gnu::always_inline]] Slopes(const Patterns<R>& f, const GaussPoint& at)
      : xi(f.a + R(at.eta) * f.h[2] + R(at.zeta) * f.h[1] + R(at.eta * at.zeta) * f.h[3]),
        eta(f.b + R(at.xi) * f.h[2] + R(at.zeta) * f.h[0] + R(at.xi * at.zeta) * f.h[3]),
        zeta(f.c + R(at.xi) * f.h[1] + R(at.eta) * f.h[0] + R(at.xi * at.eta) * f.h[3]) {}
};

/// The gradients of xi, eta and zeta at a point, times its Jacobian.
template <class R>
struct Cofactors {
  Vec3<R> xi, eta, zeta;
  R jacobian;
  [[gnu::always_inline]] explicit Cofactors(const Slopes<R>& x)
      : xi(cross(x.eta, x.zeta)), eta(cross(x.zeta, x.xi)), zeta(cross(x.xi, x.eta)), jacobian(dot(x.xi, xi)) {}
};

/// Velocity gradient v_i,j at a point.
template <class R>
[[gnu::always_inline]] inline Matrix<R> velocity_gradient(const Slopes<R>& v, const Cofactors<R>& c) {
  const R over = 1.0 / c.jacobian;
  const auto row = [&](R Vec3<R>::*i) { return over * (v.xi.*i * c.xi + v.eta.*i * c.eta + v.zeta.*i * c.zeta); };
  return {row(&Vec3<R>::x), row(&Vec3<R>::y), row(&Vec3<R>::z)};
}

/// Adds a point's share to the forces that do work on the patterns of velocity.
template <class R>
[[gnu::always_inline]] inline void collect(const SolidTensor<R>& s, const Cofactors<R>& c, const GaussPoint& at,
                                           Patterns<R>& f) {
  const Matrix<R> stress{{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  const Vec3<R> xi = stress * c.xi, eta = stress * c.eta, zeta = stress * c.zeta;
  f.a += xi;
  f.b += eta;
  f.c += zeta;
  f.h[0] += R(at.zeta) * eta + R(at.eta) * zeta;
  f.h[1] += R(at.zeta) * xi + R(at.xi) * zeta;
  f.h[2] += R(at.eta) * xi + R(at.xi) * eta;
  f.h[3] += R(at.eta * at.zeta) * xi + R(at.xi * at.zeta) * eta + R(at.xi * at.eta) * zeta;
}

/// The brick as its shape functions have it.
template <class R, class Rule = GaussRule>
struct Isoparametric {
  static constexpr bool one_pressure = true;
  static constexpr int points = 8;
  const Patterns<R>& x;

  /// Velocity gradients of the points and the volumes that go with them.
  [[gnu::always_inline]] void rates(const Patterns<R>& v, Matrix<R> (&l)[points], R (&volume)[points]) const {
    for (int p = 0; p < points; ++p) {
      const Cofactors<R> c(Slopes<R>(x, Rule::point(p)));
      l[p] = velocity_gradient(Slopes<R>(v, Rule::point(p)), c);
      volume[p] = weighted(p, c.jacobian);
    }
  }
  [[gnu::always_inline]] void volumes(R (&volume)[points]) const {
    for (int p = 0; p < points; ++p) volume[p] = weighted(p, Cofactors<R>(Slopes<R>(x, Rule::point(p))).jacobian);
  }
  /// Nodal forces that do the work of the stresses.
  [[gnu::always_inline]] void forces(const SolidTensor<R> (&stress)[points], Vec3<R> (&f)[8]) const {
    Patterns<R> sum;
    for (int p = 0; p < points; ++p)
      collect(weighted(p, stress[p]), Cofactors<R>(Slopes<R>(x, Rule::point(p))), Rule::point(p), sum);
    const R eighth = R(0.125);
    nodes_of(Patterns<R>{eighth * sum.a,
                         eighth * sum.b,
                         eighth * sum.c,
                         {eighth * sum.h[0], eighth * sum.h[1], eighth * sum.h[2], eighth * sum.h[3]}},
             f);
  }

 private:
  template <class T>
  [[gnu::always_inline]] static T weighted(int p, const T& a) {
    if constexpr (Rule::weighted)
      return R(Rule::weight(p)) * a;
    else
      return a;
  }
};

}  // namespace nugget::kernel
