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

/// A direction in the plane, a unit vector.
struct Direction {
  double a, b;
};

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
  double along = 0.0;   ///< stress along t that is left [stress]

  Waves(const SheetModuli& moduli, const AxesTensor& stress, const Direction& n) {
    const double aa = n.a * n.a, bb = n.b * n.b, ab = n.a * n.b;
    const AxesTensor own = moduli.times({aa, bb, 2.0 * ab});
    across = aa * stress.a + bb * stress.b + 2.0 * ab * stress.ab;
    const double stiffness = aa * own.a + bb * own.b + 2.0 * ab * own.ab;
    beta = std::max(-across / stiffness, 0.0);
    relief = beta * beta * stiffness;
    const AxesTensor left{stress.a + beta * own.a, stress.b + beta * own.b, stress.ab + beta * own.ab};
    shear = ab * (left.b - left.a) + (aa - bb) * left.ab;
    along = bb * left.a + aa * left.b - 2.0 * ab * left.ab;
  }
};

constexpr int tried = 12;  ///< directions over half a turn

/// Directions over a little more than half a turn: a first one, `tried` of them, and the first again, turned round.
const std::array<Direction, tried + 2>& directions() {
  static const std::array<Direction, tried + 2> all = [] {
    std::array<Direction, tried + 2> made{};
    for (int i = 0; i < tried + 2; ++i) {
      const double angle = M_PI * (i - 1) / tried;
      made[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    return made;
  }();
  return all;
}

}  // namespace

double Fabric::wave_modulus() const {
  const SheetModuli f = of_fabric(*this), l = of_liner(*this);
  return fastest_wave_modulus({{{f.aa + l.aa, f.ab + l.ab, 0.0}, {f.ab + l.ab, f.bb + l.bb, 0.0}, {0.0, 0.0, 0.0}}},
                              f.shear + l.shear, 0.0, 0.0);
}

AxesTensor without_compression(const SheetModuli& moduli, const AxesTensor& strain) {
  const AxesTensor stress = moduli.times(strain);
  const double size = std::abs(stress.a) + std::abs(stress.b) + std::abs(stress.ab);
  // Steps that move nothing, of which the stiffness is made (docs/decisions/0017), meet that of the taut fabric.
  constexpr double nothing = 1e-20;
  if (std::abs(strain.a) + std::abs(strain.b) + std::abs(strain.ab) < nothing) return stress;
  if (0.5 * (stress.a + stress.b) >= std::hypot(0.5 * (stress.a - stress.b), stress.ab)) return stress;
  if (0.5 * (strain.a + strain.b) + std::hypot(0.5 * (strain.a - strain.b), 0.5 * strain.ab) <= 0.0) return {};

  // The best of some directions, then the root of the shear that is left beside it: the relief grows as long as
  // the shear is below 0.
  const auto& all = directions();
  std::size_t best = 1;
  double relief = -1.0;
  for (std::size_t i = 1; i <= tried; ++i)
    if (const double here = Waves(moduli, stress, all[i]).relief; here > relief) relief = here, best = i;
  Direction n = all[best];
  Waves waves(moduli, stress, n);
  const bool beyond = waves.shear < 0.0;
  Direction from = beyond ? n : all[best - 1], to = beyond ? all[best + 1] : n;
  const auto slope = [&](const Direction& d, double where_taut) {
    const Waves w(moduli, stress, d);
    return w.across < 0.0 ? w.shear : where_taut;
  };
  double low = slope(from, -size), high = slope(to, size);
  for (int k = 0; k < 200 && std::abs(waves.shear) > 1e-12 * size; ++k) {
    // By the secant, and by halves where that keeps one end.
    const double secant = high > low ? -low / (high - low) : 0.5;
    n = part_way(from, to, k % 3 == 2 || !(secant > 0.0 && secant < 1.0) ? 0.5 : secant);
    waves = Waves(moduli, stress, n);
    const double here = waves.across < 0.0 ? waves.shear : (beyond ? size : -size);
    (here < 0.0 ? from : to) = n;
    (here < 0.0 ? low : high) = here;
  }
  const double tension = std::max(waves.along, 0.0);
  return {tension * n.b * n.b, tension * n.a * n.a, -tension * n.a * n.b};
}

LawKernel<Fabric>::LawKernel(const Fabric& law)
    : axes_(law.axes),
      fabric_(of_fabric(law)),
      liner_(of_liner(law)),
      no_compression_(law.no_compression),
      has_liner_(law.liner_share > 0.0),
      damping_(law.damping),
      step_share_(1.0 / std::sqrt(1.0 + 2.0 * law.damping)) {}

}  // namespace nugget::kernel
