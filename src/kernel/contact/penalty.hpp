// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/contact/friction.hpp"

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

/// What the stiffness of a pair is found from: SOFT = 0, 1, 2.
enum class PenaltyStiffness { material, node_masses, segment_masses };

/// What the pair law needs to know of a contact.
struct PenaltyLaw {
  PenaltyStiffness stiffness = PenaltyStiffness::material;
  bool balances_friction =
      false;                ///< FTORQ: friction acts on both sides beside each other, and that couple is balanced
  double soft_scale = 0.1;  ///< SOFSCL, for SOFT = 1
  double soft_step = 0.0;   ///< DTSTIF: the step that a stiffness by masses is for; 0: that of the run [time]
  double damping = 0.0;     ///< VDC, percent of critical; see damping_force()
  FrictionTable friction;

  /// The step that a stiffness by masses is for, in a run whose steps are `dt` [time].
  double step(double dt) const { return soft_step > 0.0 ? soft_step : dt; }
};

/// Penalty stiffness of two segments, before scaling: m1 m2 / (m1 + m2) / (2 dt^2) [force/length]. LS-DYNA theory
/// manual, segment-based contact; the masses are those of a shell, half that of a brick.
inline double segment_penalty(double mass_a, double mass_b, double dt) {
  return dt > 0.0 && mass_a + mass_b > 0.0 ? 0.5 * mass_a * mass_b / ((mass_a + mass_b) * dt * dt) : 0.0;
}

/// Inverse of the mass that a pair moves, 1/m_s + sum N_i^2/m_i [1/mass]. A node without mass of its own counts as
/// held.
inline double inverse_pair_mass(double node_mass, const std::array<double, 4>& weight,
                                const std::array<double, 4>& corner_mass) {
  double inverse = node_mass > 0.0 ? 1.0 / node_mass : 0.0;
  for (int i = 0; i < 4; ++i)
    if (corner_mass[i] > 0.0) inverse += weight[i] * weight[i] / corner_mass[i];
  return inverse;
}

/// Stiffness of a pair [force/length]: the penalty one; with SOFT = 1 at least SOFSCL/2 m*/DTSTIF^2; never more than
/// m*/(2 dt^2), an eighth of the stability limit of central differences for the pair alone (the rest is left to the
/// structure and to other pairs).
inline double pair_stiffness(const PenaltyLaw& law, double penalty, double inverse_mass, double dt) {
  if (!(dt > 0.0) || !(inverse_mass > 0.0)) return penalty;
  const double stable_stiffness = 0.5 / (inverse_mass * dt * dt);
  if (law.stiffness == PenaltyStiffness::node_masses) {
    const double step = law.step(dt);
    penalty = std::max(penalty, law.soft_scale * (0.5 / (inverse_mass * step * step)));
  }
  return std::min(penalty, stable_stiffness);
}

/// What a pair remembers of the cycle before, so that it gives back what it took.
struct PairMemory {
  double force = 0.0;      ///< of its spring [force]
  double pressed = 0.0;    ///< with which the two were pressed apart, damping included [force]
  double approach = 0.0;   ///< velocity at which the two closed in on each other [length/time]
  double stored = 0.0;     ///< energy that the spring took so far, as the trapezoidal rule books it [energy]
  double stiffness = 0.0;  ///< of its spring, where that has a force [force/length]

  /// Of the force, what damping adds [force].
  double damping() const { return pressed > 0.0 ? pressed - force : 0.0; }
};

/// The depth with which a spring of the `depth` keeps its energy k depth^2/2 as its stiffness becomes `stiffness`, on
/// another face or with another step of the run [length]. With the depth kept it would make energy where it is stiffer
/// and lose some where it is softer.
inline double depth_of_same_energy(const PairMemory& before, double depth, double stiffness) {
  if (!(before.stiffness > 0.0) || !(stiffness > 0.0) || before.stiffness == stiffness) return depth;
  return depth * std::sqrt(before.stiffness / stiffness);
}

/// How much less a pair approaches in a step for each unit of force, measured on the cycle before: other pairs, whose
/// force changes with it, press the same bodies [length/force]. Not less than that of the pair `alone`.
inline double measured_compliance(const PairMemory& before, double alone, double approach, double dt) {
  return before.pressed > 0.0 ? std::max(alone, (before.approach - approach) * dt / before.pressed) : alone;
}

/// Force with which a pair that does not touch any more gives back what its spring still has: the last step of the
/// touch led out of it somewhere [force]. For one cycle, within the way of which the two came apart; 0 where they did
/// not move apart along the direction of the force. Never more than the spring had at the distance of that way.
/// `before`: the cycle before, in which they touched; the other arguments as in spring_force().
inline double separation_force(const PairMemory& before, double stiffness, double inverse_mass, double approach,
                               double dt) {
  const double travel = -approach * dt, left = before.stored - 0.5 * before.force * travel;
  if (!(before.force > 0.0) || !(travel > 0.0) || !(left > 0.0)) return 0.0;
  const double compliance = 3.0 * inverse_mass * dt * dt;  // as of three pairs: see damping_force()
  return std::min(stiffness * travel, 2.0 * left / (travel + std::sqrt(travel * travel + 2.0 * compliance * left)));
}

