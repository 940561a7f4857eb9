// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/law/heated_metal.hpp"

namespace nugget::kernel {

/// Yield stress of G.R. Johnson and W.H. Cook (7th Int. Symp. on Ballistics, 1983; MAT_015, without heat MAT_098):
///   min{ min[A + B ep^N, SIGMAX] (1 + C ln(rate / EPSO)), SIGSAT } (1 - T*^M),
/// the logarithm never below 0; isotropic hardening. All plastic work heats the point, and no heat leaves it; T* is the
/// rise of its temperature over TM - TR. The yield stress never falls below a millionth of what it is when cold.
struct JohnsonCook {
  double E = 0.0;               ///< Young's modulus [stress]
  double nu = 0.0;              ///< Poisson's ratio [1]
  double yield = 0.0;           ///< A [stress]
  double hardening = 0.0;       ///< B [stress]
  double exponent = 1.0;        ///< N [1]
  double rate_factor = 0.0;     ///< C [1]; 0: no rate effect
  double reference_rate = 1.0;  ///< EPSO, the rate up to which there is no effect [1/time]
  double static_stress_limit =
      std::numeric_limits<double>::infinity();                  ///< SIGMAX, of hardening without rates [stress]
  double saturation = std::numeric_limits<double>::infinity();  ///< SIGSAT, with rates [stress]
  double heating = 0.0;       ///< rise of temperature a work, 1 / (RO CP) [temperature/stress]; 0: none
  double melting_rise = 1.0;  ///< TM - TR [temperature]
  double softening = 1.0;     ///< M [1]
};

/// Johnson and Cook's yield stress.
class JohnsonCookFormula {
 public:
  explicit JohnsonCookFormula(const JohnsonCook& law)
      : law_(law), power_(law.hardening, law.exponent), rate_(law.rate_factor, law.reference_rate) {}

  double lowest() const { return heats() ? 0.0 : std::min({law_.yield, law_.static_stress_limit, law_.saturation}); }
  bool heats() const { return law_.heating > 0.0; }
  double power(double strain) const { return power_(strain); }
  const LogarithmicRate& rate() const { return rate_; }
  double limit(double heating) const { return law_.saturation * cold(heating); }
  YieldStress<double> yield(const YieldPoint& p) const {
    YieldStress<double> y = power_.after(p.strain, p.power, p.increment);
    y.value += law_.yield;
    if (y.value > law_.static_stress_limit) y = {law_.static_stress_limit, 0.0};
    const double left = cold(p.heating);
    return {y.value * left, y.slope * left};
  }

 private:
  /// Share of the yield stress that the heat leaves.
  double cold(double heating) const {
    return heats() ? std::max(1.0 - std::pow(heating / law_.melting_rise, law_.softening), 1e-6) : 1.0;
  }

  JohnsonCook law_;
  PowerOfStrain power_;
  LogarithmicRate rate_;
};

template <>
class LawKernel<JohnsonCook> : public HeatedMetal<SmoothHardening<JohnsonCookFormula>> {
 public:
  explicit LawKernel(const JohnsonCook& law) : HeatedMetal(law, law.heating, law.melting_rise) {}
};

}  // namespace nugget::kernel
