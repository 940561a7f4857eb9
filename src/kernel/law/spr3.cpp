// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/spr3.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace nugget::kernel {
namespace {

/// Where a falling function, above 0 at `low` and not above it at `high`, passes 0: regula falsi that halves the value
/// of an end that stays (Illinois), until the value is within `tolerance` or nothing lies between the ends.
template <class Function>
double root_of_falling(const Function& f, double low, double at_low, double high, double at_high, double tolerance) {
  for (int kept = 0;;) {
    double middle = (at_low * high - at_high * low) / (at_low - at_high);
    if (!(middle > low && middle < high)) middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return high;
    const double value = f(middle);
    if (std::abs(value) <= tolerance) return middle;
    if (value > 0.0) {
      low = middle, at_low = value;
      if (kept > 0) at_high *= 0.5;
      kept = 1;
    } else {
      high = middle, at_high = value;
      if (kept < 0) at_low *= 0.5;
      kept = -1;
    }
  }
}

double size_of(double a, double b, double exponent) {
  const double larger = std::max(a, b);
  if (larger == 0.0) return 0.0;
  return larger * std::pow(std::pow(a / larger, exponent) + std::pow(b / larger, exponent), 1.0 / exponent);
}

}  // namespace

/// Magnitudes of forces, and what flow leaves of them.
struct Spr3::Trial {
  const Spr3& law;
  double tension, bending, shear, torsion;

  Trial(const Spr3& of, const Freedoms& f)
      : law(of),
        tension(std::max(f[0], 0.0)),
        bending(std::hypot(f[4], f[5])),
        shear(std::hypot(f[1], f[2])),
        torsion(std::abs(f[3])) {}

  /// The opening and the sliding that leave nothing of N and of S.
  double most_opening() const {
    const double by_bending = law.bending_share > 0.0 ? bending / (law.bending * law.bending_share) : 0.0;
    return std::max(tension / law.normal, by_bending);
  }
  double most_sliding() const {
    const double by_torsion = law.torsion_share > 0.0 ? torsion / (law.torsion * law.torsion_share) : 0.0;
    return std::max(shear / law.shear, by_torsion);
  }
  Trial after(double opening, double sliding) const {
    Trial left = *this;
    left.tension = std::max(tension - law.normal * opening, 0.0);
    left.bending = std::max(bending - law.bending * law.bending_share * opening, 0.0);
    left.shear = std::max(shear - law.shear * sliding, 0.0);
    left.torsion = std::max(torsion - law.torsion * law.torsion_share * sliding, 0.0);
    return left;
  }
  /// N / R_n and S / R_s.
  double across() const { return (tension + law.bending_share * bending) / law.normal_strength; }
  double along() const { return (shear + law.torsion_share * torsion) / law.shear_strength; }
  double size() const { return size_of(across(), along(), law.exponent); }

  struct Flow {
    double opening = 0.0, sliding = 0.0;
    double length() const { return std::hypot(opening, sliding); }
  };
  /// How N / R_n and S / R_s fall with opening and sliding, until a part of them has come to its end.
  double fall_across() const {
    const double share = bending > 0.0 ? law.bending_share : 0.0;
    return ((tension > 0.0 ? law.normal : 0.0) + share * share * law.bending) / law.normal_strength;
  }
  double fall_along() const {
    const double share = torsion > 0.0 ? law.torsion_share : 0.0;
    return ((shear > 0.0 ? law.shear : 0.0) + share * share * law.torsion) / law.shear_strength;
  }
  /// The part that a flow takes beyond its end, of several the first; null: none.
  double* first_to_end(const Flow& f) {
    double least = 1.0;
    double* first = nullptr;
    const auto look = [&](double& part, double falls) {
      if (part > 0.0 && part < least * falls) least = part / falls, first = &part;
    };
    look(tension, law.normal * f.opening);
    look(bending, law.bending * law.bending_share * f.opening);
    look(shear, law.shear * f.sliding);
    look(torsion, law.torsion * law.torsion_share * f.sliding);
    return first;
  }
  /// Flow along the surface's normal in its point x : y = c : 1 - c, so far that N / R_n + S / R_s comes down to
  /// (x + y) F0: a straight line meets the curve of F0.
  Flow straight_flow(double c, double plastic) const {
    const double size = size_of(c, 1.0 - c, law.exponent), x = c / size, y = (1.0 - c) / size;
    const double by_opening = std::pow(x, law.exponent - 1.0) / law.normal_strength,
                 by_sliding = std::pow(y, law.exponent - 1.0) / law.shear_strength,
                 length = std::hypot(by_opening, by_sliding);
    const double opening = by_opening / length, sliding = by_sliding / length;
    const double fall = (fall_across() * opening + fall_along() * sliding) / (x + y);
    const double far = law.yield.plastic_displacement(plastic, (across() + along()) / (x + y), fall) - plastic;
    return {far * opening, far * sliding};
  }
  /// The flow that ends in the point whose normal it follows, as if no part came to its end; nothing where there is
  /// none between the ends of the curve.
  std::optional<Flow> straight_flow(double plastic) const {
    const auto alone = [&](double trial, double fall) {
      return law.yield.plastic_displacement(plastic, trial, fall) - plastic;
    };
    const double n = across(), s = along();
    Flow f;
    if (n == 0.0 && s == 0.0) return std::nullopt;
    if (s == 0.0) {
      f.opening = alone(n, fall_across());
    } else if (n == 0.0) {
      f.sliding = alone(s, fall_along());
    } else {
      const auto mismatch = [&](double c) {
        const Flow to = straight_flow(c, plastic);
        return (n - fall_across() * to.opening) * (1.0 - c) - (s - fall_along() * to.sliding) * c;
      };
      const double all_across = mismatch(0.0), all_along = mismatch(1.0);
      if (!(all_across > 0.0 && all_along < 0.0)) return std::nullopt;
      constexpr double round_off = 1e-14;
      f = straight_flow(root_of_falling(mismatch, 0.0, all_across, 1.0, all_along, round_off * (n + s)), plastic);
    }
    return f;
  }
  /// The same with parts that come to their ends on the way: N is the largest of its sums with and without each part,
  /// so those that end are left out, if that agrees with where the flow then ends.
  std::optional<Flow> flow_past_ends(double plastic) const {
    Trial active = *this;
    for (;;) {
      const std::optional<Flow> f = active.straight_flow(plastic);
      if (!f) return std::nullopt;
      double* const ended = active.first_to_end(*f);
      if (ended == nullptr)
        return after(f->opening, f->sliding).same(active.after(f->opening, f->sliding)) ? f : std::nullopt;
      *ended = 0.0;
    }
  }
  bool same(const Trial& other) const {
    return tension == other.tension && bending == other.bending && shear == other.shear && torsion == other.torsion;
  }
  /// The flow normal to the surface of the size to which a plastic multiplier shrinks it. With x : y = c : 1 - c on
  /// x^beta + y^beta = 1 the point that is come to has N / R_n : S / R_s = x : y, and c (1 - c) follows from that.
  Flow flow(double multiplier) const {
    const double widest = most_opening(), farthest = most_sliding();
    const auto flow_at = [&](double c) {
      const double size = size_of(c, 1.0 - c, law.exponent), power = law.exponent - 1.0;
      return Flow{std::min(multiplier * std::pow(c / size, power) / law.normal_strength, widest),
                  std::min(multiplier * std::pow((1.0 - c) / size, power) / law.shear_strength, farthest)};
    };
    const auto mismatch = [&](double c) {
      const Flow f = flow_at(c);
      const Trial left = after(f.opening, f.sliding);
      return left.across() * (1.0 - c) - left.along() * c;
    };
    const double all_across = mismatch(0.0), all_along = mismatch(1.0);
    if (!(all_across > 0.0)) return flow_at(0.0);
    if (!(all_along < 0.0)) return flow_at(1.0);
    constexpr double round_off = 1e-14;
    return flow_at(root_of_falling(mismatch, 0.0, all_across, 1.0, all_along, round_off * size()));
  }
};

