// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/gissmo.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace nugget::kernel {
namespace {

/// What the strain at fracture depends on.
template <class R>
struct StressState {
  R triaxiality;  ///< mean over von Mises stress, tension positive
  R lode;         ///< 27/2 J3 / von Mises stress^3, -1 to 1
};

template <class R>
StressState<R> state_of(const SolidTensor<R>& s) {
  const R mean = (s.xx + s.yy + s.zz) / 3.0, x = s.xx - mean, y = s.yy - mean, z = s.zz - mean;
  const R j2 = 0.5 * (x * x + y * y + z * z) + s.xy * s.xy + s.yz * s.yz + s.zx * s.zx;
  const R j3 = x * (y * z - s.yz * s.yz) - s.xy * (s.xy * z - s.yz * s.zx) + s.zx * (s.xy * s.yz - y * s.zx);
  const R effective = sqrt(3.0 * j2), none = R(0.0);
  const auto stressed = j2 > 0.0;
  return {select(stressed, mean / effective, none),
          select(stressed, max(min(13.5 * j3 / (effective * effective * effective), R(1.0)), R(-1.0)), none)};
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
  return power(std::min(root, 1.0), growth);
}

Gissmo::Ends Gissmo::ends(double triaxiality, double lode, double size, double plastic_rate, double heating) const {
  const double of_rate = rate_factor(plastic_rate), of_heat = heat.empty() ? 1.0 : heat.clamped(heating);
  return {fracture.at(lode, triaxiality) * mesh_factor(triaxiality, size) * of_rate * of_heat,
          instability.given() ? instability.at(lode, triaxiality) * (rate_of_instability ? of_rate : 1.0) : 1.0};
}

template <class R>
R Gissmo::advance(const SolidTensor<R>& stress, const R& increment, const R& heating, MaskOf<R> carries, double dt,
                  double* h) const {
  const R size = load_field<R>(h, size_field);
  R damage = load_field<R>(h, damage_field), unstable = load_field<R>(h, instability_field),
    onset = load_field<R>(h, onset_field);
  const StressState<R> state = state_of(stress);
  const auto flows = carries && increment > 0.0;
  if (any(flows)) {
    R to_fracture = R(1.0), to_instability = R(1.0);
    for (int l = 0; l < lanes<R>; ++l) {
      if (!(lane(increment, l) > 0.0)) continue;
      const Ends of = ends(lane(state.triaxiality, l), lane(state.lode, l), lane(size, l), lane(increment, l) / dt,
                           lane(heating, l));
      set_lane(to_fracture, l, of.fracture);
      set_lane(to_instability, l, of.instability);
    }
    damage = select(flows, damage + increment / to_fracture, damage);
    store_field(h, damage_field, damage);
    if (instability.given()) {
      const auto grows = flows && unstable < 1.0;
      unstable = select(grows, unstable + increment / to_instability, unstable);
      onset = select(grows && unstable >= 1.0, power(damage, growth), onset);
      store_field(h, instability_field, unstable);
      store_field(h, onset_field, onset);
    }
  }
  const R none = R(0.0);
  if (!weakens) return none;
  const R from = instability.given() ? onset : R(threshold), beyond = power(damage, growth) - from;
  auto softens = beyond > 0.0;
  if (instability.given()) softens = softens && unstable >= 1.0;
  R lost = none;
  if (any(softens)) {
    const R share = beyond / (1.0 - from);
    for (int l = 0; l < lanes<R>; ++l)
      if (lane(beyond, l) > 0.0)
        set_lane(lost, l, power(lane(share, l), fading.at(lane(state.triaxiality, l), lane(size, l))));
    lost = select(softens, lost, none);
  }
  return select(damage >= 1.0, R(1.0), lost);
}

template NativeBatch Gissmo::advance(const SolidTensor<NativeBatch>&, const NativeBatch&, const NativeBatch&,
                                     NativeBatch::Mask, double, double*) const;

}  // namespace nugget::kernel
