// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/curve.hpp"
#include "base/vec3.hpp"

// What holds two surfaces together at a point until it fails: stress over opening, per area.
namespace nugget::kernel {

/// What the elastoplastic glue of OPTION 13 and 14 says of one mode: a trapezoid whose height and area depend on the
/// strain rate at which it begins to yield.
struct ElastoplasticMode {
  double yield = 0.0;          ///< |T0|, |S0| [stress]
  double yield_growth = 0.0;   ///< T1, S1; > 0: with the square of the logarithm, < 0: with the logarithm; 0: no rate
  double yield_rate = 0.0;     ///< EDOT_T, EDOT_S: from here on it grows [1/time]
  double energy = 0.0;         ///< |G1C_0|, |G2C_0|: to part the surfaces [energy/area]
  double fast_energy = 0.0;    ///< G1C_INF, G2C_INF: at high rates
  double energy_rate = 0.0;    ///< EDOT_G1, EDOT_G2; 0: the energy does not depend on the rate [1/time]
  double plateau = 0.0;        ///< FG1, FG2: its share in the energy; negative: in the opening beyond the yield point
  double energy_growth = 0.0;  ///< *MAT_ARUP_ADHESIVE: of the energy with the logarithm, as yield_growth below 0
  double top_rate = std::numeric_limits<double>::infinity();  ///< from here on neither grows by a logarithm [1/time]

  double yield_at(double rate) const {
    if (yield_growth == 0.0 || !(rate > yield_rate)) return yield;
    const double logarithm = std::log(std::min(rate, top_rate) / yield_rate);
    return yield + std::abs(yield_growth) * (yield_growth > 0.0 ? logarithm * logarithm : logarithm);
  }
  double energy_at(double rate) const {
    if (energy_growth != 0.0)
      return rate > yield_rate ? energy + energy_growth * std::log(std::min(rate, top_rate) / yield_rate) : energy;
    if (energy_rate == 0.0 || !(rate > 0.0)) return energy;
    return energy + (fast_energy - energy) * std::exp(-energy_rate / rate);
  }
};

/// The glue of *CONTACT_..._TIEBREAK. Up to the onset, (tension/NFLS)^2 + (shear/SFLS)^2 = 1, it is elastic; from there
/// on the stress falls in a straight line to zero, over no distance, up to a given opening, or so that a given energy
/// is spent. Or it yields there: `by_curve`, sqrt(tension^2 + 3 shear^2) stays at NFLS times a factor that a curve
/// gives over the widest opening; `elastoplastic`, a plateau that ends in a straight line.
struct Cohesion {
  enum class Softening { none, to_distance, by_energy, by_curve, elastoplastic };
  double normal_strength = 0.0, shear_strength = 0.0;  ///< NFLS, SFLS; 0: does not count [stress]
  double normal_exponent = 2.0, shear_exponent = 2.0;  ///< NEN, MES: of the onset, where it has no softening or yields
  double shear_slope = 0.0;     ///< elastoplastic: tension takes so much of itself off the shear strength
  double pressure_share = 0.0;  ///< sine of the friction angle: so much of the pressure adds to the shear strength
  Softening softening = Softening::none;
  double distance = 0.0;                           ///< CCRIT: opening at which nothing holds any more [length]
  double normal_energy = 0.0, shear_energy = 0.0;  ///< ERATEN, ERATES: to part the surfaces [energy/area]
  double exponent = 1.0;             ///< PARAM: of the mixed modes' power law; negative: that of Benzeggagh and Kenane
  double normal_stiffness = 0.0;     ///< CN; 0: the penalty's [stress/length]
  double shear_ratio = 1.0;          ///< CT2CN: stiffness in shear over that in tension
  Curve resistance;                  ///< by_curve: factor on the stress over the widest opening [length]
  ElastoplasticMode tension, shear;  ///< elastoplastic
  double thickness = 0.0;            ///< of the layer, that makes a strain rate of a velocity [length]

