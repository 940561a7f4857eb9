// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

// What holds two surfaces together at a point until it fails: stress over opening, per area.
namespace nugget::kernel {

/// The glue of *CONTACT_..._TIEBREAK. Up to the onset, (tension/NFLS)^2 + (shear/SFLS)^2 = 1, it is elastic; from there
/// on the stress falls in a straight line to zero, over no distance, up to a given opening, or so that a given energy
/// is spent.
struct Cohesion {
  enum class Softening { none, to_distance, by_energy };
  double normal_strength = 0.0, shear_strength = 0.0;  ///< NFLS, SFLS; 0: does not count [stress]
  Softening softening = Softening::none;
  double distance = 0.0;                           ///< CCRIT: opening at which nothing holds any more [length]
  double normal_energy = 0.0, shear_energy = 0.0;  ///< ERATEN, ERATES: to part the surfaces [energy/area]
  double exponent = 1.0;          ///< PARAM: of the mixed modes' power law; negative: that of Benzeggagh and Kenane
  double normal_stiffness = 0.0;  ///< CN; 0: the penalty's [stress/length]
  double shear_ratio = 1.0;       ///< CT2CN: stiffness in shear over that in tension
};

/// How far a point has opened: apart (a closed point has 0), and along the surface [length].
struct Opening {
  double normal = 0.0, shear = 0.0;
  double size() const { return std::sqrt(normal * normal + shear * shear); }
};

namespace detail {

/// Shares of the squared opening in tension and shear; stiffness of each [stress/length].
struct ModeMix {
  double tension, shear, tension_stiffness, shear_stiffness;
};

inline double squared_ratio(double stiffness, double strength) {
  return strength > 0.0 ? (stiffness / strength) * (stiffness / strength) : 0.0;
}

/// Opening at the onset, in this mix; infinite where nothing limits the stress.
inline double onset(const Cohesion& glue, const ModeMix& mix) {
  return 1.0 / std::sqrt(mix.tension * squared_ratio(mix.tension_stiffness, glue.normal_strength) +
                         mix.shear * squared_ratio(mix.shear_stiffness, glue.shear_strength));
}

/// Energy per area that parts the surfaces in this mix. Power law: (G_t/ERATEN)^p + (G_s/ERATES)^p = 1; Benzeggagh and
/// Kenane: ERATEN + (ERATES - ERATEN) (G_s/G)^p, G = G_t + G_s.
inline double energy(const Cohesion& glue, const ModeMix& mix) {
  const double tension = mix.tension * mix.tension_stiffness, shear = mix.shear * mix.shear_stiffness;
  const double t = tension / (tension + shear), s = shear / (tension + shear);
  if (glue.exponent < 0.0)
    return glue.normal_energy + (glue.shear_energy - glue.normal_energy) * std::pow(s, -glue.exponent);
  return std::pow(std::pow(t / glue.normal_energy, glue.exponent) + std::pow(s / glue.shear_energy, glue.exponent),
                  -1.0 / glue.exponent);
}

/// Opening at which nothing holds any more, never before the onset.
inline double end(const Cohesion& glue, const ModeMix& mix, double onset) {
  switch (glue.softening) {
    case Cohesion::Softening::to_distance: return std::max(onset, glue.distance);
    case Cohesion::Softening::by_energy: {
      const double stiffness = mix.tension * mix.tension_stiffness + mix.shear * mix.shear_stiffness;
      return std::max(onset, 2.0 * energy(glue, mix) / (stiffness * onset));
    }
    case Cohesion::Softening::none: break;
  }
  return onset;
}

}  // namespace detail

/// Damage of the glue, 0 to 1, opened so far and with `damage` until now: stress = (1 - damage) stiffness opening, but
/// for closed points. Stiffness in tension and in shear [stress/length]. After the bilinear law with mixed modes of
/// *MAT_COHESIVE_MIXED_MODE (Camanho and Davila, NASA/TM-2002-211737), also where the end is a distance.
inline double cohesive_damage(const Cohesion& glue, double tension_stiffness, double shear_stiffness,
                              const Opening& opening, double damage) {
  const double size = opening.size();
  if (!(size > 0.0)) return damage;
  const double share = (opening.normal / size) * (opening.normal / size);
  const detail::ModeMix mix{share, 1.0 - share, tension_stiffness, shear_stiffness};
  const double onset = detail::onset(glue, mix);
  if (size < onset) return damage;
  const double end = detail::end(glue, mix, onset);
  if (size >= end) return 1.0;
  return std::max(damage, end * (size - onset) / (size * (end - onset)));
}

}  // namespace nugget::kernel
