// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "kernel/law/saturating_fit.hpp"
#include "kernel/law/viscoplastic.hpp"
#include "law_point.hpp"

// MAT_103 with the surface of Hill and back stress: strengths and ratios against what defines them, cycles against the
// closed form, a bent path against small explicit steps, the isotropic case against that of von Mises.
namespace nugget::kernel {
namespace {

constexpr double hill_degree = std::numbers::pi / 180.0, hill_E = 70000.0;

Viscoplastic hill_law(const HillAnisotropy& anisotropy) {
  return {.E = hill_E,
          .nu = 0.33,
          .yield = 200.0,
          .hardening_1 = 80.0,
          .exponent_1 = 20.0,
          .hardening_2 = 50.0,
          .exponent_2 = 3.0,
          .anisotropy = anisotropy};
}
double hill_at_rest(double e) {
  return 200.0 + 80.0 * (1.0 - std::exp(-20.0 * e)) + 50.0 * (1.0 - std::exp(-3.0 * e));
}

LayerPoint<Viscoplastic> hill_layer(const Viscoplastic& law, double angle) {
  LayerPoint<Viscoplastic> point(law);
  point.history[first_axis_field] = std::cos(angle);
  point.history[first_axis_field + 1] = std::sin(angle);
  return point;
}
SolidPoint<Viscoplastic> hill_solid(const Viscoplastic& law, const Frame3d& axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
  SolidPoint<Viscoplastic> point(law);
  start_solid_axes(point.history.data(), 1, axes);
  return point;
}
/// Turned about c by `angle`, then about its a by `tilt`.
Frame3d hill_axes(double angle, double tilt) {
  const Vec3d a{std::cos(angle), std::sin(angle), 0.0}, b{-std::sin(angle), std::cos(angle), 0.0}, c{0.0, 0.0, 1.0};
  return {a, std::cos(tilt) * b + std::sin(tilt) * c, std::cos(tilt) * c - std::sin(tilt) * b};
}

/// Adds the strain that gives `free` of the components of stress the value 0, the first being `step`: by Newton's
/// method with differences. `Tensor`s are arrays of `size` numbers here.
template <std::size_t size>
std::array<double, size> pulled(const std::function<std::array<double, size>(const std::array<double, size>&)>& stress,
                                double step) {
  std::array<double, size> strain{step};
  for (std::size_t i = 1; i < size; ++i) strain[i] = i < (size == 5 ? 2 : 3) ? -0.45 * step : 0.0;
  for (int n = 0; n < 60; ++n) {
    const auto s = stress(strain);
    double off = 0.0;
    for (std::size_t i = 1; i < size; ++i) off += std::abs(s[i]);
    if (off < 1e-8) break;
    // Columns of the answer to each free strain, eliminated with the stress at the right.
    double m[size][size + 1];
    for (std::size_t j = 1; j < size; ++j) {
      auto more = strain;
      const double h = 1e-4 * std::abs(step);
      more[j] += h;
      const auto t = stress(more);
      for (std::size_t i = 1; i < size; ++i) m[i][j] = (t[i] - s[i]) / h;
    }
    for (std::size_t i = 1; i < size; ++i) m[i][size] = s[i];
    for (std::size_t k = 1; k < size; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k; i < size; ++i)
        if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
      std::swap(m[k], m[pivot]);
      for (std::size_t i = 1; i < size; ++i) {
        if (i == k) continue;
        const double f = m[i][k] / m[k][k];
        for (std::size_t j = k; j <= size; ++j) m[i][j] -= f * m[k][j];
      }
    }
    for (std::size_t k = 1; k < size; ++k) strain[k] -= m[k][size] / m[k][k];
  }
  return strain;
}
std::array<double, 5> hill_numbers(const LayerTensor<double>& t) {
  return {t.xx, t.yy, t.xy, t.xz, t.yz};
}
std::array<double, 6> hill_numbers(const SolidTensor<double>& t) {
  return {t.xx, t.yy, t.zz, t.xy, t.yz, t.zx};
}
LayerTensor<double> hill_tensor(const std::array<double, 5>& a) {
  return {a[0], a[1], a[2], a[3], a[4]};
}
SolidTensor<double> hill_tensor(const std::array<double, 6>& a) {
  return {a[0], a[1], a[2], a[3], a[4], a[5]};
}
/// Tension along x alone by a strain `step`; gives the strain that it took.
template <class Point>
auto hill_pull(Point& point, double step) {
  using Numbers = decltype(hill_numbers(point.s));
  const auto strain = pulled<std::tuple_size_v<Numbers>>(
      [&](const Numbers& e) {
        Point copy = point;
        copy.strain(hill_tensor(e));
        return hill_numbers(copy.s);
      },
      step);
  point.strain(hill_tensor(strain));
  return strain;
}

TEST(HillFlow, LayersStretchByTheirLankfordRatios) {
  const double ratios[] = {1.8, 1.3, 2.2};
  for (const double q : {0.0, 90.0}) {
    const Viscoplastic law =
        hill_law({.ratios = {1.8, 1.3, 2.2}, .back_stress = {q, 0.5 * q}, .back_exponent = {30.0, 4.0}});
    for (int i = 0; i < 3; ++i) {
      auto point = hill_layer(law, -45.0 * i * hill_degree);  // the pull lies at 45 i degrees to a
      double thinned = 0.0, across = 0.0, along = 0.0;
      for (int k = 0; k < 40; ++k) {
        const auto before = point.s;
        const auto e = hill_pull(point, 2e-3);
        const double elastic = (point.s.xx - before.xx) / hill_E;
        along += e[0] - elastic;
        across += e[1] + 0.33 * elastic;
        thinned += point.thickness.plastic;
      }
      EXPECT_NEAR(across / thinned, ratios[i], 1e-7 * ratios[i]) << i;
      EXPECT_NEAR(along + across + thinned, 0.0, 1e-10);
    }
  }
}

TEST(HillFlow, StrengthsOfSolids) {
  const auto [F, G, H, L, M, N] = std::array{0.35, 0.6, 0.5, 1.2, 1.9, 1.6};
  const Viscoplastic law = hill_law({.constants = {F, G, H, L, M, N}});
  // Along a, b, c, and midway of a and b, of b and c: sum of the squares with their constants.
  const double turn = 90.0 * hill_degree;
  const struct {
    Frame3d axes;
    double square;
  } cases[] = {{hill_axes(0.0, 0.0), G + H},
               {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, F + H},
               {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, F + G},
               {hill_axes(0.5 * turn, 0.0), 0.25 * (F + G + 2.0 * N)},
               {{{0, 0, 1}, {std::sqrt(0.5), -std::sqrt(0.5), 0}, {std::sqrt(0.5), std::sqrt(0.5), 0}},
                0.25 * (G + H + 2.0 * L)}};
  for (const auto& c : cases) {
    auto point = hill_solid(law, c.axes);
    for (int k = 0; k < 30; ++k) hill_pull(point, 1e-3);
    EXPECT_NEAR(point.s.xx * std::sqrt(c.square), hill_at_rest(point.plastic_strain()), 1e-6);
    EXPECT_GT(point.plastic_strain(), 0.02);
  }
  // Shear alone.
  const std::array<double, 6> shears[] = {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}};
  const double doubled[] = {2.0 * N, 2.0 * L, 2.0 * M};
  for (int i = 0; i < 3; ++i) {
    auto point = hill_solid(law);
    for (int k = 0; k < 30; ++k) point.strain(2e-3 * hill_tensor(shears[i]));
    const auto s = hill_numbers(point.s);
    EXPECT_NEAR(s[3 + i] * std::sqrt(doubled[i]), hill_at_rest(point.plastic_strain()), 1e-6);
  }
}

