// SPDX-License-Identifier: Apache-2.0
// Gas in a chamber whose lid moves: pressure over volume, the work that it does on the lid; gas that flows in and out.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "base/index.hpp"
#include "model/control_volume.hpp"
#include "model/segments.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double side = 100.0, height = 50.0, area = side * side, pressure = 0.2, density = 7.85e-9, thickness = 2.0;
constexpr double mass = density * thickness * area;

/// A lid of 4 x 4 rigid shells over a fixed bottom; the walls between them are faces without elements.
struct Chamber {
  Specimen specimen;
  Grid bottom, lid;

  explicit Chamber(double end_time, bool with_bottom = true, bool held = false) {
    specimen.text("*MAT_RIGID\n" + fields({1, density, 210000, 0.3}) + (held ? fields({1, 7, 7}) : fields({0})) + "\n")
        .text("*MAT_RIGID\n" + fields({2, density, 210000, 0.3}) + fields({1, 7, 7}) + "\n")
        .text("*SECTION_SHELL\n" + fields({1, 2}) + fields({thickness, thickness, thickness, thickness}))
        .card("CONTROL_TERMINATION", {end_time})
        .part(1, 1, 1)
        .part(2, 1, 2);
    bottom = specimen.shells(2, {}, {side, side, 0}, 4, 4);
    lid = specimen.shells(1, {0, 0, height}, {side, side, 0}, 4, 4);
    std::string faces = "*SET_SEGMENT\n" + fields({1});
    const auto add = [&](int a, int b, int c, int d) { faces += fields({1.0 * a, 1.0 * b, 1.0 * c, 1.0 * d}); };
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        add(lid(i, j), lid(i + 1, j), lid(i + 1, j + 1), lid(i, j + 1));
        if (with_bottom) add(bottom(i, j), bottom(i, j + 1), bottom(i + 1, j + 1), bottom(i + 1, j));
      }
      add(bottom(i, 0), bottom(i + 1, 0), lid(i + 1, 0), lid(i, 0));
      add(bottom(i + 1, 4), bottom(i, 4), lid(i, 4), lid(i + 1, 4));
      add(bottom(0, i + 1), bottom(0, i), lid(0, i), lid(0, i + 1));
      add(bottom(4, i), bottom(4, i + 1), lid(4, i + 1), lid(4, i));
    }
    specimen.text(faces);
  }

  struct End {
    double height, kinetic, balance, force;
  };
  End run() {
    Experiment experiment(specimen.deck());
    End end{};
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      const double v = experiment.velocity(now, lid(2, 2)).z;
      end.height = height + experiment.displacement(now, lid(2, 2)).z;
      end.kinetic = 0.5 * mass * v * v;
      end.balance = std::max(end.balance, std::abs(now.energy.total() - now.energy.external));
      if (now.state.time > 0.0) end.force = mass * v / now.state.time;
    });
    return end;
  }
};

/// The work of a gas with p V = const from the start to `h`.
double isothermal(double h) {
  return pressure * area * height * std::log(h / height);
}

// Sabotage: the sign of the pressure, the relative volume upside down, a face left out of the volume.
TEST(ControlVolumes, LidOverATyresGas) {
  Chamber chamber(4e-3);
  chamber.specimen.card("AIRBAG_SIMPLE_PRESSURE_VOLUME", {1}).text(fields({2 * pressure, 0.5}));
  const Chamber::End end = chamber.run();
  EXPECT_GT(end.height, 1.5 * height);
  expect_reference("control volumes", "*AIRBAG_SIMPLE_PRESSURE_VOLUME: energy of the lid [N mm]", end.kinetic,
                   isothermal(end.height), 1e-3);
  expect_reference("control volumes", "*AIRBAG_SIMPLE_PRESSURE_VOLUME: energy balance [N mm]", end.balance, 0.0, 1e-6,
                   1.0);
}

// Under a bilinear face over the unit square lies the mean height of its corners. Sabotage: the face cut along one
// diagonal, which gives 7/6 or 4/3 of the square.
TEST(ControlVolumes, AWarpedFaceIsBilinear) {
  const std::vector<Vec3d> x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::vector<model::Segment> faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const auto place = [&](model::Index n) { return x.at(at(n)); };
  EXPECT_TRUE(model::surface_border(faces).openings.empty());
  EXPECT_NEAR(model::enclosed_volume(faces, {}, place), 1.25, 1e-14);
  faces.erase(faces.begin() + 2);  // a plane side: its four edges are one opening
  const auto border = model::surface_border(faces);
  EXPECT_TRUE(border.twisted.empty());
  ASSERT_EQ(border.openings.size(), 1u);
  EXPECT_EQ(border.openings[0].edges.size(), 4u);
  EXPECT_NEAR(model::enclosed_volume(faces, border.openings, place), 1.25, 1e-14);
}

