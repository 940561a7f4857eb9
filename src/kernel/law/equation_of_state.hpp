// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "base/batch.hpp"
#include "base/curve.hpp"
#include "kernel/law/stress_space.hpp"

namespace nugget::kernel {

/// Pressure linear in the internal energy E a volume at the start (*EOS_LINEAR_POLYNOMIAL):
///   p = C0 + C1 mu + C2 mu^2 + C3 mu^3 + (C4 + C5 mu + C6 mu^2) E,   mu = V0/V - 1;
/// C2 and C6 count under compression only.
struct LinearPolynomial {
  double c0 = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0;  ///< [stress]
  double c4 = 0.0, c5 = 0.0, c6 = 0.0;            ///< [1]
};

/// Mie and Gruneisen's pressure about a cubic shock velocity over particle velocity (*EOS_GRUNEISEN); under compression
///   p = rho0 C^2 mu (1 + (1 - gamma0/2) mu - A/2 mu^2) / (1 - (S1 - 1) mu - S2 mu^2/(mu + 1) - S3 mu^3/(mu + 1)^2)^2
///       + (gamma0 + A mu) E,
/// in expansion rho0 C^2 mu + (gamma0 + A mu) E.
struct Gruneisen {
  double stiffness = 0.0;               ///< rho0 C^2 [stress]
  double s1 = 0.0, s2 = 0.0, s3 = 0.0;  ///< slopes of the shock velocity [1]
  double gamma0 = 0.0, gamma_mu = 0.0;  ///< gamma0 and A [1]
};

/// Pressure between given points of ln V, V the relative volume, and along the last lines beyond them
/// (*EOS_TABULATED): p = C(ln V) + gamma T(ln V) E. Loading and unloading follow the same line.
struct TabulatedPressure {
  Curve cold;  ///< C over ln V, ascending [stress]; two points or more
  Curve heat;  ///< gamma T over ln V; empty: 0
};

/// A point's pressure as a function of its volume and internal energy. Volumes are relative to the undeformed one at
/// the reference density; energies a volume of that.
struct EquationOfState {
  std::variant<LinearPolynomial, Gruneisen, TabulatedPressure> pressure;
  double start_energy = 0.0;  ///< E0 [stress]
  double start_volume = 1.0;  ///< V0 [1]
};

/// How a point that is pulled apart by pressure breaks (PC and SPALL of MAT_015).
struct Spall {
  enum class Form {
    limited_tension = 1,  ///< the pressure does not fall below the limit
    largest_stress = 2,   ///< a principal stress beyond the limit breaks the point
    mean_stress = 3,      ///< the mean stress does
  };
  Form form = Form::largest_stress;
  double limit = 0.0;  ///< tension cutoff, -PC [stress]
};

/// p = cold + heat E at a compression, and the slopes of both over mu.
template <class R>
struct PressureLine {
  R cold, heat, cold_slope, heat_slope;
};

template <class R>
PressureLine<R> pressure_line(const LinearPolynomial& p, const R& mu) {
  const R squeezed = max(mu, R(0.0));
  return {p.c0 + mu * (p.c1 + p.c3 * (mu * mu)) + p.c2 * (squeezed * squeezed),
          p.c4 + p.c5 * mu + p.c6 * (squeezed * squeezed), p.c1 + 3.0 * p.c3 * (mu * mu) + 2.0 * p.c2 * squeezed,
          p.c5 + 2.0 * p.c6 * squeezed};
}

template <class R>
PressureLine<R> pressure_line(const Gruneisen& g, const R& mu) {
  const R m = max(mu, R(0.0)), one = R(1.0), share = m / (m + one);
  const double bow = 1.0 - 0.5 * g.gamma0;
  const R top = m * (one + m * (bow - 0.5 * g.gamma_mu * m)), top_slope = one + m * (2.0 * bow - 1.5 * g.gamma_mu * m);
  // 1 - (S1 - 1) m - S2 m s - S3 m s^2, s = m/(1 + m), ds/dm = (1 - s)^2. Where the shock would outrun itself it is
  // held.
  const R root = max(one - m * ((g.s1 - 1.0) + share * (g.s2 + g.s3 * share)), R(0.05));
  const R turn = (one - share) * (one - share);
  const R root_slope = -(R(g.s1 - 1.0) + share * (g.s2 + g.s3 * share) + m * turn * (g.s2 + 2.0 * g.s3 * share));
  const R over = one / (root * root);
  const auto squeezed = mu > 0.0;
  return {g.stiffness * select(squeezed, top * over, mu), g.gamma0 + g.gamma_mu * mu,
          g.stiffness * select(squeezed, over * (top_slope - 2.0 * top * root_slope / root), one), R(g.gamma_mu)};
}

template <class R>
PressureLine<R> pressure_line(const TabulatedPressure& p, const R& mu) {
  PressureLine<R> line;
  for (int l = 0; l < lanes<R>; ++l) {
    // d ln V / d mu = -1/(1 + mu).
    const double squeezed = std::max(1.0 + lane(mu, l), 1e-12), at = -std::log1p(std::max(lane(mu, l), 1e-12 - 1.0));
    const auto set = [&](const Curve& curve, R& value, R& slope) {
      const double tilt = curve.empty() ? 0.0 : curve.slope(at);
      const double before = curve.empty() ? 0.0 : std::min(0.0, at - curve.x.front());
      set_lane(value, l, curve.empty() ? 0.0 : curve.extrapolated(at) + tilt * before);
      set_lane(slope, l, -tilt / squeezed);
    };
    set(p.cold, line.cold, line.cold_slope);
    set(p.heat, line.heat, line.heat_slope);
  }
  return line;
}

/// The pressure of a point, step by step. History: relative volume less V0, energy less E0, growth of the volume in the
/// last step, viscous pressure at its end.
class EquationOfStateKernel {
 public:
  static constexpr int size = 4;  ///< of the history: the fields named below