/// Force of the spring of a pair, k depth but in its first and its last cycle [force]. The pair came to the `depth`
/// (how far the surfaces overlap [length]) in a step `dt`, in which the two closed in with the velocity `approach`.
///
/// Steps cut the way into the spring and out of it somewhere. With k depth in every cycle two bodies part with up to a
/// fifth more or less energy than they came with (k dt^2 = 0.4 m*, two such pairs at each node). Ours: in the first
/// cycle the force is such that v^2/2 + k d(n) d(n+1)/2m*, which central differences keep while the spring acts, is
/// what v^2/2 was before; in the last one, such that the booked energy comes out as 0. How much closer the pair would
/// come without the force is measured on the cycle before; in the first one it is that of two such pairs, as a pair is
/// seldom alone.
inline double spring_force(PairMemory& memory, double stiffness, double inverse_mass, double depth, double approach,
                           double dt) {
  const PairMemory before = memory;
  memory = {};
  if (!(depth > 0.0)) return separation_force(before, stiffness, inverse_mass, approach, dt);
  double force = stiffness * depth;
  const double travel = approach * dt;          // in the step; that in the next one is way - give force
  const double alone = inverse_mass * dt * dt;  // give of the pair alone
  if (!(before.force > 0.0)) {
    const double compliance = 2.0 * alone, b = 2.0 * travel + compliance * force, c = force * (depth + travel);
    if (travel > depth) force = 2.0 * c / (b + std::sqrt(std::max(0.0, b * b - 4.0 * compliance * c)));
    memory.stored = 0.5 * force * travel;
  } else {
    const double compliance = measured_compliance(before, alone, approach, dt);
    const double stored = before.stored + 0.5 * before.force * travel;
    if (depth + travel < compliance * force)
      force = stored > 0.0
                  ? std::min(force, 2.0 * stored / (std::sqrt(travel * travel + 2.0 * compliance * stored) - travel))
                  : 0.0;
    memory.stored = stored + 0.5 * force * travel;
  }
  memory.force = force;
  memory.approach = approach;
  memory.stiffness = stiffness;
  return force;
}

/// Viscous force of a pair whose spring has the force `spring` and that closes in with the velocity `approach` [force];
/// `inverse_node_mass`: of its one side, `before`: the cycle before. VDC percent of 2 m w, m the lesser mass of the two
/// sides and w = sqrt(k/m*) (keyword manual, *CONTACT, VDC): percent of critical where one side is much the heavier, of
/// twice that where they are alike.
///
/// Ours: it acts on the velocity as it decays within the step, as far as the pair gives to force. On the velocity of
/// the step before, strong damping throws the bodies apart faster than they came, as more pairs than one act on them.
/// Of meshes that are alike 3.2 do, so the measured give counts up to 4 pairs, and in the first cycle it is that of 3.
inline double damping_force(const PenaltyLaw& law, double stiffness, double inverse_mass, double inverse_node_mass,
                            double spring, const PairMemory& before, double approach, double dt) {
  if (!(law.damping > 0.0) || !(inverse_mass > 0.0) || !(dt > 0.0)) return 0.0;
  const double lesser = 1.0 / std::max(inverse_node_mass, inverse_mass - inverse_node_mass);
  const double viscosity = 0.02 * law.damping * lesser * std::sqrt(stiffness * inverse_mass);
  const double alone = inverse_mass * dt * dt;
  const double compliance =
      before.pressed > 0.0 ? std::min(4.0 * alone, measured_compliance(before, alone, approach, dt)) : 3.0 * alone;
  const double slowed = compliance / dt;  // by the unit of force
  return (approach - 0.5 * slowed * spring) * -std::expm1(-slowed * viscosity) / slowed;
}

/// Contact force of a pair [force], positive when it presses the two apart; never adhesive. For the arguments see
/// spring_force() and damping_force().
inline double pair_force(const PenaltyLaw& law, PairMemory& memory, double stiffness, double inverse_mass,
                         double inverse_node_mass, double depth, double approach, double dt) {
  const PairMemory before = memory;
  const double spring = spring_force(memory, stiffness, inverse_mass, depth, approach, dt);
  if (!(spring > 0.0) || !(depth > 0.0)) return spring;
  const double damping = damping_force(law, stiffness, inverse_mass, inverse_node_mass, spring, before, approach, dt);
  memory.pressed = std::max(0.0, spring + damping);
  return memory.pressed;
}

}  // namespace nugget::kernel