TEST(ControlVolumes, AnOpeningIsCovered) {
  Chamber chamber(4e-3, false);
  chamber.specimen.card("AIRBAG_SIMPLE_PRESSURE_VOLUME", {1}).text(fields({pressure, 1}));
  const Chamber::End end = chamber.run();
  expect_reference("control volumes", "a bottom without faces: energy of the lid [N mm]", end.kinetic,
                   isothermal(end.height), 1e-3);
}

TEST(ControlVolumes, LidOverAnAdiabaticGas) {
  constexpr double gamma = 1.4, gauge = 0.2, ambient = 0.1, absolute = gauge + ambient, scale = 0.9;
  Chamber chamber(4e-3);
  chamber.specimen.card("AIRBAG_ADIABATIC_GAS_MODEL", {1}).text(fields({scale, 0, gamma, gauge, ambient, 1.2e-12}));
  const Chamber::End end = chamber.run();
  const double work = absolute * area * height / (gamma - 1.0) * (1.0 - std::pow(height / end.height, gamma - 1.0)) -
                      ambient * area * (end.height - height);
  EXPECT_GT(end.height, 1.3 * height);
  expect_reference("control volumes", "*AIRBAG_ADIABATIC_GAS_MODEL: energy of the lid [N mm]", end.kinetic,
                   scale * work, 1e-3);
}

// Until the preload is over the pressure does not follow the volume.
TEST(ControlVolumes, PreloadOfAnAdiabaticGas) {
  Chamber chamber(4e-3);
  chamber.specimen.text(curve(7, {{0.0, 0.0}, {1.0, 0.0}}))
      .card("AIRBAG_ADIABATIC_GAS_MODEL", {1})
      .text(fields({0.9, 7, 1.4, 0.2, 0.1}));
  const Chamber::End end = chamber.run();
  EXPECT_GT(end.height, 1.3 * height);
  expect_reference("control volumes", "preload of the adiabatic gas: energy of the lid [N mm]", end.kinetic,
                   0.9 * 0.2 * area * (end.height - height), 1e-4);
}

/// Mean force on the lid over 1e-5, in which it hardly moves.
double first_force(const std::string& keywords) {
  Chamber chamber(1e-5);
  chamber.specimen.text(keywords);
  return chamber.run().force;
}

// Each field by the pressure at the start. Sabotage of any one of them fails.
TEST(ControlVolumes, PressureAtTheStart) {
  const auto gas = [](std::initializer_list<double> volume, std::initializer_list<double> card) {
    return "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + fields(volume) + fields(card);
  };
  const auto check = [](const std::string& what, double force, double p) {
    expect_reference("control volumes", what + ": force on the lid [N]", force, p * area, 2e-3);
  };
  check("PSCA 1.5", first_force(gas({1, 0, 0, 1, 1.5}, {pressure, 1})), 1.5 * pressure);
  check("VSCA 2", first_force(gas({1, 0, 0, 2}, {pressure, 1})), pressure);
  check("CN as a curve", first_force(constant_curve(7, 0.1) + gas({1}, {-7, 3})), 0.3);
  check("LCID", first_force(curve(7, {{0.5, 0.4}, {1.5, 0.2}}) + gas({1}, {pressure, 1, 7})), 0.3);
  check("the adiabatic gas, P0 above PE",
        first_force(constant_curve(7) + "*AIRBAG_ADIABATIC_GAS_MODEL\n" + fields({1}) + fields({2, 7, 1.4, 0.3, 0.1})),
        0.6);
}

// In the relaxation the lid moves only where LCIDDR has a pressure; in the run, which is next to nothing, CN holds.
// Sabotage: CN in both.
TEST(ControlVolumes, AnotherCurveInDynamicRelaxation) {
  const auto lifted = [](double level) {
    Chamber chamber(1e-8);
    chamber.specimen.card("CONTROL_DYNAMIC_RELAXATION", {10, 1e-3, 0.995, 1e-4, 0, 0, 0, 1})
        .text(constant_curve(7, level) + "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + fields({1}) +
              fields({pressure, 1, 0, 7}));
    return chamber.run().height - height;
  };
  EXPECT_NEAR(lifted(0.0), 0.0, 1e-6);
  EXPECT_GT(lifted(pressure), 1e-3);
}

