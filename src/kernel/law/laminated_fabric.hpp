// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/elementary.hpp"
#include "base/index.hpp"
#include "kernel/law/orthotropic.hpp"

namespace nugget::kernel {

/// Layers of fibres, laminates and fabrics with continuum damage (MAT_058; A. Matzenmiller, J. Lubliner, R.L. Taylor,
/// Mechanics of Materials 20, 1995), for layers of shells. With the shares k of its stiffness that damage has left,
///   strain_a = stress_a / (ka EA) - PRBA stress_b / EB,   strain_b alike,   shear_ab = stress_ab / (ks GAB),
/// ka and kb those of tension or of compression by the sign of the stress. Each k falls with the largest r so far,
///   k = exp(-(r^m / (m e))),   m = 1 / ln(modulus strain / strength),
/// r the undamaged stress over the strength: alone, a stress rises to its strength at its strain and falls beyond,
/// never below SLIM times the strength. What r is: Surface.
struct LaminatedFabric : Orthotropic {
  enum class Surface {
    faceted,      ///< FS -1: each stress by itself; shear by the curve of TAU1 and GAMMA1 where these are given
    fibre_alone,  ///< FS 0: along a by itself; across and in shear sqrt((b/Y)^2 + (ab/SC)^2)
    quadratic     ///< FS 1: along a likewise, with the shear; shear by the larger of both
  };
  struct Mode {
    double strength = 0.0;  ///< [stress]
    double strain = 0.0;    ///< at the strength [1]
    double left = 1e-8;     ///< SLIM: of the strength, at least, beyond it [1]
  };
  Surface surface = Surface::fibre_alone;
  /// XT E11T SLIMT1, XC E11C SLIMC1, YT E22T SLIMT2, YC E22C SLIMC2, SC GMS SLIMS.
  Mode tension_a, compression_a, tension_b, compression_b, shear;
  double first_shear_stress = 0.0, first_shear_strain = 0.0;  ///< TAU1 [stress], GAMMA1 [1]; 0: none
  /// ERODS, effective strain at which the layer fails [1]: above 0 with a thickness that keeps the volume, below 0 with
  /// that of the layer; 0: none.
  double failure_strain = 0.0;
  double soft = 1.0;  ///< SOFT: factor on all strengths, and their strains, beside a deleted element [1]
};

/// History of a point: the material axes as of Orthotropic; strains a, b, ab, c, ac, bc; the largest r of each mode;
/// the stresses a, b, ab of its damaged law; whether the layer has failed; where SOFT is not 1, whether it stands
/// beside a deleted element.
template <>
class LawKernel<LaminatedFabric> {
 public:
  static constexpr bool has_plastic_strain = false;

  explicit LawKernel(const LaminatedFabric& law);

