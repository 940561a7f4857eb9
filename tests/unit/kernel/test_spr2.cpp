// SPDX-License-Identifier: Apache-2.0
// The law of self-piercing rivets against the formulas of Hanssen et al. (2010), by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/law/spr2.hpp"

namespace nugget::kernel {
namespace {

Spr2 rivet() {
  Spr2 law;
  law.normal_force = 3000.0;
  law.shear_force = 5000.0;
  law.normal_failure = 4.0;
  law.shear_failure = 8.0;
  law.normal_peak = 0.4;
  law.shear_peak = 0.5;
  law.alpha = {0.5, 0.8, 2.0};
  law.arm = 1.5;
  return law;
}

/// Displaced step by step to `to`; the damage.
double pulled(const Spr2& law, const Spr2::Freedoms& to, int steps = 1000) {
  double damage = 0.0;
  for (int i = 1; i <= steps; ++i) {
    Spr2::Freedoms now{};
    for (std::size_t k = 0; k < 6; ++k) now[k] = to[k] * i / steps;
    damage = std::max(damage, law.effective_displacement(now, damage));
  }
  return damage;
}

// In a pure mode the force is F(d/DN), whatever ALPHA. Sabotage: DT for DN, exponent 1.
TEST(Spr2, PureModesFollowTheirCurves) {
  const Spr2 law = rivet();
  for (const double part : {0.01, 0.2, 0.399, 0.4, 0.6, 0.9}) {
    const Spr2::Freedoms tension{4.0 * part};
    const double curve = part <= 0.4 ? 1.0 - std::pow(1.0 - part / 0.4, 8) : (1.0 - part) / 0.6;
    EXPECT_NEAR(pulled(law, tension), part, 1e-14);
    EXPECT_NEAR(law.forces(tension, part)[0], 3000.0 * curve, 1e-9) << part;
    const Spr2::Freedoms sheared{0.0, 0.6 * 8.0 * part, 0.8 * 8.0 * part};
    const double shear = part <= 0.5 ? 1.0 - std::pow(1.0 - part / 0.5, 8) : (1.0 - part) / 0.5;
    const double damage = pulled(law, sheared);
    EXPECT_NEAR(damage, part, 1e-14);
    EXPECT_NEAR(law.forces(sheared, damage)[1], 0.6 * 5000.0 * shear, 1e-9) << part;
    EXPECT_NEAR(law.forces(sheared, damage)[2], 0.8 * 5000.0 * shear, 1e-9) << part;
  }
  EXPECT_GE(pulled(law, {4.0}), 1.0 - 1e-14);
  EXPECT_EQ(law.forces({4.0}, 1.0)[0], 0.0);
}

TEST(Spr2, UndamagedStiffness) {
  const Spr2 law = rivet();
  EXPECT_NEAR(law.normal_stiffness(), 3000.0 * 8.0 / (0.4 * 4.0), 1e-9);
  EXPECT_NEAR(law.forces({1e-9, 0.0, 1e-9}, 0.0)[0], 1e-9 * law.normal_stiffness(), 1e-15);
  EXPECT_NEAR(law.forces({1e-9, 0.0, 1e-9}, 0.0)[2], 1e-9 * law.shear_stiffness(), 1e-15);
}

// At atan(d_n/d_t) = 60 degrees q is 0: with all ALPHA alike h is 1/ALPHA times what it is of pure modes.
TEST(Spr2, AlphaCountsBetweenThePureModes) {
  Spr2 law = rivet();
  law.alpha = {0.8, 0.8, 0.8};
  const Spr2::Freedoms mixed{0.5 * std::sqrt(3.0), 0.5, 0.0};
  const double size = std::hypot(mixed[0] / 4.0, mixed[1] / 8.0);
  EXPECT_NEAR(pulled(law, mixed), size / 0.8, 1e-14);
  // At 45 degrees q is 1 - 27/16 + 27/32 = 5/32.
  const Spr2::Freedoms half{0.7, 0.0, 0.7};
  EXPECT_NEAR(pulled(law, half), (5.0 / 32.0 + 27.0 / 32.0 / 0.8) * std::hypot(0.7 / 4.0, 0.7 / 8.0), 1e-14);
  // ALPHA runs over the damage: from 0.5 at 0 to 0.8 at XIT to 2 at 1.
  law.alpha = {0.5, 0.8, 2.0};
  EXPECT_NEAR(law.effective_displacement(mixed, 0.0), size / 0.5, 1e-14);
  EXPECT_NEAR(law.effective_displacement(mixed, 0.25), size / 0.65, 1e-14);
  EXPECT_NEAR(law.effective_displacement(mixed, 0.75), size / 1.4, 1e-14);
}

// Back along the secant, and closing sheets press with the undamaged stiffness.
TEST(Spr2, UnloadingAndClosing) {
  const Spr2 law = rivet();
  const double damage = pulled(law, {2.4}), at = law.forces({2.4}, damage)[0];
  EXPECT_NEAR(law.forces({1.2}, damage)[0], 0.5 * at, 1e-9);
  EXPECT_EQ(pulled(law, {-1.0}), 0.0);
  EXPECT_NEAR(law.forces({-0.1}, damage)[0], -0.1 * law.normal_stiffness(), 1e-9);
}

// Moments along a beam of the sheets' distance a, M_t(x) = M_t - x N_s: a/2 f on either sheet up to XIT, all of a f on
// the first one and nothing on the second at the end. Sabotage: towards the first sheet.
TEST(Spr2, ShearMovesToTheSecondSheet) {
  const Spr2 law = rivet();
  const Spr2::Freedoms sheared{0.0, 6.0, 2.0};
  EXPECT_EQ(law.forces(sheared, 0.5)[4], 0.0);
  EXPECT_EQ(law.forces(sheared, 0.5)[5], 0.0);
  const Spr2::Freedoms f = law.forces(sheared, 0.75), late = law.forces(sheared, 1.0 - 1e-9);
  const double half = 0.5 * 1.5;
  EXPECT_NEAR(f[5] - half * f[1], -0.5 * half * f[1], 1e-9) << "on the second sheet, half the way";
  EXPECT_NEAR(f[5] + half * f[1], 1.5 * half * f[1], 1e-9) << "on the first";
  EXPECT_NEAR(f[4] + half * f[2], 0.5 * half * f[2], 1e-9);
  EXPECT_NEAR(late[5] - half * late[1], 0.0, 1e-8 * late[1]);
  EXPECT_NEAR(late[4] + half * late[2], 0.0, 1e-8 * late[2]);
}

}  // namespace
}  // namespace nugget::kernel
