// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/law/heated_metal.hpp"

namespace nugget::kernel {

/// Yield stress of T. Borvik, O.S. Hopperstad, T. Berstad and M. Langseth (Eur. J. Mech. A/Solids 20, 2001; MAT_107):
///   [A + B ep^N + Q1 (1 - exp(-C1 ep)) + Q2 (1 - exp(-C2 ep))] (1 + rate / E0DOT)^C (1 - T*^M),
/// rate that of the plastic strain, T* = (T - TR) / (TM - TR). A share XS1 of the plastic work heats the point, and no
/// heat leaves it. The yield stress never falls below a millionth of what it is when cold.
struct ModifiedJohnsonCook {
  double E = 0.0;                                 ///< Young's modulus [stress]
  double nu = 0.0;                                ///< Poisson's ratio [1]
  double yield = 0.0;                             ///< A [stress]
  double hardening = 0.0;                         ///< B [stress]
  double exponent = 1.0;                          ///< N [1]
  double saturating_1 = 0.0, saturating_2 = 0.0;  ///< Q1, Q2 [stress]
  double saturation_1 = 0.0, saturation_2 = 0.0;  ///< C1, C2 [1]
  double rate_exponent = 0.0;                     ///< C [1]; 0: no rate effect
  double reference_rate = 1.0;                    ///< E0DOT [1/time]
  double heating = 0.0;       ///< rise of temperature a work, XS1 / (RO CP) [temperature/stress]; 0: none
  double melting_rise = 1.0;  ///< TM - T0 [temperature]: at this rise the point has melted
  double warmth = 0.0;        ///< T* at the start, (T0 - TR) / (TM - TR) [1]
  double softening = 1.0;     ///< M [1]
};

class ModifiedJohnsonCookFormula {
 public:
  explicit ModifiedJohnsonCookFormula(const ModifiedJohnsonCook& law)
      : law_(law), power_(law.hardening, law.exponent), rate_(law.rate_exponent, law.reference_rate) {}

  double lowest() const {
    if (heats()) return 0.0;
    return std::max((law_.yield + std::min(law_.saturating_1, 0.0) + std::min(law_.saturating_2, 0.0)) * cold(0.0),
                    0.0);
  }
  bool heats() const { return law_.heating > 0.0; }
  double power(double strain) const { return power_(strain); }
  const PowerOfRate& rate() const { return rate_; }
  static double limit(double) { return std::numeric_limits<double>::infinity(); }
  YieldStress<double> yield(const YieldPoint& p) const {
    const double strain = p.strain + p.increment, left = cold(p.heating);
    const double left_1 = std::exp(-law_.saturation_1 * strain), left_2 = std::exp(-law_.saturation_2 * strain);
    YieldStress<double> y = power_.after(p.strain, p.power, p.increment);
    y.value += law_.yield + law_.saturating_1 * (1.0 - left_1) + law_.saturating_2 * (1.0 - left_2);
    y.slope += law_.saturating_1 * law_.saturation_1 * left_1 + law_.saturating_2 * law_.saturation_2 * left_2;
    return {y.value * left, y.slope * left};
  }

 private:
  /// Share of the yield stress that the heat leaves.
  double cold(double rise) const {
    const double warmth = law_.warmth + (1.0 - law_.warmth) * rise / law_.melting_rise;
    return warmth > 0.0 ? std::max(1.0 - std::pow(warmth, law_.softening), 1e-6) : 1.0;
  }

  ModifiedJohnsonCook law_;
  PowerOfStrain power_;
  PowerOfRate rate_;
};

template <>
class LawKernel<ModifiedJohnsonCook> : public HeatedMetal<SmoothHardening<ModifiedJohnsonCookFormula>> {
 public:
  explicit LawKernel(const ModifiedJohnsonCook& law) : HeatedMetal(law, law.heating, law.melting_rise) {}
};

}  // namespace nugget::kernel
