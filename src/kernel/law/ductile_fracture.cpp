// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/ductile_fracture.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::kernel {

void DuctileFracture::advance(const PointNow& p, double* h, int stride) const {
  if (p.heating >= last_rise) h[0] = 1.0;
  if (shear_strength < std::numeric_limits<double>::infinity()) {
    const std::array<double, 3> principal = principal_values(p.stress);
    if (0.5 * (principal[2] - principal[0]) >= shear_strength) h[0] = 1.0;
  }
  if (!grows || !(p.plastic_increment > 0.0)) return;
  if (by_work) {
    h[0] += std::max(principal_values(p.stress)[2], 0.0) * p.plastic_increment / work;
    return;
  }
  double& strain = h[stride];
  strain += p.plastic_increment;
  const double beyond = std::min(p.plastic_increment, strain - threshold);
  if (!(beyond > 0.0)) return;
  const double mean = (p.stress.xx + p.stress.yy + p.stress.zz) / 3.0;
  const double hot = std::clamp(warmth + (1.0 - warmth) * p.heating / melting_rise, 0.0, 1.0);
  const double rate = p.plastic_increment / p.dt / reference_rate;
  const double last = (d1 + d2 * std::exp(d3 * mean / std::sqrt(1.5 * deviator2(p.stress)))) *
                      std::pow(1.0 + rate, d4) * (1.0 + d5 * hot);
  h[0] += beyond / std::max(last - threshold, 1e-6);
}

}  // namespace nugget::kernel