/// Tension, then compression: effective stress of the curve and of both terms of the back stress, whatever the
/// direction; behind the turn each term goes from a towards -Q, as -Q + (a + Q) exp(-C e).
TEST(HillFlow, CyclesByTheClosedForm) {
  const std::array<double, 2> Q{90.0, 40.0}, C{35.0, 6.0};
  HillAnisotropy anisotropy{.ratios = {0.7, 1.6, 1.1}, .back_stress = Q, .back_exponent = C};
  anisotropy.constants = anisotropy.of_layers();
  const Viscoplastic law = hill_law(anisotropy);
  const double F = anisotropy.constants[0], G = anisotropy.constants[1], H = anisotropy.constants[2],
               N = anisotropy.constants[5];
  const auto cycle = [&](auto point, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double strength = std::sqrt((G + H) * c * c * c * c + (F + H) * s * s * s * s - 2.0 * H * c * c * s * s +
                                      2.0 * N * c * c * s * s);
    for (int k = 0; k < 40; ++k) hill_pull(point, 1e-3);
    const double turn = point.plastic_strain();
    double back[2], sum = 0.0;
    for (int k = 0; k < 2; ++k) sum += back[k] = Q[k] * (1.0 - std::exp(-C[k] * turn));
    EXPECT_NEAR(point.s.xx * strength, hill_at_rest(turn) + sum, 1e-6);
    // The way back begins with what is elastic.
    hill_pull(point, (-2.0 * hill_at_rest(turn) / strength + 1e-3) / hill_E);
    EXPECT_NEAR(point.plastic_strain(), turn, 1e-14);
    for (int k = 0; k < 30; ++k) hill_pull(point, -1e-3);
    const double e = point.plastic_strain();
    ASSERT_GT(e, turn + 0.02);
    sum = 0.0;
    for (int k = 0; k < 2; ++k) sum += -Q[k] + (back[k] + Q[k]) * std::exp(-C[k] * (e - turn));
    EXPECT_NEAR(point.s.xx * strength, -hill_at_rest(e) + sum, 1e-6);
  };
  for (const double angle : {0.0, 30.0 * hill_degree, 45.0 * hill_degree, 90.0 * hill_degree}) {
    cycle(hill_layer(law, -angle), angle);
    cycle(hill_solid(law, hill_axes(-angle, 0.0)), angle);
  }
}

