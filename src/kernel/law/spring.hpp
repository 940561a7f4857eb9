// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <variant>

#include "kernel/law/discrete_spring.hpp"

// Laws of *ELEMENT_DISCRETE (*MAT_SPRING_..., *MAT_DAMPER_...): force over elongation, or moment over twist. S01 to S05
// are a DiscreteSpring; here is what that does not have. Source: LS-DYNA Keyword Manual, springs and dampers.
namespace nugget::kernel {

/// MAT_S06: follows the loading curve until the force leaves [compression_yield, tension_yield]. From then on it
/// unloads along the unloading curve, laid through the point of reversal, until it meets the yield force again: that
/// of the side's last point on the loading curve, from where the loading curve goes on, shifted along the elongation.
/// `isotropic` (BETA = 1): hardening on one side widens the other by as much. Otherwise (BETA = 0) each side hardens or
/// softens for itself.
struct ReversingSpring {
  Curve load, unload;  ///< both from compression to tension; `unload` rises everywhere
  double tension_yield = 0.0, compression_yield = 0.0;
  bool isotropic = false;

  struct State {
    double elongation = 0.0, force = 0.0;
    bool yielded = false;
    double tension = 0.0, compression = 0.0;  ///< abscissae on `load` that either side has reached
    double shift = 0.0;                       ///< of `unload` along the elongation
  };
  double advance(State& state, double increment) const;
  double stiffness_at(double first) const;  ///< after a first elongation [force/length]

  /// Where `curve` first reaches `force`, seen from `start` towards tension or compression; its end slopes go on.
  static double reach(const Curve& curve, double start, double force, bool towards_tension);
};

/// MAT_S07, Maxwell: force K_I d + int (K_0 - K_I) e^(-beta (t - s)) d'(s) ds, incremental (Herrmann and Peterson): it
/// relaxes only what has been deformed. Exact for a rate constant over the step. After the cut-off time `last_force`.
struct MaxwellSpring {
  double instantaneous_stiffness = 0.0, long_term_stiffness = 0.0;  ///< K_0, K_I [force/length]
  double decay = 0.0;                                               ///< beta [1/time]
  double cut_off = 1e20, last_force = 0.0;

  struct State {
    double elongation = 0.0, relaxing_force = 0.0, time = 0.0;
  };
  double advance(State& state, double increment, double dt) const;
};

/// MAT_S08: crushed (or drawn) along the curve of the positive quadrant, unloaded along `unloading`, without force
/// until it closes again at the elongation that remained.
struct InelasticSpring {
  ForceCurve load;         ///< force over the amount of compression (or elongation), both positive
  double unloading = 0.0;  ///< not less than the steepest slope of `load`
  bool tension = false;    ///< CTF = -1: only in tension; else only in compression

  struct State {
    double elongation = 0.0, remaining = 0.0;
  };
  double advance(State& state, double increment) const;
  double stiffness_at(double first) const;  ///< after a first elongation [force/length]
};

/// The law of a discrete element as *MAT_... says it.
struct Spring {
  static constexpr double E = 0.0, nu = 0.0;  ///< it has none; asked of every law
  std::variant<DiscreteSpring, ReversingSpring, MaxwellSpring, InelasticSpring> law;

  using State =
      std::variant<DiscreteSpring::State, ReversingSpring::State, MaxwellSpring::State, InelasticSpring::State>;
  State start() const;
  /// Advances by an `increment` of the elongation at the rate `velocity` over `dt`; returns the force, positive in
  /// tension.
  double advance(State& state, double increment, double velocity, double dt) const;
  /// Slope where a first elongation has led, for linear analyses; of a force that has yielded that of unloading
  /// [force/length].
  double stiffness_at(double elongation) const;
  double initial_stiffness() const { return stiffness_at(0.0); }
  /// Likewise of the damping force [force time/length].
  double initial_viscosity() const;
  /// Bounds for the time step: largest stiffness, largest viscosity at a force.
  double greatest_stiffness() const;
  double greatest_viscosity(double force) const;
};

}  // namespace nugget::kernel