// Air in t, mm, s, K.
constexpr double cp = 1004.5e6, cv = 717.5e6, r = cp - cv, k = cp / cv, ambient = 0.101325, ambient_density = 1.2e-12;

/// Gas and lid by the equations of a control volume, with a Runge-Kutta method and small steps.
struct Reference {
  double m = ambient_density * area * height, energy = ambient * area * height / (k - 1.0), h = height, v = 0.0;
  double lid = 0.0;  ///< its mass; 0: held
  std::function<double(double t)> inflow = [](double) { return 0.0; };
  std::function<double(double p, double temperature)> outflow = [](double, double) { return 0.0; };
  double inflow_temperature = 400.0;

  double p() const { return (k - 1.0) * energy / (area * h); }
  double temperature() const { return energy / (m * cv); }
  void run(double from, double to, int steps) {
    const double dt = (to - from) / steps;
    using Rates = std::array<double, 4>;
    const auto rates = [this](double t, const Rates& y) {
      Reference now = *this;
      now.m = y[0], now.energy = y[1], now.h = y[2], now.v = y[3];
      const double in = inflow(t), out = now.p() > ambient ? outflow(now.p(), now.temperature()) : 0.0;
      return Rates{in - out, in * cp * inflow_temperature - out * cp * now.temperature() - now.p() * area * now.v,
                   now.v, lid > 0.0 ? (now.p() - ambient) * area / lid : 0.0};
    };
    const auto plus = [](Rates a, double factor, const Rates& b) {
      for (std::size_t i = 0; i < 4; ++i) a[i] += factor * b[i];
      return a;
    };
    for (int i = 0; i < steps; ++i) {
      const double t = from + i * dt;
      const Rates y{m, energy, h, v}, a = rates(t, y), b = rates(t + 0.5 * dt, plus(y, 0.5 * dt, a)),
                                      c = rates(t + 0.5 * dt, plus(y, 0.5 * dt, b)), d = rates(t + dt, plus(y, dt, c));
      const Rates end = plus(plus(plus(plus(y, dt / 6.0, a), dt / 3.0, b), dt / 3.0, c), dt / 6.0, d);
      m = end[0], energy = end[1], h = end[2], v = end[3];
    }
  }
};

/// Flow of air through an opening, in the two forms of textbooks.
double nozzle(double opening, double p, double temperature) {
  const double ratio = ambient / p;
  if (ratio < std::pow(2.0 / (k + 1.0), k / (k - 1.0)))
    return opening * p * std::sqrt(k / (r * temperature)) * std::pow(2.0 / (k + 1.0), 0.5 * (k + 1.0) / (k - 1.0));
  return opening * p * std::pow(ratio, 1.0 / k) *
         std::sqrt(2.0 / (r * temperature) * k / (k - 1.0) * (1.0 - std::pow(ratio, (k - 1.0) / k)));
}

std::string air(double inflow_curve, double mu = 0.0, double vent = 0.0, double lou = 0.0) {
  return "*AIRBAG_SIMPLE_AIRBAG_MODEL\n" + fields({1}) +
         fields({cv, cp, 400.0, inflow_curve, mu, vent, ambient, ambient_density}) + fields({lou});
}

using GasWatch = std::function<void(double time, const impact::Bag&)>;
/// The gas at the end.
impact::Bag gas_of(
    const Chamber& chamber, const GasWatch& watch = [](double, const impact::Bag&) {}) {
  Experiment experiment(chamber.specimen.deck());
  impact::Bag end;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    end = now.components.loads.of<model::ControlVolume>().front().gas().bag;
    watch(now.state.time, end);
  });
  return end;
}

// What flows in brings its enthalpy. Sabotage: cv in the place of cp; the curve over one time step late.
TEST(FlowingGas, ARigidBoxIsFilled) {
  constexpr double end = 4e-3, slope = 0.1;  // q = slope t
  Chamber chamber(end, true, true);
  chamber.specimen.text(curve(7, {{0.0, 0.0}, {2.0 * end, 2.0 * end * slope}}) + air(7));
  const impact::Bag gas = gas_of(chamber);
  const double in = 0.5 * slope * end * end, m = ambient_density * area * height + in;
  const double energy = ambient * area * height / (k - 1.0) + in * cp * 400.0;
  expect_reference("flowing gas", "a rigid box is filled: pressure [MPa]", gas.pressure,
                   (k - 1.0) * energy / (area * height), 1e-9);
  expect_reference("flowing gas", "the same: temperature [K]", gas.temperature, energy / (m * cv), 1e-9);
  expect_reference("flowing gas", "the same: mass [t]", gas.mass, m, 1e-9);
  EXPECT_DOUBLE_EQ(gas.inflow, slope * end);
}

