// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/fabric.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/law/orthotropic.hpp"

namespace nugget::kernel {
namespace {

SheetModuli sheet_moduli(double young_a, double young_b, double poisson_ba, double shear, double share) {
  const double over = share / (1.0 - poisson_ba * poisson_ba * young_a / young_b);
  return {over * young_a, over * young_b, over * poisson_ba * young_a, share * shear};
}

SheetModuli of_fabric(const Fabric& law) {
  return sheet_moduli(law.young_a, law.young_b, law.poisson_ba, law.shear_ab, 1.0 - law.liner_share);
}

SheetModuli of_liner(const Fabric& law) {
  const double shear = law.liner_young / (2.0 * (1.0 + law.liner_poisson));
  return law.liner_share > 0.0
             ? sheet_moduli(law.liner_young, law.liner_young, law.liner_poisson, shear, law.liner_share)
             : SheetModuli{};
}

using Direction = Wrinkling::Direction;

/// Between two directions: `share` of the way along their chord.
Direction part_way(const Direction& from, const Direction& to, double share) {
  const double a = from.a + share * (to.a - from.a), b = from.b + share * (to.b - from.b);
  const double over = 1.0 / std::sqrt(a * a + b * b);
  return {over * a, over * b};
}

/// What waves across a direction n do: they take up the strain beta n n.
struct Waves {
  double across = 0.0;  ///< stress along n without them [stress]
  double beta = 0.0;    ///< that leaves no stress along n; not below 0 [1]
  double relief = 0.0;  ///< energy that they save, twice [stress]
  double shear = 0.0;   ///< stress between n and t that is left [stress]
  double slope = 0.0;   ///< by which that grows as n turns towards t, where beta is above 0 [stress]
  double along = 0.0;   ///< stress along t that is left [stress]

