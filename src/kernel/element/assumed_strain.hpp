// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "kernel/element/hexahedron_points.hpp"
#include "kernel/element/physical_stabilisation.hpp"

// Assumed strains of an eight-node brick that bends without locking. Included by .cpp files only.
namespace nugget::kernel {

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

/// Strains and stresses in the plane of two directions of a brick, `first` and `second`: those of a bent plate, with
/// the thinning that they draw along, none of whose fibres across the plane shears. Tensors in global axes.
template <class R>
struct BentPlane {
  Vec3<R> first, second, across;  ///< gradients of the two natural coordinates in the plane [1/length]; its normal
  R along_first, along_second, both, over;  ///< their products; one over the square of `across`

  [[gnu::always_inline]] BentPlane(const Vec3<R>& g, const Vec3<R>& h) : across(cross(g, h)) {
    over = 1.0 / dot(across, across);
    first = over * cross(h, across);
    second = over * cross(across, g);
    along_first = dot(first, first);
    along_second = dot(second, second);
    both = dot(first, second);
  }
  /// Strain whose components by the two directions are `ff`, `ss` and, twice, `fs`.
  [[gnu::always_inline]] SolidTensor<R> strain(const BendingStrains& draws, const R& ff, const R& ss,
                                               const R& fs) const {
    const R half = R(0.5) * fs, in_plane = along_first * ff + along_second * ss + both * fs,
            thinning = R(-draws.thinning) * over * in_plane;
    const Vec3<R> u = ff * first + half * second, v = half * first + ss * second, w = thinning * across;
    const R share = draws.deviatoric ? R((1.0 - draws.thinning) / 3.0) * in_plane : R(0.0);
    return {u.x * first.x + v.x * second.x + w.x * across.x - share,
            u.y * first.y + v.y * second.y + w.y * across.y - share,
            u.z * first.z + v.z * second.z + w.z * across.z - share,
            u.x * first.y + v.x * second.y + w.x * across.y,
            u.y * first.z + v.y * second.z + w.y * across.z,
            u.z * first.x + v.z * second.x + w.z * across.x};
  }
  /// What does the work of a stress on these three.
  [[gnu::always_inline]] Vec3<R> stress(const BendingStrains& draws, const SolidTensor<R>& s) const {
    const Vec3<R> on_second = traction(s, second);
    const R drawn = R(draws.thinning) * over * dot(across, traction(s, across));
    return {dot(first, traction(s, first)) - along_first * drawn, dot(second, on_second) - along_second * drawn,
            dot(first, on_second) - both * drawn};
  }
};

/// The brick with the uniform gradient of Flanagan and Belytschko and, on the hourglass patterns, the assumed strains
/// of Belytschko and Bindeman (CMAME 105 (1993), their equations for a stabilisation taken at points), by the brick's
/// own directions (strains_of), so that neither the numbering of its nodes nor the angles of its sides matter: a shear
/// strain varies only along the third direction, so bending makes none; the direct strains draw those of BendingStrains
/// along (the paper's are nu/(1 - nu) and nu, for a pressure that varies). Constant strain is exact on any shape. While
/// it is elastic its stiffness is that of one point with hourglass type 6 and QM = 1.
/// docs/theory/brick.md#assumed-strains.
template <class R>
class AssumedStrain {
 public:
  static constexpr bool one_pressure = true;
  static constexpr int points = 8;

  [[gnu::always_inline]] AssumedStrain(const BendingStrains& draws, const Patterns<R>& x)
      : draws_(draws), x_(x), uniform_(x), plane_{{x.b, x.c}, {x.c, x.a}, {x.a, x.b}} {
    over_[0] = 1.0 / dot(x.a, x.a);
    over_[1] = 1.0 / dot(x.b, x.b);
    over_[2] = 1.0 / dot(x.c, x.c);
  }