/// A path that turns, against the rate equations in small explicit steps.
TEST(HillFlow, BentPathsFollowTheRateEquations) {
  const std::array<double, 6> k{0.35, 0.6, 0.5, 1.2, 1.9, 1.6};
  const std::array<double, 2> Q{90.0, 40.0}, C{35.0, 6.0};
  const Viscoplastic law = hill_law({.constants = k, .back_stress = Q, .back_exponent = C});
  auto point = hill_solid(law);
  const std::array<double, 6> legs[] = {
      {1, -0.4, -0.5, 0.3, 0, 0}, {-0.2, 0.5, -0.3, 0.8, 0.6, -0.4}, {-1, 0, 0.2, 0, 0.5, 0.5}};
  const double G = hill_E / 2.66, lame = hill_E * 0.33 / (1.33 * 0.34);
  std::array<double, 6> s{};
  std::array<std::array<double, 6>, 2> a{};
  double ep = 0.0;
  const auto normal = [&](const std::array<double, 6>& x, double& f) {
    const double bc = x[1] - x[2], ca = x[2] - x[0], ab = x[0] - x[1];
    f = std::sqrt(k[0] * bc * bc + k[1] * ca * ca + k[2] * ab * ab + 2 * k[3] * x[4] * x[4] + 2 * k[4] * x[5] * x[5] +
                  2 * k[5] * x[3] * x[3]);
    return std::array{(k[2] * ab - k[1] * ca) / f, (k[0] * bc - k[2] * ab) / f, (k[1] * ca - k[0] * bc) / f,
                      2 * k[5] * x[3] / f,         2 * k[3] * x[4] / f,         2 * k[4] * x[5] / f};
  };
  const auto elastic = [&](const std::array<double, 6>& e) {
    const double v = lame * (e[0] + e[1] + e[2]);
    return std::array{v + 2 * G * e[0], v + 2 * G * e[1], v + 2 * G * e[2], G * e[3], G * e[4], G * e[5]};
  };
  for (const auto& leg : legs) {
    constexpr int coarse = 400, fine = 50;
    for (int n = 0; n < coarse; ++n) {
      point.strain((0.02 / coarse) * hill_tensor(leg));
      for (int m = 0; m < fine; ++m) {
        std::array<double, 6> de = leg, x;
        for (double& one : de) one *= 0.02 / (coarse * fine);
        const auto ds = elastic(de);
        for (int i = 0; i < 6; ++i) x[i] = s[i] - a[0][i] - a[1][i];
        for (int i = 0; i < 6; ++i) s[i] += ds[i];
        for (int i = 0; i < 6; ++i) x[i] += ds[i];
        double trial;
        const auto now = normal(x, trial);
        const double y = hill_at_rest(ep);
        if (trial > y) {
          const auto cn = elastic(now);
          double slope = 80.0 * 20.0 * std::exp(-20.0 * ep) + 50.0 * 3.0 * std::exp(-3.0 * ep);
          for (int i = 0; i < 6; ++i) {
            slope += now[i] * cn[i];
            for (int t = 0; t < 2; ++t) slope += now[i] * C[t] * (Q[t] * x[i] / trial - a[t][i]);
          }
          const double increment = (trial - y) / slope;
          for (int i = 0; i < 6; ++i) {
            s[i] -= increment * cn[i];
            for (int t = 0; t < 2; ++t) a[t][i] += increment * C[t] * (Q[t] * x[i] / trial - a[t][i]);
          }
          ep += increment;
        }
      }
    }
    EXPECT_NEAR(point.plastic_strain(), ep, 1e-3 * ep);
    const auto got = hill_numbers(point.s);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(got[i], s[i], 0.5) << i;
  }
  EXPECT_GT(ep, 0.03);
}

