// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "kernel/law/cohesive.hpp"
#include "kernel/law/shaped_cohesion.hpp"

namespace nugget::kernel {

/// The law of cohesive bricks: tractions over the separation of two faces, per area of the surface midway.
struct CohesiveBond {
  /// *MAT_COHESIVE_ELASTIC has `glue.softening` none: a point fails at once where its tension exceeds the normal or its
  /// shear the shear strength, each by itself; 0: it does not. *MAT_COHESIVE_MIXED_MODE has by_energy, _MIXED_MODE_
  /// ELASTOPLASTIC_RATE and *MAT_ARUP_ADHESIVE elastoplastic, and `glue.thickness` of the layer; 0: that of each brick.
  Cohesion glue;
  ShapedCohesion shaped{};             ///< *MAT_COHESIVE_TH, _GENERAL; where it is given `glue` has no meaning
  CohesiveStiffness stiffness;         ///< EN, ET [stress/length]; of a layer that yields EMOD, GMOD [stress]
  double stiffest = 0.0;               ///< of any mode and of pressure; 0: that of both [stress/length]
  double stiffness_exponent = 1.0;     ///< GAMMA, of the mean of EN and ET in the law of Benzeggagh and Kenane
  int points_to_delete = 1;            ///< INTFAIL; 0: the brick is never deleted, and its points lie at its corners
  bool density_by_area = false;        ///< ROFLG = 1
  bool in_plain_bricks = false;        ///< also bricks of ELFORM 1 may have it; they are computed as those of 19
  bool between_closest_faces = false;  ///< THKDIR = 0: N1-N4 and N5-N8 must be the closest faces of a brick

  bool yields() const { return glue.softening == Cohesion::Softening::elastoplastic; }
  /// Of the layer in a brick of this thickness.
  double thickness_in(double brick) const { return glue.thickness > 0.0 ? glue.thickness : brick; }
  CohesiveStiffness stiffness_in(double brick) const {
    if (!yields()) return stiffness;
    const double over = 1.0 / thickness_in(brick);
    return {over * stiffness.tension, over * stiffness.shear};
  }
  double stiffest_in(double brick) const {
    if (stiffest > 0.0) return stiffest;
    const CohesiveStiffness k = stiffness_in(brick);
    return std::max(k.tension, k.shear);
  }
};

/// The same bond as linear analyses have it: its first stiffness, whatever the mode, and no failure.
inline CohesiveBond unbroken(const CohesiveBond& bond) {
  if (!bond.shaped.given()) return bond;
  CohesiveBond linear = bond;
  linear.shaped = {};
  linear.stiffest = 0.0;
  return linear;
}

namespace detail {

/// Separation at which nothing holds any more. For the power law that of `end`; for Benzeggagh and Kenane's with the
/// mean stiffness (sum of share k^GAMMA)^(1/GAMMA). Source: remarks of *MAT_COHESIVE_MIXED_MODE.
inline double end_of_bond(const CohesiveBond& bond, const ModeMix& mix, double onset) {
  if (bond.glue.exponent >= 0.0 || bond.stiffness_exponent == 1.0) return end(bond.glue, mix, onset);
  const double g = bond.stiffness_exponent;
  const double stiffness = std::pow(
      mix.tension * std::pow(mix.tension_stiffness, g) + mix.shear * std::pow(mix.shear_stiffness, g), 1.0 / g);
  return std::max(onset, 2.0 * energy(bond.glue, mix) / (stiffness * onset));
}

/// Damage at a separation, never less than it was.
inline double damage_of_bond(const CohesiveBond& bond, const Opening& opening, double damage) {
  const CohesiveStiffness& k = bond.stiffness;
  const Cohesion& glue = bond.glue;
  const auto exceeds = [](double stress, double strength) { return strength > 0.0 && stress > strength; };
  if (glue.softening == Cohesion::Softening::none)
    return exceeds(k.tension * opening.normal, glue.normal_strength) ||
                   exceeds(k.shear * opening.shear, glue.shear_strength)
               ? 1.0
               : damage;
  const double size = opening.size();
  if (!(size > 0.0)) return damage;
  const ModeMix mix{opening.tension(), 1.0 - opening.tension(), k.tension, k.shear};
  const double first = onset(mix, glue.normal_strength, glue.shear_strength);
  if (size < first) return damage;
  const double last = end_of_bond(bond, mix, first);
  if (size >= last) return 1.0;
  return std::max(damage, last * (size - first) / (size * (last - first)));
}

}  // namespace detail

/// Traction at `opening`: x and y along the surface midway, z apart, negative where the faces approach each other
/// [length]; and what the point remembers from then on. Loading, softening and unloading to the origin by one damage
/// for all directions, which never falls. Pressure is EN times the approach, whatever the damage. Damage 1: it failed.
///
/// A layer that yields keeps a part of its separation; see elastoplastic_stress. Its strain rate is that of `speed`,
/// the rate of the separation, over the thickness, shear counted half. `brick`: thickness at the start.
inline Vec3d bond_traction(const CohesiveBond& bond, double brick, const Vec3d& opening, const Vec3d& speed,
                           CohesiveState& state) {
  if (bond.shaped.given()) return bond.shaped.traction(opening, state.damage);
  if (bond.yields()) {
    const double rate = std::sqrt(speed.z * speed.z + 0.25 * (speed.x * speed.x + speed.y * speed.y));
    return detail::elastoplastic_stress(bond.glue, bond.stiffness_in(brick), opening, rate / bond.thickness_in(brick),
                                        state);
  }
  const detail::Opening open{std::max(0.0, opening.z), std::hypot(opening.x, opening.y)};
  state.damage = detail::damage_of_bond(bond, open, state.damage);
  const CohesiveStiffness& k = bond.stiffness;
  return detail::weakened({k.shear * opening.x, k.shear * opening.y, k.tension * opening.z}, state.damage);
}

}  // namespace nugget::kernel