  bool yields_on_an_ellipse() const { return normal_exponent == 2.0 && shear_exponent == 2.0 && shear_slope == 0.0; }
};

/// What a point of glue remembers.
struct CohesiveState {
  double damage = 0.0;          ///< 0 to 1: stress that is lost
  double widest = 0.0;          ///< opening so far, closed: 0 [length]
  Vec3d plastic;                ///< opening that is left without stress, as CohesiveStiffness' [length]
  double rate_at_yield = -1.0;  ///< strain rate when it first yielded; negative: it has not [1/time]
};

/// Stiffness of glue in tension and in shear [stress/length].
struct CohesiveStiffness {
  double tension = 0.0, shear = 0.0;
};

namespace detail {

/// How far a point has opened: apart (a closed point has 0), and along the surface [length].
struct Opening {
  double normal = 0.0, shear = 0.0;
  double size() const { return std::sqrt(normal * normal + shear * shear); }
  /// Share of the tension in the square of the size.
  double tension() const { return normal / size() * (normal / size()); }
};

/// Shares of the squared opening in tension and shear; stiffness of each [stress/length].
struct ModeMix {
  double tension, shear, tension_stiffness, shear_stiffness;
};

inline double squared_ratio(double stiffness, double strength) {
  return strength > 0.0 ? (stiffness / strength) * (stiffness / strength) : 0.0;
}

/// Opening at which (tension/strength)^2 + (shear/strength)^2 is 1, in this mix; infinite where nothing limits it.
inline double onset(const ModeMix& mix, double normal_strength, double shear_strength) {
  return 1.0 / std::sqrt(mix.tension * squared_ratio(mix.tension_stiffness, normal_strength) +
                         mix.shear * squared_ratio(mix.shear_stiffness, shear_strength));
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
  if (glue.softening == Cohesion::Softening::to_distance) return std::max(onset, glue.distance);
  const double stiffness = mix.tension * mix.tension_stiffness + mix.shear * mix.shear_stiffness;
  return std::max(onset, 2.0 * energy(glue, mix) / (stiffness * onset));
}

/// Whether a stress is beyond the strength of glue without softening: (tension/NFLS)^NEN + (shear/SFLS)^MES >= 1.
inline bool beyond(const Cohesion& glue, double tension, double shear) {
  double value = 0.0;
  if (glue.normal_strength > 0.0) value += std::pow(tension / glue.normal_strength, glue.normal_exponent);
  if (glue.shear_strength > 0.0) value += std::pow(shear / glue.shear_strength, glue.shear_exponent);
  return value >= 1.0;
}

/// Damage of glue that softens in a straight line. After the bilinear law with mixed modes of
/// *MAT_COHESIVE_MIXED_MODE (Camanho and Davila, NASA/TM-2002-211737), also where the end is a distance. `pressure`
/// raises the shear strength (Coulomb), not the energy.
inline double bilinear_damage(const Cohesion& glue, const CohesiveStiffness& k, const Opening& opening, double pressure,
                              double damage) {
  if (glue.softening == Cohesion::Softening::none)
    return beyond(glue, k.tension * opening.normal, k.shear * opening.shear) ? 1.0 : damage;
  const double size = opening.size();
  if (!(size > 0.0)) return damage;
  const ModeMix mix{opening.tension(), 1.0 - opening.tension(), k.tension, k.shear};
  const double first = onset(mix, glue.normal_strength, glue.shear_strength + glue.pressure_share * pressure);
  if (size < first) return damage;
  const double last = end(glue, mix, first);
  if (size >= last) return 1.0;
  return std::max(damage, last * (size - first) / (size * (last - first)));
}

/// The surface (tension/normal)^NEN + (shear/(along - slope tension))^MES = 1 along one way of the stress: its value at
/// a share of that stress. Pressure is not shared out: it adds the slope times itself to `along`.
class YieldSurface {
 public:
  YieldSurface(const Cohesion& glue, double normal, double along, double stress, double shear) : glue_(glue) {
    const double strength = along + glue.shear_slope * std::max(0.0, -stress), tension = std::max(0.0, stress);
    tension_ = tension / normal;
    shear_ = shear / strength;
    fall_ = glue.shear_slope * tension / strength;
  }
  double at(double share) const {
    return std::pow(share * tension_, glue_.normal_exponent) + std::pow(along(share), glue_.shear_exponent);
  }
  /// The share, above or below 1, at which it is 1; infinite without tension and shear. By Newton's method, halving
  /// where it leaves the bracket, to the last bits.
  double share() const {
    if (!(tension_ + shear_ > 0.0)) return std::numeric_limits<double>::infinity();
    double low = 0.0, high = 1.0 / std::max(tension_, shear_ + fall_), m = high;
    while (true) {
      const double excess = at(m) - 1.0;
      (excess > 0.0 ? high : low) = m;
      double next = m - excess / slope(m);
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (!(std::abs(next - m) > 1e-15 * m)) return next;
      m = next;
    }
  }