  /// Velocity gradients of the points, all with the spin of the brick, and the volumes that go with them.
  [[gnu::always_inline]] void rates(const Patterns<R>& v, Matrix<R> (&l)[points], R (&volume)[points]) const {
    const Matrix<R> mean = velocity_gradient(uniform_, v);
    const Hourglass<R> e = strains_of(x_, hourglass_rates(v, mean, x_));
    const Vec3<R>&e1 = e.q[0], &e2 = e.q[1], &e3 = e.q[2], &e4 = e.q[3];
    // Points stand at +-1/sqrt(3): these are the strains there.
    const R place = R(GaussPoint::place), square = R(1.0 / 3.0);
    const SolidTensor<R> xi = place * plane_[0].strain(draws_, e3.y, e2.z, e2.y + e3.z),
                         eta = place * plane_[1].strain(draws_, e1.z, e3.x, e1.x + e3.z),
                         zeta = place * plane_[2].strain(draws_, e2.x, e1.y, e1.x + e2.y),
                         eta_zeta = square * along_edge(0, x_.a, e4.x), zeta_xi = square * along_edge(1, x_.b, e4.y),
                         xi_eta = square * along_edge(2, x_.c, e4.z);
    for (int p = 0; p < points; p += 2) {
      const double y = p & 2 ? 1.0 : -1.0, z = p & 4 ? 1.0 : -1.0;
      const SolidTensor<R> middle = R(y) * eta + R(z) * zeta + R(y * z) * eta_zeta,
                           grows = xi + R(z) * zeta_xi + R(y) * xi_eta;
      l[p] = with(mean, middle + R(-1.0) * grows);
      l[p + 1] = with(mean, middle + grows);
    }
    volumes(volume);
  }
  [[gnu::always_inline]] void volumes(R (&volume)[points]) const {
    for (R& v : volume) v = R(1.0 / points) * uniform_.volume;
  }
  /// Nodal forces that do the work of the stresses.
  [[gnu::always_inline]] void forces(const SolidTensor<R> (&stress)[points], Vec3<R> (&f)[8]) const {
    SolidTensor<R> mean{}, xi{}, eta{}, zeta{}, eta_zeta{}, zeta_xi{}, xi_eta{};
    for (int p = 0; p < points; p += 2) {
      const R y = R(p & 2 ? 1.0 : -1.0), z = R(p & 4 ? 1.0 : -1.0), yz = y * z;
      const SolidTensor<R> sum = stress[p + 1] + stress[p], grows = stress[p + 1] + R(-1.0) * stress[p];
      mean = mean + sum;
      xi = xi + grows;
      eta = eta + y * sum;
      zeta = zeta + z * sum;
      eta_zeta = eta_zeta + yz * sum;
      zeta_xi = zeta_xi + z * grows;
      xi_eta = xi_eta + y * grows;
    }
    const R share = R(1.0 / points), place = R(GaussPoint::place) * share * uniform_.volume,
            square = R(GaussPoint::place) * place;
    const Vec3<R> s1 = plane_[0].stress(draws_, varying(place, xi)), s2 = plane_[1].stress(draws_, varying(place, eta)),
                  s3 = plane_[2].stress(draws_, varying(place, zeta));
    const Hourglass<R> s{{{s2.z + s3.z, s3.y, s2.x},
                          {s3.x, s3.z + s1.z, s1.y},
                          {s2.y, s1.x, s1.z + s2.z},
                          {on_edge(0, x_.a, varying(square, eta_zeta)), on_edge(1, x_.b, varying(square, zeta_xi)),
                           on_edge(2, x_.c, varying(square, xi_eta))}}};
    forces_of(uniform_, x_, share * mean, forces_on_patterns(x_, s), true, f);
  }

 private:
  /// Strain of the pattern xi eta zeta along a direction of the brick; of the last, `e` is its component by it.
  [[gnu::always_inline]] SolidTensor<R> along_edge(int i, const Vec3<R>& g, const R& e) const {
    const R stretch = e * over_[i], along = R(1.0 + draws_.last) * stretch * over_[i];
    const R share = R(draws_.deviatoric ? (1.0 + draws_.last) / 3.0 : draws_.last) * stretch;
    const Vec3<R> u = along * g;
    return {u.x * g.x - share, u.y * g.y - share, u.z * g.z - share, u.x * g.y, u.y * g.z, u.z * g.x};
  }
  [[gnu::always_inline]] R on_edge(int i, const Vec3<R>& g, const SolidTensor<R>& s) const {
    const R direct = over_[i] * dot(g, traction(s, g));
    return over_[i] * (R(1.0 + draws_.last) * direct - R(draws_.last) * (s.xx + s.yy + s.zz));
  }
  /// Stress that varies over the brick, times `scale`; without its pressure where that does not vary.
  [[gnu::always_inline]] SolidTensor<R> varying(const R& scale, const SolidTensor<R>& s) const {
    SolidTensor<R> a = scale * s;
    if (!draws_.deviatoric) return a;
    const R mean = R(1.0 / 3.0) * (a.xx + a.yy + a.zz);
    a.xx -= mean;
    a.yy -= mean;
    a.zz -= mean;
    return a;
  }
  /// The gradient with a strain rate added.
  [[gnu::always_inline]] static Matrix<R> with(Matrix<R> l, const SolidTensor<R>& e) {
    l.x += {e.xx, e.xy, e.zx};
    l.y += {e.xy, e.yy, e.yz};
    l.z += {e.zx, e.yz, e.zz};
    return l;
  }

  BendingStrains draws_;
  const Patterns<R>& x_;
  Gradient<R> uniform_;
  BentPlane<R> plane_[3];  ///< across xi, eta and zeta
  R over_[3];              ///< one over the squares of the brick's directions [1/length^2]
};

}  // namespace nugget::kernel
