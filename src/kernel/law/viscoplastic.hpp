// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "kernel/law/hill_flow.hpp"
#include "kernel/law/j2.hpp"
#include "kernel/law/smooth_hardening.hpp"

namespace nugget::kernel {

/// Isotropic hardening in two terms that saturate (E. Voce, J. Inst. Metals 74, 1948), with a viscous stress that is
/// added: yield stress SIGY + Q1 [1 - exp(-C1 ep)] + Q2 [1 - exp(-C2 ep)] + V (rate)^m (MAT_103), isotropic or with the
/// surface of Hill and back stress.
struct Viscoplastic {
  double E = 0.0;              ///< Young's modulus [stress]
  double nu = 0.0;             ///< Poisson's ratio [1]
  double yield = 0.0;          ///< SIGY [stress]
  double hardening_1 = 0.0;    ///< Q1 [stress]
  double exponent_1 = 0.0;     ///< C1 [1]
  double hardening_2 = 0.0;    ///< Q2 [stress]
  double exponent_2 = 0.0;     ///< C2 [1]
  double viscosity = 0.0;      ///< V, stress at a rate of 1 of the plastic strain [stress]; 0: none
  double rate_exponent = 0.0;  ///< m [1]
  std::optional<HillAnisotropy> anisotropy{};
};

/// Its yield stress at rest, and the rate effect.
class ViscoplasticFormula {
 public:
  explicit ViscoplasticFormula(const Viscoplastic& law)
      : start_(law.yield),
        hardening_1_(law.hardening_1),
        exponent_1_(law.exponent_1),
        hardening_2_(law.hardening_2),
        exponent_2_(law.exponent_2),
        rate_(law.viscosity > 0.0 ? CowperSymonds(1.0, 1.0 / law.rate_exponent, law.viscosity) : CowperSymonds()) {}

  /// With a Q below 0 the stress falls towards this.
  double lowest() const { return std::max(start_ + std::min(hardening_1_, 0.0) + std::min(hardening_2_, 0.0), 0.0); }
  static constexpr double power(double) { return 0.0; }
  static constexpr bool heats() { return false; }
  const CowperSymonds& rate() const { return rate_; }
  static double limit(double) { return std::numeric_limits<double>::infinity(); }
  YieldStress<double> yield(const YieldPoint& p) const {
    const double strain = p.strain + p.increment, left_1 = std::exp(-exponent_1_ * strain),
                 left_2 = std::exp(-exponent_2_ * strain);
    return {start_ + hardening_1_ * (1.0 - left_1) + hardening_2_ * (1.0 - left_2),
            hardening_1_ * exponent_1_ * left_1 + hardening_2_ * exponent_2_ * left_2};
  }

 private:
  double start_, hardening_1_, exponent_1_, hardening_2_, exponent_2_;
  CowperSymonds rate_;  // none: C is 0
};

template <>
class LawKernel<Viscoplastic> : private J2<SmoothHardening<ViscoplasticFormula>, false> {
  using Isotropic = J2<SmoothHardening<ViscoplasticFormula>, false>;

 public:
  explicit LawKernel(const Viscoplastic& law) : Isotropic(law.E, law.nu, Hardening(law), 0.0) {
    if (!law.anisotropy) return;
    hill_.emplace(*law.anisotropy, elastic());
    hardening_ = made_ready(law);
  }

  using Isotropic::elastic;
  using Isotropic::fibre;  // of the isotropic law only
  using Isotropic::fibre_history;
  using Isotropic::has_plastic_strain;
  using Isotropic::wave_modulus;

  int layer_history() const { return hill_ ? hill_->layer_history() : Isotropic::layer_history(); }
  int solid_history() const { return hill_ ? hill_->solid_history() : Isotropic::solid_history(); }
  /// Null: isotropic.
  const MaterialAxes* axes() const { return hill_ ? &hill_->axes() : nullptr; }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    if (!hill_) return Isotropic::layer(s, rate, dt, history);
    return std::visit([&](const auto& hardening) { return hill_->layer(hardening, s, rate, dt, history); }, hardening_);
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    if (!hill_) return Isotropic::solid(s, rate, dt, history);
    std::visit([&](const auto& hardening) { hill_->solid(hardening, s, rate, dt, history); }, hardening_);
  }
  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    if (hill_) turn_solid_axes(q, history);
  }

 private:
  using Hardening = SmoothHardening<ViscoplasticFormula>;
  using AnyHardening = std::variant<Hardening, CurveHardening>;
  static AnyHardening made_ready(const Viscoplastic& law) {
    if (law.anisotropy->curves) return CurveHardening(*law.anisotropy->curves);
    return Hardening(law);
  }

  std::optional<HillFlow> hill_;
  AnyHardening hardening_{Hardening(Viscoplastic{})};
};

}  // namespace nugget::kernel
