// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/spr2.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nugget::kernel {
namespace {

/// F(h) / (h F_max), exact to round-off down to h = 0.
double secant(double h, double peak, double exponent) {
  if (h <= 0.0) return exponent / peak;
  if (h < peak) return -std::expm1(exponent * std::log1p(-h / peak)) / h;
  return h < 1.0 ? (1.0 - h) / ((1.0 - peak) * h) : 0.0;
}

}  // namespace

double Spr2::effective_displacement(const Freedoms& displacement, double damage) const {
  const double opening = std::max(displacement[0], 0.0) / normal_failure;
  const double sliding = std::hypot(displacement[1], displacement[2]);
  const double w = 2.0 / std::numbers::pi * std::atan2(std::max(displacement[0], 0.0), sliding);
  const double q = 1.0 + 6.75 * w * w * (w - 1.0);
  const double a = damage < shear_peak ? alpha[0] + (alpha[1] - alpha[0]) * damage / shear_peak
                                       : alpha[1] + (alpha[2] - alpha[1]) * (damage - shear_peak) / (1.0 - shear_peak);
  return (q + (1.0 - q) / a) * std::hypot(opening, sliding / shear_failure);
}

Spr2::Freedoms Spr2::forces(const Freedoms& displacement, double damage) const {
  if (damage >= 1.0) return {};
  const double normal =
      normal_force / normal_failure * secant(displacement[0] > 0.0 ? damage : 0.0, normal_peak, normal_exponent);
  const double shear = shear_force / shear_failure * secant(damage, shear_peak, shear_exponent);
  const double fs = shear * displacement[1], ft = shear * displacement[2];
  const double moved = 0.5 * arm * std::max(damage - shear_peak, 0.0) / (1.0 - shear_peak);
  return {normal * displacement[0], fs, ft, 0.0, -moved * ft, moved * fs};
}

}  // namespace nugget::kernel