// A box filled to 4 bar until 1 ms loses its gas through a hole; while the flow is choked, until about 1.9 bar,
// p/p0 = (1 + (k - 1)/2 K t)^(-2 k/(k - 1)), K = mu A / V sqrt(k R T0) (2/(k + 1))^((k + 1)/(2 (k - 1))).
// Sabotages: temperature of what leaves, the critical ratio, a factor 2 in the flow.
TEST(FlowingGas, ABoxIsEmptiedThroughAVent) {
  constexpr double filled = 1e-3, end = 40e-3, mu = 0.7, vent = 300.0, q = 1e-3;
  Chamber chamber(end, true, true);
  chamber.specimen.text(curve(7, {{0.0, q}, {filled, q}, {filled + 1e-9, 0.0}, {1.0, 0.0}}) + air(7, mu, vent));
  Reference reference;
  reference.inflow = [](double t) { return t < filled ? q : 0.0; };
  reference.outflow = [](double p, double temperature) { return nozzle(mu * vent, p, temperature); };
  impact::Bag full, half;
  double start = 0.0, time = 0.0, lowest = 1.0;
  const impact::Bag gas = gas_of(chamber, [&](double t, const impact::Bag& bag) {
    if (start == 0.0 && t > 1.1 * filled) full = bag, start = t;
    if (time == 0.0 && start > 0.0 && bag.pressure < 1.95 * ambient) half = bag, time = t;
    lowest = std::min(lowest, bag.pressure);
  });
  ASSERT_GT(time, 0.0);
  const double rate = mu * vent / (area * height) * std::sqrt(k * r * full.temperature) *
                      std::pow(2.0 / (k + 1.0), 0.5 * (k + 1.0) / (k - 1.0));
  EXPECT_GT(full.pressure, 3.0 * ambient);
  expect_reference("flowing gas", "choked discharge, closed form: pressure [MPa]", half.pressure,
                   full.pressure * std::pow(1.0 + 0.5 * (k - 1.0) * rate * (time - start), -2.0 * k / (k - 1.0)), 1e-4);
  reference.run(0.0, filled, 1000);
  reference.run(filled, time, 2000);
  expect_reference("flowing gas", "filling and choked discharge, Runge-Kutta: pressure [MPa]", half.pressure,
                   reference.p(), 1e-3);
  const double until = time + 3e-3;
  Chamber shorter(until, true, true);
  shorter.specimen.text(curve(7, {{0.0, q}, {filled, q}, {filled + 1e-9, 0.0}, {1.0, 0.0}}) + air(7, mu, vent));
  reference.run(time, until, 2000);
  EXPECT_LT(reference.p(), 1.7 * ambient);
  EXPECT_GT(reference.p(), 1.05 * ambient);
  expect_reference("flowing gas", "discharge below the critical ratio: pressure [MPa]", gas_of(shorter).pressure,
                   reference.p(), 1e-3);
  expect_reference("flowing gas", "the box empty: pressure [MPa]", gas.pressure, ambient, 1e-6);
  EXPECT_GE(lowest, ambient * (1.0 - 1e-9));
}

// A lid is blown up from rest. The gas keeps what flowed in but for the work on lid and surroundings.
TEST(FlowingGas, ALidIsLiftedByWhatFlowsIn) {
  constexpr double end = 4e-3, q = 4e-4;
  Chamber chamber(end);
  chamber.specimen.text(constant_curve(7, q) + air(7));
  impact::Bag gas;
  double balance = 0.0, kinetic = 0.0, h = 0.0;
  Experiment experiment(chamber.specimen.deck());
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    gas = now.components.loads.of<model::ControlVolume>().front().gas().bag;
    const double v = experiment.velocity(now, chamber.lid(2, 2)).z;
    h = height + experiment.displacement(now, chamber.lid(2, 2)).z;
    kinetic = 0.5 * mass * v * v;
    balance = std::max(balance, std::abs(now.energy.total() - now.energy.external));
  });
  Reference reference;
  reference.lid = mass;
  reference.inflow = [](double) { return q; };
  reference.run(0.0, end, 4000);
  EXPECT_GT(h, 1.3 * height);
  expect_reference("flowing gas", "a lid is lifted, Runge-Kutta: height [mm]", h, reference.h, 1e-3);
  expect_reference("flowing gas", "the same: pressure [MPa]", gas.pressure, reference.p(), 1e-3);
  expect_reference("flowing gas", "the same: energy of the gas, from its inflow and the lid's [N mm]", gas.energy,
                   ambient * area * height / (k - 1.0) + q * end * cp * 400.0 - kinetic - ambient * area * (h - height),
                   1e-4);
  expect_reference("flowing gas", "the same: energy balance of the model [N mm]", balance, 0.0, 1e-6, 1.0);
}

