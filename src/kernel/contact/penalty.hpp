// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

// The penalty law of one contact pair.
namespace nugget::kernel {

/// Penalty stiffness of a shell segment, before scaling: K A / (longest diagonal) [force/length].
/// LS-DYNA theory manual, "Contact-impact algorithm": K bulk modulus E/(3(1-2 nu)), A area of the segment.
inline double shell_penalty(double bulk_modulus, double area, double longest_diagonal) {
  return bulk_modulus * area / longest_diagonal;
}

/// Penalty stiffness of a brick's face, before scaling: K A^2 / V [force/length]. Source as above.
inline double solid_penalty(double bulk_modulus, double area, double volume) {
  return bulk_modulus * area * area / volume;
}

/// Friction after Coulomb, with a coefficient that falls from the static to the dynamic one and a bound on the shear
/// stress: mu = FD + (FS - FD) exp(-DC |v|), force <= mu |normal force|, force <= VC area (LS-DYNA keyword manual,
/// *CONTACT, card 2).
struct Friction {
  double at_rest = 0.0, sliding = 0.0;  ///< FS, FD [1]
  double decay = 0.0;                   ///< DC [time/length]
  double shear_strength = 0.0;          ///< VC; 0: no bound [stress]

  bool any() const { return at_rest > 0.0 || sliding > 0.0; }
  /// Largest friction force of a pair [force].
  double bound(double normal_force, double slip_speed, double area) const {
    const double coefficient = sliding + (at_rest - sliding) * std::exp(-decay * slip_speed);
    const double coulomb = coefficient * normal_force;
    return shear_strength > 0.0 ? std::min(coulomb, shear_strength * area) : coulomb;
  }
};

/// Friction of two surfaces that differ. Ours: half of each; the keyword manual names no rule.
inline Friction mean(const Friction& a, const Friction& b) {
  return {0.5 * (a.at_rest + b.at_rest), 0.5 * (a.sliding + b.sliding), 0.5 * (a.decay + b.decay),
          0.5 * (a.shear_strength + b.shear_strength)};
}

/// What the pair law needs to know of a contact.
struct PenaltyLaw {
  bool soft = false;  ///< SOFT = 1: the stiffness that the step allows counts too, for soft material against stiff
  double soft_scale = 0.1;  ///< SOFSCL
  double damping = 0.0;     ///< VDC, percent of critical
  Friction friction;
};

/// Inverse of the mass that a pair moves, 1/m_s + sum N_i^2/m_i [1/mass]. A node without mass of its own counts as
/// held.
inline double inverse_pair_mass(double node_mass, const std::array<double, 4>& weight,
                                const std::array<double, 4>& corner_mass) {
  double inverse = node_mass > 0.0 ? 1.0 / node_mass : 0.0;
  for (int i = 0; i < 4; ++i)
    if (corner_mass[i] > 0.0) inverse += weight[i] * weight[i] / corner_mass[i];
  return inverse;
}

/// Stiffness of a pair [force/length]: the penalty one; with SOFT = 1 at least SOFSCL/2 m*/dt^2; never more than m*/(2
/// dt^2), an eighth of what central differences bear for the pair alone (the rest is left to the structure and to other
/// pairs).
inline double pair_stiffness(const PenaltyLaw& law, double penalty, double inverse_mass, double dt) {
  if (!(dt > 0.0) || !(inverse_mass > 0.0)) return penalty;
  const double bearable = 0.5 / (inverse_mass * dt * dt);
  if (law.soft) penalty = std::max(penalty, law.soft_scale * bearable);
  return std::min(penalty, bearable);
}

/// Contact force of a pair [force], positive when it presses the two apart; never adhesive. `depth`: how far the
/// surfaces overlap [length], `approach`: velocity at which they close in on each other [length/time].
inline double pair_force(const PenaltyLaw& law, double stiffness, double inverse_mass, double depth, double approach) {
  if (!(depth > 0.0)) return 0.0;
  const double damping =
      law.damping > 0.0 && inverse_mass > 0.0 ? 0.02 * law.damping * std::sqrt(stiffness / inverse_mass) : 0.0;
  return std::max(0.0, stiffness * depth + damping * approach);
}

}  // namespace nugget::kernel
