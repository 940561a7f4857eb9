// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "kernel/law/j2.hpp"
#include "kernel/law/smooth_hardening.hpp"

namespace nugget::kernel {

/// Isotropic hardening k (e_y + ep)^n with Cowper-Symonds rates (MAT_018).
struct PowerLaw {
  double E = 0.0;             ///< Young's modulus [stress]
  double nu = 0.0;            ///< Poisson's ratio [1]
  double strength = 0.0;      ///< k [stress]
  double exponent = 0.0;      ///< n [1]
  double yield_strain = 0.0;  ///< e_y, elastic strain at first yield [1]
  double rate_c = 0.0;        ///< SRC, Cowper-Symonds C [1/time]; 0: no rate effect
  double rate_p = 1.0;        ///< SRP [1]
};

/// Power law of the elastic and plastic strain.
class PowerLawFormula {
 public:
  explicit PowerLawFormula(const PowerLaw& law)
      : law_(law), power_(law.strength, law.exponent), rate_(law.rate_c, law.rate_p) {}

  double lowest() const { return power(0.0); }
  double power(double strain) const { return power_(law_.yield_strain + strain); }
  static constexpr bool heats() { return false; }
  const CowperSymonds& rate() const { return rate_; }
  static double limit(double) { return std::numeric_limits<double>::infinity(); }
  YieldStress<double> yield(const YieldPoint& p) const {
    return power_.after(law_.yield_strain + p.strain, p.power, p.increment);
  }

 private:
  PowerLaw law_;
  PowerOfStrain power_;
  CowperSymonds rate_;
};

template <>
class LawKernel<PowerLaw> : public J2<SmoothHardening<PowerLawFormula>, false> {
 public:
  explicit LawKernel(const PowerLaw& law) : J2(law.E, law.nu, SmoothHardening<PowerLawFormula>(law), 0.0) {}
};

}  // namespace nugget::kernel