double Spr3::equivalent_force(const Freedoms& force) const {
  return Trial(*this, force).size();
}

double Spr3::mode_mixity(const Freedoms& force) {
  constexpr double nothing = 1e-300;
  const double tension = std::max(force[0], 0.0), sheared = std::hypot(force[1], force[2]);
  if (tension + sheared < nothing) return 1.0;
  return 2.0 / std::numbers::pi * std::atan2(tension, sheared);
}

double Spr3::failure_value(const Freedoms& force, double plastic) const {
  return rupture.empty() ? 0.0 : plastic / rupture.clamped(mode_mixity(force));
}

Spr3::Freedoms Spr3::advance(State& state, const Freedoms& increment) const {
  const Freedoms k = stiffness();
  for (std::size_t i = 0; i < 6; ++i) state.force[i] += k[i] * increment[i];
  if (equivalent_force(state.force) > yield.yield(state.plastic)) {
    flow(state);
    grow_damage(state);
  }
  Freedoms acting = state.force;
  for (double& f : acting) f *= 1.0 - state.damage;
  return acting;
}

/// The flow that brings a force back to the surface, also where parts of it come to their ends on the way.
static double multiplier_to_surface(const Spr3& law, const auto& trial, double plastic) {
  const auto excess = [&](double multiplier) {
    const auto f = trial.flow(multiplier);
    return trial.after(f.opening, f.sliding).size() - law.yield.yield(plastic + f.length());
  };
  // What brings the stiffer of the two back alone, as if nothing hardened; doubled until it is enough.
  double low = 0.0, at_low = excess(0.0);
  double high = at_low / std::max(trial.fall_across() / law.normal_strength, trial.fall_along() / law.shear_strength),
         at_high = excess(high);
  while (at_high > 0.0) {
    low = high, at_low = at_high;
    high *= 2.0;
    at_high = excess(high);
  }
  constexpr double round_off = 1e-13;
  return root_of_falling(excess, low, at_low, high, at_high, round_off * trial.size());
}

void Spr3::flow(State& state) const {
  const Trial trial(*this, state.force);
  const std::optional<Trial::Flow> straight = trial.flow_past_ends(state.plastic);
  const Trial::Flow f = straight ? *straight : trial.flow(multiplier_to_surface(*this, trial, state.plastic));
  const Trial left = trial.after(f.opening, f.sliding);
  const auto share = [](double now, double before) { return before > 0.0 ? now / before : 1.0; };
  if (state.force[0] > 0.0) state.force[0] = left.tension;
  for (const std::size_t i : {1u, 2u}) state.force[i] *= share(left.shear, trial.shear);
  state.force[3] *= share(left.torsion, trial.torsion);
  for (const std::size_t i : {4u, 5u}) state.force[i] *= share(left.bending, trial.bending);
  state.plastic += f.length();
}

void Spr3::grow_damage(State& state) const {
  if (initiation.empty()) return;
  const double kappa = mode_mixity(state.force), begins = initiation.clamped(kappa), ends = rupture.clamped(kappa);
  if (state.plastic <= begins) return;
  const double grown = ends > begins ? (state.plastic - begins) / (ends - begins) : 1.0;
  state.damage = std::clamp(grown, state.damage, 1.0);
}

}  // namespace nugget::kernel
