// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/law/j2.hpp"
#include "kernel/law/smooth_hardening.hpp"

namespace nugget::kernel {

/// Isotropic hardening in two terms that saturate (E. Voce, J. Inst. Metals 74, 1948), with a viscous stress that is
/// added: yield stress SIGY + Q1 [1 - exp(-C1 ep)] + Q2 [1 - exp(-C2 ep)] + V (rate)^m (isotropic MAT_103).
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
};

/// Its yield stress at rest, and the rate effect: a Cowper-Symonds one with C = 1 and P = 1 / m that raises V.
class ViscoplasticFormula {
 public:
  explicit ViscoplasticFormula(const Viscoplastic& law)
      : law_(law),
        rate_(law.viscosity > 0.0 ? CowperSymonds(1.0, 1.0 / law.rate_exponent, law.viscosity) : CowperSymonds()) {}

  /// With a Q below 0 the stress falls towards this.
  double lowest() const {
    return std::max(law_.yield + std::min(law_.hardening_1, 0.0) + std::min(law_.hardening_2, 0.0), 0.0);
  }
  static constexpr double power(double) { return 0.0; }
  static constexpr bool heats() { return false; }
  const CowperSymonds& rate() const { return rate_; }
  static double limit(double) { return std::numeric_limits<double>::infinity(); }
  YieldStress<double> yield(const YieldPoint& p) const {
    const double strain = p.strain + p.increment, left_1 = std::exp(-law_.exponent_1 * strain),
                 left_2 = std::exp(-law_.exponent_2 * strain);
    return {law_.yield + law_.hardening_1 * (1.0 - left_1) + law_.hardening_2 * (1.0 - left_2),
            law_.hardening_1 * law_.exponent_1 * left_1 + law_.hardening_2 * law_.exponent_2 * left_2};
  }

 private:
  Viscoplastic law_;
  CowperSymonds rate_;  // none: C is 0
};

template <>
class LawKernel<Viscoplastic> : public J2<SmoothHardening<ViscoplasticFormula>, false> {
 public:
  explicit LawKernel(const Viscoplastic& law) : J2(law.E, law.nu, SmoothHardening<ViscoplasticFormula>(law), 0.0) {}
};

}  // namespace nugget::kernel
