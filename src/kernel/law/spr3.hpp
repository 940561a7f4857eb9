// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/curve.hpp"
#include "kernel/law/discrete_spring.hpp"

namespace nugget::kernel {

/// Law of *CONSTRAINED_INTERPOLATION_SPOTWELD, MODEL 1 (SPR3): forces between two sheets at one spot, elastic, plastic
/// and damaged. Undamaged forces are K u in each freedom less what flows; with the magnitudes f_s of shear, m_b of
/// bending, m_t of torsion
///     N = max(f_n, 0) + alpha m_b,   S = f_s + gamma m_t,
///     P = ((N / R_n)^beta + (S / R_s)^beta)^(1/beta) <= F0(u),
/// u' = |(v', w')| for the plastic displacements v' = l' dP/dN of opening and w' = l' dP/dS of sliding, normal to the
/// surface; the return is implicit, exact to round-off. Compression is elastic. While there is flow the damage is
///     d = (u - u_0(kappa)) / (u_f(kappa) - u_0(kappa)),   kappa = 2/pi atan(max(f_n, 0) / f_s),
/// never falling; what acts is (1 - d) times the undamaged force, and at d = 1 nothing more. Source: LS-DYNA Keyword
/// Manual, Vol. I, and what is ours: docs/theory/spr3.md.
struct Spr3 {
  double normal = 0.0, shear = 0.0;                    ///< K [force/length]
  double bending = 0.0, torsion = 0.0;                 ///< K [moment/rad]
  double normal_strength = 1.0, shear_strength = 1.0;  ///< R_n, R_s: times F0 a force
  double exponent = 2.0;                               ///< beta, 1 and more
  double bending_share = 0.0, torsion_share = 0.0;     ///< alpha, gamma [1/length]
  ForceCurve yield;                                    ///< F0 over the plastic displacement
  Curve initiation, rupture;                           ///< u_0, u_f over kappa [length]; empty: never damaged

  /// Normal, shear along s and t; torsion, bending about s and t: the freedoms of a discrete beam whose r axis is the
  /// sheets' normal.
  using Freedoms = std::array<double, 6>;
  struct State {
    Freedoms force{};      ///< undamaged
    double plastic = 0.0;  ///< u [length]
    double damage = 0.0;   ///< d
  };
  /// Advances the state by displacements and angles; returns the forces that act.
  Freedoms advance(State& state, const Freedoms& increment) const;

  Freedoms stiffness() const { return {normal, shear, shear, torsion, bending, bending}; }
  /// P of undamaged forces.
  double equivalent_force(const Freedoms& force) const;
  /// kappa, 0 in shear to 1 in tension. Of bending alone 1: it opens the joint.
  static double mode_mixity(const Freedoms& force);
  /// u / u_f(kappa), which is 1 where the joint breaks under such forces; 0 where it never does.
  double failure_value(const Freedoms& force, double plastic) const;

 private:
  struct Trial;
  void flow(State& state) const;
  void grow_damage(State& state) const;
};

}  // namespace nugget::kernel
