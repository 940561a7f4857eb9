// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/composite_layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "law_point.hpp"

// Layers of fibres (MAT_022, 054, 055): the stresses at which each mode is met against the written indices, what they
// leave, and strains at failure.
namespace nugget::kernel {
namespace {

using Rule = CompositeLayer::Rule;

/// Carbon and epoxy, MPa.
CompositeLayer layer(Rule rule) {
  CompositeLayer l;
  l.young_a = 130e3;
  l.young_b = 9e3;
  l.young_c = 9e3;
  l.poisson_ba = 0.02;
  l.poisson_ca = 0.02;
  l.poisson_cb = 0.3;
  l.shear_ab = 4.8e3;
  l.shear_bc = 3.1e3;
  l.shear_ca = 4.2e3;
  l.take_isotropic_constants();
  l.rule = rule;
  l.tension_a = 2000.0;
  l.compression_a = 1200.0;
  l.tension_b = 50.0;
  l.compression_b = 180.0;
  l.shear_strength = 80.0;
  return l;
}

LayerPoint<CompositeLayer> point_of(const CompositeLayer& law, double degrees = 0.0) {
  LayerPoint<CompositeLayer> p(law);
  p.history[first_axis_field] = std::cos(degrees * std::numbers::pi / 180.0);
  p.history[first_axis_field + 1] = std::sin(degrees * std::numbers::pi / 180.0);
  return p;
}

/// Strain of a stress along the axes.
LayerTensor<double> strain_of(const CompositeLayer& l, double a, double b, double ab) {
  const double mixed = -l.poisson_ba / l.young_b;
  return {a / l.young_a + mixed * b, b / l.young_b + mixed * a, ab / l.shear_ab + l.shear_cube * ab * ab * ab, 0, 0};
}

/// Stresses grow in proportion, in `steps` to `most`; the largest share of it at which all still followed.
double share_at_failure(const CompositeLayer& l, double a, double b, double ab, double most, int steps = 20000,
                        bool beside_a_deleted_element = false) {
  auto p = point_of(l);
  if (beside_a_deleted_element) p.history[at(p.law.crash_front_field())] = 1.0;
  LayerTensor<double> before{};
  for (int k = 1; k <= steps; ++k) {
    const double share = most * k / steps;
    const LayerTensor<double> e = strain_of(l, share * a, share * b, share * ab);
    p.strain({e.xx - before.xx, e.yy - before.yy, e.xy - before.xy, 0, 0});
    before = e;
    const double off = std::abs(p.s.xx - share * a) + std::abs(p.s.yy - share * b) + std::abs(p.s.xy - share * ab);
    if (off > 1e-6 * (std::abs(a) + std::abs(b) + std::abs(ab)) * share || p.law.failed<double>(p.history.data()))
      return most * (k - 1) / steps;
  }
  return most;
}

/// The indices as the manuals write them, 1 at failure.
double index(const CompositeLayer& l, double a, double b, double ab) {
  const double s = l.shear_strength, square = ab * ab / (s * s);
  double shear = square;
  if (l.rule == Rule::stresses_vanish) {
    const double g = 1.0 / (2.0 * l.shear_ab), c = 0.75 * l.shear_cube;
    shear = (g * ab * ab + c * std::pow(ab, 4)) / (g * s * s + c * std::pow(s, 4));
  }
  double most = 0.0;
  const double weight = l.rule == Rule::stresses_vanish ? shear : l.shear_weight * square;
  if (a > 0.0) most = std::pow(a / l.tension_a, 2) + weight;
  if (a < 0.0 && l.rule != Rule::stresses_vanish) most = std::pow(a / l.compression_a, 2);
  double matrix = 0.0;
  if (l.rule == Rule::tsai_wu)
    matrix = b * b / (l.compression_b * l.tension_b) + square +
             (l.compression_b - l.tension_b) * b / (l.compression_b * l.tension_b);
  else if (b >= 0.0)
    matrix = std::pow(b / l.tension_b, 2) + shear;
  else
    matrix =
        std::pow(b / (2.0 * s), 2) + (std::pow(l.compression_b / (2.0 * s), 2) - 1.0) * b / l.compression_b + shear;
  return std::max(most, matrix);
}

// Beside a deleted element every strength is SOFT times what it is elsewhere, so that stresses in proportion go as far.
// Sabotage: one of the strengths as it was; SOFT everywhere.
TEST(CompositeLayer, IsWeakerBesideADeletedElement) {
  for (const Rule rule : {Rule::stresses_stay, Rule::tsai_wu}) {
    CompositeLayer law = layer(rule);
    law.shear_weight = 0.5;
    law.soft = 0.6;
    for (const auto& [a, b, ab] :
         {std::array{1.0, 0.0, 0.0}, std::array{-1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0}, std::array{0.0, -1.0, 0.0},
          std::array{0.0, 0.0, 1.0}, std::array{0.3, 0.02, 0.02}, std::array{-0.3, -0.1, 0.03}}) {
      const double elsewhere = share_at_failure(law, a, b, ab, 4000.0),
                   beside = share_at_failure(law, a, b, ab, 4000.0, 20000, true);
      EXPECT_NEAR(beside, 0.6 * elsewhere, 0.4) << a << ' ' << b << ' ' << ab;
    }
  }
  EXPECT_EQ(LawKernel<CompositeLayer>(layer(Rule::stresses_stay)).crash_front_field(), 0);
}

TEST(CompositeLayer, IsOrthotropicUntilItFails) {
  const CompositeLayer law = layer(Rule::stresses_stay);
  auto p = point_of(law, 25.0);
  LayerPoint<Orthotropic> reference(law);
  std::copy(p.history.begin(), p.history.end(), reference.history.begin());
  const LayerTensor<double> step{3e-5, -2e-5, 4e-5, 1e-5, -2e-5};
  for (int k = 0; k < 10; ++k) {
    p.strain(step);
    reference.strain(step);
  }
  for (const auto& [own, other] : {std::pair{p.s.xx, reference.s.xx},
                                   {p.s.yy, reference.s.yy},
                                   {p.s.xy, reference.s.xy},
                                   {p.s.xz, reference.s.xz},
                                   {p.s.yz, reference.s.yz},
                                   {p.thickness.total, reference.thickness.total}})
    EXPECT_NEAR(own, other, 1e-12 * std::abs(other));
}

// Sabotage: SC for 2 SC; Tsai and Wu's linear term with the other sign; T without ALPH; BETA left out.
TEST(CompositeLayer, ModesAreMetWhereTheIndicesSay) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> chance(-1.0, 1.0);
  for (const Rule rule : {Rule::stresses_vanish, Rule::stresses_stay, Rule::tsai_wu})
    for (int k = 0; k < 40; ++k) {
      CompositeLayer law = layer(rule);
      law.shear_weight = k % 2 == 0 ? 0.0 : 0.7;
      law.shear_cube = k % 3 == 0 ? 0.0 : 3e-9;
      const double a = 2000.0 * chance(engine), b = 180.0 * chance(engine), ab = 100.0 * chance(engine);
      // The first share of this stress at which an index is 1.
      double share = 1e-3;
      while (index(law, share * a, share * b, share * ab) < 1.0 && share < 40.0) share += 1e-5;
      if (share >= 40.0) continue;
      EXPECT_NEAR(share_at_failure(law, a, b, ab, 1.3 * share), share, 2e-4 * share)
          << static_cast<int>(rule) << ": " << a << " " << b << " " << ab;
    }
}

TEST(CompositeLayer, StrengthsAlongAndAcross) {
  for (const Rule rule : {Rule::stresses_vanish, Rule::stresses_stay, Rule::tsai_wu}) {
    const CompositeLayer law = layer(rule);
    EXPECT_NEAR(share_at_failure(law, 1, 0, 0, 2100), 2000.0, 0.2);
    EXPECT_NEAR(share_at_failure(law, 0, 1, 0, 60), 50.0, 0.01);
    EXPECT_NEAR(share_at_failure(law, 0, -1, 0, 200), 180.0, 0.02);
    EXPECT_NEAR(share_at_failure(law, 0, 0, 1, 100), 80.0, 0.01);
    if (rule == Rule::stresses_vanish) continue;  // it has no such strength
    EXPECT_NEAR(share_at_failure(law, -1, 0, 0, 1300), 1200.0, 0.2);
  }
}

// Wade, Feraboli and Osborne's single element of MAT54: linear to the strength, level to DFAILT, then nothing; without
// DFAILT the layer goes at its strength.
TEST(CompositeLayer, FibresStayAtTheirStrengthUpToTheStrainAtFailure) {
  CompositeLayer law = layer(Rule::stresses_stay);
  law.failure_strain_t = 0.024995;  // between two steps
  law.failure_strain_c = 0.019995;
  for (const double sign : {1.0, -1.0}) {
    auto p = point_of(law);
    const double strength = sign > 0.0 ? 2000.0 : 1200.0, last = sign > 0.0 ? 0.025 : 0.02;
    for (int k = 1; k <= 3000; ++k) {
      const double strain = 1e-5 * k;
      p.uniaxial(sign * 1e-5);
      EXPECT_NEAR(p.s.xx, sign * std::min(130e3 * strain, strength), 1.5) << strain;
      EXPECT_EQ(p.law.failed<double>(p.history.data()), strain > last - 1e-9) << strain;
      if (strain > last - 1e-9) break;
    }
  }
  CompositeLayer brittle = layer(Rule::stresses_stay);
  auto p = point_of(brittle);
  for (int k = 0; k < 1538; ++k) p.uniaxial(1e-5);
  EXPECT_FALSE(p.law.failed<double>(p.history.data()));
  p.uniaxial(1e-5);
  EXPECT_TRUE(p.law.failed<double>(p.history.data()));
}

TEST(CompositeLayer, OtherStrainsAtFailure) {
  CompositeLayer law = layer(Rule::stresses_stay);
  law.failure_strain_t = 0.5;
  law.failure_strain_c = 0.5;
  law.failure_strain_m = 0.03;
  law.failure_strain_s = 0.04;
  const auto steps_of = [](CompositeLayer of, const LayerTensor<double>& step) {
    auto p = point_of(of);
    int k = 0;
    while (!p.law.failed<double>(p.history.data()) && k < 100000) p.strain(step), ++k;
    return k;
  };
  EXPECT_NEAR(steps_of(law, {0, 1e-5, 0, 0, 0}), 3000, 1);
  EXPECT_NEAR(steps_of(law, {0, -1e-5, 0, 0, 0}), 3000, 1);
  EXPECT_NEAR(steps_of(law, {0, 0, 2e-5, 0, 0}), 4000, 1);  // tensorial
  law.effective_failure_strain = 0.01;
  EXPECT_NEAR(steps_of(law, {0, 0, -2e-5, 0, 0}), 1000 * std::sqrt(3.0) / 2.0, 1);
}

// The stress that a mode has stopped falls over NCYRED cycles to its share, and unloads along the elastic line.
TEST(CompositeLayer, StressesFallToTheirShare) {
  CompositeLayer law = layer(Rule::stresses_stay);
  law.left = {1.0, 1.0, 0.2, 0.6, 0.4};
  law.cycles_of_loss = 50.0;
  auto p = point_of(law);
  for (int k = 0; k < 1000; ++k) p.strain({0, 1e-5, 0, 0, 0});
  EXPECT_NEAR(p.s.yy, 0.2 * 50.0, 0.2);
  const double stress = p.s.yy;
  for (int k = 0; k < 50; ++k) p.strain({0, -1e-5, 0, 0, 0});
  EXPECT_NEAR(p.s.yy, stress - 9e3 / (1.0 - 0.02 * 0.02 * 130e3 / 9e3) * 50e-5, 1e-6);

  auto q = point_of(law);
  double before = 0.0;
  int steps = 0;
  for (int k = 0; k < 2000; ++k) {
    q.strain({0, 0, 2e-5, 0, 0});
    if (q.s.xy < before) ++steps;
    before = q.s.xy;
  }
  EXPECT_EQ(steps, 50);
  EXPECT_NEAR(q.s.xy, 0.4 * 80.0, 0.1);

  auto r = point_of(law);
  for (int k = 0; k < 4000; ++k) r.strain({0, -1e-5, 0, 0, 0});
  EXPECT_NEAR(r.s.yy, -0.6 * 180.0, 0.2);
}

// FBRT and YCFAC: fibres in a matrix that has been crushed.
TEST(CompositeLayer, CrushedMatrixWeakensFibres) {
  CompositeLayer law = layer(Rule::stresses_stay);
  law.failure_strain_t = law.failure_strain_c = 0.5;
  law.crushed_tension = 0.5;
  for (const double sign : {1.0, -1.0}) {
    auto p = point_of(law);
    for (int k = 0; k < 3000; ++k) p.strain({0, -1e-5, 0, 0, 0});
    ASSERT_NEAR(p.s.yy, -180.0, 0.2);
    for (int k = 0; k < 3000; ++k) p.strain({sign * 1e-5, 0, 0, 0, 0});
    EXPECT_NEAR(p.s.xx, sign > 0.0 ? 0.5 * 2000.0 : -2.0 * 180.0, 1.5);
  }
}

TEST(CompositeLayer, ModesOfMat22TakeTheirStresses) {
  const CompositeLayer law = layer(Rule::stresses_vanish);
  auto p = point_of(law);
  double most = 0.0;
  for (int k = 0; k < 600; ++k) {
    p.strain({1e-5, 1e-5, 2e-6, 0, 0});
    most = std::max(most, p.s.yy);
  }
  EXPECT_NEAR(most, 50.0, 0.5);
  EXPECT_EQ(p.s.yy, 0.0);
  EXPECT_NEAR(p.s.xy, 0.0, 1e-15);
  const double a = p.s.xx;
  p.strain({1e-5, 1e-5, 1e-5, 0, 0});
  EXPECT_NEAR(p.s.xx - a, 130e3 * 1e-5, 1e-9);
  EXPECT_FALSE(p.law.failed<double>(p.history.data()));

  auto q = point_of(law);  // crushed: shear goes on, to its strength
  for (int k = 0; k < 2100; ++k) q.strain({0, -1e-5, 0, 0, 0});
  for (int k = 0; k < 10; ++k) q.strain({0, -1e-5, 1e-5, 0, 0});
  EXPECT_EQ(q.s.yy, 0.0);
  EXPECT_NEAR(q.s.xy, 4.8e3 * 1e-4, 1e-9);
}

// gamma = tau / G + ALPH tau^3, there and back.
TEST(CompositeLayer, ShearFollowsItsCubic) {
  CompositeLayer law = layer(Rule::stresses_stay);
  law.shear_cube = 4e-8;
  auto p = point_of(law);
  double strain = 0.0;
  for (const double step : {1e-5, -1.3e-5})
    for (int k = 0; k < 2000; ++k) {
      p.strain({0, 0, step, 0, 0});
      strain += step;
      EXPECT_NEAR(p.s.xy / 4.8e3 + 4e-8 * std::pow(p.s.xy, 3), strain, 1e-10);
    }
}

// A batch gives bit for bit what its lanes give alone.
TEST(CompositeLayer, BatchesGiveTheBitsOfTheirLanes) {
  for (const Rule rule : {Rule::stresses_vanish, Rule::stresses_stay, Rule::tsai_wu}) {
    CompositeLayer law = layer(rule);
    law.shear_cube = 2e-9;
    law.shear_weight = 0.5;
    law.left = {0.5, 0.4, 0.3, 0.2, 0.1};
    law.failure_strain_t = rule == Rule::stresses_stay ? 0.03 : 0.0;
    law.failure_strain_m = 0.2;
    law.effective_failure_strain = 0.3;
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> chance(-4e-3, 4e-3);
    const auto increment = [&](int l) {
      const double size = l % 2 == 0 ? 1.0 : 0.01;
      return LayerTensor<double>{size * chance(engine), size * chance(engine), size * chance(engine),
                                 size * chance(engine), size * chance(engine)};
    };
    int failed = 0;
    expect_bits_of_lanes(
        law, 400, 1e-3, [&](int l) { return point_of(law, 17.0 * l); }, increment,
        [&](int, const auto& p) { failed += p.law.template failed<double>(p.history.data()); });
    EXPECT_GT(failed, 0);
  }
}

}  // namespace
}  // namespace nugget::kernel
