// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/index.hpp"
#include "kernel/law/orthotropic.hpp"

namespace nugget::kernel {

/// A layer of fibres in one direction: orthotropic elasticity in rate form with failure by modes (MAT_022, MAT_054,
/// MAT_055), for layers of shells. Shear in the plane follows gamma = tau / GAB + ALPH tau^3.
///
/// Failure indices, 1 at failure, of the stresses a, b (along and across the fibres) and ab:
///   fibre, tension      (a/XT)^2 + BETA (ab/SC)^2; of MAT_022 (a/XT)^2 + T
///   fibre, compression  (a/XC)^2; MAT_022 has none
///   matrix, tension     (b/YT)^2 + (ab/SC)^2; of MAT_022 (b/YT)^2 + T
///   matrix, compression (b/2SC)^2 + ((YC/2SC)^2 - 1) b/YC + (ab/SC)^2; of MAT_022 with T at the end
///   matrix of MAT_055   b^2/(YC YT) + (ab/SC)^2 + (YC - YT) b/(YC YT)
/// with T = (ab^2/2GAB + 3/4 ALPH ab^4) / (SC^2/2GAB + 3/4 ALPH SC^4). F.-K. Chang, K.-Y. Chang, J. Composite Materials
/// 21 (1987); Z. Hashin, J. Appl. Mech. 47 (1980); S.W. Tsai, E.M. Wu, J. Composite Materials 5 (1971); LS-DYNA Theory
/// Manual, material models 22 and 54. What a mode takes from the layer: docs/decisions/0106.
struct CompositeLayer : Orthotropic {
  enum class Rule {
    stresses_vanish,  ///< MAT_022: with the moduli of a mode its stresses are gone
    stresses_stay,    ///< MAT_054: they do not rise above what they were
    tsai_wu           ///< MAT_055: as MAT_054, with the index of Tsai and Wu for the matrix
  };
  Rule rule = Rule::stresses_stay;
  double tension_a = 0.0, compression_a = 0.0;  ///< XT, XC [stress]
  double tension_b = 0.0, compression_b = 0.0;  ///< YT, YC [stress]
  double shear_strength = 0.0;                  ///< SC [stress]
  double shear_cube = 0.0;                      ///< ALPH [1/stress^3]
  double shear_weight = 0.0;                    ///< BETA [1]
  /// After matrix failure in compression: FBRT, factor on XT [1], 0: none; YCFAC, XC becomes YCFAC YC where that is
  /// less [1].
  double crushed_tension = 0.0, crushed_compression = 2.0;
  /// DFAILT, DFAILC (as a positive number), DFAILM, DFAILS: strains at which the layer fails [1]; 0: none. The last is
  /// a tensorial shear strain. Without DFAILT the layer fails with its fibres in tension.
  double failure_strain_t = 0.0, failure_strain_c = 0.0, failure_strain_m = 0.0, failure_strain_s = 0.0;
  double effective_failure_strain = 0.0;  ///< EFS: sqrt(2/3 e:e) of the strain's deviator [1]; 0: none
  /// SLIMT1, SLIMC1, SLIMT2, SLIMC2, SLIMS: what is left of the stress that a mode stopped [1], NCYRED cycles later.
  std::array<double, 5> left{1.0, 1.0, 1.0, 1.0, 1.0};
  double cycles_of_loss = 100.0;
  double soft = 1.0;  ///< SOFT: factor on all strengths of MAT_054 and MAT_055 beside a deleted element [1]
};

/// History of a point: the material axes as of Orthotropic; strains a, b, ab, c, ac, bc; for each mode the cycles since
/// it was met; the stresses that they stopped; whether the layer has failed; where SOFT is not 1, whether it stands
/// beside a deleted element.
template <>
class LawKernel<CompositeLayer> {
 public:
  static constexpr bool has_plastic_strain = false;

  explicit LawKernel(const CompositeLayer& law);

