// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/modified_johnson_cook.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "kernel/law/law_components.hpp"
#include "law_point.hpp"

// MAT_107: its yield stress over strain, rate and temperature, and its fracture.
namespace nugget::kernel {
namespace {

ModifiedJohnsonCook weldox() {
  ModifiedJohnsonCook law;
  law.E = 210000.0;
  law.nu = 0.33;
  law.yield = 490.0;
  law.hardening = 383.0;
  law.exponent = 0.45;
  law.saturating_1 = 80.0;
  law.saturation_1 = 30.0;
  law.saturating_2 = 40.0;
  law.saturation_2 = 4.0;
  law.rate_exponent = 0.0114;
  law.reference_rate = 5e-4;
  return law;
}

// Sabotage: the logarithm of Johnson and Cook for the power; Q2 with C1.
TEST(ModifiedJohnsonCook, YieldsByStrainAndRate) {
  for (const double rate : {0.0, 1e-4, 1.0, 1e4}) {
    ModifiedJohnsonCook law = weldox();
    if (rate == 0.0) law.rate_exponent = 0.0;
    LayerPoint<ModifiedJohnsonCook> layer(law);
    SolidPoint<ModifiedJohnsonCook> solid(law);
    layer.dt = solid.dt = rate > 0.0 ? 1e-3 / rate : 1.0;
    for (int k = 0; k < 200; ++k) {
      const double of_layer = layer.plastic_strain(), of_solid = solid.plastic_strain();
      layer.uniaxial(1e-3);
      solid.uniaxial(1e-3);
      const auto expected = [&](double before, double p) {
        const double at_rest =
            490.0 + 383.0 * std::pow(p, 0.45) + 80.0 * (1.0 - std::exp(-30.0 * p)) + 40.0 * (1.0 - std::exp(-4.0 * p));
        return at_rest * std::pow(1.0 + (p - before) / layer.dt / 5e-4, law.rate_exponent);
      };
      if (k < 10) continue;
      EXPECT_NEAR(layer.s.xx, expected(of_layer, layer.plastic_strain()), 1e-6 * layer.s.xx) << rate;
      EXPECT_NEAR(solid.s.xx, expected(of_solid, solid.plastic_strain()), 1e-6 * solid.s.xx) << rate;
    }
    EXPECT_GT(layer.plastic_strain(), 0.19);
  }
}

// Without hardening and with M 1: the stress falls as exp(-A XS1 p / (RO CP (TM - TR))) from what T0 leaves of it.
TEST(ModifiedJohnsonCook, SoftensByItsHeat) {
  ModifiedJohnsonCook law;
  law.E = 210000.0;
  law.nu = 0.3;
  law.yield = 500.0;
  law.heating = 0.3;  // a MPa
  law.warmth = 0.2;   // T0 393, TR 293, TM 793
  law.melting_rise = 400.0;
  LayerPoint<ModifiedJohnsonCook> p(law);
  for (int k = 0; k < 2000; ++k) p.uniaxial(1e-4);
  EXPECT_NEAR(p.s.xx, 500.0 * 0.8 * std::exp(-500.0 * 0.3 * p.plastic_strain() / 500.0), 0.05);
}

// A fibre of a beam is heated as layers are. Sabotage: it stays cold.
TEST(ModifiedJohnsonCook, FibresSoftenByTheirHeat) {
  ModifiedJohnsonCook law;
  law.E = 210000.0;
  law.nu = 0.3;
  law.yield = 500.0;
  law.heating = 0.3;
  law.melting_rise = 500.0;
  const LawKernel<ModifiedJohnsonCook> kernel(law);
  std::vector<double> history(static_cast<std::size_t>(kernel.fibre_history()));
  FibreTensor<double> s{};
  for (int k = 0; k < 2000; ++k) kernel.fibre(s, FibreTensor<double>{1e-4, 0.0, 0.0}, 1.0, history.data());
  EXPECT_NEAR(s.rr, 500.0 * std::exp(-500.0 * 0.3 * history[0] / 500.0), 0.05);
}

/// Plastic strain at which a bar of 500 MPa without hardening fails.
double strain_at_failure(const DuctileFracture& rule, double heating = 0.0) {
  ModifiedJohnsonCook law;
  law.E = 210000.0;
  law.nu = 0.3;
  law.yield = 500.0;
  law.heating = heating;
  law.melting_rise = 1e6;
  LawComponents components{law};
  components.rules = {rule};
  SolidPoint<ComposedLaw> p(composed_law(std::move(components)));
  p.dt = 1e-3;
  for (int k = 0; k < 20000; ++k) {
    p.uniaxial(1e-4);
    if (p.law.failed<double>(p.history.data())) return p.plastic_strain();
  }
  return 0.0;
}

TEST(ModifiedJohnsonCook, Fracture) {
  DuctileFracture rule;
  rule.grows = true;
  rule.d1 = 0.1;
  rule.d2 = 0.8;
  rule.d3 = -1.5;
  rule.d4 = -0.02;
  rule.d5 = 0.4;
  rule.warmth = 0.25;
  rule.reference_rate = 1e-3;
  rule.threshold = 0.05;
  const double last = (0.1 + 0.8 * std::exp(-0.5)) * std::pow(1.0 + 0.1 / 1e-3, -0.02) * (1.0 + 0.4 * 0.25);
  EXPECT_NEAR(strain_at_failure(rule), last, 5e-4);
  DuctileFracture work;
  work.grows = work.by_work = true;
  work.work = 300.0;
  EXPECT_NEAR(strain_at_failure(work), 300.0 / 500.0, 2e-4);
  DuctileFracture hot;
  hot.last_rise = 60.0;
  EXPECT_NEAR(strain_at_failure(hot, 0.4), 60.0 / (0.4 * 500.0), 1e-3);
  DuctileFracture sheared;
  sheared.shear_strength = 249.0;  // Tresca: a half of 500
  EXPECT_LT(strain_at_failure(sheared), 1e-4);
}

// A batch gives bit for bit what its lanes give alone.
TEST(ModifiedJohnsonCook, BatchesGiveTheBitsOfTheirLanes) {
  ModifiedJohnsonCook law = weldox();
  law.heating = 0.2;
  law.melting_rise = 1500.0;
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> chance(-1.0, 1.0);
  const auto increment = [&](int l) {
    const double size = l == 1 ? 1e-6 : 2e-3;
    return LayerTensor<double>{size * chance(engine), size * chance(engine), size * chance(engine), 0, 0};
  };
  double strain = 0.0;
  expect_bits_of_lanes(
      law, 200, 1e-3, [&](int) { return LayerPoint<ModifiedJohnsonCook>(law); }, increment,
      [&](int l, const auto& p) { strain = l == 0 ? p.plastic_strain() : strain; });
  EXPECT_GT(strain, 0.05);
}

}  // namespace
}  // namespace nugget::kernel
