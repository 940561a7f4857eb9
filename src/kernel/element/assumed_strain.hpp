// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "kernel/element/uniform_gradient.hpp"

// Assumed strains of an eight-node brick that bends without locking. Included by full_hexahedron.cpp only.
namespace nugget::kernel {

/// Natural coordinates of a point of the 2 x 2 x 2 rule.
struct GaussPoint {
  double xi, eta, zeta;
};
constexpr GaussPoint gauss_point(int p) {
  constexpr double place = 0.57735026918962576;
  return {p & 1 ? place : -place, p & 2 ? place : -place, p & 4 ? place : -place};
}

/// What a direct strain that varies over the element draws along across itself, as shares of it.
///
/// A fibre stretched on one side of the neutral plane and shortened on the other becomes thinner and thicker, which the
/// nodes of a brick cannot show. `thinning` is this strain, across the neutral plane, and `last` that of the pattern xi
/// eta zeta, in both directions across. With one pressure in the brick, only deviators vary, and these are the shares
/// that give the elastic bending stiffness exactly, of a wide plate (E/(1 - nu^2)) and of a narrow beam (E):
///   thinning^2 - (1 - thinning)^2/3 = nu/(1 - nu),   (2/3) (1 + last)^2 = 1 + nu.
/// Both keep the volume at nu = 1/2. None: of a stress state without stresses across.
struct BendingStrains {
  double thinning = 0.0, last = 0.0;
  bool deviatoric = false;  ///< the dilatation does not vary over the brick

  BendingStrains() = default;
  explicit BendingStrains(double nu)
      : thinning(0.5 * (std::sqrt(3.0 + 6.0 * nu / (1.0 - nu)) - 1.0)),
        last(std::sqrt(1.5 * (1.0 + nu)) - 1.0),
        deviatoric(true) {}
};

/// The brick with the uniform gradient of Flanagan and Belytschko and, on the hourglass patterns, the assumed strains
/// of Belytschko and Bindeman (CMAME 105 (1993), their equations for a stabilisation taken at points): a shear strain
/// varies only along the third axis, so bending makes none; the direct strains draw those of BendingStrains along (the
/// paper's are nu/(1 - nu) and nu, for a pressure that varies). Constant strain is exact on any shape.
template <class R>
class AssumedStrain {
 public:
  static constexpr int points = 8;

  [[gnu::always_inline]] AssumedStrain(const BendingStrains& strains, const Patterns<R>& x)
      : strains_(strains), x_(x), uniform_(x), axes_(axes_of(x)) {
    const Vec3<R> bc = cross(x.b, x.c);
    const R over = 1.0 / dot(x.a, bc);
    xi_ = axes_.local(over * bc);
    eta_ = axes_.local(over * cross(x.c, x.a));
    zeta_ = axes_.local(over * cross(x.a, x.b));
  }

  /// Velocity gradients of the points, all with the spin of the brick, and the volumes that go with them.
  [[gnu::always_inline]] void rates(const Patterns<R>& v, Matrix<R> (&l)[points], R (&volume)[points]) const {
    const Matrix<R> mean = velocity_gradient(uniform_, v);
    Hourglass<R> q = hourglass_rates(v, mean, x_);
    for (Vec3<R>& a : q.q) a = axes_.local(a);
    for (int p = 0; p < points; ++p) l[p] = with(mean, strain(Slopes(*this, p), q));
    volumes(volume);
  }
  [[gnu::always_inline]] void volumes(R (&volume)[points]) const {
    for (R& v : volume) v = R(1.0 / points) * uniform_.volume;
  }
  /// Nodal forces that do the work of the stresses.
  [[gnu::always_inline]] void forces(const SolidTensor<R> (&stress)[points], Vec3<R> (&f)[8]) const {
    const R share = R(1.0 / points);
    SolidTensor<R> mean{};
    Hourglass<R> q{};
    for (int p = 0; p < points; ++p) {
      const SolidTensor<R>& s = stress[p];
      mean = mean + share * s;
      add_work(Slopes(*this, p), in_axes(s), q);
    }
    for (Vec3<R>& a : q.q) a = (share * uniform_.volume) * axes_.global(a);
    forces_of(uniform_, x_, mean, q, true, f);
  }

 private:
  /// Gradients of the hourglass patterns at a point, by those of xi, eta and zeta in the middle; in the brick's axes.
  struct Slopes {
    Vec3<R> h1, h2, h3, h4;
    [[gnu::always_inline]] Slopes(const AssumedStrain& b, int p) {
      const GaussPoint at = gauss_point(p);
      h1 = R(at.zeta) * b.eta_ + R(at.eta) * b.zeta_;
      h2 = R(at.xi) * b.zeta_ + R(at.zeta) * b.xi_;
      h3 = R(at.eta) * b.xi_ + R(at.xi) * b.eta_;
      h4 = R(at.eta * at.zeta) * b.xi_ + R(at.zeta * at.xi) * b.eta_ + R(at.xi * at.eta) * b.zeta_;
    }
  };