  int layer_history() const { return failed_field + (crash_front_field() > 0 ? 2 : 1); }
  /// Where the history says, by 1, that the layer stands beside a deleted element; 0: nowhere.
  int crash_front_field() const { return law_.soft != 1.0 ? failed_field + 1 : 0; }
  const MaterialAxes& axes() const { return law_.axes; }
  static bool can_fail() { return true; }
  template <class R>
  MaskOf<R> failed(const double* history) const {
    return load_field<R>(history, failed_field) > R(0.5);
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const R c = load_field<R>(history, first_axis_field), t = load_field<R>(history, first_axis_field + 1);
    const R cc = c * c, tt = t * t, ct = c * t;
    const LayerTensor<R> e = R(dt) * rate;
    const Plane<R> strain{cc * e.xx + tt * e.yy + ct * e.xy, tt * e.xx + cc * e.yy - ct * e.xy,
                          2.0 * ct * (e.yy - e.xx) + (cc - tt) * e.xy};
    const R shear_az = c * e.xz + t * e.yz, shear_bz = c * e.yz - t * e.xz;
    const Plane<R> before{cc * s.xx + tt * s.yy + 2.0 * ct * s.xy, tt * s.xx + cc * s.yy - 2.0 * ct * s.xy,
                          ct * (s.yy - s.xx) + (cc - tt) * s.xy};
    Plane<R> now{before.a + (aa_ * strain.a + ab_ * strain.b), before.b + (ab_ * strain.a + bb_ * strain.b),
                 sheared(before.ab, strain.ab)};
    if (law_.rule == CompositeLayer::Rule::stresses_vanish)
      lose_stresses(before, strain, now, history);
    else
      limit_stresses(now, history);

    const R da = now.a - before.a, db = now.b - before.b, dab = now.ab - before.ab;
    const R az = law_.shear_ca * shear_az, bz = law_.shear_bc * shear_bz;
    ThicknessStrain<R> thickness{thinning_a_ * da + thinning_b_ * db, R(0.0)};
    add_strains(strain, thickness.total, shear_az, shear_bz, history);
    s.xx += cc * da + tt * db - 2.0 * ct * dab;
    s.yy += tt * da + cc * db + 2.0 * ct * dab;
    s.xy += ct * (da - db) + (cc - tt) * dab;
    s.xz += c * az - t * bz;
    s.yz += t * az + c * bz;
    return thickness;
  }

 private:
  template <class R>
  struct Plane {
    R a, b, ab;
  };
  enum Mode { fibre_tension, fibre_compression, matrix_tension, matrix_compression, modes };
  enum Held { a_tension, a_compression, b_tension, b_compression, shear, held };
  static constexpr int strain_field = first_axis_field + 2, mode_field = strain_field + 6,
                       held_field = mode_field + modes, failed_field = held_field + held;

  /// Shear stress after an engineering strain increment: the root of x / GAB + ALPH x^3 by Newton's method.
  template <class R>
  R sheared(const R& before, const R& increment) const {
    const double g = law_.shear_ab, alpha = law_.shear_cube;
    if (alpha == 0.0) return before + g * increment;
    const double over_g = 1.0 / g;
    const R wanted = before * over_g + alpha * before * before * before + increment;
    R x = before + increment / (over_g + 3.0 * alpha * before * before);
    for (int i = 0; i < 100; ++i) {
      const R off = x * over_g + alpha * x * x * x - wanted;
      const auto open = abs(off) > 1e-14 * abs(wanted);
      if (!any(open)) break;
      x = select(open, x - off / (over_g + 3.0 * alpha * x * x), x);
    }
    return x;
  }

  template <class R>
  static R shear_ratio(const R& ab, double strength) {
    const R x = ab * (1.0 / strength);
    return x * x;
  }
  /// T of MAT_022.
  template <class R>
  R shear_energy_ratio(const R& ab) const {
    const R x = ab * ab;
    return (x * half_over_g_ + three_quarters_alpha_ * x * x) * over_shear_energy_;
  }
  template <class R>
  R compression_index(const R& b, const R& of_shear) const {
    const double twice = 2.0 * law_.shear_strength, ratio = law_.compression_b / twice;
    const R x = b * (1.0 / twice);
    return x * x + ((ratio * ratio - 1.0) / law_.compression_b) * b + of_shear;
  }
  template <class R>
  static MaskOf<R> met(const double* history, Mode mode) {
    return load_field<R>(history, mode_field + mode) > R(0.5);
  }
  template <class R>
  static void fail(const MaskOf<R>& here, double* history) {
    store_field(history, failed_field, select(here, R(1.0), load_field<R>(history, failed_field)));
  }