// As a tyre: filled within 1 ms, then pressed together by a fifth: p V^k = const.
TEST(FlowingGas, ATyreIsFilledAndPressed) {
  constexpr double filled = 1e-3, end = 3e-3, q = 6e-4;
  Chamber chamber(end);
  chamber.specimen.text(curve(7, {{0.0, q}, {filled, q}, {filled + 1e-9, 0.0}, {1.0, 0.0}}) + air(7))
      .text("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n" + fields({1, 3, 2, 8}) +
            curve(8, {{0.0, 0.0}, {1.5 * filled, 0.0}, {end, -0.2 * height}}));
  impact::Bag full;
  const impact::Bag gas = gas_of(chamber, [&](double t, const impact::Bag& bag) {
    if (t < 1.4 * filled) full = bag;
  });
  const double energy = ambient * area * height / (k - 1.0) + q * filled * cp * 400.0;
  expect_reference("flowing gas", "a tyre is filled: pressure [MPa]", full.pressure,
                   (k - 1.0) * energy / (area * height), 1e-3);
  expect_reference("flowing gas", "the tyre is pressed: pressure [MPa]", gas.pressure,
                   full.pressure * std::pow(gas.volume / full.volume, -k), 1e-5);
  EXPECT_LT(gas.volume, 0.81 * full.volume);
  EXPECT_DOUBLE_EQ(gas.mass, full.mass);
}

// LOU is over the gauge pressure; it and the vent take nothing from a gas at the ambient pressure.
TEST(FlowingGas, OutflowByCurves) {
  constexpr double end = 4e-3, q = 2e-4;
  const auto filled_with = [&](const std::string& keywords) {
    Chamber chamber(end, true, true);
    chamber.specimen.text(constant_curve(7, q) + keywords);
    return gas_of(chamber);
  };
  const auto expected = [&](const std::function<double(double, double)>& outflow) {
    Reference reference;
    reference.inflow = [](double) { return q; };
    reference.outflow = outflow;
    reference.run(0.0, end, 4000);
    return reference.p();
  };
  expect_reference("flowing gas", "LOU over the gauge pressure: pressure [MPa]",
                   filled_with(curve(8, {{0.0, 0.0}, {1.0, 1e-3}}) + air(7, 0, 0, 8)).pressure,
                   expected([](double p, double) { return 1e-3 * (p - ambient); }), 1e-3);
  const auto rising = [](double p) { return 100.0 * (p - 0.1); };  // over the absolute pressure
  expect_reference("flowing gas", "AREA as a curve: pressure [MPa]",
                   filled_with(curve(8, {{0.1, 0.0}, {1.1, 100.0}}) + air(7, 0.7, -8)).pressure,
                   expected([&](double p, double t) { return nozzle(0.7 * rising(p), p, t); }), 1e-3);
  expect_reference("flowing gas", "MU as a curve: pressure [MPa]",
                   filled_with(curve(8, {{0.1, 0.0}, {1.1, 100.0}}) + air(7, -8, 0.7)).pressure,
                   expected([&](double p, double t) { return nozzle(0.7 * rising(p), p, t); }), 1e-3);
  EXPECT_DOUBLE_EQ(filled_with(constant_curve(8, 1.0) + air(0, 0, 0, 8)).pressure, ambient);
}