  Waves(const SheetModuli& moduli, const AxesTensor& stress, const Direction& n) {
    const double aa = n.a * n.a, bb = n.b * n.b, ab = n.a * n.b, wide = aa - bb;
    const AxesTensor own = moduli.times({aa, bb, 2.0 * ab});  // the stress of n n
    const auto shear_of = [&](const AxesTensor& s) { return ab * (s.b - s.a) + wide * s.ab; };
    // Its change as n turns.
    const auto turned_shear_of = [&](const AxesTensor& s) { return wide * (s.b - s.a) - 4.0 * ab * s.ab; };
    across = aa * stress.a + bb * stress.b + 2.0 * ab * stress.ab;
    const double over_stiffness = 1.0 / (aa * own.a + bb * own.b + 2.0 * ab * own.ab);
    beta = std::max(-across * over_stiffness, 0.0);
    relief = -across * beta;
    const AxesTensor left{stress.a + beta * own.a, stress.b + beta * own.b, stress.ab + beta * own.ab};
    shear = shear_of(left);
    along = bb * left.a + aa * left.b - 2.0 * ab * left.ab;
    const double own_shear = shear_of(own);
    const double turned_beta = -over_stiffness * (2.0 * shear_of(stress) + 4.0 * beta * own_shear);
    const AxesTensor turned_own = moduli.times({-2.0 * ab, 2.0 * ab, 2.0 * wide});
    slope = turned_shear_of(left) + turned_beta * own_shear + beta * shear_of(turned_own);
  }
};

/// Direction of the least principal stress.
Direction direction_of_least(const AxesTensor& stress) {
  const double half = 0.5 * (stress.a - stress.b), radius = std::hypot(half, stress.ab);
  if (radius == 0.0) return {1.0, 0.0};
  // An eigenvector by the row that does not vanish.
  const double a = half < 0.0 ? radius - half : -stress.ab, b = half < 0.0 ? -stress.ab : radius + half;
  const double over = 1.0 / std::sqrt(a * a + b * b);
  return {over * a, over * b};
}

}  // namespace

double Fabric::wave_modulus() const {
  const SheetModuli f = of_fabric(*this), l = of_liner(*this);
  return fastest_wave_modulus({{{f.aa + l.aa, f.ab + l.ab, 0.0}, {f.ab + l.ab, f.bb + l.bb, 0.0}, {0.0, 0.0, 0.0}}},
                              f.shear + l.shear, 0.0, 0.0);
}

Wrinkling::Wrinkling(const SheetModuli& moduli) : moduli_(moduli) {
  for (std::size_t i = 0; i < tried; ++i) {
    const double angle = M_PI * static_cast<double>(i) / tried, a = std::cos(angle), b = std::sin(angle);
    const AxesTensor own = moduli.times({a * a, b * b, 2.0 * a * b});
    tried_[i] = {a, b, a * a, b * b, 2.0 * a * b, 1.0 / (a * a * own.a + b * b * own.b + 2.0 * a * b * own.ab)};
  }
}

Direction Wrinkling::within_a_step(const AxesTensor& stress, const Direction& best, double enough) const {
  constexpr double cosine = 0.96592582628906828675, sine = 0.25881904510252076235;  // of half a turn / tried
  static_assert(tried == 12);
  Waves waves(moduli_, stress, best);
  // The relief grows as long as the shear is below 0.
  const bool beyond = waves.shear < 0.0;
  const Direction before{cosine * best.a + sine * best.b, cosine * best.b - sine * best.a},
      behind{cosine * best.a - sine * best.b, cosine * best.b + sine * best.a};
  Direction n = best, from = beyond ? best : before, to = beyond ? behind : best;
  const auto shear_at = [&](const Direction& d, double where_taut) {
    const Waves w(moduli_, stress, d);
    return w.beta > 0.0 ? w.shear : where_taut;
  };
  const double far = 1e12 * enough;
  double low = shear_at(from, -far), high = shear_at(to, far);
  for (int k = 0; k < 200 && std::abs(waves.shear) > enough; ++k) {
    const double secant = high > low ? -low / (high - low) : 0.5;
    n = part_way(from, to, k % 3 == 2 || !(secant > 0.0 && secant < 1.0) ? 0.5 : secant);
    waves = Waves(moduli_, stress, n);
    const double here = waves.beta > 0.0 ? waves.shear : (beyond ? far : -far);
    (here < 0.0 ? from : to) = n;
    (here < 0.0 ? low : high) = here;
  }
  return n;
}

AxesTensor Wrinkling::stress(const AxesTensor& strain) const {
  const AxesTensor stress = moduli_.times(strain);
  const double size = std::abs(stress.a) + std::abs(stress.b) + std::abs(stress.ab);
  // Steps that move nothing, of which the stiffness is made (docs/decisions/0017), meet that of the taut fabric.
  constexpr double nothing = 1e-20;
  if (std::abs(strain.a) + std::abs(strain.b) + std::abs(strain.ab) < nothing) return stress;
  if (stress.a + stress.b >= 0.0 && stress.a * stress.b >= stress.ab * stress.ab) return stress;     // taut
  if (strain.a + strain.b <= 0.0 && strain.a * strain.b >= 0.25 * strain.ab * strain.ab) return {};  // slack

  // The best of some directions and of that of the greatest compression, then the root of the shear that is left
  // beside.
  Direction start = direction_of_least(stress);
  double relief = Waves(moduli_, stress, start).relief;
  for (const Tried& n : tried_) {
    const double across = n.aa * stress.a + n.bb * stress.b + n.ab2 * stress.ab,
                 here = across < 0.0 ? across * across * n.over_stiffness : 0.0;
    if (here > relief) relief = here, start = {n.a, n.b};
  }
  const double enough = 1e-12 * size;
  // Newton's steps, as long as they stay near and the shear falls.
  constexpr double near = 0.97, half_as_much = 0.5;
  Direction n = start;
  Waves waves(moduli_, stress, n);
  while (std::abs(waves.shear) > enough) {
    const double turn = -waves.shear / waves.slope, a = n.a - turn * n.b, b = n.b + turn * n.a,
                 over = 1.0 / std::sqrt(a * a + b * b);
    const Direction next{over * a, over * b};
    const Waves there(moduli_, stress, next);
    if (!(next.a * start.a + next.b * start.b > near && there.beta > 0.0 &&
          std::abs(there.shear) <= half_as_much * std::abs(waves.shear))) {
      n = within_a_step(stress, start, enough);
      waves = Waves(moduli_, stress, n);
      break;
    }
    n = next;
    waves = there;
  }
  const double tension = std::max(waves.along, 0.0);
  return {tension * n.b * n.b, tension * n.a * n.a, -tension * n.a * n.b};
}

LawKernel<Fabric>::LawKernel(const Fabric& law)
    : axes_(law.axes),
      fabric_(of_fabric(law)),
      liner_(of_liner(law)),
      wrinkling_(fabric_),
      no_compression_(law.no_compression),
      has_liner_(law.liner_share > 0.0),
      damping_(law.damping),
      step_share_(1.0 / std::sqrt(1.0 + 2.0 * law.damping)) {}

}  // namespace nugget::kernel