  /// Stresses to be compared with the strengths: where these are SOFT times theirs, stresses over SOFT.
  template <class R>
  Plane<R> against_strengths(const Plane<R>& s, const double* history) const {
    if (crash_front_field() == 0) return s;
    const R over = select(load_field<R>(history, crash_front_field()) > 0.5, R(1.0 / law_.soft), R(1.0));
    return {over * s.a, over * s.b, over * s.ab};
  }

  /// MAT_022.
  template <class R>
  void lose_stresses(const Plane<R>& before, const Plane<R>& strain, Plane<R>& now, double* history) const {
    auto cracked = met<R>(history, matrix_tension), crushed = met<R>(history, matrix_compression);
    const auto lost = [&] {
      now.a = select(cracked || crushed, before.a + law_.young_a * strain.a, now.a);
      now.b = select(cracked || crushed, R(0.0), now.b);
      now.ab = select(cracked, R(0.0), now.ab);
    };
    lost();
    const R of_shear = shear_energy_ratio(now.ab), x = now.a * (1.0 / law_.tension_a),
            y = now.b * (1.0 / law_.tension_b);
    const auto tears = now.a > R(0.0) && x * x + of_shear >= R(1.0);
    const auto pulled = now.b >= R(0.0);
    cracked = cracked || (pulled && y * y + of_shear >= R(1.0));
    crushed = crushed || (!pulled && compression_index(now.b, of_shear) >= R(1.0));
    lost();
    store_field(history, mode_field + matrix_tension, select(cracked, R(1.0), R(0.0)));
    store_field(history, mode_field + matrix_compression, select(crushed, R(1.0), R(0.0)));
    fail<R>(tears, history);
  }

