// SPDX-License-Identifier: Apache-2.0
// Gas in a chamber whose lid moves: pressure over volume, the work that it does on the lid.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "model/control_volume.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double side = 100.0, height = 50.0, area = side * side, pressure = 0.2, density = 7.85e-9, thickness = 2.0;
constexpr double mass = density * thickness * area;
constexpr int gap = 100;  // between the ids of the bottom's nodes and those of the lid above them

/// A lid of 4 x 4 rigid shells over a fixed bottom; the walls between them are faces without elements.
struct Chamber {
  Specimen specimen;
  Grid bottom, lid;

  explicit Chamber(double end_time, bool with_bottom = true) {
    specimen.text("*MAT_RIGID\n" + fields({1, density, 210000, 0.3}) + fields({0}) + "\n")
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
  const auto place = [&](model::Index n) { return x.at(static_cast<std::size_t>(n)); };
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
  constexpr double gamma = 1.4, absolute = 0.3, ambient = 0.1, scale = 0.9;
  Chamber chamber(4e-3);
  chamber.specimen.card("AIRBAG_ADIABATIC_GAS_MODEL", {1}).text(fields({scale, 0, gamma, absolute, ambient, 1.2e-12}));
  const Chamber::End end = chamber.run();
  const double work = absolute * area * height / (gamma - 1.0) * (1.0 - std::pow(height / end.height, gamma - 1.0)) -
                      ambient * area * (end.height - height);
  EXPECT_GT(end.height, 1.3 * height);
  expect_reference("control volumes", "*AIRBAG_ADIABATIC_GAS_MODEL: energy of the lid [N mm]", end.kinetic,
                   scale * work, 1e-3);
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
  check("preload of the adiabatic gas",
        first_force(curve(7, {{0.0, 0.0}, {1.0, 0.0}}) + "*AIRBAG_ADIABATIC_GAS_MODEL\n" + fields({1}) +
                    fields({2, 7, 1.4, 0.3, 0.1})),
        0.6);
  check("the same when it is over",
        first_force(constant_curve(7) + "*AIRBAG_ADIABATIC_GAS_MODEL\n" + fields({1}) + fields({2, 7, 1.4, 0.3, 0.1})),
        0.4);
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

// The lid alone, as a part set, has an opening that its cover closes flat: no volume.
TEST(ControlVolumes, WhatIsRefused) {
  const auto message = [](const std::string& keywords, bool turned) {
    Chamber chamber(1e-5);
    if (turned)
      chamber.specimen.text(
          "*SET_SEGMENT\n" + fields({2}) +
          fields({1.0 * chamber.lid(0, 0), 1.0 * chamber.lid(0, 1), 1.0 * chamber.lid(1, 1), 1.0 * chamber.lid(1, 0)}) +
          fields({1.0 * chamber.lid(1, 0), 1.0 * chamber.lid(2, 0), 1.0 * chamber.lid(2, 1), 1.0 * chamber.lid(1, 1)}));
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
              HasSubstr("normals of neighbours disagree at 1 edge"));
  EXPECT_THAT(message("*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + fields({1}) + fields({0.2}), false),
              HasSubstr("neither LCID nor CN times BETA is given"));
  EXPECT_THAT(message("*SET_PART_LIST\n" + fields({3}) + fields({1}) + "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" +
                          fields({3, 1}) + fields({0.2, 1}),
                      false),
              HasSubstr("the enclosed volume is 0"));
  EXPECT_THAT(message("*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + fields({1}) + fields({-9, 1}), false),
              HasSubstr("curve 9 is not defined"));
}

}  // namespace
}  // namespace nugget::verify
