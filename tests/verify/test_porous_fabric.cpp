// SPDX-License-Identifier: Apache-2.0
// Gas that leaks through fabric: a box whose walls let it out, against closed forms of its mass over time.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "base/index.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

// Air in t, mm, s, K.
constexpr double box_cp = 1004.5e6, box_cv = 717.5e6, box_r = box_cp - box_cv, box_k = box_cp / box_cv;
constexpr double box_side = 100.0, box_area = 6.0 * box_side * box_side, box_volume = box_side * box_side * box_side;
constexpr double box_pressure = 0.2, box_temperature = 300.0;
constexpr double box_mass = box_pressure * box_volume / (box_r * box_temperature);

/// Fields of *MAT_FABRIC that say what leaks.
struct Porosity {
  double flc = 0, fac = 0, ela = 0, fvopt = 0, x0 = 0, x1 = 0;
};

/// A cube of fabric around the gas, 4 shells along each edge; the shells of its top are part 2, the others part 1.
struct FabricBox {
  static constexpr int cells = 4;
  Specimen specimen;
  std::map<std::array<int, 3>, int> nodes;

  FabricBox(double end_time, const Porosity& sides, const Porosity& top) {
    specimen.card("CONTROL_TERMINATION", {end_time}).part(1, 1, 1).part(2, 1, 2);
    specimen.text("*SECTION_SHELL\n" + fields({1, 9}) + fields({0.3, 0.3, 0.3, 0.3}));
    for (const auto& [material, p] : {std::pair{1, sides}, std::pair{2, top}})
      specimen.text("*MAT_FABRIC\n" + fields({1.0 * material, 1e-9, 400.0}) + fields({0}) +
                    fields({0, p.flc, p.fac, p.ela, 0, 0, p.fvopt}) + fields({0, 0, 0, 0, 0, 0, p.x0, p.x1}) +
                    fields({0}));
    specimen.text("*SET_PART_LIST\n" + fields({1}) + fields({1, 2}));
    // Sides by the axis along which they look out; all outwards.
    for (int axis = 0; axis < 3; ++axis)
      for (const int level : {0, cells})
        for (int i = 0; i < cells; ++i)
          for (int j = 0; j < cells; ++j) {
            const auto corner = [&](int di, int dj) {
              std::array<int, 3> at{};
              at[static_cast<std::size_t>(axis)] = level;
              at[static_cast<std::size_t>((axis + 1) % 3)] = i + di;
              at[static_cast<std::size_t>((axis + 2) % 3)] = j + dj;
              return node(at);
            };
            const int part = axis == 2 && level == cells ? 2 : 1;
            if (level == cells)
              specimen.shell(part, {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
            else
              specimen.shell(part, {corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
          }
  }

  int node(const std::array<int, 3>& at) {
    const auto [found, is_new] = nodes.try_emplace(at, 0);
    const double size = box_side / cells;
    if (is_new) found->second = specimen.node({size * at[0], size * at[1], size * at[2]});
    return found->second;
  }

  FabricBox& held() {
    for (const auto& [at, id] : nodes) specimen.card("BOUNDARY_SPC_NODE", {1.0 * id, 0, 1, 1, 1});
    return *this;
  }
  /// A gas in it with `ambient` around it and `option` as OPT.
  FabricBox& gas(double ambient = 0.0, double option = 0.0) {
    specimen.text("*AIRBAG_WANG_NEFSKE\n" + fields({1, 1}) + fields({box_cv, box_cp, 0, 0, 0, 0, 0, box_temperature}) +
                  fields({0}) + fields({ambient, 0, 1, 0, box_pressure - ambient, 0, option}) + fields({0}));
    return *this;
  }

  impact::Bag run() {
    Experiment experiment(specimen.deck());
    impact::Bag end;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      end = now.components.loads.of<model::ControlVolume>().front().gas().bag;
    });
    return end;
  }
};

constexpr double box_end = 4e-3;

void expect_mass(const std::string& what, const impact::Bag& gas, double left, double gate = 1e-4) {
  expect_reference("porous fabric", what + ": mass over that at the start [1]", gas.mass / box_mass, left, gate);
  // What is left has expanded without heat.
  expect_reference("porous fabric", what + ": pressure [MPa]", gas.pressure, box_pressure * std::pow(left, box_k),
                   2.0 * gate);
  EXPECT_NEAR(gas.mass + gas.leaked, box_mass, 1e-9 * box_mass);
  EXPECT_EQ(gas.vented, 0.0);
  EXPECT_LT(left, 0.8);
}

/// A mass that falls as m^(1 + n), by `rate` at the start.
double power_decay(double n, double rate, double t = box_end) {
  return std::pow(1.0 + n * rate * t, -1.0 / n);
}

// Into a vacuum the flow is choked: m/m0 = (1 + (k - 1)/2 K t)^(-2/(k - 1)), K = FLC FAC A/V sqrt(k R T0)
// (2/(k + 1))^((k + 1)/(2 (k - 1))). Sabotages: FLC or FAC alone, the sides without the top, CP23's area.
TEST(PorousFabric, LeaksAsThroughAVent) {
  const Porosity p{.flc = 0.02, .fac = 0.4, .fvopt = 1};
  const double rate = p.flc * p.fac * box_area / box_volume * std::sqrt(box_k * box_r * box_temperature) *
                      std::pow(2.0 / (box_k + 1.0), 0.5 * (box_k + 1.0) / (box_k - 1.0));
  expect_mass("FVOPT 1", FabricBox(box_end, p, p).held().gas().run(), power_decay(0.5 * (box_k - 1.0), rate));
  Porosity without = p;
  without.fvopt = 0;
  expect_mass("FVOPT 0, OPT 2", FabricBox(box_end, without, without).held().gas(0.0, 2.0).run(),
              power_decay(0.5 * (box_k - 1.0), rate));
  EXPECT_EQ(FabricBox(1e-4, without, without).held().gas().run().leaked, 0.0);
  // FAC over the absolute pressure, 2 p: the flow falls as m^((3 k + 1)/2).
  Porosity by_curve = p;
  by_curve.fac = -7;
  FabricBox box(box_end, by_curve, by_curve);
  box.specimen.text(curve(7, {{0.0, 0.0}, {1.0, 2.0}}));
  expect_mass("FVOPT 1, FAC by a curve", box.held().gas().run(), power_decay(0.5 * (3.0 * box_k - 1.0), rate));
  // Area X0 + X1, where nothing is stretched and nothing presses from outside.
  const Porosity by_stretch{.flc = 0.5, .fac = 0.7, .fvopt = 1, .x0 = 0.005, .x1 = 0.003};
  expect_mass("FVOPT 1, X0 and X1", FabricBox(box_end, by_stretch, by_stretch).held().gas().run(),
              power_decay(0.5 * (box_k - 1.0), rate));
}

// The velocity sqrt(2 (p - pe)/density) is sqrt(2 R T) into a vacuum. Only the top leaks.
TEST(PorousFabric, LeaksByThePressure) {
  const Porosity p{.flc = 0.03, .fac = 1.0, .fvopt = 3};
  const double rate = p.flc * box_area / 6.0 / box_volume * std::sqrt(2.0 * box_r * box_temperature);
  expect_mass("FVOPT 3, the top alone", FabricBox(box_end, {}, p).held().gas().run(),
              power_decay(0.5 * (box_k - 1.0), rate));
}

// With a velocity v the mass falls by exp(-FLC v A t/V); v = c p: as m^(k + 1); FLC = b t: by exp(-b v A t^2/2V).
TEST(PorousFabric, LeaksWithAVelocity) {
  constexpr double velocity = 2000.0, flc = 0.8;
  const auto box = [&](double leak, const std::string& curves) {
    const Porosity p{.flc = leak, .fac = -7, .fvopt = 7};
    FabricBox made(box_end, p, p);
    made.specimen.text(curves);
    return made.held().gas().run();
  };
  const double rate = flc * velocity * box_area / box_volume;
  expect_mass("FVOPT 7", box(flc, constant_curve(7, velocity)), std::exp(-rate * box_end));
  expect_mass("FVOPT 7, a velocity as the pressure", box(flc, curve(7, {{0.0, 0.0}, {1.0, velocity / box_pressure}})),
              power_decay(box_k, rate));
  expect_mass("FVOPT 7, FLC over time",
              box(-8, constant_curve(7, velocity) + curve(8, {{0.0, 0.0}, {box_end, 2.0 * flc}})),
              std::exp(-rate * box_end));
}

/// The box grows by `rate` x X, so that V = V0 (1 + rate t)^3; mass and energy of its gas by Runge and Kutta's method.
struct GrowingBox {
  double ambient, rate;
  Porosity p;
  /// Outflow of mass for the mass m and the energy e at the time t.
  double leaked(double t, double m, double e) const {
    const double scale = 1.0 + rate * t, v = box_volume * scale * scale * scale, pressure = (box_k - 1.0) * e / v;
    const double s = scale * scale, q = ambient / pressure, density = m / v;
    if (!(pressure > ambient)) return 0.0;
    const double open = box_area * (p.x0 + p.x1 * s + p.flc * q + p.fac * s * q);
    return open * density * std::sqrt(2.0 * (pressure - ambient) / density);
  }
  std::array<double, 2> rates(double t, double m, double e) const {
    const double scale = 1.0 + rate * t, v = box_volume * scale * scale * scale, pressure = (box_k - 1.0) * e / v;
    const double out = leaked(t, m, e);
    return {-out, -out * box_cp * e / (m * box_cv) - pressure * 3.0 * rate * box_volume * scale * scale};
  }
  std::array<double, 2> run(double until) const {
    double m = box_mass, e = box_pressure * box_volume / (box_k - 1.0);
    constexpr int steps = 4000;
    const double dt = until / steps;
    for (int i = 0; i < steps; ++i) {
      const double t = i * dt, h = 0.5 * dt;
      const auto a = rates(t, m, e), b = rates(t + h, m + h * a[0], e + h * a[1]),
                 c = rates(t + h, m + h * b[0], e + h * b[1]), d = rates(t + dt, m + dt * c[0], e + dt * c[1]);
      m += dt / 6.0 * (a[0] + 2.0 * b[0] + 2.0 * c[0] + d[0]);
      e += dt / 6.0 * (a[1] + 2.0 * b[1] + 2.0 * c[1] + d[1]);
    }
    return {m, e};
  }
};

// Anagonye and Wang's area grows with the fabric and falls with the pressure. Sabotages: A for A0 and the other way
// round, p/pe for pe/p, X2 and X3 exchanged.
TEST(PorousFabric, LeaksByItsStretch) {
  constexpr double ambient = 0.08, rate = 50.0;  // a fifth longer in the end
  const Porosity p{.flc = 0.006, .fac = 0.002, .fvopt = 3, .x0 = 0.004, .x1 = 0.008};
  FabricBox box(box_end, p, p);
  box.gas(ambient).specimen.text(constant_curve(9, 1.0)).card("CONTROL_TIMESTEP", {0, 0.3});
  for (const auto& [at, id] : box.nodes)
    for (int i = 0; i < 3; ++i) {
      const double x = box_side / FabricBox::cells * at[static_cast<std::size_t>(i)];
      if (x > 0.0)
        box.specimen.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {1.0 * id, 1.0 + i, 0, 9, rate * x});
      else
        box.specimen.card("BOUNDARY_SPC_NODE",
                          {1.0 * id, 0, i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0});
    }
  const impact::Bag gas = box.run();
  const auto [mass, energy] = GrowingBox{ambient, rate, p}.run(box_end);
  const double volume = box_volume * std::pow(1.0 + rate * box_end, 3);
  expect_reference("porous fabric", "FVOPT 3, X0 to X3, a box that grows, Runge-Kutta: mass over that at the start [1]",
                   gas.mass / box_mass, mass / box_mass, 1e-4);
  expect_reference("porous fabric", "the same: pressure [MPa]", gas.pressure, (box_k - 1.0) * energy / volume, 1e-4);
}

/// Mass at the end where a plate over x below `width` comes down onto the top and touches it at a quarter of the time.
double left_under_a_plate(double fvopt, double ela, double width) {
  constexpr double gap = 1.0, thickness = 0.3, speed = gap / (0.25 * box_end);
  const Porosity p{.flc = 1.0, .fac = -7, .ela = ela, .fvopt = fvopt};
  FabricBox box(box_end, {}, p);
  Specimen& s = box.specimen;
  s.text(constant_curve(7, 2000.0)).text(constant_curve(9, 1.0)).part(3, 2, 3);
  s.text("*MAT_RIGID\n" + fields({3, 1e-9, 1000, 0.3}) + fields({1, 4, 7}) + "\n");
  s.text("*SECTION_SHELL\n" + fields({2, 2}) + fields({thickness, thickness, thickness, thickness}));
  s.shells(3, {-10, -10, box_side + thickness + gap}, {width + 10, box_side + 20, 0}, 1, 1);
  s.card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {3, 3, 0, 9, -speed});
  s.text("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n" + fields({2, 3, 3, 3}) + fields({0}) + fields({0}));
  return box.held().gas().run().mass / box_mass;
}

