// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/johnson_cook_fracture.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::kernel {

double JohnsonCookFracture::fracture_strain(double triaxiality, double rate, double heating) const {
  const double over = std::max(rate / reference_rate, 1.0);
  const double warmth = melting_rise > 0.0 ? std::min(heating / melting_rise, 1.0) : 0.0;
  return std::max((d1 + d2 * std::exp(d3 * triaxiality)) * (1.0 + d4 * std::log(over)) * (1.0 + d5 * warmth), least);
}

void JohnsonCookFracture::advance(const PointNow& p, double* h, int) const {
  if (!(p.plastic_increment > 0.0)) return;
  const double mean = (p.stress.xx + p.stress.yy + p.stress.zz) / 3.0;
  const double fracture_rate = by_plastic_rate ? p.plastic_increment / p.dt : p.rate;
  h[0] += p.plastic_increment / fracture_strain(mean / std::sqrt(1.5 * deviator2(p.stress)), fracture_rate, p.heating);
}

}  // namespace nugget::kernel