std::vector<std::array<double, 6>> hill_path(int steps, double size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<std::array<double, 6>> path;
  std::array<double, 6> way{};
  for (int n = 0; n < steps; ++n) {
    if (n % 10 == 0)
      for (double& one : way) one = size * any(generator);
    path.push_back(way);
  }
  return path;
}

TEST(HillFlow, IsVonMisesWhereTheConstantsSaySo) {
  Viscoplastic isotropic = hill_law({});
  isotropic.anisotropy.reset();
  isotropic.viscosity = 12.0;
  isotropic.rate_exponent = 0.3;
  Viscoplastic hill = isotropic;
  hill.anisotropy.emplace();
  auto layer = hill_layer(hill, 0.4);
  LayerPoint<Viscoplastic> layer_of_mises(isotropic);
  auto solid = hill_solid(hill, hill_axes(0.7, 0.3));
  SolidPoint<Viscoplastic> solid_of_mises(isotropic);
  for (auto* point : {&layer, &layer_of_mises}) point->dt = 1e-4;
  for (auto* point : {&solid, &solid_of_mises}) point->dt = 1e-4;
  for (const auto& e : hill_path(300, 1e-3, 3)) {
    const LayerTensor<double> in_layer{e[0], e[1], e[3], e[4], e[5]};
    layer.strain(in_layer);
    layer_of_mises.strain(in_layer);
    solid.strain(hill_tensor(e));
    solid_of_mises.strain(hill_tensor(e));
    const auto a = hill_numbers(layer.s), b = hill_numbers(layer_of_mises.s);
    for (int i = 0; i < 5; ++i) ASSERT_NEAR(a[i], b[i], 1e-6);
    EXPECT_NEAR(layer.thickness.total, layer_of_mises.thickness.total, 1e-11);
    EXPECT_NEAR(layer.thickness.plastic, layer_of_mises.thickness.plastic, 1e-11);
    const auto c = hill_numbers(solid.s), d = hill_numbers(solid_of_mises.s);
    for (int i = 0; i < 6; ++i) ASSERT_NEAR(c[i], d[i], 1e-6);
  }
  EXPECT_GT(layer.plastic_strain(), 0.1);
  EXPECT_NEAR(layer.plastic_strain(), layer_of_mises.plastic_strain(), 1e-9);
  EXPECT_NEAR(solid.plastic_strain(), solid_of_mises.plastic_strain(), 1e-9);
}