// Where a plate presses on the fabric the share ELA of it leaks. Sabotages: FVOPT 7 for 8, the area that is covered for
// the one that is not.
TEST(PorousFabric, LeaksLessWhereAPlateCoversIt) {
  const double open = 2000.0 * box_area / 6.0 / box_volume * box_end;
  const auto expected = [&](double share) { return std::exp(-open * (0.25 + 0.75 * share)); };
  expect_reference("porous fabric", "FVOPT 8, a plate from a quarter of the time on: mass over that at the start [1]",
                   left_under_a_plate(8, 0.0, box_side + 10), expected(0.0), 1e-3);
  expect_reference("porous fabric", "FVOPT 8, ELA 0.3: mass over that at the start [1]",
                   left_under_a_plate(8, 0.3, box_side + 10), expected(0.3), 1e-3);
  expect_reference("porous fabric", "FVOPT 7, whatever presses: mass over that at the start [1]",
                   left_under_a_plate(7, 0.3, box_side + 10), expected(1.0), 1e-3);
  // Three of five rows of nodes are under the plate: two rows of shells, and half of the third.
  expect_reference("porous fabric", "FVOPT 8, a plate over a part of it: mass over that at the start [1]",
                   left_under_a_plate(8, 0.0, 60.0), expected(1.0 - 2.5 / 4.0), 1e-3);
}