  explicit EquationOfStateKernel(const EquationOfState& of) : law_(of) {}

  /// The pressure after a step in which the volume grows at `rate` and the deviators do the work `sheared` a volume at
  /// its end; it does not fall below `least`. The energy takes the mean of the pressures before and after, which is
  /// linear in it.
  template <class R>
  R advance(const R& rate, const R& sheared, const R& old_pressure, const R& least, double dt, double* history) const {
    // By its change since the start: that of a step in which nothing moves (AssembledStep) is no part of a volume.
    const R since_start = load_field<R>(history, volume_field), half = 0.5 * dt * rate;
    const R growth = (since_start + law_.start_volume) * half / (1.0 - half), change = since_start + 2.0 * growth;
    const R volume = change + law_.start_volume;
    const R before = load_field<R>(history, energy_field) + law_.start_energy + volume * sheared -
                     growth * (old_pressure + load_field<R>(history, viscous_field));
    const PressureLine<R> line = line_at<R>(change);
    R energy = (before - growth * line.cold) / (1.0 + growth * line.heat), pressure = line.cold + line.heat * energy;
    const auto limited = pressure < least;
    pressure = select(limited, least, pressure);
    energy = select(limited, before - growth * least, energy);
    store_field(history, volume_field, change);
    store_field(history, energy_field, energy - law_.start_energy);
    store_field(history, growth_field, growth);
    return pressure;
  }
  /// d p / d mu at constant entropy, as the point stands: rho0 times the square of the bulk speed of sound [stress].
  template <class R>
  R modulus(const double* history) const {
    const R change = load_field<R>(history, volume_field), volume = change + law_.start_volume,
            energy = load_field<R>(history, energy_field) + law_.start_energy;
    const PressureLine<R> line = line_at<R>(change);
    const R pressure = max(line.cold + line.heat * energy, R(0.0));
    return line.cold_slope + line.heat_slope * energy + line.heat * pressure * volume * volume;
  }
  /// What a point may give at most on its way to no pressure [energy/undeformed volume].
  double energy_at_start() const {
    const PressureLine<double> line = line_at<double>(0.0);
    const double pressure = line.cold + line.heat * law_.start_energy;
    return std::max(law_.start_energy, 0.0) + 0.5 * pressure * pressure / linear_modulus_at_start();
  }
  /// The change of the pressure from that at the start, over the change of volume there, at constant entropy.
  EquationOfStateKernel linear_at_start() const {
    return EquationOfStateKernel({LinearPolynomial{.c1 = linear_modulus_at_start()}});
  }
  /// Adds the work of viscous pressure, `work` a present volume with its value at the end of the step. As that of the
  /// stress it is taken with the mean of the values before and after: half of it now, half in the next step.
  template <class R>
  void add_viscous_work(const R& work, double* history) const {
    const R volume = load_field<R>(history, volume_field) + law_.start_volume,
            growth = load_field<R>(history, growth_field);
    const auto squeezed = growth < 0.0;
    const R pressure = select(squeezed, 0.5 * volume * work / select(squeezed, -growth, R(1.0)), R(0.0));
    store_field(history, energy_field, load_field<R>(history, energy_field) - growth * pressure);
    store_field(history, viscous_field, pressure);
  }

 private:
  /// V0/V - 1 changes by -e/V0 where the volume V grows by e V.
  double linear_modulus_at_start() const {
    const std::array<double, size> at_start{};
    return modulus<double>(at_start.data()) / law_.start_volume;
  }
  static constexpr int volume_field = 0, energy_field = 1, growth_field = 2, viscous_field = 3;

  template <class R>
  PressureLine<R> line_at(const R& change) const {
    const R mu = ((1.0 - law_.start_volume) - change) / (change + law_.start_volume);
    return std::visit([&](const auto& p) { return pressure_line(p, mu); }, law_.pressure);
  }

  EquationOfState law_;
};

}  // namespace nugget::kernel
