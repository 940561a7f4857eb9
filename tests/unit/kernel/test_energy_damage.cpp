// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/law/law_components.hpp"
#include "law_point.hpp"

// Damage by the elastic energy set free (MAT_105): without hardening dD/dp is constant in tension and in shear.
namespace nugget::kernel {
namespace {

constexpr double young = 210000.0, poisson = 0.3, strength = 300.0, resistance = 0.05, onset = 0.02, critical = 0.3;

ComposedLaw lemaitre() {
  PiecewiseLinear flow;
  flow.E = young;
  flow.nu = poisson;
  flow.yield = {{0, {0.0, 1.0}, {strength, strength}}};
  LawComponents law{flow};
  law.energy_damage = EnergyDamage{young, poisson, onset, resistance, critical};
  return composed_law(std::move(law));
}
/// In tension 2/3 (1 + nu) + (1 - 2 nu) / 3 = 1.
const double in_tension = strength * strength / (2.0 * young * resistance);

template <class Point>
void expect_tension(Point p, double sign) {
  const double step = sign * 1e-4;
  bool failed = false;
  for (int k = 0; k < 1200 && !failed; ++k) {
    p.uniaxial(step);
    const double strain = p.plastic_strain();
    const double damage = sign > 0.0 ? std::max(strain - onset, 0.0) * in_tension : 0.0;
    failed = p.law.template failed<double>(p.history.data());
    EXPECT_EQ(failed, damage >= critical) << strain;
    if (failed) {
      EXPECT_EQ(p.s.xx, 0.0);
      EXPECT_NEAR(strain, onset + critical / in_tension, 1e-4);
    } else if (strain > 0.0) {
      EXPECT_NEAR(p.s.xx, sign * (1.0 - damage) * strength, 1e-6 * strength) << strain;
    }
  }
  EXPECT_EQ(failed, sign > 0.0);
}

// Sabotage: damage from the first yield on, in compression, or by the stress that is left.
TEST(EnergyDamage, InTension) {
  for (const double sign : {1.0, -1.0}) {
    expect_tension(SolidPoint<ComposedLaw>(lemaitre()), sign);
    expect_tension(LayerPoint<ComposedLaw>(lemaitre()), sign);
  }
}

// Pure shear has no mean stress: 2/3 (1 + nu) of what tension has.
TEST(EnergyDamage, InShear) {
  SolidPoint<ComposedLaw> p(lemaitre());
  int k = 0;
  for (; k < 4000 && !p.law.failed<double>(p.history.data()); ++k) {
    p.strain({0, 0, 0, 1e-4, 0, 0});
    const double damage = std::max(p.plastic_strain() - onset, 0.0) * in_tension * 2.0 / 3.0 * (1.0 + poisson);
    if (damage < critical && p.plastic_strain() > 0.0) {
      EXPECT_NEAR(p.s.xy, (1.0 - damage) * strength / std::sqrt(3.0), 1e-6 * strength);
    }
  }
  EXPECT_NEAR(p.plastic_strain(), onset + critical / (in_tension * 2.0 / 3.0 * (1.0 + poisson)), 1e-4);
}

}  // namespace
}  // namespace nugget::kernel