  /// MAT_054, MAT_055.
  template <class R>
  void limit_stresses(Plane<R>& now, double* history) const {
    const R none = R(0.0), one = R(1.0);
    std::array<R, modes> cycles;
    for (int m = 0; m < modes; ++m) cycles[at(m)] = load_field<R>(history, mode_field + m);
    std::array<R, held> stopped;
    for (int i = 0; i < held; ++i) stopped[at(i)] = load_field<R>(history, held_field + i);
    const auto torn = cycles[fibre_tension] > 0.5, kinked = cycles[fibre_compression] > 0.5,
               cracked = cycles[matrix_tension] > 0.5, crushed = cycles[matrix_compression] > 0.5;

    // What the modes met so far leave of each stress.
    const double lost_a_cycle = 1.0 / law_.cycles_of_loss;
    const auto limit = [&](Held stress, const R& since) {
      const double left = law_.left[stress];
      return stopped[stress] * max(R(left), one - ((1.0 - left) * lost_a_cycle) * max(since - one, none));
    };
    now.a = select(torn, min(now.a, limit(a_tension, cycles[fibre_tension])), now.a);
    now.a = select(kinked, max(now.a, -limit(a_compression, cycles[fibre_compression])), now.a);
    now.b = select(cracked || torn, min(now.b, limit(b_tension, cycles[matrix_tension])), now.b);
    now.b = select(crushed || torn, max(now.b, -limit(b_compression, cycles[matrix_compression])), now.b);
    const R most = limit(shear, max(cycles[matrix_tension], cycles[matrix_compression]));
    now.ab = select(torn || cracked || crushed, max(min(now.ab, most), -most), now.ab);

    const Plane<R> judged = against_strengths(now, history);
    const R of_shear = shear_ratio(judged.ab, law_.shear_strength);
    R strength_t = R(law_.tension_a), strength_c = R(law_.compression_a);
    if (law_.crushed_tension > 0.0) strength_t = select(crushed, law_.crushed_tension * strength_t, strength_t);
    strength_c = select(crushed, min(strength_c, R(law_.crushed_compression * law_.compression_b)), strength_c);
    const auto along = now.a > none, across = now.b >= none;
    const R pull = judged.a / strength_t, push = judged.a / strength_c, open = judged.b * (1.0 / law_.tension_b);
    const auto tears = along && !torn && pull * pull + law_.shear_weight * of_shear >= one;
    const auto kinks = !along && !kinked && push * push >= one;
    R tension_index, pressed_index;
    if (law_.rule == CompositeLayer::Rule::tsai_wu) {
      const double product = 1.0 / (law_.compression_b * law_.tension_b);
      tension_index =
          product * (judged.b * judged.b) + of_shear + ((law_.compression_b - law_.tension_b) * product) * judged.b;
      pressed_index = tension_index;
    } else {
      tension_index = open * open + of_shear;
      pressed_index = compression_index(judged.b, of_shear);
    }
    const auto cracks = across && !cracked && tension_index >= one;
    const auto crushes = !across && !crushed && pressed_index >= one;

    const auto stop = [&](Held stress, const MaskOf<R>& new_one, const MaskOf<R>& old_one, const R& value) {
      const R bound = max(value, none);
      stopped[stress] = select(new_one, select(old_one, min(stopped[stress], bound), bound), stopped[stress]);
    };
    const bool layer_goes = law_.failure_strain_t == 0.0;
    stop(a_tension, tears, torn, now.a);
    stop(a_compression, kinks, kinked, -now.a);
    stop(b_tension, cracks || tears, cracked || torn, now.b);
    stop(b_compression, crushes || tears, crushed || torn, -now.b);
    stop(shear, cracks || crushes || tears, cracked || crushed || torn, abs(now.ab));
    const MaskOf<R> is_new[modes] = {tears, kinks, cracks, crushes}, was[modes] = {torn, kinked, cracked, crushed};
    for (int m = 0; m < modes; ++m)
      store_field(history, mode_field + m, select(was[m] || is_new[m], cycles[at(m)] + one, none));
    for (int i = 0; i < held; ++i) store_field(history, held_field + i, stopped[at(i)]);
    if (layer_goes) fail<R>(tears, history);
  }

  /// Adds the strains of the step up, and lets the layer fail by them.
  template <class R>
  void add_strains(const Plane<R>& strain, const R& thickness, const R& az, const R& bz, double* history) const {
    if (!by_strain_) return;
    const R more[] = {strain.a, strain.b, strain.ab, thickness, az, bz};
    std::array<R, 6> e;
    for (int i = 0; i < 6; ++i) {
      e[at(i)] = load_field<R>(history, strain_field + i) + more[i];
      store_field(history, strain_field + i, e[at(i)]);
    }
    auto fails = R(0.0) > R(1.0);
    if (law_.failure_strain_t > 0.0) {
      fails = e[0] >= R(law_.failure_strain_t);
      if (law_.failure_strain_c > 0.0) fails = fails || e[0] <= R(-law_.failure_strain_c);
      if (law_.failure_strain_m > 0.0) fails = fails || abs(e[1]) >= R(law_.failure_strain_m);
      if (law_.failure_strain_s > 0.0) fails = fails || abs(e[2]) >= R(2.0 * law_.failure_strain_s);
    }
    if (const double limit = law_.effective_failure_strain; limit > 0.0) {
      const R mean = (e[0] + e[1] + e[3]) * (1.0 / 3.0), a = e[0] - mean, b = e[1] - mean, c = e[3] - mean;
      const R square = a * a + b * b + c * c + 0.5 * (e[2] * e[2] + e[4] * e[4] + e[5] * e[5]);
      fails = fails || (2.0 / 3.0) * square >= R(limit * limit);
    }
    fail<R>(fails, history);
  }

  CompositeLayer law_;
  double aa_, ab_, bb_, thinning_a_, thinning_b_;
  double half_over_g_, three_quarters_alpha_, over_shear_energy_;  // of T
  bool by_strain_;
};

}  // namespace nugget::kernel