  int layer_history() const { return failed_field + (crash_front_field() > 0 ? 2 : 1); }
  /// Where the history says, by 1, that the layer stands beside a deleted element; 0: nowhere.
  int crash_front_field() const { return law_.soft != 1.0 ? failed_field + 1 : 0; }
  const MaterialAxes& axes() const { return law_.axes; }
  bool can_fail() const { return law_.failure_strain != 0.0; }
  template <class R>
  MaskOf<R> failed(const double* history) const {
    return load_field<R>(history, failed_field) > R(0.5);
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const R c = load_field<R>(history, first_axis_field), t = load_field<R>(history, first_axis_field + 1);
    const R cc = c * c, tt = t * t, ct = c * t;
    const LayerTensor<R> e = R(dt) * rate;
    const R shear_az = c * e.xz + t * e.yz, shear_bz = c * e.yz - t * e.xz;
    const R strain_a = add(history, 0, cc * e.xx + tt * e.yy + ct * e.xy),
            strain_b = add(history, 1, tt * e.xx + cc * e.yy - ct * e.xy),
            strain_ab = add(history, 2, 2.0 * ct * (e.yy - e.xx) + (cc - tt) * e.xy);

    std::array<R, modes> most;
    for (int m = 0; m < modes; ++m) most[at(m)] = load_field<R>(history, most_field + m);
    grow(strain_a, strain_b, strain_ab, history, most);
    for (int m = 0; m < modes; ++m) store_field(history, most_field + m, most[at(m)]);
    const Undamaged<R> now = undamaged(strain_a, strain_b, left<R>(most));
    const R stress[] = {now.left_a * now.a, now.left_b * now.b,
                        law_.shear_ab * (left_of(most[shear], shear) * strain_ab)};
    R change[3];
    for (int i = 0; i < 3; ++i) {
      change[i] = stress[i] - load_field<R>(history, stress_field + i);
      store_field(history, stress_field + i, stress[i]);
    }
    const R da = change[0], db = change[1], dab = change[2];
    const R az = law_.shear_ca * shear_az, bz = law_.shear_bc * shear_bz;
    const ThicknessStrain<R> thickness{thinning_a_ * da + thinning_b_ * db, R(0.0)};
    if (can_fail()) {
      const R strain_c = add(history, 3, thickness.total), strain_ac = add(history, 4, shear_az),
              strain_bc = add(history, 5, shear_bz);
      fail(strain_a, strain_b, strain_ab, strain_c, strain_ac, strain_bc, history);
    }
    s.xx += cc * da + tt * db - 2.0 * ct * dab;
    s.yy += tt * da + cc * db + 2.0 * ct * dab;
    s.xy += ct * (da - db) + (cc - tt) * dab;
    s.xz += c * az - t * bz;
    s.yz += t * az + c * bz;
    return thickness;
  }

 private:
  enum ModeNumber { a_tension, a_compression, b_tension, b_compression, shear, modes };
  static constexpr int strain_field = first_axis_field + 2, most_field = strain_field + 6,
                       stress_field = most_field + modes, failed_field = stress_field + 3;

  /// Stresses of the strains as if the layer had no damage where they pull or press, and what of them is left.
  template <class R>
  struct Undamaged {
    R a, b, left_a, left_b;
  };
  /// Of a mode: m, 1 / (m e), r at the strength.
  struct Fall {
    double exponent = 1.0, share = 0.0, peak = 1.0, left = 0.0;
  };

  template <class R>
  static R add(double* history, int i, const R& more) {
    const R sum = load_field<R>(history, strain_field + i) + more;
    store_field(history, strain_field + i, sum);
    return sum;
  }

  /// What is left of the stiffness of a mode, by its largest r.
  template <class R>
  R left_of(const R& r, ModeNumber mode) const {
    const Fall& fall = fall_[mode];
    const R floor = select(r > fall.peak, fall.left / max(r, R(1e-300)), R(0.0));
    if (mode == shear && curved_) {
      const R first = exponential((-shear_bend_) * min(r, R(first_shear_))),
              second = (shear_start_ + shear_slope_ * r) / max(r, R(1e-300));
      return select(r > fall.peak, floor, select(r > first_shear_, second, first));
    }
    return max(exponential((-fall.share) * power(r, fall.exponent)), floor);
  }
  template <class R>
  std::array<R, modes> left(const std::array<R, modes>& most) const {
    std::array<R, modes> k;
    for (int m = 0; m < shear; ++m) k[at(m)] = left_of(most[at(m)], static_cast<ModeNumber>(m));
    return k;
  }