// cp = (A + B T)/MW: enthalpy and energy are its integrals. Sabotage: cp T for the enthalpy.
TEST(FlowingGas, HeatCapacityGrowsWithTemperature) {
  constexpr double end = 4e-3, q = 2e-4, inflow_temperature = 800.0;
  constexpr double mole = 0.029e-3, gas_constant = 8.314e3, a = 27.0e3, b = 7.0;  // t, N mm/K, N mm/K^2
  Chamber chamber(end, true, true);
  chamber.specimen.text(constant_curve(7, q) + "*AIRBAG_SIMPLE_AIRBAG_MODEL\n" + fields({1}) +
                        fields({0, 0, inflow_temperature, 7, 0, 0, ambient}) +
                        fields({0, 290, a, b, mole, gas_constant}));
  const impact::Bag gas = gas_of(chamber);
  const double moles = ambient * area * height / (gas_constant * 290.0), added = q * end / mole;
  const auto energy = [&](double t) { return (a - gas_constant) * t + 0.5 * b * t * t; };
  const double all = moles * energy(290.0) + added * (energy(inflow_temperature) + gas_constant * inflow_temperature);
  double low = 290.0, high = 2000.0;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    ((moles + added) * energy(middle) < all ? low : high) = middle;
  }
  expect_reference("flowing gas", "heat capacity by A, B, MW: temperature [K]", gas.temperature, low, 1e-8);
  expect_reference("flowing gas", "the same: pressure [MPa]", gas.pressure,
                   (moles + added) * gas_constant * low / (area * height), 1e-8);
}