/// Turning a solid and what strains it turns its stress.
TEST(HillFlow, TurnsWithTheMaterial) {
  const Viscoplastic law = hill_law(
      {.constants = {0.35, 0.6, 0.5, 1.2, 1.9, 1.6}, .back_stress = {90.0, 0.0}, .back_exponent = {35.0, 0.0}});
  auto still = hill_solid(law), turned = hill_solid(law);
  const Frame3d q = hill_axes(0.8, -0.5);
  const auto halved = [](SolidTensor<double> e) {
    e.xy *= 0.5, e.yz *= 0.5, e.zx *= 0.5;
    return e;
  };
  int n = 0;
  for (const auto& one : hill_path(100, 1e-3, 8)) {
    const SolidTensor<double> e = hill_tensor(one);
    still.strain(e);
    if (n++ < 50) {
      turned.strain(e);
      if (n == 50) turned.turn(q);
    } else {
      SolidTensor<double> r = rotated(q, halved(e));
      r.xy *= 2.0, r.yz *= 2.0, r.zx *= 2.0;
      turned.strain(r);
    }
  }
  const auto a = hill_numbers(rotated(q, still.s)), b = hill_numbers(turned.s);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(a[i], b[i], 1e-8);
  EXPECT_GT(still.plastic_strain(), 0.02);
}

/// Also by a rate of which the stress is a power so small that the rate is one of some fifty of the stress. Sabotage:
/// Newton's method without bisection where it does not get on.
TEST(HillFlow, RaisesTheStressByTheRate) {
  Viscoplastic law = hill_law({.ratios = {1.8, 1.3, 2.2}, .back_stress = {60.0, 0.0}, .back_exponent = {20.0, 0.0}});
  for (const auto& [rate, viscosity, exponent] :
       {std::array{1e-3, 25.0, 0.25}, {1.0, 25.0, 0.25}, {1e3, 25.0, 0.25}, {2e4, 1.2, 0.02}, {2e4, 25.0, 0.02}}) {
    law.viscosity = viscosity;
    law.rate_exponent = exponent;
    auto point = hill_layer(law, 0.0);
    const double step = exponent < 0.1 ? 0.04 : 1e-4;
    point.dt = step / rate;
    double before = 0.0;
    for (int k = 0; k < static_cast<int>(std::lround(0.04 / step)); ++k) {
      before = point.plastic_strain();
      hill_pull(point, step);
    }
    const double e = point.plastic_strain();
    EXPECT_NEAR(point.s.xx,
                hill_at_rest(e) + 60.0 * (1.0 - std::exp(-20.0 * e)) +
                    law.viscosity * std::pow((e - before) / point.dt, law.rate_exponent),
                1e-6);
  }
}

/// Of a table over the rate, and from far beyond the surface.
TEST(HillFlow, FollowsCurves) {
  PiecewiseLinear curves;
  curves.E = hill_E;
  curves.nu = 0.33;
  curves.rates = {1.0, 100.0};
  curves.yield = {{0, {0.0, 0.1, 1.0}, {200.0, 300.0, 350.0}}, {0, {0.0, 0.1, 1.0}, {250.0, 340.0, 400.0}}};
  const Viscoplastic law = hill_law({.constants = {0.35, 0.6, 0.4, 1.2, 1.9, 1.6}, .curves = curves});
  for (const double step : {1e-3, 0.04}) {
    auto point = hill_solid(law);  // G + H = 1
    point.dt = step / 1e4;
    for (int k = 0; k < static_cast<int>(0.08 / step); ++k) hill_pull(point, step);
    EXPECT_NEAR(point.s.xx, curves.yield[1].extrapolated(point.plastic_strain()), 1e-6);
  }
}

/// The same of the isotropic law, in steps of an explicit run. Sabotage: the range of any Cowper-Symonds effect.
TEST(HillFlow, IsotropicStressByTheRate) {
  Viscoplastic law = hill_law({});
  law.anisotropy.reset();
  for (const double exponent : {1.0, 0.2, 0.1, 0.02, 0.01, 0.003})
    for (const double viscosity : {1.2, 25.0, 200.0})
      for (const double step : {1e-5, 1e-4, 1e-3})
        for (const double rate : {1.0, 2e4}) {
          law.viscosity = viscosity;
          law.rate_exponent = exponent;
          SolidPoint<Viscoplastic> point(law);
          point.dt = step / rate;
          double before = 0.0;
          for (int k = 0; k < static_cast<int>(std::lround(0.02 / step)); ++k) {
            before = point.plastic_strain();
            point.strain(step * SolidTensor<double>{1.0, -0.4, -0.5, 0.3, 0.0, 0.0});
          }
          const double e = point.plastic_strain();
          EXPECT_NEAR(point.effective(), hill_at_rest(e) + viscosity * std::pow((e - before) / point.dt, exponent),
                      1e-6)
              << exponent << ' ' << viscosity << ' ' << step << ' ' << rate;
        }
}