  /// The signs of both stresses depend on each other by what is left of either way; there is one pair that agrees, and
  /// turning the first that does not finds it (the compliance is positive definite).
  template <class R>
  Undamaged<R> undamaged(const R& strain_a, const R& strain_b, const std::array<R, modes>& left) const {
    auto pulled_a = strain_a + law_.poisson_ba * strain_b >= 0.0, pulled_b = strain_b + poisson_ab_ * strain_a >= 0.0;
    for (int turns = 0;; ++turns) {
      const R left_a = select(pulled_a, left[a_tension], left[a_compression]),
              left_b = select(pulled_b, left[b_tension], left[b_compression]);
      const R a = strain_a + left_b * (law_.poisson_ba * strain_b), b = strain_b + left_a * (poisson_ab_ * strain_a);
      const auto pulls_a = a >= 0.0, pulls_b = b >= 0.0;
      const auto off_a = (pulls_a && !pulled_a) || (!pulls_a && pulled_a);
      const auto off_b = ((pulls_b && !pulled_b) || (!pulls_b && pulled_b)) && !off_a;
      if (!any(off_a || off_b) || turns == 4) {
        const R over = 1.0 / (1.0 - poisson_ab_ * law_.poisson_ba * left_a * left_b);
        return {law_.young_a * (over * a), law_.young_b * (over * b), left_a, left_b};
      }
      pulled_a = (pulled_a && !off_a) || (!pulled_a && off_a);
      pulled_b = (pulled_b && !off_b) || (!pulled_b && off_b);
    }
  }

  /// The largest r with that of these strains.
  template <class R>
  void grow(const R& strain_a, const R& strain_b, const R& strain_ab, const double* history,
            std::array<R, modes>& most) const {
    const Undamaged<R> s = undamaged(strain_a, strain_b, left<R>(most));
    R over = R(1.0);
    if (crash_front_field() > 0)
      over = select(load_field<R>(history, crash_front_field()) > 0.5, R(1.0 / law_.soft), R(1.0));
    const auto pull = [&](const R& x, double strength) { return over * (1.0 / strength) * max(x, R(0.0)); };
    const R sheared = over * (law_.shear_ab / law_.shear.strength) * abs(strain_ab);
    const auto with_shear = [&](const R& r) { return sqrt(r * r + sheared * sheared); };
    std::array<R, modes> r{pull(s.a, law_.tension_a.strength), pull(-s.a, law_.compression_a.strength),
                           pull(s.b, law_.tension_b.strength), pull(-s.b, law_.compression_b.strength), sheared};
    if (law_.surface != LaminatedFabric::Surface::faceted) {
      for (int m = b_tension; m < shear; ++m) r[at(m)] = with_shear(r[at(m)]);
      r[shear] = max(r[b_tension], r[b_compression]);
    }
    if (law_.surface == LaminatedFabric::Surface::quadratic) {
      for (int m = 0; m < b_tension; ++m) r[at(m)] = with_shear(r[at(m)]);
      r[shear] = max(r[shear], max(r[a_tension], r[a_compression]));
    }
    for (int m = 0; m < modes; ++m) most[at(m)] = max(most[at(m)], r[at(m)]);
  }

  template <class R>
  void fail(const R& a, const R& b, const R& ab, const R& of_thickness, const R& ac, const R& bc,
            double* history) const {
    const R c = law_.failure_strain > 0.0 ? -(a + b) : of_thickness, mean = (1.0 / 3.0) * (a + b + c);
    const R x = a - mean, y = b - mean, z = c - mean;
    const R square = x * x + y * y + z * z + 0.5 * (ab * ab + ac * ac + bc * bc);
    const auto fails = (2.0 / 3.0) * square >= R(law_.failure_strain * law_.failure_strain);
    store_field(history, failed_field, select(fails, R(1.0), load_field<R>(history, failed_field)));
  }

  LaminatedFabric law_;
  double poisson_ab_, thinning_a_, thinning_b_;
  std::array<Fall, modes> fall_;
  /// Of shear by a curve over r = GAB gamma / SC: its first part is r exp(-bend r), to first_shear_, its second start +
  /// slope r, both over SC.
  bool curved_ = false;
  double first_shear_ = 0.0, shear_bend_ = 0.0, shear_start_ = 0.0, shear_slope_ = 0.0;
};

}  // namespace nugget::kernel
