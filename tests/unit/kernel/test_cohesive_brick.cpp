// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/index.hpp"
#include "kernel/element/cohesive_brick.hpp"
#include "motion.hpp"
#include "one_element.hpp"

namespace nugget::kernel {
namespace {

using L = CohesiveBrickLayout;
using Corners = std::array<Vec3d, 8>;

CohesiveBond elastic(int points_to_delete = 1) {
  CohesiveBond bond;
  bond.stiffness = {8000.0, 3000.0};
  bond.points_to_delete = points_to_delete;
  return bond;
}

Curve shape(std::vector<double> x, std::vector<double> y) {
  Curve curve;
  curve.x = std::move(x);
  curve.y = std::move(y);
  return curve;
}

CohesiveBond bond_of(const ShapedCohesion& shaped) {
  CohesiveBond bond;
  bond.shaped = shaped;
  bond.stiffness = shaped.first_stiffness();
  bond.stiffest = shaped.stiffest();
  return bond;
}

/// A trapezoid of 40 high, 0.1 to failure in tension and 0.15 in shear.
ShapedCohesion scaled() {
  return {.mixing = ShapedCohesion::Mixing::potential,
          .shape = shape({0, 0.1, 0.5, 1}, {0, 1, 1, 0}),
          .normal_strength = 40.0,
          .normal_end = 0.1,
          .shear_end = 0.15};
}

/// Its curve has an area of 0.515.
ShapedCohesion general(ShapedCohesion::Mixing mixing, double exponent) {
  ShapedCohesion law{.mixing = mixing,
                     .shape = shape({0, 0.1, 0.4, 1}, {0, 1, 0.7, 0}),
                     .normal_strength = 40.0,
                     .shear_strength = 30.0,
                     .normal_energy = 2.0,
                     .shear_energy = 6.0,
                     .exponent = exponent,
                     .pressure_factor = 1.5};
  law.normal_end = 2.0 / (0.515 * 40.0);
  law.shear_end = 6.0 / (0.515 * 30.0);
  return law;
}

Corners distorted(Random& random, double height, double size = 0.5) {
  Corners x{Vec3d{0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {0, 4, 0}, {0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {0, 4, 0}};
  for (std::size_t a = 0; a < 4; ++a) {
    const Vec3d off = random.vector(size);
    x[a] += off;
    x[a + 4] += off + Vec3d{0, 0, height} + random.vector(0.2 * height);
  }
  return x;
}

struct Driven {
  CohesiveBrickProperties brick;
  CohesiveBond bond;
  NodalMotion<double, 8> nodes{};
  std::array<double, L::count> state{};

  Driven(bool between_shells, const CohesiveBond& law, const Corners& x) : brick{1.2e-9, between_shells}, bond(law) {
    start_cohesive_brick(brick, bond, x, state.data(), 1, 0);
    std::copy(x.begin(), x.end(), nodes.x);
  }
  /// Moves on by a step with these velocities and spins.
  NodalForces<double, 8> step(const std::array<Vec3d, 8>& v, const std::array<Vec3d, 8>& w, double dt) {
    for (std::size_t a = 0; a < 8; ++a) {
      nodes.v[a] = v[a];
      nodes.w[a] = w[a];
      nodes.x[a] += dt * v[a];
    }
    return one_element(nodes, state, [&](const auto& all, double* store) {
      return cohesive_brick_cycle(brick, bond, all, dt, store);
    });
  }
};

double greatest(const NodalForces<double, 8>& out) {
  double most = 0.0;
  for (const Vec3d* of : {out.f, out.m})
    for (int a = 0; a < 8; ++a) most = std::max(most, norm(of[a]));
  return most;
}

TEST(CohesiveBrick, ForcesHaveNeitherResultantNorMoment) {
  Random random;
  for (const bool between_shells : {false, true})
    for (const double height : {0.0, 1.5}) {
      Driven d(between_shells, elastic(), distorted(random, height));
      NodalForces<double, 8> out;
      for (int n = 0; n < 5; ++n) {
        std::array<Vec3d, 8> v, w;
        for (std::size_t a = 0; a < 8; ++a) v[a] = random.vector(1.0), w[a] = random.vector(1.0);
        out = d.step(v, w, 0.05);
      }
      Vec3d sum{}, moment{};
      for (int a = 0; a < 8; ++a) {
        sum += out.f[a];
        moment += cross(d.nodes.x[a], out.f[a]);
        if (between_shells) moment += out.m[a];
      }
      const double size = greatest(out);
      EXPECT_GT(size, 100.0);
      EXPECT_LT(norm(sum), 1e-12 * size);
      EXPECT_LT(norm(moment), 1e-11 * size);
    }
}

TEST(CohesiveBrick, PowerOfTheForcesIsThatOfTheTractions) {
  Random random;
  for (const bool between_shells : {false, true}) {
    Driven d(between_shells, elastic(), distorted(random, 1.5));
    std::array<Vec3d, 8> v, w;
    const auto draw = [&] {
      for (std::size_t a = 0; a < 8; ++a) v[a] = random.vector(1.0), w[a] = random.vector(1.0);
    };
    draw();
    const auto out = d.step(v, w, 0.1);
    draw();
    double power = 0.0, of_tractions = 0.0;
    for (std::size_t a = 0; a < 8; ++a) power += dot(out.f[a], v[a]) + (between_shells ? dot(out.m[a], w[a]) : 0.0);
    const auto before = d.state;
    const double dt = 1e-7;
    d.step(v, w, dt);
    for (int p = 0; p < L::points; ++p)
      for (int i = 0; i < 3; ++i) {
        const auto place = at(L::point(p));
        of_tractions += before[place] * before[place + L::traction + i] *
                        (d.state[place + L::separation + i] - before[place + L::separation + i]) / dt;
      }
    EXPECT_NEAR(power, of_tractions, 1e-5 * std::abs(of_tractions));
  }
}

TEST(CohesiveBrick, RotationAsARigidBodyMakesNoForce) {
  Random random;
  const Vec3d axis = unit(Vec3d{0.3, -0.5, 0.8});
  for (const bool between_shells : {false, true}) {
    const Corners start = distorted(random, 1.5);
    Driven d(between_shells, elastic(), start);
    // First a separation, to see that its traction turns with the brick.
    std::array<Vec3d, 8> v{}, w{};
    for (std::size_t a = 4; a < 8; ++a) v[a] = {0.3, -0.2, 0.5};
    const double before = greatest(d.step(v, w, 0.01));
    const std::array<double, L::count> held = d.state;
    const Corners opened = [&] {
      Corners x;
      std::copy_n(d.nodes.x, 8, x.begin());
      return x;
    }();
    const int steps = 100;
    const double angle = 5.0, dt = 0.01;
    NodalForces<double, 8> out;
    for (int n = 1; n <= steps; ++n) {
      for (std::size_t a = 0; a < 8; ++a) {
        v[a] = (1.0 / dt) * (turned(axis, angle * n / steps, opened[a]) - d.nodes.x[a]);
        w[a] = (angle / steps / dt) * axis;
      }
      out = d.step(v, w, dt);
    }
    for (int p = 0; p < L::points; ++p)
      for (int i = 0; i < 3; ++i) {
        const auto place = at(L::point(p) + L::separation + i);
        EXPECT_NEAR(d.state[place], held[place], 1e-8);
      }
    EXPECT_NEAR(greatest(out), before, 1e-5 * before);
  }
}

/// Highest frequency of the brick with its own masses, by the power method on its stiffness.
double highest_frequency(bool between_shells, const CohesiveBond& bond, const Corners& x) {
  const Driven rest(between_shells, bond, x);
  const std::size_t freedoms = between_shells ? 48 : 24;
  const auto apply = [&](const std::vector<double>& u) {
    Driven d = rest;
    std::array<Vec3d, 8> v{}, w{};
    for (std::size_t a = 0; a < 8; ++a) {
      v[a] = {u[3 * a], u[3 * a + 1], u[3 * a + 2]};
      if (between_shells) w[a] = {u[24 + 3 * a], u[25 + 3 * a], u[26 + 3 * a]};
    }
    const double tiny = 0x1p-100;
    const auto out = d.step(v, w, tiny);
    std::vector<double> r(freedoms);
    for (std::size_t a = 0; a < 8; ++a) {
      const double m = rest.state[L::nodal_mass] * tiny, j = rest.state[L::nodal_inertia] * tiny;
      r[3 * a] = out.f[a].x / m, r[3 * a + 1] = out.f[a].y / m, r[3 * a + 2] = out.f[a].z / m;
      if (between_shells)
        r[24 + 3 * a] = out.m[a].x / j, r[25 + 3 * a] = out.m[a].y / j, r[26 + 3 * a] = out.m[a].z / j;
    }
    return r;
  };
  Random random;
  std::vector<double> u(freedoms);
  for (double& c : u) c = random();
  double square = 0.0;
  for (int n = 0; n < 3000; ++n) {
    const std::vector<double> r = apply(u);
    double size = 0.0;
    for (const double c : r) size = std::max(size, std::abs(c));
    square = size;
    for (std::size_t i = 0; i < freedoms; ++i) u[i] = r[i] / size;
  }
  return std::sqrt(square);
}

TEST(CohesiveBrick, StableStepBoundsTheHighestFrequencyClosely) {
  Random random;
  for (const bool between_shells : {false, true})
    for (const double height : {0.3, 1.5, 6.0})
      for (const CohesiveBond& bond : {elastic(), elastic(0), bond_of(scaled())}) {
        for (int n = 0; n < 5; ++n) {
          const Corners x = distorted(random, height, n == 0 ? 0.0 : 1.2);
          Driven d(between_shells, bond, x);
          const double step = d.step({}, {}, 0x1p-100).stable_step;
          const double critical = 2.0 / highest_frequency(between_shells, bond, x);
          EXPECT_LE(step, critical * (1.0 + 1e-9)) << between_shells << height;
          EXPECT_GT(step, (height < 2.0 ? 0.5 : 0.35) * critical) << between_shells << height;
        }
      }
}

void expect_bits_of_each_alone(const CohesiveBond& bond);
CohesiveBond arup(double pwrt, double pwrs, double slope);

TEST(CohesiveBrick, BatchGivesTheBitsOfEachAlone) {
  CohesiveBond bond = elastic(2);
  bond.glue.softening = Cohesion::Softening::by_energy;
  bond.glue.normal_strength = 30.0;
  bond.glue.shear_strength = 20.0;
  bond.glue.normal_energy = 1.0;
  bond.glue.shear_energy = 3.0;
  bond.glue.exponent = 1.5;
  expect_bits_of_each_alone(bond);
  expect_bits_of_each_alone(bond_of(scaled()));
  expect_bits_of_each_alone(arup(1.5, 3.0, 0.2));
  expect_bits_of_each_alone(bond_of(general(ShapedCohesion::Mixing::power, 1.4)));
}

void expect_bits_of_each_alone(const CohesiveBond& bond) {
  constexpr int width = native_width;
  for (const bool between_shells : {false, true}) {
    Random random;
    std::vector<Driven> single;
    std::vector<double> state(at(L::count * width));
    NodalMotion<NativeBatch, 8> batch{};
    for (int l = 0; l < width; ++l) {
      const Corners x = distorted(random, 0.8);
      single.emplace_back(between_shells, bond, x);
      start_cohesive_brick(single.back().brick, bond, x, state.data(), width, l);
    }
    int dead = 0;
    for (int n = 0; n < 150; ++n) {
      std::vector<NodalForces<double, 8>> expected;
      for (int l = 0; l < width; ++l) {
        std::array<Vec3d, 8> v, w;
        for (std::size_t a = 0; a < 8; ++a) {
          v[a] = random.vector(1.0);
          if (a > 3) v[a] += Vec3d{0.3, 0.2, 0.4};
          w[a] = random.vector(0.1);
        }
        expected.push_back(single[l].step(v, w, 0.005));
        for (std::size_t a = 0; a < 8; ++a) {
          const auto& nodes = single[l].nodes;
          const auto put = [l](Vec3<NativeBatch>& to, const Vec3d& from) {
            set_lane(to.x, l, from.x), set_lane(to.y, l, from.y), set_lane(to.z, l, from.z);
          };
          put(batch.x[a], nodes.x[a]), put(batch.v[a], nodes.v[a]), put(batch.w[a], nodes.w[a]);
        }
      }
      const auto out = cohesive_brick_cycle(single[0].brick, bond, batch, 0.005, state.data());
      dead = 0;
      for (int l = 0; l < width; ++l) {
        const auto& e = expected[l];
        EXPECT_EQ(lane(out.stable_step, l), e.stable_step);
        dead += std::isinf(e.stable_step);
        for (int a = 0; a < 8; ++a) {
          EXPECT_EQ(lane(out.f[a].x, l), e.f[a].x);
          EXPECT_EQ(lane(out.f[a].z, l), e.f[a].z);
          EXPECT_EQ(lane(out.m[a].y, l), e.m[a].y);
        }
      }
    }
    EXPECT_EQ(dead, width);
  }
}

/// Work of a straight way to failure, by the trapezoidal rule.
double energy_of(const CohesiveBond& bond, const Vec3d& direction, double& last, double step = 1e-6) {
  CohesiveState state;
  double work = 0.0, size = 0.0;
  Vec3d before{};
  while (state.damage < 1.0) {
    size += step;
    const Vec3d t = bond_traction(bond, 0.0, size * direction, {}, state);
    work += 0.5 * step * dot(t + before, direction);
    before = t;
  }
  last = size;
  return work;
}

TEST(CohesiveBrick, EnergyOfMixedModesIsThatOfTheCriteria) {
  CohesiveBond bond;
  bond.stiffness = {1e4, 4e3};
  bond.glue.softening = Cohesion::Softening::by_energy;
  bond.glue.normal_strength = 40.0;
  bond.glue.shear_strength = 30.0;
  bond.glue.normal_energy = 2.0;
  bond.glue.shear_energy = 6.0;
  for (const double degrees : {0.0, 25.0, 60.0, 90.0}) {
    const double c = std::cos(degrees * std::acos(-1.0) / 180.0), s = std::sin(degrees * std::acos(-1.0) / 180.0);
    const Vec3d direction{0.6 * s, 0.8 * s, c};
    // Energies of the modes are in a constant ratio on the way.
    const double tension = 1e4 * c * c, shear = 4e3 * s * s, share = shear / (tension + shear);
    for (const double xmu : {1.0, 1.7, -1.5}) {
      bond.glue.exponent = xmu;
      bond.stiffness_exponent = 1.0;
      const double expected =
          xmu > 0.0 ? std::pow(std::pow((1.0 - share) / 2.0, xmu) + std::pow(share / 6.0, xmu), -1.0 / xmu)
                    : 2.0 + 4.0 * std::pow(share, -xmu);
      double last = 0.0;
      EXPECT_NEAR(energy_of(bond, direction, last), expected, 1e-3 * expected) << degrees << ' ' << xmu;
    }
    // GAMMA: the separation at failure of the manual's formula.
    bond.glue.exponent = -1.5;
    bond.stiffness_exponent = 2.0;
    const double onset = 1.0 / std::hypot(1e4 * c / 40.0, 4e3 * s / 30.0);
    const double mean = std::sqrt(c * c * 1e8 + s * s * 1.6e7);
    double last = 0.0;
    energy_of(bond, direction, last);
    EXPECT_NEAR(last, 2.0 / (onset * mean) * (2.0 + 4.0 * std::pow(share, 1.5)), 2e-6);
  }
}

// *MAT_COHESIVE_TH has a potential: the work is the same whatever the way to failure. Sabotage: shear by TLS alone.
TEST(CohesiveBrick, ScaledSeparationHasAPotential) {
  const CohesiveBond bond = bond_of(scaled());
  const double energy = 40.0 * 0.1 * 0.5 * (1.0 - 0.1 + 0.5);
  for (const double degrees : {0.0, 25.0, 60.0, 90.0}) {
    const double c = std::cos(degrees * std::acos(-1.0) / 180.0), s = std::sin(degrees * std::acos(-1.0) / 180.0);
    double last = 0.0;
    EXPECT_NEAR(energy_of(bond, {0.6 * s, 0.8 * s, c}, last), energy, 1e-4 * energy) << degrees;
    EXPECT_NEAR(last, 1.0 / std::hypot(c / 0.1, s / 0.15), 2e-6);
  }
  // Tension onto the plateau, then aside to failure, and a way that comes back to the start.
  const auto work = [&](const std::vector<Vec3d>& way, double& damage) {
    CohesiveState state;
    double sum = 0.0;
    Vec3d at{}, before{};
    for (const Vec3d& corner : way) {
      const Vec3d from = at;
      for (int i = 1; i <= 20000; ++i) {
        const Vec3d next = from + (i / 20000.0) * (corner - from);
        const Vec3d t = bond_traction(bond, 0.0, next, {}, state);
        sum += 0.5 * dot(t + before, next - at);
        at = next;
        before = t;
      }
    }
    damage = state.damage;
    return sum;
  };
  double damage = 0.0;
  EXPECT_NEAR(work({{0, 0, 0.03}, {0.2, 0, 0.03}}, damage), energy, 1e-4 * energy);
  EXPECT_EQ(damage, 1.0);
  EXPECT_NEAR(work({{0, 0, 0.06}, {0.05, 0.02, 0.04}, {0, 0, 0}}, damage), 0.0, 1e-4 * energy);
  EXPECT_EQ(damage, 0.0);
}

// Sabotage: the stiffness of the tension in shear; the exponent on the wrong side of the sum.
TEST(CohesiveBrick, GeneralCurvesHaveTheEnergyOfTheCriteria) {
  using Mixing = ShapedCohesion::Mixing;
  for (const auto& [mixing, exponent] :
       {std::pair{Mixing::power, 1.0}, {Mixing::power, 1.7}, {Mixing::benzeggagh, 1.5}}) {
    const ShapedCohesion law = general(mixing, exponent);
    const CohesiveBond bond = bond_of(law);
    EXPECT_NEAR(law.end(1.0), law.normal_end, 1e-15);
    EXPECT_NEAR(law.end(0.0), law.shear_end, 1e-15);
    // The first tenth rises to T and S.
    const double kt = 10.0 * 40.0 / law.normal_end, ks = 10.0 * 30.0 / law.shear_end;
    for (const double degrees : {0.0, 25.0, 60.0, 90.0}) {
      const double c = std::cos(degrees * std::acos(-1.0) / 180.0), s = std::sin(degrees * std::acos(-1.0) / 180.0);
      const double share = ks * s * s / (kt * c * c + ks * s * s);
      const double expected =
          mixing == Mixing::power
              ? std::pow(std::pow((1.0 - share) / 2.0, exponent) + std::pow(share / 6.0, exponent), -1.0 / exponent)
              : 2.0 + 4.0 * std::pow(share, exponent);
      double last = 0.0;
      EXPECT_NEAR(energy_of(bond, {0.6 * s, 0.8 * s, c}, last), expected, 1e-4 * expected) << degrees;
    }
  }
}

TEST(CohesiveBrick, GeneralCurvesUnloadToTheOriginAndBearPressure) {
  const CohesiveBond bond = bond_of(general(ShapedCohesion::Mixing::power, 1.0));
  CohesiveState state;
  const double end = bond.shaped.normal_end;
  EXPECT_NEAR(bond_traction(bond, 0.0, {0, 0, 0.4 * end}, {}, state).z, 28.0, 1e-12);
  EXPECT_NEAR(bond_traction(bond, 0.0, {0, 0, 0.1 * end}, {}, state).z, 7.0, 1e-12);
  EXPECT_NEAR(bond_traction(bond, 0.0, {0, 0, 0.4 * end}, {}, state).z, 28.0, 1e-12);
  EXPECT_NEAR(bond_traction(bond, 0.0, {0, 0, -0.01 * end}, {}, state).z, -1.5 * 4.0, 1e-12);
  bond_traction(bond, 0.0, {0, 0, 1.01 * end}, {}, state);
  EXPECT_EQ(state.damage, 1.0);
  EXPECT_EQ(bond_traction(bond, 0.0, {0, 0, 0.1 * end}, {}, state).z, 0.0);
}

/// *MAT_ARUP_ADHESIVE: 40 with 2.0 in tension, 30 with 6.0 and a plateau of 0.3 of the separation in shear.
CohesiveBond arup(double pwrt, double pwrs, double slope) {
  CohesiveBond bond;
  bond.stiffness = {4000.0, 1200.0};
  bond.glue.softening = Cohesion::Softening::elastoplastic;
  bond.glue.thickness = 0.3;
  bond.glue.tension = {.yield = 40.0, .energy = 2.0};
  bond.glue.shear = {.yield = 30.0, .energy = 6.0, .plateau = 2.0 * 0.3 / 1.3};
  bond.glue.normal_exponent = pwrt;
  bond.glue.shear_exponent = pwrs;
  bond.glue.shear_slope = slope;
  return bond;
}

// Yield on the surface, and the energy of the modes. Sabotage: the exponents exchanged; the slope's sign.
TEST(CohesiveBrick, ArupAdhesiveYieldsOnItsSurfaceAndTakesItsEnergy) {
  for (const auto& [pwrt, pwrs, slope] :
       {std::tuple{2.0, 2.0, 0.0}, {2.0, 2.0, 0.3}, {1.5, 3.0, 0.0}, {1.2, 2.5, 0.5}}) {
    const CohesiveBond bond = arup(pwrt, pwrs, slope);
    for (const double degrees : {0.0, 25.0, 60.0, 90.0}) {
      const double c = std::cos(degrees * std::acos(-1.0) / 180.0), s = std::sin(degrees * std::acos(-1.0) / 180.0);
      const Vec3d direction{0.6 * s, 0.8 * s, c};
      CohesiveState state;
      Vec3d t;
      for (double size = 0.0; state.rate_at_yield < 0.0; size += 1e-6)
        t = bond_traction(bond, 0.0, size * direction, {}, state);
      const double tension = t.z, shear = std::hypot(t.x, t.y);
      EXPECT_NEAR(std::pow(tension / 40.0, pwrt) + std::pow(shear / (30.0 - slope * tension), pwrs), 1.0, 1e-9);
      const double kt = 4000.0 * c * c, ks = 1200.0 * s * s, share = ks / (kt + ks);
      double last = 0.0;
      const double expected = 1.0 / ((1.0 - share) / 2.0 + share / 6.0);
      EXPECT_NEAR(energy_of(bond, direction, last, 1e-5), expected, 1e-3 * expected)
          << degrees << ' ' << pwrt << ' ' << slope;
      if (degrees == 90.0) {
        EXPECT_NEAR(last, 2.0 * 6.0 / (1.3 * 30.0), 2e-5);
      }
      if (degrees == 0.0) {
        EXPECT_NEAR(last, 2.0 * 2.0 / 40.0, 2e-5);
      }
    }
    // Pressure adds to the shear strength, and stays.
    CohesiveState state;
    const Vec3d pressed = bond_traction(bond, 0.0, {0.054, 0.072, -0.002}, {}, state);
    EXPECT_NEAR(pressed.z, -4000.0 / 0.3 * 0.002, 1e-9);
    EXPECT_NEAR(std::hypot(pressed.x, pressed.y), 30.0 + slope * 4000.0 / 0.3 * 0.002, 1e-9);
  }
}

// Tractions over small separations of every mode, by differences. Sabotage: a stiffness that depends on the mode.
TEST(CohesiveBrick, NothingIsStifferThanTheStepIsMadeFor) {
  using Mixing = ShapedCohesion::Mixing;
  Random random;
  for (const auto& [mixing, exponent] : {std::pair{Mixing::power, 0.6},
                                         {Mixing::power, 1.0},
                                         {Mixing::power, 3.0},
                                         {Mixing::benzeggagh, 0.5},
                                         {Mixing::benzeggagh, 2.0}}) {
    ShapedCohesion law = general(mixing, exponent);
    law.pressure_factor = 1.0;
    const CohesiveBond bond = bond_of(law);
    const auto traction = [&](const Vec3d& d) {
      CohesiveState state;
      return bond_traction(bond, 0.0, d, {}, state);
    };
    double most = 0.0;
    for (int n = 0; n < 20000; ++n) {
      Vec3d d = 1e-4 * unit(random.vector(1.0));
      d.z = std::abs(d.z);
      const Vec3d off = 1e-9 * unit(random.vector(1.0));
      if (d.z < 2e-9) continue;
      most = std::max(most, norm(traction(d + off) - traction(d - off)) / (2.0 * norm(off)));
    }
    EXPECT_LT(most, 1.002 * bond.stiffest) << exponent;
    EXPECT_GT(most, 0.95 * bond.stiffest) << exponent;
  }
}

}  // namespace
}  // namespace nugget::kernel