/// Two terms are found again from their curve, of one there is nothing beside it, and a power is met to a percent.
TEST(SaturatingFit, ComesNearestToACurve) {
  Curve two, one, power;
  for (int i = 0; i <= 40; ++i) {
    const double e = 0.02 * i;
    for (Curve* curve : {&two, &one, &power}) curve->x.push_back(e);
    two.y.push_back(hill_at_rest(e));
    one.y.push_back(300.0 - 90.0 * std::exp(-12.0 * e));
    power.y.push_back(400.0 * std::pow(0.01 + e, 0.15));
  }
  const SaturatingFit fit = saturating_fit(two, 200.0);
  EXPECT_NEAR(fit.stress[0], 50.0, 1e-3);
  EXPECT_NEAR(fit.exponent[0], 3.0, 1e-4);
  EXPECT_NEAR(fit.stress[1], 80.0, 1e-3);
  EXPECT_NEAR(fit.exponent[1], 20.0, 1e-3);
  EXPECT_LT(fit.farthest, 1e-7);
  const SaturatingFit of_one = saturating_fit(one, 210.0);
  EXPECT_NEAR(of_one.stress[0] + of_one.stress[1], 90.0, 1e-4);
  EXPECT_LT(of_one.farthest, 1e-7);
  EXPECT_LT(saturating_fit(power, power.y.front()).farthest, 0.02);
}

// A batch gives bit for bit what its lanes give alone.
TEST(HillFlow, BatchesGiveTheBitsOfTheirLanes) {
  Viscoplastic law = hill_law(
      {.constants = {0.35, 0.6, 0.5, 1.2, 1.9, 1.6}, .back_stress = {90.0, 40.0}, .back_exponent = {35.0, 6.0}});
  law.viscosity = 12.0;
  law.rate_exponent = 0.3;
  const LawKernel<Viscoplastic> kernel(law);
  constexpr int width = lanes<NativeBatch>;
  const auto size = static_cast<std::size_t>(kernel.solid_history());
  std::vector<double> together(size * width);
  std::vector<SolidPoint<Viscoplastic>> alone;
  std::vector<std::vector<std::array<double, 6>>> path;
  for (int l = 0; l < width; ++l) {
    alone.push_back(hill_solid(law, hill_axes(0.3 * l, 0.2)));
    alone.back().dt = 1e-3;
    path.push_back(hill_path(100, l == 1 ? 1e-5 : 1e-3, 11 + l));
    for (std::size_t i = 0; i < size; ++i) together[i * width + l] = alone[l].history[i];
  }
  SolidTensor<NativeBatch> s;
  for (std::size_t n = 0; n < path[0].size(); ++n) {
    SolidTensor<NativeBatch> rate;
    for (int l = 0; l < width; ++l) {
      const SolidTensor<double> one = (1.0 / 1e-3) * hill_tensor(path[l][n]);
      set_lane(rate.xx, l, one.xx), set_lane(rate.yy, l, one.yy), set_lane(rate.zz, l, one.zz);
      set_lane(rate.xy, l, one.xy), set_lane(rate.yz, l, one.yz), set_lane(rate.zx, l, one.zx);
      alone[l].strain(hill_tensor(path[l][n]));
    }
    kernel.solid(s, rate, 1e-3, together.data());
  }
  for (int l = 0; l < width; ++l) {
    EXPECT_EQ(lane(s.xx, l), alone[l].s.xx);
    EXPECT_EQ(lane(s.yz, l), alone[l].s.yz);
    for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(together[i * width + l], alone[l].history[i]);
  }
  EXPECT_GT(alone[0].plastic_strain(), 0.01);
}

}  // namespace
}  // namespace nugget::kernel