 private:
  double along(double share) const {
    const double left = 1.0 - share * fall_;
    if (!(shear_ > 0.0)) return 0.0;
    return left > 0.0 ? share * shear_ / left : std::numeric_limits<double>::infinity();
  }
  double slope(double share) const {
    const double n = glue_.normal_exponent, s = glue_.shear_exponent, left = 1.0 - share * fall_;
    double sum = 0.0;
    if (tension_ > 0.0) sum += n * tension_ * std::pow(share * tension_, n - 1.0);
    if (shear_ > 0.0) sum += s * shear_ / (left * left) * std::pow(along(share), s - 1.0);
    return sum;
  }

  const Cohesion& glue_;
  double tension_ = 0.0, shear_ = 0.0, fall_ = 0.0;
};

/// By how much a stress lies beyond yield, as a factor; 1 or less: it does not.
inline double beyond_yield(const Cohesion& glue, double normal, double along, double stress, double shear) {
  if (glue.yields_on_an_ellipse()) return std::hypot(std::max(0.0, stress) / normal, shear / along);
  const YieldSurface surface(glue, normal, along, stress, shear);
  return surface.at(1.0) > 1.0 ? 1.0 / surface.share() : 0.0;
}

/// Stress of glue that yields where (tension/normal)^2 + (shear/along)^2 is 1, before damage; it is brought back along
/// the way to no stress, and what is left of the opening is `plastic`. Opened for good it does not resist closing
/// until the surfaces meet. Whether it yielded is the answer.
/// With other exponents or a slope it is that of YieldSurface.
inline bool yields(const Cohesion& glue, const CohesiveStiffness& k, const Vec3d& opening, double normal, double along,
                   Vec3d& plastic, Vec3d& stress) {
  stress = {k.shear * (opening.x - plastic.x), k.shear * (opening.y - plastic.y),
            k.tension * (opening.z > 0.0 ? std::max(0.0, opening.z - plastic.z) : opening.z)};
  const double shear = std::hypot(stress.x, stress.y);
  const double beyond = beyond_yield(glue, normal, along, stress.z, shear);
  if (!(beyond > 1.0)) return false;
  stress.x /= beyond;
  stress.y /= beyond;
  if (stress.z > 0.0) stress.z /= beyond;
  plastic.x = opening.x - stress.x / k.shear;
  plastic.y = opening.y - stress.y / k.shear;
  if (stress.z > 0.0) plastic.z = opening.z - stress.z / k.tension;
  return true;
}

/// The stress, less what damage takes; pressure stays.
inline Vec3d weakened(const Vec3d& stress, double damage) {
  const double left = 1.0 - damage;
  return {left * stress.x, left * stress.y, stress.z > 0.0 ? left * stress.z : stress.z};
}

inline Vec3d stress_by_curve(const Cohesion& glue, const CohesiveStiffness& k, const Vec3d& opening,
                             CohesiveState& state) {
  Vec3d stress;
  yields(glue, k, opening, glue.normal_strength, glue.normal_strength / std::sqrt(3.0), state.plastic, stress);
  state.widest = std::max(state.widest, opening.z);
  state.damage = 1.0 - std::clamp(glue.resistance.clamped(state.widest), 0.0, 1.0);
  return weakened(stress, state.damage);
}

/// Openings at which one mode begins to yield, to soften, and at which it ends.
struct Trapezoid {
  double yield, soften;
  Trapezoid(const ElastoplasticMode& mode, double stiffness, double strength, double energy)
      : yield(strength / stiffness), soften(yield) {
    const double share = std::abs(mode.plateau);
    if (mode.plateau >= 0.0)
      soften += share * energy / strength;
    else
      soften += share * ((2.0 * energy / strength + share * yield) / (1.0 + share) - yield);
  }
};

/// The law of *MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE (Marzi, Hesebeck, Brede, Kleiner 2009), and of
/// *MAT_ARUP_ADHESIVE: in each mode a trapezoid; yield after an ellipse of the stresses, or the latter's surface,
/// softening after one of the openings, and an end such that G_t/G1C + G_s/G2C = 1.
inline Vec3d elastoplastic_stress(const Cohesion& glue, const CohesiveStiffness& k, const Vec3d& opening,
                                  double strain_rate, CohesiveState& state) {
  const double rate = state.rate_at_yield >= 0.0 ? state.rate_at_yield : strain_rate;
  const double normal = glue.tension.yield_at(rate), along = glue.shear.yield_at(rate);
  Vec3d stress;
  if (yields(glue, k, opening, normal, along, state.plastic, stress) && state.rate_at_yield < 0.0)
    state.rate_at_yield = rate;
  const Opening open{std::max(0.0, opening.z), std::hypot(opening.x, opening.y)};
  const double size = open.size();
  if (size > 0.0 && state.rate_at_yield >= 0.0) {
    const double normal_energy = glue.tension.energy_at(rate), shear_energy = glue.shear.energy_at(rate);
    const Trapezoid tension(glue.tension, k.tension, normal, normal_energy);
    const Trapezoid shear(glue.shear, k.shear, along, shear_energy);
    const double t = open.tension(), s = 1.0 - t;
    const double yield =
        glue.yields_on_an_ellipse()
            ? 1.0 / std::sqrt(t / (tension.yield * tension.yield) + s / (shear.yield * shear.yield))
            : size * YieldSurface(glue, normal, along, k.tension * open.normal, k.shear * open.shear).share();
    const double soften =
        std::max(glue.yields_on_an_ellipse() ? 0.0 : yield,
                 1.0 / std::sqrt(t / (tension.soften * tension.soften) + s / (shear.soften * shear.soften)));
    const double area = 2.0 / (yield * (t * k.tension / normal_energy + s * k.shear / shear_energy));
    const double end = std::max(soften, area + yield - soften);
    if (size >= end)
      state.damage = 1.0;
    else if (size > soften)
      state.damage = std::max(state.damage, (size - soften) / (end - soften));
  }
  return weakened(stress, state.damage);
}

}  // namespace detail

/// Stress of the glue at `opening`: x and y along the surface, z apart, negative where it is closed [length]; and what
/// it remembers from then on. Where damage reaches 1 the glue has failed. Pressure is elastic in any case.
inline Vec3d cohesive_stress(const Cohesion& glue, const CohesiveStiffness& k, const Vec3d& opening, double strain_rate,
                             CohesiveState& state) {
  if (glue.softening == Cohesion::Softening::by_curve) return detail::stress_by_curve(glue, k, opening, state);
  if (glue.softening == Cohesion::Softening::elastoplastic)
    return detail::elastoplastic_stress(glue, k, opening, strain_rate, state);
  const detail::Opening open{std::max(0.0, opening.z), std::hypot(opening.x, opening.y)};
  state.damage = detail::bilinear_damage(glue, k, open, k.tension * std::max(0.0, -opening.z), state.damage);
  return detail::weakened({k.shear * opening.x, k.shear * opening.y, k.tension * opening.z}, state.damage);
}

}  // namespace nugget::kernel