  /// Strain rate of the hourglass rates, in the brick's axes; engineering shears.
  [[gnu::always_inline]] SolidTensor<R> strain(const Slopes& g, const Hourglass<R>& q) const {
    const R c = R(strains_.thinning), d = R(strains_.last);
    const Vec3<R>&q1 = q.q[0], &q2 = q.q[1], &q3 = q.q[2], &q4 = q.q[3];
    const R x2 = g.h2.x * q2.x, x3 = g.h3.x * q3.x, x4 = g.h4.x * q4.x;
    const R y1 = g.h1.y * q1.y, y3 = g.h3.y * q3.y, y4 = g.h4.y * q4.y;
    const R z1 = g.h1.z * q1.z, z2 = g.h2.z * q2.z, z4 = g.h4.z * q4.z;
    SolidTensor<R> e{g.h1.x * q1.x + x2 + x3 + x4 - c * (y3 + z2) - d * (y4 + z4),
                     y1 + g.h2.y * q2.y + y3 + y4 - c * (x3 + z1) - d * (x4 + z4),
                     z1 + z2 + g.h3.z * q3.z + z4 - c * (x2 + y1) - d * (x4 + y4),
                     g.h1.y * q1.x + g.h2.y * q2.x + g.h1.x * q1.y + g.h2.x * q2.y,
                     g.h2.z * q2.y + g.h3.z * q3.y + g.h2.y * q2.z + g.h3.y * q3.z,
                     g.h1.z * q1.x + g.h3.z * q3.x + g.h1.x * q1.z + g.h3.x * q3.z};
    if (strains_.deviatoric) e = deviator(e);
    return e;
  }

  /// Adds the forces that do the work of a stress on `strain`; both in the brick's axes.
  [[gnu::always_inline]] void add_work(const Slopes& g, const SolidTensor<R>& stress, Hourglass<R>& q) const {
    const R c = R(strains_.thinning), d = R(strains_.last);
    const SolidTensor<R> s = strains_.deviatoric ? deviator(stress) : stress;
    q.q[0] += Vec3<R>{g.h1.x * s.xx + g.h1.y * s.xy + g.h1.z * s.zx, g.h1.y * (s.yy - c * s.zz) + g.h1.x * s.xy,
                      g.h1.z * (s.zz - c * s.yy) + g.h1.x * s.zx};
    q.q[1] += Vec3<R>{g.h2.x * (s.xx - c * s.zz) + g.h2.y * s.xy, g.h2.y * s.yy + g.h2.x * s.xy + g.h2.z * s.yz,
                      g.h2.z * (s.zz - c * s.xx) + g.h2.y * s.yz};
    q.q[2] += Vec3<R>{g.h3.x * (s.xx - c * s.yy) + g.h3.z * s.zx, g.h3.y * (s.yy - c * s.xx) + g.h3.z * s.yz,
                      g.h3.z * s.zz + g.h3.x * s.zx + g.h3.y * s.yz};
    q.q[3] += Vec3<R>{g.h4.x * (s.xx - d * (s.yy + s.zz)), g.h4.y * (s.yy - d * (s.zz + s.xx)),
                      g.h4.z * (s.zz - d * (s.xx + s.yy))};
  }

  static SolidTensor<R> deviator(SolidTensor<R> a) {
    const R mean = R(1.0 / 3.0) * (a.xx + a.yy + a.zz);
    a.xx -= mean;
    a.yy -= mean;
    a.zz -= mean;
    return a;
  }

  /// A stress in the brick's axes.
  [[gnu::always_inline]] SolidTensor<R> in_axes(const SolidTensor<R>& s) const {
    const Matrix<R> m{{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
    const Vec3<R> t1 = m * axes_.e1, t2 = m * axes_.e2, t3 = m * axes_.e3;
    return {dot(axes_.e1, t1), dot(axes_.e2, t2), dot(axes_.e3, t3),
            dot(axes_.e1, t2), dot(axes_.e2, t3), dot(axes_.e3, t1)};
  }

  /// The gradient with a strain rate in the brick's axes added.
  [[gnu::always_inline]] Matrix<R> with(Matrix<R> l, const SolidTensor<R>& e) const {
    const R half = R(0.5);
    const Vec3<R> t1 = e.xx * axes_.e1 + (half * e.xy) * axes_.e2 + (half * e.zx) * axes_.e3,
                  t2 = (half * e.xy) * axes_.e1 + e.yy * axes_.e2 + (half * e.yz) * axes_.e3,
                  t3 = (half * e.zx) * axes_.e1 + (half * e.yz) * axes_.e2 + e.zz * axes_.e3;
    l.x += axes_.e1.x * t1 + axes_.e2.x * t2 + axes_.e3.x * t3;
    l.y += axes_.e1.y * t1 + axes_.e2.y * t2 + axes_.e3.y * t3;
    l.z += axes_.e1.z * t1 + axes_.e2.z * t2 + axes_.e3.z * t3;
    return l;
  }

  BendingStrains strains_;
  const Patterns<R>& x_;
  Gradient<R> uniform_;
  Frame<R> axes_;
  Vec3<R> xi_, eta_, zeta_;  ///< gradients of the natural coordinates in the middle, in the brick's axes
};

}  // namespace nugget::kernel
