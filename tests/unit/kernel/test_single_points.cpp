// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>

#include "kernel/law/law_components.hpp"
#include "kernel/law/single_points.hpp"
#include "law_point.hpp"
#include "motion.hpp"

// Rubbers, foams and viscoelasticity of solids, against their closed forms.
namespace nugget::kernel {
namespace {

using Point = SolidPoint<ComposedLaw>;

/// Strain increment of the mid-step rate by which a length l becomes l + d.
double mid(double l, double d) {
  return d / (l + 0.5 * d);
}

/// Stretches along the axes, from where the point stands, in `steps` of equal changes of length.
void pull(Point& p, std::array<double, 3>& stretch, const std::array<double, 3>& to, int steps) {
  std::array<double, 3> d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = (to[i] - stretch[i]) / steps;
  for (int n = 0; n < steps; ++n) {
    p.strain({mid(stretch[0], d[0]), mid(stretch[1], d[1]), mid(stretch[2], d[2]), 0, 0, 0});
    for (std::size_t i = 0; i < 3; ++i) stretch[i] += d[i];
  }
}

MooneyRivlin mooney(double a, double b, double nu) {
  return {4.0 * (a + b) * (1.0 + nu), nu, a, b};
}

/// Cauchy stresses by the derivative of the energy over principal stretches, sigma_i = l_i / J dW/dl_i, by differences.
std::array<double, 3> by_energy(const std::function<double(double, double, double)>& W,
                                const std::array<double, 3>& l) {
  std::array<double, 3> s{};
  const double h = 1e-5, J = l[0] * l[1] * l[2];
  for (std::size_t i = 0; i < 3; ++i) {
    auto up = l, down = l;
    up[i] += h;
    down[i] -= h;
    s[i] = l[i] / J * (W(up[0], up[1], up[2]) - W(down[0], down[1], down[2])) / (2.0 * h);
  }
  return s;
}

void expect_energy(const LawComponents& law, const std::function<double(double, double, double)>& W, double gate) {
  for (const std::array<double, 3>& to : {std::array{1.8, 0.75, 0.75}, std::array{0.6, 1.28, 1.3},
                                          std::array{1.2, 1.3, 0.65}, std::array{1.0, 1.0, 1.0}}) {
    Point p(composed_law(law));
    std::array<double, 3> l{1, 1, 1};
    pull(p, l, {1.3, 0.9, 1.0}, 100);  // any way there
    pull(p, l, to, 100);
    const std::array<double, 3> s = by_energy(W, to);
    EXPECT_NEAR(p.s.xx, s[0], gate);
    EXPECT_NEAR(p.s.yy, s[1], gate);
    EXPECT_NEAR(p.s.zz, s[2], gate);
    EXPECT_NEAR(p.s.xy, 0.0, 1e-9);
  }
}

TEST(SinglePoints, MooneyRivlinIsTheDerivativeOfItsEnergy) {
  const double a = 0.8, b = 0.2, nu = 0.49, c = 0.5 * a + b,
               d = (a * (5 * nu - 2) + b * (11 * nu - 5)) / (2 * (1 - 2 * nu));
  const auto W = [=](double x, double y, double z) {
    const double first = x * x + y * y + z * z, third = x * x * y * y * z * z;
    const double second = x * x * y * y + y * y * z * z + z * z * x * x;
    return a * (first - 3) + b * (second - 3) + c * (1 / (third * third) - 1) + d * (third - 1) * (third - 1);
  };
  expect_energy({mooney(a, b, nu)}, W, 1e-6);
}

BlatzKo blatz_ko(double G) {
  return {2.0 * G * 1.463, 0.463, G};
}

TEST(SinglePoints, BlatzKoIsTheDerivativeOfItsEnergy) {
  const double G = 0.5, beta = 0.463 / (1 - 2 * 0.463);
  const auto W = [=](double x, double y, double z) {
    return 0.5 * G * (x * x + y * y + z * z - 3 + (std::pow(x * y * z, -2 * beta) - 1) / beta);
  };
  expect_energy({blatz_ko(G)}, W, 1e-6);
}

TEST(SinglePoints, OgdenIsTheDerivativeOfItsEnergy) {
  // Treloar's rubber in Ogden's three terms.
  const std::vector<Ogden::Term> terms{{0.63, 1.3}, {0.0012, 5.0}, {-0.01, -2.0}};
  double G = 0.0;
  for (const Ogden::Term& t : terms) G += 0.5 * t.mu * t.alpha;
  const double nu = 0.49, K = 2 * G * (1 + nu) / (3 * (1 - 2 * nu));
  const auto W = [=](double x, double y, double z) {
    const double J = x * y * z, s = 1 / std::cbrt(J);
    double w = K * (J - 1 - std::log(J));
    for (const Ogden::Term& t : terms)
      w += t.mu / t.alpha * (std::pow(s * x, t.alpha) + std::pow(s * y, t.alpha) + std::pow(s * z, t.alpha) - 3);
    return w;
  };
  expect_energy({Ogden{2 * G * (1 + nu), nu, terms, {}}}, W, 1e-6);
}

PolynomialRubber polynomial(double nu) {
  PolynomialRubber law;
  law.c10 = 0.3, law.c01 = 0.1, law.c11 = 0.02, law.c20 = -0.03, law.c02 = 0.01, law.c30 = 0.05;
  law.nu = nu;
  law.E = 2.0 * 2.0 * (law.c10 + law.c01) * (1.0 + nu);
  return law;
}

// Sabotage: J1 to the power 2/3 of J instead of -2/3; W11 without C30.
TEST(SinglePoints, ThePolynomialRubberIsTheDerivativeOfItsEnergy) {
  const PolynomialRubber r = polynomial(0.49);
  const double K = r.E / (3 * (1 - 2 * r.nu));
  const auto W = [=](double x, double y, double z) {
    const double J = x * y * z, c = std::pow(J, -2.0 / 3.0);
    const double a = c * (x * x + y * y + z * z) - 3, b = c * c * (x * x * y * y + y * y * z * z + z * z * x * x) - 3;
    return r.c10 * a + r.c01 * b + r.c11 * a * b + r.c20 * a * a + r.c02 * b * b + r.c30 * a * a * a +
           K * (J - 1 - std::log(J));
  };
  expect_energy({r}, W, 1e-6);
}

TEST(SinglePoints, RubberIsElasticAtSmallStrains) {
  const double nu = 0.45;
  const Ogden ogden{2 * 0.5 * (1 + nu), nu, {{0.5, 2.0}}, {}};
  PolynomialRubber quarter;
  quarter.c10 = 0.2, quarter.c01 = 0.05, quarter.c20 = 3.0, quarter.nu = nu, quarter.E = 1.0 * (1 + nu);
  for (const LawComponents& law : {LawComponents{mooney(0.2, 0.05, nu)}, LawComponents{ogden}, LawComponents{quarter}})
    for (const double size : {1e-12, 1e-5}) {
      Point p(composed_law(law));
      SolidPoint<Elastic> e(Elastic{1.0 * (1 + nu), nu});
      p.strain({size, -0.2 * size, 0.1 * size, size, 0.3 * size, 0});
      e.strain({size, -0.2 * size, 0.1 * size, size, 0.3 * size, 0});
      EXPECT_NEAR(p.s.xx / size, e.s.xx / size, 1e-3);
      EXPECT_NEAR(p.s.yy / size, e.s.yy / size, 1e-3);
      EXPECT_NEAR(p.s.xy / size, e.s.xy / size, 1e-3);
    }
}

TEST(SinglePoints, RubberInSimpleShear) {
  // Neo-Hookean and Mooney: tau = 2 (A + B) g at constant volume; normal stress difference 2 (A + B) g^2.
  const double a = 0.8, b = 0.2;
  Point p(composed_law({mooney(a, b, 0.45)}));
  // v_x = g y: rate of strain g/2 and spin g/2 together, as a brick applies them.
  const double dg = 1e-3;
  for (int i = 0; i < 1000; ++i) {
    const double q = 0.5 * dg;
    const double h = 0.5 * q, s = 2.0 / (1.0 + h * h);  // Cayley of the spin
    const Frame3d turn{{1.0 - s * h * h, s * h, 0}, {-s * h, 1.0 - s * h * h, 0}, {0, 0, 1}};
    p.turn(turn);
    p.strain({0, 0, 0, dg, 0, 0});
  }
  EXPECT_NEAR(p.s.xy, 2.0 * (a + b), 2e-3);
  EXPECT_NEAR(p.s.xx - p.s.yy, 2.0 * (a + b), 4e-3);
}

TEST(SinglePoints, TheStableStepKnowsTheStiffnessReached) {
  // Wave modulus at least the tangent of a laterally held pull.
  for (const LawComponents& law :
       {LawComponents{mooney(0.8, 0.2, 0.49)}, LawComponents{polynomial(0.3)}, LawComponents{blatz_ko(1.0)}})
    for (const double to : {0.4, 0.7, 1.0, 1.4, 2.5}) {
      Point p(composed_law(law));
      std::array<double, 3> l{1, 1, 1};
      pull(p, l, {to, 1.0, 1.0}, 50);
      const double wave = p.wave_modulus(), before = p.s.xx;
      p.strain({1e-6, 0, 0, 0, 0, 0});
      EXPECT_GE(wave, (p.s.xx - before) / 1e-6 * 0.999) << to;
    }
}

// Sabotage: G instead of 2 G; the decay of the first term for both.
TEST(SinglePoints, RubberRelaxes) {
  // Both energies with two viscous terms, sheared at a constant rate and held: what is more than without the terms is
  // sum GI g' (1 - exp(-beta t)) / beta, then decays.
  const Overstress viscous{{{3.0, 100.0}, {5.0, 700.0}}, 0.0, 0.0};
  PolynomialRubber polynomial_with = polynomial(0.49);
  polynomial_with.overstress = viscous;
  const Ogden ogden{3.0, 0.49, {{1.0, 2.0}}, {}}, ogden_with{3.0, 0.49, {{1.0, 2.0}}, viscous};
  const std::pair<LawComponents, LawComponents> pairs[] = {{{polynomial(0.49)}, {polynomial_with}},
                                                           {{ogden}, {ogden_with}}};
  for (const auto& [without, with] : pairs) {
    Point a(composed_law(without)), b(composed_law(with));
    EXPECT_NEAR(b.wave_modulus() - a.wave_modulus(), 4.0 / 3.0 * 8.0, 1e-9);
    a.dt = b.dt = 1e-4;
    const double rate = 2.0, t = 0.01;
    const auto step = [&](double g) {
      a.strain({0, 0, 0, g * a.dt, 0, 0});
      b.strain({0, 0, 0, g * b.dt, 0, 0});
    };
    for (int i = 0; i < 100; ++i) step(rate);
    double more = 0.0, left = 0.0;
    for (const auto& [G, beta] : viscous.maxwell_branches) {
      const double grown = G * rate * (1.0 - std::exp(-beta * t)) / beta;
      more += grown;
      left += grown * std::exp(-beta * t);
    }
    EXPECT_NEAR(b.s.xy - a.s.xy, more, 1e-10);
    EXPECT_NEAR(b.s.xx - a.s.xx, 0.0, 1e-10);
    for (int i = 0; i < 100; ++i) step(0.0);
    EXPECT_NEAR(b.s.xy - a.s.xy, left, 1e-10);
  }
}

// Sabotage: the limit on the shear stress instead of the effective one.
TEST(SinglePoints, FrictionInRubberIsALoopOfTheSameSizeAtAnyRate) {
  PolynomialRubber with = polynomial(0.49);
  with.overstress.friction_shear = 40.0;
  with.overstress.friction_limit = 0.09;
  for (const double dt : {1.0, 1e-3}) {
    Point a(composed_law({polynomial(0.49)})), b(composed_law({with}));
    a.dt = b.dt = dt;
    const auto shear = [&](double by, int steps) {
      for (int i = 0; i < steps; ++i) {
        a.strain({0, 0, 0, by / steps, 0, 0});
        b.strain({0, 0, 0, by / steps, 0, 0});
      }
      return b.s.xy - a.s.xy;
    };
    const double most = 0.09 / std::sqrt(3.0);
    EXPECT_NEAR(shear(0.001, 10), 40.0 * 0.001, 1e-10);  // spring
    EXPECT_NEAR(shear(0.099, 200), most, 1e-10);         // slides
    EXPECT_NEAR(shear(-0.002, 20), most - 40.0 * 0.002, 1e-10);
    EXPECT_NEAR(shear(-0.1, 200), -most, 1e-10);
  }
}

LowDensityFoam foam() {
  LowDensityFoam law;
  law.E = 2.0;
  law.compression = Curve{0, {0.0, 0.05, 0.5, 0.7, 0.8}, {0.0, 0.1, 0.15, 0.4, 1.2}};
  return law;
}

TEST(SinglePoints, LowDensityFoamFollowsItsCurve) {
  Point p(composed_law({foam()}));
  std::array<double, 3> l{1, 1, 1};
  for (const double to : {0.97, 0.7, 0.4, 0.15, 0.6, 1.0}) {
    pull(p, l, {to, 1.0, 1.0}, 200);
    EXPECT_NEAR(p.s.xx, -foam().compression.extrapolated(1.0 - to), 1e-9) << to;  // nominal is true: no contraction
    EXPECT_NEAR(p.s.yy, 0.0, 1e-12);
  }
  pull(p, l, {1.5, 1.0, 1.0}, 100);
  EXPECT_NEAR(p.s.xx, 2.0 * 0.5, 1e-9);
  // Pressed in two directions: the force on a face is that of its own curve, the face is smaller.
  pull(p, l, {0.5, 0.8, 1.0}, 200);
  EXPECT_NEAR(p.s.xx, -0.15 / 0.8, 1e-9);
  EXPECT_NEAR(p.s.yy, -foam().compression.extrapolated(0.2) / 0.5, 1e-9);
}

TEST(SinglePoints, LowDensityFoamUnloadsAlongAnotherPath) {
  LowDensityFoam law = foam();
  law.unloading = 0.1;
  law.shape = 2.0;
  Point p(composed_law({law}));
  std::array<double, 3> l{1, 1, 1};
  pull(p, l, {0.3, 1.0, 1.0}, 200);
  const auto area = [&](double x) {  // plainly, by the midpoint rule
    double sum = 0.0;
    for (int i = 0; i < 10000; ++i) sum += law.compression.extrapolated(x * (i + 0.5) / 10000) * x / 10000;
    return sum;
  };
  EXPECT_NEAR(p.s.xx, -0.4, 1e-9);
  pull(p, l, {0.6, 1.0, 1.0}, 200);
  const double left = 0.1 + 0.9 * std::pow(area(0.4) / area(0.7), 2.0);
  EXPECT_NEAR(p.s.xx, -left * law.compression.extrapolated(0.4), 1e-6);
  pull(p, l, {0.25, 1.0, 1.0}, 200);  // loading again beyond where it was
  EXPECT_NEAR(p.s.xx, -law.compression.extrapolated(0.75), 1e-9);
}

TEST(SinglePoints, LowDensityFoamTears) {
  for (const bool tension_failure : {false, true}) {
    LowDensityFoam law = foam();
    law.cutoff = 0.3;
    law.tension_failure = tension_failure;
    Point p(composed_law({law}));
    std::array<double, 3> l{1, 1, 1};
    pull(p, l, {1.1, 1.0, 1.0}, 100);
    EXPECT_NEAR(p.s.xx, 0.2, 1e-9);
    pull(p, l, {1.2, 1.0, 1.0}, 100);
    EXPECT_NEAR(p.s.xx, tension_failure ? 0.0 : 0.3, 1e-9);
    pull(p, l, {1.1, 1.0, 1.0}, 100);
    EXPECT_NEAR(p.s.xx, tension_failure ? 0.0 : 0.2, 1e-9);
    pull(p, l, {0.95, 1.0, 1.0}, 100);
    EXPECT_NEAR(p.s.xx, -0.1, 1e-9);
  }
}

TEST(SinglePoints, CrushableFoamYieldsByVolumeAndDoesNotRecover) {
  CrushableFoam law;
  law.E = 50.0;
  law.yield = Curve{0, {0.0, 0.4, 0.8}, {0.5, 0.7, 20.7}};
  law.cutoff = 0.2;
  Point p(composed_law({law}));
  std::array<double, 3> l{1, 1, 1};
  pull(p, l, {0.995, 1.0, 1.0}, 10);
  EXPECT_NEAR(p.s.xx, 50.0 * std::log(0.995), 1e-6);
  pull(p, l, {0.5, 1.0, 1.0}, 500);
  EXPECT_NEAR(p.s.xx, -law.yield.extrapolated(0.5), 1e-6);
  EXPECT_NEAR(p.s.yy, 0.0, 1e-12);
  const double pressed = p.s.xx;
  pull(p, l, {0.505, 1.0, 1.0}, 10);
  EXPECT_NEAR(p.s.xx, pressed + 50.0 * std::log(0.505 / 0.5), 1e-6);  // elastic way back
  pull(p, l, {0.7, 1.0, 1.0}, 100);
  EXPECT_NEAR(p.s.xx, 0.2, 1e-9);  // the cutoff
  // In shear: principal stresses +- tau, tension cut off at 0.2.
  Point q(composed_law({law}));
  for (int i = 0; i < 500; ++i) q.strain({0, 0, 0, 1e-4, 0, 0});
  const Principal axes = principal_axes(q.s);
  EXPECT_NEAR(axes.value[2], 0.2, 1e-9);
  EXPECT_NEAR(axes.value[0], -0.5, 1e-9);
}

TEST(SinglePoints, ViscoelasticRelaxation) {
  const double K = 2000.0, G0 = 50.0, G1 = 10.0, beta = 100.0;
  const Viscoelastic law{9 * K * G0 / (3 * K + G0), (3 * K - 2 * G0) / (6 * K + 2 * G0), K, G0, G1, beta};
  for (const double dt : {1e-5, 2e-3}) {  // exact for any step
    Point p(composed_law({law}));
    p.dt = dt;
    // A constant rate of shear g: tau = GI g t + (G0 - GI) g (1 - exp(-beta t)) / beta.
    const int steps = static_cast<int>(std::lround(0.02 / dt));
    for (int i = 0; i < steps; ++i) p.strain({0, 0, 0, 0.5 * dt, 0, 0});
    const double relaxing = 0.5 * (1 - std::exp(-beta * 0.02)) / beta;
    EXPECT_NEAR(p.s.xy, G1 * 0.5 * 0.02 + (G0 - G1) * relaxing, 1e-9);
    // Held: GI g + what decays.
    for (int i = 0; i < steps; ++i) p.strain({});
    EXPECT_NEAR(p.s.xy, G1 * 0.5 * 0.02 + (G0 - G1) * relaxing * std::exp(-beta * 0.02), 1e-9);
    Point q(composed_law({law}));
    q.dt = dt;
    q.strain({1e-3, 1e-3, 1e-3, 0, 0, 0});
    for (int i = 0; i < 100; ++i) q.strain({});
    EXPECT_NEAR(q.s.xx, 3e-3 * K, 1e-9);  // volume does not relax
  }
}

TEST(SinglePoints, PrincipalAxes) {
  Random random;
  for (int i = 0; i < 50; ++i) {
    const SolidTensor<double> a{random(), random(), random(), random(), random(), random()};
    const SolidTensor<double> same = with_values(principal_axes(a), principal_axes(a).value);
    EXPECT_NEAR(same.xx, a.xx, 1e-14);
    EXPECT_NEAR(same.xy, a.xy, 1e-14);
    EXPECT_NEAR(same.zx, a.zx, 1e-14);
  }
}

// ---- layers of shells

using Layer = LayerPoint<ComposedLaw>;

/// Stretches of the plane, from 1, in `steps` steps of mid-step rates; returns the thickness.
double pull(Layer& p, const std::array<double, 2>& to, int steps) {
  std::array<double, 2> l{1, 1}, d{(to[0] - 1) / steps, (to[1] - 1) / steps};
  double thickness = 1.0;
  for (int n = 0; n < steps; ++n) {
    p.strain({mid(l[0], d[0]), mid(l[1], d[1]), 0, 0, 0});
    const double e = p.thickness.total;
    thickness *= (1 + 0.5 * e) / (1 - 0.5 * e);  // as the stretch of a step is taken
    for (std::size_t i = 0; i < 2; ++i) l[i] += d[i];
  }
  return thickness;
}

/// The stretch through the thickness at which an energy leaves no stress there, by halving an interval.
double free_thickness(const std::function<double(double, double, double)>& W, double x, double y) {
  double low = 0.05, high = 5.0;
  for (int i = 0; i < 200; ++i) {
    const double z = 0.5 * (low + high);
    (by_energy(W, {x, y, z})[2] < 0.0 ? low : high) = z;
  }
  return low;
}

constexpr std::array<std::array<double, 2>, 6> plane_stretches{
    {{1.8, 0.75}, {1.5, 1.5}, {2.0, 1.0}, {0.7, 1.2}, {0.8, 0.8}, {1.0, 1.0}}};

// Sabotage: the thickness kept; the strain through the thickness of the last step.
TEST(SinglePoints, LayersOfRubberHaveNoStressThroughTheThickness) {
  const double a = 0.8, b = 0.2, nu = 0.49, c = 0.5 * a + b,
               d = (a * (5 * nu - 2) + b * (11 * nu - 5)) / (2 * (1 - 2 * nu));
  const auto W = [=](double x, double y, double z) {
    const double first = x * x + y * y + z * z, third = x * x * y * y * z * z;
    const double second = x * x * y * y + y * y * z * z + z * z * x * x;
    return a * (first - 3) + b * (second - 3) + c * (1 / (third * third) - 1) + d * (third - 1) * (third - 1);
  };
  for (const auto& [x, y] : plane_stretches) {
    Layer p(composed_law({mooney(a, b, nu)}));
    const double thickness = pull(p, {x, y}, 200), z = free_thickness(W, x, y);
    const std::array<double, 3> s = by_energy(W, {x, y, z});
    EXPECT_NEAR(p.s.xx, s[0], 1e-6) << x << ' ' << y;
    EXPECT_NEAR(p.s.yy, s[1], 1e-6) << x << ' ' << y;
    EXPECT_NEAR(thickness, z, 1e-8) << x << ' ' << y;
  }
}

// Textbook: at constant volume (nu 0.4999) sigma_i = 2 (l_i^2 - l_3^2) (A + B l_j^2) in the plane.
TEST(SinglePoints, LayersOfMooneysRubberPulledInOneAndTwoDirections) {
  const double a = 0.8, b = 0.2;
  for (const auto& [x, y] : plane_stretches) {
    Layer p(composed_law({mooney(a, b, 0.4999)}));
    pull(p, {x, y}, 200);
    const double z2 = 1.0 / (x * x * y * y);
    EXPECT_NEAR(p.s.xx, 2 * (x * x - z2) * (a + b * y * y), 4e-3) << x << ' ' << y;
    EXPECT_NEAR(p.s.yy, 2 * (y * y - z2) * (a + b * x * x), 4e-3) << x << ' ' << y;
  }
}

TEST(SinglePoints, LayersOfRubberKnowTheStiffnessReachedInTheirPlane) {
  for (const LawComponents& law : {LawComponents{mooney(0.8, 0.2, 0.49)}, LawComponents{polynomial(0.49)},
                                   LawComponents{blatz_ko(1.0)}, LawComponents{Ogden{3.0, 0.49, {{0.3, 5.0}}, {}}}})
    for (const auto& [x, y] : plane_stretches) {
      Layer p(composed_law(law));
      pull(p, {x, y}, 50);
      const double wave = p.law.elastic().plane * p.stiffening();
      Layer along = p, across = p, sheared = p;
      along.strain({1e-6, 0, 0, 0, 0});
      across.strain({0, 1e-6, 0, 0, 0});
      sheared.strain({0, 0, 1e-6, 0, 0});
      EXPECT_GE(wave, (along.s.xx - p.s.xx) / 1e-6 * 0.999) << x << ' ' << y;
      EXPECT_GE(wave, (across.s.yy - p.s.yy) / 1e-6 * 0.999) << x << ' ' << y;
      EXPECT_GE(wave, (sheared.s.xy - p.s.xy) / 1e-6 * 0.999) << x << ' ' << y;
    }
}

// ---- rubber by a test curve

/// The nominal stress of a bar over its nominal strain, of its true stress.
Curve test_of(const std::function<double(double)>& true_stress, double from, double to) {
  Curve curve;
  const double step = 0.002;
  for (int i = static_cast<int>(std::lround(from / step)); i <= std::lround(to / step); ++i) {
    curve.x.push_back(step * i);
    curve.y.push_back(true_stress(1.0 + step * i) / (1.0 + step * i));
  }
  return curve;
}

TabulatedRubber tabulated(const Curve& test) {
  const double G = test.slope(0.0) / 3.0, K = 4000.0 * G, nu = (3 * K - 2 * G) / (2 * (3 * K + G));
  return {.E = 2.0 * G * (1.0 + nu), .nu = nu, .bulk = K, .tests = {test}, .rates = {0.0}};
}

// Ogden's law of one term, which the series finds from its uniaxial test alone: sigma_i = mu (l_i^alpha - l_3^alpha).
// Sabotage: the series without its second term; f not less its mean.
TEST(SinglePoints, ATestCurveOfOgdensRubberGivesOgdensRubber) {
  for (const auto& [mu, alpha] : {std::pair{1.0, 2.0}, std::pair{0.4, 4.0}, std::pair{-1.5, -1.5}}) {
    const auto f = [&, m = mu, a = alpha](double l) { return m * std::pow(l, a); };
    const TabulatedRubber law = tabulated(test_of([&](double l) { return f(l) - f(1.0 / std::sqrt(l)); }, -0.7, 1.5));
    for (const auto& [x, y] : plane_stretches) {
      Layer p(composed_law({law}));
      pull(p, {x, y}, 200);
      const double z = 1.0 / (x * y), size = std::abs(f(x) - f(z)) + std::abs(f(y) - f(z)) + 0.01;
      EXPECT_NEAR(p.s.xx, f(x) - f(z), 2e-3 * size) << mu << ' ' << alpha << ' ' << x << ' ' << y;
      EXPECT_NEAR(p.s.yy, f(y) - f(z), 2e-3 * size) << mu << ' ' << alpha << ' ' << x << ' ' << y;
    }
  }
}

// Sheared at a constant rate: what is more than without the terms is sum GI g' (1 - exp(-beta t)) / beta.
TEST(SinglePoints, RubberByATestRelaxes) {
  const TabulatedRubber without = tabulated(test_of([](double l) { return l * l - 1.0 / l; }, -0.7, 1.5));
  TabulatedRubber with = without;
  with.overstress.maxwell_branches = {{3.0, 100.0}, {5.0, 700.0}};
  Point a(composed_law({without})), b(composed_law({with}));
  a.dt = b.dt = 1e-4;
  const double rate = 2.0, t = 0.01;
  for (int i = 0; i < 100; ++i)
    for (auto* point : {&a, &b}) point->strain({0, 0, 0, rate * point->dt, 0, 0});
  const double more =
      3.0 * rate * (1.0 - std::exp(-100.0 * t)) / 100.0 + 5.0 * rate * (1.0 - std::exp(-700.0 * t)) / 700.0;
  EXPECT_NEAR(b.s.xy - a.s.xy, more, 1e-10);
  EXPECT_NEAR(b.s.xx - a.s.xx, 0.0, 1e-10);
}

// A test of straight pieces, which no power gives: pulled so, layers and solids give the curve itself.
TEST(SinglePoints, ATestCurveComesBackInItsOwnTest) {
  Curve test;
  test.x = {-0.6, -0.3, 0.0, 0.2, 0.6, 1.5};
  test.y = {-8.0, -1.2, 0.0, 0.5, 0.8, 3.5};
  const TabulatedRubber law = tabulated(test);
  for (const double strain : {-0.5, -0.2, 0.1, 0.4, 1.2}) {
    const double l = 1.0 + strain, side = 1.0 / std::sqrt(l), expected = l * test.extrapolated(strain);
    Layer layer(composed_law({law}));
    pull(layer, {l, side}, 400);
    EXPECT_NEAR(layer.s.xx - layer.s.yy, expected, 1e-3 * std::abs(expected)) << strain;
    EXPECT_NEAR(layer.s.yy, 0.0, 1e-3 * std::abs(expected)) << strain;
    Point solid(composed_law({law}));
    std::array<double, 3> stretch{1, 1, 1};
    pull(solid, stretch, {l, side, side}, 400);
    EXPECT_NEAR(solid.s.xx - solid.s.yy, expected, 1e-3 * std::abs(expected)) << strain;
  }
}

// Below the greatest energy so far the stress of a bar is HU + (1 - HU) (W / Wmax)^SHAPE of the curve's, W the area
// under it (LS-DYNA Keyword Manual, material 181). Sabotage: the share of the stress, or of the strain, for that of the
// energy.
TEST(SinglePoints, ATestCurveKeepsAShareOnItsWayBack) {
  Curve test;
  test.x = {-0.6, -0.3, 0.0, 0.2, 0.6, 1.5};
  test.y = {-8.0, -1.2, 0.0, 0.5, 0.8, 3.5};
  TabulatedRubber law = tabulated(test);
  law.kept = 0.3;
  law.shape = 2.5;
  const auto area = [&](double strain) {
    double sum = 0.0;
    constexpr int parts = 20000;
    for (int i = 0; i < parts; ++i) sum += strain / parts * test.extrapolated((i + 0.5) * strain / parts);
    return sum;
  };
  for (const auto& [far, back] : {std::pair{1.2, 0.5}, std::pair{1.2, 0.1}, std::pair{-0.5, -0.2}}) {
    const double l = 1.0 + back, side = 1.0 / std::sqrt(l), most = 1.0 + far, thinnest = 1.0 / std::sqrt(most);
    const double kept = 0.3 + 0.7 * std::pow(area(back) / area(far), 2.5),
                 expected = kept * l * test.extrapolated(back);
    Layer layer(composed_law({law}));
    pull(layer, {most, thinnest}, 400);
    EXPECT_NEAR(layer.s.xx, most * test.extrapolated(far), 2e-3 * std::abs(layer.s.xx)) << far;
    pull(layer, {l / most, side / thinnest}, 400);
    EXPECT_NEAR(layer.s.xx - layer.s.yy, expected, 3e-3 * std::abs(expected)) << far << ' ' << back;
    Point solid(composed_law({law}));
    std::array<double, 3> stretch{1, 1, 1};
    pull(solid, stretch, {most, thinnest, thinnest}, 400);
    pull(solid, stretch, {l, side, side}, 400);
    EXPECT_NEAR(solid.s.xx - solid.s.yy, expected, 3e-3 * std::abs(expected)) << far << ' ' << back;
    // And on again: by the same way to where it turned, then by the curve.
    pull(solid, stretch, {most, thinnest, thinnest}, 400);
    EXPECT_NEAR(solid.s.xx - solid.s.yy, most * test.extrapolated(far), 3e-3 * std::abs(solid.s.xx)) << far;
  }
}

// ---- foam by test curves, rates, and unloading by a curve (MAT_181)

/// Foam of Poisson's ratio nu.
TabulatedRubber foam_of(const Curve& test, double nu) {
  return {.E = test.slope(0.0), .nu = nu, .tests = {test}, .rates = {0.0}, .contraction = nu};
}

// Hill's foam of one term, W = C/b [sum l^b - 3 + (J^-nb - 1)/n], which the series finds from its uniaxial test alone.
// Sabotage: the stress of the volume left out; the series of rubber, -1/2 for -nu; n = nu.
TEST(SinglePoints, ATestCurveOfHillsFoamGivesHillsFoam) {
  for (const auto& [C, power, nu] :
       {std::tuple{1.0, 2.0, 0.3}, std::tuple{0.4, 4.0, 0.1}, std::tuple{-1.5, -1.5, 0.45}}) {
    const double n = nu / (1.0 - 2.0 * nu);
    const auto W = [&, C = C, b = power](double x, double y, double z) {
      return C / b * (std::pow(x, b) + std::pow(y, b) + std::pow(z, b) - 3.0 + (std::pow(x * y * z, -n * b) - 1.0) / n);
    };
    const auto f = [&, C = C, b = power](double l) { return C * std::pow(l, b); };
    const Curve test = test_of([&, nu = nu](double l) { return f(l) - f(std::pow(l, -nu)); }, -0.7, 1.5);
    TabulatedRubber law = foam_of(test, nu);
    // As far as the test tells f: J^-n from 0.8 to 1.5.
    const double compressed = std::exp(-0.12 / n), pulled = std::min(std::exp(0.2 / n) / 1.56, 2.2);
    for (const std::array<double, 3>& to :
         {std::array{1.8, std::pow(1.8, -nu), std::pow(1.8, -nu)}, std::array{compressed, compressed, compressed},
          std::array{1.2, 1.3, pulled}, std::array{0.7, 1.2, std::max(std::exp(-0.3 / n) / 0.84, 0.4)}}) {
      Point p(composed_law({law}));
      std::array<double, 3> l{1, 1, 1};
      pull(p, l, to, 100);
      const std::array<double, 3> s = by_energy(W, to);
      const double gate = 2e-3 * (std::abs(s[0]) + std::abs(s[1]) + std::abs(s[2]));
      EXPECT_NEAR(p.s.xx, s[0], gate) << power;
      EXPECT_NEAR(p.s.yy, s[1], gate) << power;
      EXPECT_NEAR(p.s.zz, s[2], gate) << power;
    }
  }
}

// No wave is faster than the modulus of the stable step says, of a foam with a stiff start and a plateau.
TEST(SinglePoints, FoamByATestKnowsItsStiffness) {
  Curve test;
  test.x = {-0.9, -0.6, -0.05, 0.0, 0.05, 1.5};
  test.y = {-8.0, -0.3, -0.2, 0.0, 0.3, 1.0};
  for (const double nu : {0.05, 0.3, 0.45})
    for (const std::array<double, 3>& to :
         {std::array{0.3, 0.9, 1.1}, std::array{0.5, 0.5, 0.5}, std::array{2.0, 0.7, 0.9}, std::array{1.0, 1.0, 1.0}}) {
      Point p(composed_law({foam_of(test, nu)}));
      std::array<double, 3> l{1, 1, 1};
      pull(p, l, to, 50);
      const double wave = p.wave_modulus();
      const auto gains = [&](const SolidTensor<double>& d, auto of) {
        Point q = p;
        q.strain(1e-6 * d);
        return (of(q.s) - of(p.s)) / 1e-6;
      };
      EXPECT_GE(wave, gains({1, 0, 0, 0, 0, 0}, [](const auto& s) { return s.xx; }) * 0.999) << nu << ' ' << to[0];
      EXPECT_GE(wave, gains({0, 1, 0, 0, 0, 0}, [](const auto& s) { return s.yy; }) * 0.999) << nu << ' ' << to[0];
      EXPECT_GE(wave, gains({0, 0, 0, 1, 0, 0}, [](const auto& s) { return s.xy; }) * 0.999) << nu << ' ' << to[0];
    }
}

Curve scaled(Curve test, double factor) {
  for (double& y : test.y) y *= factor;
  return test;
}

/// Stretches a bar at constant volume (or of foam with its lateral strain) at a constant rate, over the length at first
/// or over that now, in equal steps of some 1e-3.
void pull_at(Point& p, double& length, double to, double rate, double contraction, bool engineering) {
  const double whole = engineering ? std::abs(to - length) : std::abs(std::log(to / length));
  const double steps = std::ceil(whole / rate / 1e-3), from = length;
  p.dt = whole / rate / steps;
  for (double n = 1.0; n <= steps; n += 1.0) {
    const double next = engineering ? from + (to - from) * n / steps : from * std::pow(to / from, n / steps);
    const double side = std::pow(length, -contraction), side_next = std::pow(next, -contraction);
    const double lateral = mid(side, side_next - side);
    p.strain({mid(length, next - length), lateral, lateral, 0, 0, 0});
    length = next;
  }
}

// A bar pulled at a rate has the stress of the table at that rate, half way between two curves; what TENSION, RTYPE and
// AVGOPT say. Sabotage: each direction at its own rate; the lowest curve for every rate; RTYPE the other way round.
TEST(SinglePoints, TestCurvesOverTheRate) {
  Curve test;
  test.x = {-0.6, -0.3, 0.0, 0.2, 0.6, 1.5};
  test.y = {-8.0, -1.2, 0.0, 0.5, 0.8, 3.5};
  const TabulatedRubber rubber = tabulated(test);
  for (const double contraction : {0.5, 0.3})
    for (const bool engineering : {false, true}) {
      TabulatedRubber law = contraction < 0.5 ? foam_of(test, contraction) : rubber;
      law.tests = {test, scaled(test, 1.5), scaled(test, 3.0)};
      law.rates = {0.0, 1.0, 3.0};
      law.engineering_rate = engineering;
      const auto axial = [](const Point& p) { return p.s.xx - p.s.yy; };
      const auto at = [&](double strain, double factor) {
        return factor * std::pow(1.0 + strain, 2.0 * contraction) * test.extrapolated(strain);
      };
      for (const double strain : {0.4, 1.2, -0.4})
        for (const auto& [rate, factor] : {std::pair{2.0, 2.25}, std::pair{0.5, 1.25}, std::pair{5.0, 3.0}}) {
          Point p(composed_law({law}));
          double length = 1.0;
          pull_at(p, length, 1.0 + strain, rate, contraction, engineering);
          EXPECT_NEAR(axial(p), at(strain, factor), 4e-3 * std::abs(at(strain, factor))) << strain << ' ' << rate;
          // Held, or let back, it has the stress of the lowest rate.
          Point back = p;
          double returned = length;
          pull_at(back, returned, 1.0 + 0.5 * strain, 2.0, contraction, engineering);
          EXPECT_NEAR(axial(back), at(0.5 * strain, 1.0), 4e-3 * std::abs(at(strain, 1.0))) << strain << ' ' << rate;
          for (int i = 0; i < 200; ++i) p.strain({});
          EXPECT_NEAR(axial(p), at(strain, 1.0), 4e-3 * std::abs(at(strain, 1.0))) << strain << ' ' << rate;
        }
      law.rate_counts = TabulatedRubber::RateCounts::compressive_loading;
      for (const double strain : {0.4, -0.4}) {
        Point p(composed_law({law}));
        double length = 1.0;
        pull_at(p, length, 1.0 + strain, 2.0, contraction, engineering);
        const double expected = at(strain, strain < 0.0 ? 2.25 : 1.0);
        EXPECT_NEAR(axial(p), expected, 4e-3 * std::abs(expected)) << strain;
      }
      law.rate_counts = TabulatedRubber::RateCounts::always;
      Point p(composed_law({law}));
      double length = 1.0;
      pull_at(p, length, 1.6, 2.0, contraction, engineering);
      pull_at(p, length, 1.2, 2.0, contraction, engineering);
      EXPECT_NEAR(axial(p), at(0.2, 2.25), 4e-3 * at(0.2, 2.25));
      // Over a tenth of a second: after a tenth most of the rate is there, and the first steps hardly feel it.
      law.window = 0.1;
      Point slow(composed_law({law}));
      length = 1.0;
      pull_at(slow, length, 1.0 + 0.01, 2.0, contraction, engineering);
      EXPECT_LT(axial(slow), at(0.01, 1.2));
      pull_at(slow, length, 1.6, 2.0, contraction, engineering);
      EXPECT_NEAR(axial(slow), at(0.6, 2.25), 1e-2 * at(0.6, 2.25));
    }
}

// A bar comes back along LCUNLD from the ends of the test, in tension and compression; from half way by the share of
// the energy. Sabotage: the curve of the other side; the share over the strain.
TEST(SinglePoints, ATestCurveComesBackByItsCurveOfUnloading) {
  Curve test, back;
  test.x = {-0.6, -0.3, 0.0, 0.2, 0.6, 1.5};
  test.y = {-8.0, -1.2, 0.0, 0.5, 0.8, 3.5};
  back.x = {-0.6, -0.4, 0.0, 0.6, 1.5};
  back.y = {-8.0, -0.4, 0.0, 0.2, 3.5};
  for (const double contraction : {0.5, 0.3}) {
    TabulatedRubber law = contraction < 0.5 ? foam_of(test, contraction) : tabulated(test);
    law.unloading = back;
    for (const auto& [far, strain] :
         {std::pair{1.5, 1.2}, std::pair{1.5, 0.5}, std::pair{-0.6, -0.5}, std::pair{-0.6, -0.2}}) {
      Point p(composed_law({law}));
      double length = 1.0;
      pull_at(p, length, 1.0 + far, 2.0, contraction, false);
      pull_at(p, length, 1.0 + strain, 2.0, contraction, false);
      const double expected = std::pow(1.0 + strain, 2.0 * contraction) * back.extrapolated(strain);
      EXPECT_NEAR(p.s.xx - p.s.yy, expected, 1e-2 * std::abs(expected)) << far << ' ' << strain;
    }
  }
}

}  // namespace
}  // namespace nugget::kernel
