// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/gissmo.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::kernel {
namespace {

/// What the strain at fracture depends on.
struct StressState {
  double triaxiality;  ///< mean over von Mises stress, tension positive
  double lode;         ///< 27/2 J3 / von Mises stress^3, -1 to 1
};

StressState state_of(const SolidTensor<double>& s) {
  const double mean = (s.xx + s.yy + s.zz) / 3.0, x = s.xx - mean, y = s.yy - mean, z = s.zz - mean;
  const double j2 = 0.5 * (x * x + y * y + z * z) + s.xy * s.xy + s.yz * s.yz + s.zx * s.zx;
  if (!(j2 > 0.0)) return {0.0, 0.0};
  const double j3 = x * (y * z - s.yz * s.yz) - s.xy * (s.xy * z - s.yz * s.zx) + s.zx * (s.xy * s.yz - y * s.zx);
  const double effective = std::sqrt(3.0 * j2);
  return {mean / effective, std::clamp(13.5 * j3 / (effective * effective * effective), -1.0, 1.0)};
}

}  // namespace

double Gissmo::mesh_factor(double triaxiality, double size) const {
  if (!mesh.given()) return 1.0;
  const double factor = mesh.at(triaxiality, size);
  double missing = 0.0;
  if (triaxiality < shear_end)
    missing = shear * (1.0 - std::max(triaxiality, 0.0) / shear_end);
  else if (triaxiality > biaxial_start)
    missing = biaxial * (std::min(triaxiality, 2.0 / 3.0) - biaxial_start) / (2.0 / 3.0 - biaxial_start);
  return factor + missing * (1.0 - factor);
}

double Gissmo::rate_factor(double plastic_rate) const {
  if (rate.empty()) return 1.0;
  return rate.clamped(log_rates ? std::log(plastic_rate) : plastic_rate);
}

double Gissmo::grown(double root) const {
  return std::pow(std::min(root, 1.0), growth);
}

double Gissmo::advance(const SolidTensor<double>& stress, double increment, double dt, double* h, int stride) const {
  const double size = h[size_field * stride];
  double &damage = h[damage_field * stride], &unstable = h[instability_field * stride],
         &onset = h[onset_field * stride];
  const StressState state = state_of(stress);
  if (increment > 0.0) {
    const double of_rate = rate_factor(increment / dt);
    damage += increment / (fracture.at(state.lode, state.triaxiality) * mesh_factor(state.triaxiality, size) * of_rate);
    if (instability.given() && unstable < 1.0) {
      unstable += increment / (instability.at(state.lode, state.triaxiality) * (rate_of_instability ? of_rate : 1.0));
      if (unstable >= 1.0) onset = std::pow(damage, growth);
    }
  }
  if (!weakens || (instability.given() && unstable < 1.0 && damage < 1.0)) return 0.0;
  if (damage >= 1.0) return 1.0;
  const double from = instability.given() ? onset : threshold, beyond = std::pow(damage, growth) - from;
  return beyond > 0.0 ? std::pow(beyond / (1.0 - from), fading.at(state.triaxiality, size)) : 0.0;
}

}  // namespace nugget::kernel
