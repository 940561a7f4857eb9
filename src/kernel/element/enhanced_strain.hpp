// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/hexahedron_points.hpp"

// Enhanced strains of an eight-node brick, for linear analyses. Included by full_hexahedron.cpp only.
namespace nugget::kernel {

/// The brick of Simo and Rifai (IJNME 29 (1990)) with nine inner strains, those of displacements that are quadratic in
/// one natural coordinate (Taylor, Beresford and Wilson 1976), by the directions of the brick in its middle. They take
/// the values at which the stresses of an isotropic elastic material do no work on them; forces do the work of the
/// law's stresses on the strains so made. Exact in bending of parallelepipeds, constant strain exact on any shape.
template <class R>
class EnhancedStrain {
 public:
  static constexpr bool one_pressure = false;
  static constexpr int points = 8;

  [[gnu::always_inline]] EnhancedStrain(const ElasticConstants& e, const Patterns<R>& x)
      : x_(x),
        shear_(e.shear),
        lame_(e.bulk_wave() - 2.0 * e.shear),
        middle_{cross(x.b, x.c), cross(x.c, x.a), cross(x.a, x.b)} {
    SolidTensor<R> share{};  // of the points' inverse Jacobians what goes with xi xi, eta eta, zeta zeta, xi eta, ...
    for (int p = 0; p < points; ++p) {
      const GaussPoint at = gauss_point(p);
      over_[p] = 1.0 / Cofactors<R>(Slopes<R>(x, at)).jacobian;
      share.xx += R(at.xi * at.xi) * over_[p];
      share.xy += R(at.xi * at.eta) * over_[p];
      share.yz += R(at.eta * at.zeta) * over_[p];
      share.zx += R(at.zeta * at.xi) * over_[p];
    }
    share.yy = share.zz = share.xx;
    const R of[3][3] = {{share.xx, share.xy, share.zx}, {share.xy, share.yy, share.yz}, {share.zx, share.yz, share.zz}};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b <= a; ++b) {
        const Vec3<R>&u = middle_[a], &v = middle_[b];
        const R both = shear_ * dot(u, v);
        const R uu[3] = {u.x, u.y, u.z}, vv[3] = {v.x, v.y, v.z};
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k) {
            const R same = i == k ? both : R(0.0);
            matrix_[3 * a + i][3 * b + k] = of[a][b] * (lame_ * uu[i] * vv[k] + shear_ * vv[i] * uu[k] + same);
          }
      }
    for (int j = 0; j < 9; ++j) {  // L D L^T, row by row; the inverse of D on the diagonal
      for (int k = 0; k < j; ++k) {
        R sum = matrix_[j][k];
        for (int i = 0; i < k; ++i) sum -= matrix_[j][i] * matrix_[k][i];
        matrix_[j][k] = sum;  // L D
      }
      R pivot = matrix_[j][j];
      for (int k = 0; k < j; ++k) {
        const R l = matrix_[j][k] * matrix_[k][k];
        pivot -= l * matrix_[j][k];
        matrix_[j][k] = l;
      }
      matrix_[j][j] = 1.0 / pivot;
    }
  }

  /// Velocity gradients of the points and the volumes that go with them.
  [[gnu::always_inline]] void rates(const Patterns<R>& v, Matrix<R> (&l)[points], R (&volume)[points]) const {
    Inner work{};
    for (int p = 0; p < points; ++p) {
      const GaussPoint at = gauss_point(p);
      const Cofactors<R> c(Slopes<R>(x_, at));
      l[p] = velocity_gradient(Slopes<R>(v, at), c);
      volume[p] = c.jacobian;
      const Matrix<R>& g = l[p];
      collect_inner(elastic({g.x.x, g.y.y, g.z.z, g.x.y + g.y.x, g.y.z + g.z.y, g.z.x + g.x.z}), at, work);
    }
    const Inner inner = relaxed(work);
    for (int p = 0; p < points; ++p) {
      const SolidTensor<R> e = strain(inner, p);
      const R xy = R(0.5) * e.xy, yz = R(0.5) * e.yz, zx = R(0.5) * e.zx;
      l[p].x += {e.xx, xy, zx};
      l[p].y += {xy, e.yy, yz};
      l[p].z += {zx, yz, e.zz};
    }
  }
  [[gnu::always_inline]] void volumes(R (&volume)[points]) const {
    for (int p = 0; p < points; ++p) volume[p] = 1.0 / over_[p];
  }
  /// Nodal forces that do the work of the stresses.
  [[gnu::always_inline]] void forces(const SolidTensor<R> (&stress)[points], Vec3<R> (&f)[8]) const {
    Inner work{};
    for (int p = 0; p < points; ++p) collect_inner(stress[p], gauss_point(p), work);
    const Inner inner = relaxed(work);
    SolidTensor<R> all[points];
    for (int p = 0; p < points; ++p) all[p] = stress[p] + elastic(strain(inner, p));
    Isoparametric<R>{x_}.forces(all, f);
  }

 private:
  struct Inner {
    Vec3<R> of[3];  ///< of xi, eta and zeta
  };

  /// Elastic stress of a strain with engineering shears.
  [[gnu::always_inline]] SolidTensor<R> elastic(const SolidTensor<R>& e) const {
    const R mean = lame_ * (e.xx + e.yy + e.zz), twice = 2.0 * shear_;
    return {mean + twice * e.xx, mean + twice * e.yy, mean + twice * e.zz, shear_ * e.xy, shear_ * e.yz, shear_ * e.zx};
  }
  /// Adds the forces of a point's stress on the inner displacements.
  [[gnu::always_inline]] void collect_inner(const SolidTensor<R>& s, const GaussPoint& at, Inner& work) const {
    const double place[3] = {at.xi, at.eta, at.zeta};
    for (int a = 0; a < 3; ++a) work.of[a] += R(place[a]) * traction(s, middle_[a]);
  }
  /// Strain of inner displacements at a point; engineering shears.
  [[gnu::always_inline]] SolidTensor<R> strain(const Inner& inner, int p) const {
    const GaussPoint at = gauss_point(p);
    const double place[3] = {at.xi, at.eta, at.zeta};
    SolidTensor<R> e{};
    for (int a = 0; a < 3; ++a) {
      const Vec3<R> u = (R(place[a]) * over_[p]) * inner.of[a], &g = middle_[a];
      e = e + SolidTensor<R>{
                  u.x * g.x, u.y * g.y, u.z * g.z, u.x * g.y + u.y * g.x, u.y * g.z + u.z * g.y, u.z * g.x + u.x * g.z};
    }
    return e;
  }
  /// The inner displacements whose elastic forces are opposite to these.
  [[gnu::always_inline]] Inner relaxed(const Inner& work) const {
    R y[9];
    for (int a = 0; a < 3; ++a) {
      y[3 * a] = -work.of[a].x;
      y[3 * a + 1] = -work.of[a].y;
      y[3 * a + 2] = -work.of[a].z;
    }
    for (int j = 1; j < 9; ++j)
      for (int k = 0; k < j; ++k) y[j] -= matrix_[j][k] * y[k];
    for (int j = 0; j < 9; ++j) y[j] = y[j] * matrix_[j][j];
    for (int j = 7; j >= 0; --j)
      for (int k = j + 1; k < 9; ++k) y[j] -= matrix_[k][j] * y[k];
    return {{{y[0], y[1], y[2]}, {y[3], y[4], y[5]}, {y[6], y[7], y[8]}}};
  }

  const Patterns<R>& x_;
  R shear_, lame_;
  Vec3<R> middle_[3];  ///< gradients of xi, eta and zeta in the middle, times its Jacobian
  R over_[points];     ///< one over the Jacobians
  R matrix_[9][9];     ///< L below the diagonal, one over D on it
};

}  // namespace nugget::kernel
