// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/fabric.hpp"

#include <algorithm>
#include <cmath>

#include "base/batch.hpp"
#include "kernel/law/orthotropic.hpp"

namespace nugget::kernel {
namespace {

SheetModuli sheet_moduli(double young_a, double young_b, double poisson_ba, double shear, double share) {
  const double over = share / (1.0 - poisson_ba * poisson_ba * young_a / young_b);
  return {over * young_a, over * young_b, over * poisson_ba * young_a, share * shear};
}

using Direction = Wrinkling::Direction;

/// What follows is computed in a lane of a batch: GCC 12 makes vfmaddsub of neighbouring sums and differences of
/// products of plain numbers where the processor has AVX-512, contraction off or not, and the bits would be others
/// there.
using Lane = Batch<4>;
double number(const Lane& x) {
  return lane(x, 0);
}
Direction unit_vector(const Lane& a, const Lane& b) {
  const Lane over = 1.0 / sqrt(a * a + b * b);
  return {number(over * a), number(over * b)};
}

/// Between two directions: `share` of the way along their chord.
Direction part_way(const Direction& from, const Direction& to, double share) {
  return unit_vector(Lane(from.a) + share * (Lane(to.a) - Lane(from.a)),
                     Lane(from.b) + share * (Lane(to.b) - Lane(from.b)));
}

/// Turned forth by an angle with this tangent.
Direction turned(const Direction& n, double tangent) {
  return unit_vector(Lane(n.a) - tangent * Lane(n.b), Lane(n.b) + tangent * Lane(n.a));
}

/// Of half a turn / Wrinkling's number of directions.
constexpr double tangent_of_a_step = 0.26794919243112270647;

/// What waves across a direction n do: they take up the strain beta n n.
struct Waves {
  double beta = 0.0;    ///< that leaves no stress along n; not below 0 [1]
  double relief = 0.0;  ///< energy that they save, twice [stress]
  double shear = 0.0;   ///< stress between n and t that is left [stress]
  double slope = 0.0;   ///< by which that grows as n turns towards t, where beta is above 0 [stress]
  double along = 0.0;   ///< stress along t that is left [stress]

  Waves(const SheetModuli& moduli, const AxesTensor& stress, const Direction& n) {
    struct Tensor {
      Lane a, b, ab;
    };
    const Lane aa = Lane(n.a) * Lane(n.a), bb = Lane(n.b) * Lane(n.b), ab = Lane(n.a) * Lane(n.b), wide = aa - bb;
    const auto stress_of = [&](const Lane& a, const Lane& b, const Lane& shear_strain) {
      return Tensor{moduli.aa * a + moduli.ab * b, moduli.ab * a + moduli.bb * b, moduli.shear * shear_strain};
    };
    const auto shear_of = [&](const Tensor& s) { return ab * (s.b - s.a) + wide * s.ab; };
    // Its change as n turns.
    const auto turned_shear_of = [&](const Tensor& s) { return wide * (s.b - s.a) - 4.0 * ab * s.ab; };
    const Tensor whole{Lane(stress.a), Lane(stress.b), Lane(stress.ab)};
    const Tensor own = stress_of(aa, bb, 2.0 * ab);  // of n n
    const Lane across = aa * whole.a + bb * whole.b + 2.0 * ab * whole.ab;
    const Lane over_stiffness = 1.0 / (aa * own.a + bb * own.b + 2.0 * ab * own.ab);
    const Lane taken_up = max(-across * over_stiffness, Lane(0.0));
    const Tensor left{whole.a + taken_up * own.a, whole.b + taken_up * own.b, whole.ab + taken_up * own.ab};
    const Lane own_shear = shear_of(own);
    const Lane turned_beta = -over_stiffness * (2.0 * shear_of(whole) + 4.0 * taken_up * own_shear);
    const Tensor turned_own = stress_of(-2.0 * ab, 2.0 * ab, 2.0 * wide);
    beta = number(taken_up);
    relief = number(-across * taken_up);
    shear = number(shear_of(left));
    slope = number(turned_shear_of(left) + turned_beta * own_shear + taken_up * shear_of(turned_own));
    along = number(bb * left.a + aa * left.b - 2.0 * ab * left.ab);
  }
};

/// Direction of the least principal stress.
Direction direction_of_least(const AxesTensor& stress) {
  const Lane half = 0.5 * (Lane(stress.a) - Lane(stress.b)), ab(stress.ab), radius = sqrt(half * half + ab * ab);
  if (number(radius) == 0.0) return {1.0, 0.0};
  // An eigenvector by the row that does not vanish.
  return number(half) < 0.0 ? unit_vector(radius - half, -ab) : unit_vector(-ab, radius + half);
}

}  // namespace

SheetModuli Fabric::fabric_moduli() const {
  return sheet_moduli(young_a, young_b, poisson_ba, shear_ab, 1.0 - liner_share);
}

SheetModuli Fabric::liner_moduli() const {
  const double shear = liner_young / (2.0 * (1.0 + liner_poisson));
  return liner_share > 0.0 ? sheet_moduli(liner_young, liner_young, liner_poisson, shear, liner_share) : SheetModuli{};
}

double Fabric::wave_modulus() const {
  const SheetModuli f = fabric_moduli(), l = liner_moduli();
  return fastest_wave_modulus({{{f.aa + l.aa, f.ab + l.ab, 0.0}, {f.ab + l.ab, f.bb + l.bb, 0.0}, {0.0, 0.0, 0.0}}},
                              f.shear + l.shear, 0.0, 0.0);
}

Wrinkling::Wrinkling(const SheetModuli& moduli) : moduli_(moduli) {
  // Not by cosines: these may come from the compiler in one program and from its library in another.
  static_assert(tried == 12);
  Direction n{1.0, 0.0};
  for (Tried& t : tried_) {
    const Lane aa = Lane(n.a) * Lane(n.a), bb = Lane(n.b) * Lane(n.b), ab2 = 2.0 * Lane(n.a) * Lane(n.b);
    const Lane stiffness =
        aa * (moduli.aa * aa + moduli.ab * bb) + bb * (moduli.ab * aa + moduli.bb * bb) + ab2 * (moduli.shear * ab2);
    t = {n.a, n.b, number(aa), number(bb), number(ab2), number(1.0 / stiffness)};
    n = turned(n, tangent_of_a_step);
  }
}

Direction Wrinkling::within_a_step(const AxesTensor& stress, const Direction& best, double enough) const {
  Waves waves(moduli_, stress, best);
  // The relief grows as long as the shear is below 0.
  const bool beyond = waves.shear < 0.0;
  const Direction before = turned(best, -tangent_of_a_step), behind = turned(best, tangent_of_a_step);
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
    const Direction next = turned(n, -waves.shear / waves.slope);
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
      fabric_(law.fabric_moduli()),
      liner_(law.liner_moduli()),
      wrinkling_(fabric_),
      no_compression_(law.no_compression),
      has_liner_(law.liner_share > 0.0),
      damping_(law.damping),
      step_share_(1.0 / std::sqrt(1.0 + 2.0 * law.damping)),
      wave_modulus_(law.wave_modulus()) {}

}  // namespace nugget::kernel