// Faces whose normals all point inwards, as those of LSTC's public airbag do: the gas pushes the lid up all the same.
TEST(ControlVolumes, NormalsThatAllPointInwardsAreTurned) {
  const auto force = [](bool inwards) {
    Chamber chamber(1e-5);
    const Grid &lid = chamber.lid, &low = chamber.bottom;
    std::string faces = "*SET_SEGMENT\n" + fields({2});
    const auto add = [&](int a, int b, int c, int d) {
      faces += inwards ? fields({1.0 * d, 1.0 * c, 1.0 * b, 1.0 * a}) : fields({1.0 * a, 1.0 * b, 1.0 * c, 1.0 * d});
    };
    add(lid(0, 0), lid(4, 0), lid(4, 4), lid(0, 4));
    add(low(0, 0), low(0, 4), low(4, 4), low(4, 0));
    add(low(0, 0), low(4, 0), lid(4, 0), lid(0, 0));
    add(low(4, 4), low(0, 4), lid(0, 4), lid(4, 4));
    add(low(0, 4), low(0, 0), lid(0, 0), lid(0, 4));
    add(low(4, 0), low(4, 4), lid(4, 4), lid(4, 0));
    chamber.specimen.text(faces).text("*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + fields({2}) + fields({pressure, 1}));
    return chamber.run().force;
  };
  EXPECT_GT(force(false), 0.9 * pressure * area);
  EXPECT_NEAR(force(true), force(false), 1e-9 * pressure * area);
}

// A strip of three faces with half a turn in it has one side only.
TEST(ControlVolumes, FacesAreTurnedUntilNeighboursAgree) {
  using Faces = std::vector<model::Segment>;
  const Faces cube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  Faces some = cube;
  for (const std::size_t f : {1u, 4u}) some[f] = model::turned_over(some[f]);
  EXPECT_EQ(model::turn_faces_to_agree(some), (std::vector<std::size_t>{1, 4}));
  EXPECT_EQ(model::surface_border(some).twisted.size(), 0u);
  EXPECT_TRUE(model::turn_faces_to_agree(some).empty());
  Faces strip{{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 0, 1}};
  model::turn_faces_to_agree(strip);
  EXPECT_EQ(model::surface_border(strip).twisted.size(), 1u);
}

// The lid alone, as a part set, has an opening that its cover closes flat: no volume.
TEST(ControlVolumes, WhatIsRefused) {
  const auto message = [](const std::string& keywords, bool twisted) {
    Chamber chamber(1e-5);
    if (twisted) {
      const auto a = [&](int i) { return 1.0 * chamber.lid(i, 0); };
      const auto b = [&](int i) { return 1.0 * chamber.lid(i, 1); };
      chamber.specimen.text("*SET_SEGMENT\n" + fields({2}) + fields({a(0), b(0), b(1), a(1)}) +
                            fields({a(1), b(1), b(2), a(2)}) + fields({a(2), b(2), a(0), b(0)}));
    }
    chamber.specimen.text(keywords);
    try {
      Experiment experiment(chamber.specimen.deck());
    } catch (const std::runtime_error& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  using testing::HasSubstr;
  EXPECT_THAT(message("*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + fields({2}) + fields({1, 1}), true),
              testing::ContainsRegex(
                  "normals of neighbours disagree at 1 edge, the first from node [0-9]+ to [0-9]+, between shell "
                  "17 and face [0-9 ]+ .turn the elements"));
  EXPECT_THAT(message("*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + fields({1}) + fields({0.2}), false),
              HasSubstr("neither LCID nor CN times BETA is given"));
  EXPECT_THAT(message("*SET_PART_LIST\n" + fields({3}) + fields({1}) + "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" +
                          fields({3, 1}) + fields({0.2, 1}),
                      false),
              HasSubstr("the faces enclose no volume"));
  EXPECT_THAT(message("*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + fields({1}) + fields({-9, 1}), false),
              HasSubstr("curve 9 is not defined"));
  const auto bag = [&](const std::string& gas) {
    return message("*AIRBAG_SIMPLE_AIRBAG_MODEL\n" + fields({1}) + gas, false);
  };
  EXPECT_THAT(bag(fields({1, 1, 300, 0, 0, 0, 0.1, 1e-12}) + fields({0})), HasSubstr("is not above CV"));
  EXPECT_THAT(bag(fields({0, 1, 300, 0, 0, 0, 0.1, 1e-12}) + fields({0})), HasSubstr("without CV the gas needs MW"));
  EXPECT_THAT(bag(fields({1, 2, 0, 0, 0, 0, 0.1}) + fields({0})), HasSubstr("there is no mass at the start"));
  EXPECT_THAT(bag(fields({1, 2, 0, 0, -9, 1, 0.1, 1e-12}) + fields({0})), HasSubstr("mu = -9: curve 9 is not defined"));
  EXPECT_THAT(bag(fields({1, 2, 0, 0, 0.7, 1, 0.1, 1e-12}) + fields({7}) + constant_curve(7)),
              HasSubstr("the outflow is given twice"));
  EXPECT_THAT(bag(fields({1, 2, 0, 7, 0, 0, 0.1, 1e-12}) + fields({0}) + constant_curve(7)),
              HasSubstr("the gas that flows in has no temperature"));
  EXPECT_THAT(bag(fields({1, 2, 300, 7, 0, 0, 0.1, 1e-12}) + fields({0}) + constant_curve(7, -1)),
              HasSubstr("this curve has values below 0"));
}

/// *AIRBAG_WANG_NEFSKE: inflow at 400 K or by `temperature`, holes and curves as on its third card, what is on its
/// fourth behind GC.
std::string wang_nefske(double inflow_curve, double temperature, std::initializer_list<double> holes,
                        std::initializer_list<double> more = {}) {
  std::string outside = fmt::format("{:10}{:10.3g}{:10}", ambient, ambient_density, 1);
  for (const double value : more) outside += fmt::format("{:10.4g}", value);
  return "*AIRBAG_WANG_NEFSKE\n" + fields({1}) +
         fields({cv, cp, temperature == 0.0 ? 400.0 : 0.0, temperature, inflow_curve}) + fields(holes) + outside +
         "\n" + fields({});
}

// LCT: the temperature of what flows in grows with time; its enthalpy over time is a parabola. Sabotage: the
// temperature at the start of the run, or that of T.
TEST(WangNefske, ARigidBoxIsFilledWithHotterAndHotterGas) {
  constexpr double end = 4e-3, q = 2e-4, slope = 1e5;
  Chamber chamber(end, true, true);
  chamber.specimen.text(constant_curve(7, q))
      .text(curve(8, {{0.0, 300.0}, {2.0 * end, 300.0 + 2.0 * end * slope}}))
      .text(wang_nefske(7, 8, {}));
  const impact::Bag gas = gas_of(chamber);
  const double energy = ambient * area * height / (k - 1.0) + q * cp * (300.0 * end + 0.5 * slope * end * end);
  expect_reference("flowing gas", "*AIRBAG_WANG_NEFSKE, a rigid box, LCT: pressure [MPa]", gas.pressure,
                   (k - 1.0) * energy / (area * height), 1e-6);
  expect_reference("flowing gas", "the same: mass [t]", gas.mass, ambient_density * area * height + q * end, 1e-9);
}

// A23 below 0: the area of a part's shell, which grows from 200 to 400 mm2 as it is drawn out. Sabotage: the area at
// the start.
TEST(WangNefske, AVentHasTheAreaOfAPart) {
  constexpr double end = 4e-3, q = 4e-4, mu = 0.7, low = 200.0, high = 400.0;
  Chamber chamber(end, true, true);
  chamber.specimen.text("*MAT_ELASTIC\n" + fields({3, density, 210000, 0.3})).part(3, 1, 3);
  const Grid shell = chamber.specimen.shells(3, {0, 0, -90}, {20, low / 20, 0}, 1, 1);
  chamber.specimen.text(curve(9, {{0.0, 0.0}, {end, (high - low) / 20}}))
      .text(constant_curve(7, q))
      .text(wang_nefske(7, 0, {mu, 0, -3}));
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const double node = shell(i, j);
      chamber.specimen.card("BOUNDARY_SPC_NODE", {node, 0, 1, j == 0 ? 1.0 : 0.0, 1, 1, 1, 1});
      if (j == 1) chamber.specimen.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {node, 2, 2, 9});
    }
  Reference reference;
  reference.inflow = [](double) { return q; };
  double time = 0.0;
  reference.outflow = [&](double p, double temperature) {
    return nozzle(mu * (low + (high - low) * time / end), p, temperature);
  };
  constexpr int parts = 400;
  for (int i = 0; i < parts; ++i) {
    time = (i + 0.5) * end / parts;
    reference.run(i * end / parts, (i + 1) * end / parts, 10);
  }
  expect_reference("flowing gas", "*AIRBAG_WANG_NEFSKE, A23 of a part that grows, Runge-Kutta: pressure [MPa]",
                   gas_of(chamber).pressure, reference.p(), 1e-3);
  EXPECT_GT(reference.p(), 1.5 * ambient);
}

// POVER: more gas of the same temperature.
TEST(WangNefske, OverpressureAtTheStart) {
  Chamber chamber(1e-4, true, true);
  chamber.specimen.text(wang_nefske(0, 0, {}, {0, 0.05}));
  const impact::Bag gas = gas_of(chamber);
  expect_reference("flowing gas", "POVER: pressure [MPa]", gas.pressure, ambient + 0.05, 1e-9);
  expect_reference("flowing gas", "POVER: mass [t]", gas.mass, ambient_density * (1.0 + 0.05 / ambient) * area * height,
                   1e-9);
}

// Vent and leak are two holes: of the same shape, one as large as both. Sabotage: one of them left out.
TEST(WangNefske, VentAndLeakAddUp) {
  constexpr double end = 4e-3, q = 4e-4;
  const auto pressure_of = [](const std::string& gas) {
    Chamber chamber(end, true, true);
    chamber.specimen.text(constant_curve(7, q)).text(constant_curve(8, 0.7)).text(constant_curve(9, 60.0)).text(gas);
    return gas_of(chamber).pressure;
  };
  const double whole = pressure_of(air(7, 0.7, 100.0)), closed = pressure_of(air(7));
  EXPECT_LT(whole, 0.9 * closed);
  EXPECT_NEAR(pressure_of(wang_nefske(7, 0, {0.7, 0, 100.0})), whole, 1e-12);
  EXPECT_NEAR(pressure_of(wang_nefske(7, 0, {0.7, 0, 60.0, 0, 0.7, 0, 40.0})), whole, 1e-12);
  EXPECT_NEAR(pressure_of(wang_nefske(7, 0, {0, 8, 0, 9, 0, 8, 40.0})), whole, 1e-12);
}

// PPOP: until the pressure has been reached once, nothing leaves; from then on the vent is open. While it fills, the
// box has p = pe + (k - 1) q cp T t / V. Sabotage: a vent that closes again below PPOP, an absolute pressure.
TEST(WangNefske, TheVentOpensForGoodAtItsPressure) {
  constexpr double filled = 3e-3, q = 4e-4, pop = 0.1;
  const double rate = (k - 1.0) * q * cp * 400.0 / (area * height);
  ASSERT_LT(pop / rate, 1e-3);
  double opened = 0.0;
  const auto end_of = [&](double end) {
    Chamber chamber(end, true, true);
    chamber.specimen.text(curve(7, {{0.0, q}, {filled, q}, {filled + 1e-9, 0.0}, {1.0, 0.0}}))
        .text(wang_nefske(7, 0, {0.7, 0, 100.0}, {0, 0, pop}));
    return gas_of(chamber, [&](double t, const impact::Bag& bag) {
      if (opened == 0.0 && bag.outflow > 0.0) opened = t;
    });
  };
  end_of(1e-3);
  expect_reference("flowing gas", "PPOP: time at which the vent opens [s]", opened, pop / rate, 5e-3);
  EXPECT_LT(end_of(60e-3).pressure - ambient, 0.2 * pop);
}

}  // namespace
}  // namespace nugget::verify