std::string message(const FabricBox& box) {
  try {
    Experiment experiment(box.specimen.deck());
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "accepted";
}

TEST(PorousFabric, WhatIsRefused) {
  using testing::HasSubstr;
  const auto of = [](const Porosity& p, double option = 0.0) {
    return message(FabricBox(1e-4, p, {}).held().gas(0.0, option));
  };
  EXPECT_THAT(of({.flc = 0.1, .fac = 1, .fvopt = 5}), HasSubstr("fvopt = 5: leakage as through a porous medium"));
  EXPECT_THAT(of({.flc = 0.1, .fac = 1}, 6), HasSubstr("opt = 6: leakage as through a porous medium"));
  EXPECT_THAT(of({.flc = 0.1, .fac = 1, .fvopt = 9}), HasSubstr("there is no such formula of leakage"));
  EXPECT_THAT(of({.flc = 0.1, .fac = 1, .fvopt = 7}), HasSubstr("fac = 1: with FVOPT 7 and 8 the velocity of the gas"));
  EXPECT_THAT(of({.flc = 0.1, .fac = 1, .fvopt = 1, .x0 = -1}), HasSubstr("X0 below 0 is not built"));
  EXPECT_THAT(of({.flc = 0.1, .fac = -8, .fvopt = 8, .x0 = 1}), HasSubstr("which FVOPT 7 and 8 take from FAC"));
  EXPECT_THAT(of({.flc = -8, .fac = 1, .fvopt = 1}), HasSubstr("flc = -8: curve 8 is not defined"));
}

}  // namespace
}  // namespace nugget::verify
