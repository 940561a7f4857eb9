// SPDX-License-Identifier: Apache-2.0
// Stable steps and mass scaling.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiment.hpp"
#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/hexahedron.hpp"
#include "kernel/element/weld_beam.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

/// The first step of a whole run with TSSFAC 0.9.
double first_step(const std::string& model) {
  Experiment run("*KEYWORD\n" + termination(1e-9) + model + "*END\n");
  run.run([](const impact::Snapshot&) {});
  return run.simulation().first_step();
}

std::string lone_weld(const WeldData& weld) {
  return weld_part(1, weld) + beam_between(1, 1, 1, {0, 0, 0}, 2, {weld.length, 0, 0});
}

std::string lone_shell(double a, double b) {
  SheetMesh mesh;
  mesh.along = {a, 0, 0};
  mesh.across = {0, b, 0};
  return sheet_part(1, 1.2) + mesh.text();
}

std::string box_nodes(double a, double b, double c) {
  std::string text = "*NODE\n";
  for (int k = 0; k < 2; ++k) {
    text += node_line(4 * k + 1, 0, 0, k * c) + node_line(4 * k + 2, a, 0, k * c);
    text += node_line(4 * k + 3, a, b, k * c) + node_line(4 * k + 4, 0, b, k * c);
  }
  return text + "*ELEMENT_SOLID\n" + element_line(1, 1, {1, 2, 3, 4, 5, 6, 7, 8});
}

std::string brick_part() {
  return "*PART\nbrick\n" + fields({1, 1, 1}) + "*SECTION_SOLID\n" + fields({1, 1}) + "*MAT_ELASTIC\n" +
         fields({1, 7.85e-9, 210000.0, 0.3});
}

// Sabotage to be caught: the bar velocity taken from the bulk modulus, or the mean of two lengths for the length.
TEST(TimeSteps, StepOfAWeldBeam) {
  expect_reference("step of a weld beam", "step of a 0.5 mm weld, kernel [s]",
                   kernel::weld_beam_stable_step(0.5, 210000.0, 7.89e-9), 9.69168e-8, 1e-4);
  WeldData weld{.length = 0.5, .density = 7.89e-9};
  expect_reference("step of a weld beam", "step of a 0.5 mm weld, run / TSSFAC [s]", first_step(lone_weld(weld)) / 0.9,
                   9.69168e-8, 1e-4);
  weld = {.length = 1.5, .density = 7.8e-9};
  expect_reference("step of a weld beam", "step of a 1.5 mm weld, run / TSSFAC [s]", first_step(lone_weld(weld)) / 0.9,
                   2.89087e-7, 1e-4);
}

// Sabotage to be caught: the bar velocity in place of the plate's; the shorter side divided by the longer.
TEST(TimeSteps, StepOfAShell) {
  const std::array<Vec3d, 4> square{{{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}}};
  expect_reference("step of a shell", "step of a 5 x 5 shell, kernel [s]",
                   kernel::shell_stable_step(square, kernel::ShellLength::area_over_side, 210000.0, 0.3, 7.85e-9),
                   9.22180e-7, 1e-4);
  expect_reference("step of a shell", "step of a 5 x 5 shell with TSSFAC 0.9, run [s]", first_step(lone_shell(5, 5)),
                   0.9 * 9.22180e-7, 1e-4);
  expect_reference("step of a shell", "step of a 4 x 6 shell with TSSFAC 0.9, run [s]", first_step(lone_shell(4, 6)),
                   0.9 * 7.37744e-7, 1e-4);
}

// The kernel function knows no viscosity; the run's step contains the linear one, as LS-DYNA's first step does
// (single_hex). Sabotage to be caught: the cube root of the volume for the length; Q2 left out of the run's step.
TEST(TimeSteps, StepOfABrick) {
  std::array<Vec3d, 8> x{
      {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}, {0, 0, 1.5}, {5, 0, 1.5}, {5, 5, 1.5}, {0, 5, 1.5}}};
  expect_reference("step of a brick", "step of a 5 x 5 x 1.5 brick, kernel [s]",
                   kernel::hexahedron_stable_step(x, 210000.0, 0.3, 7.85e-9), 2.49959e-7, 1e-4);
  // Q = Q2 c = 0.06 c: L / (Q + sqrt(Q^2 + c^2)).
  const double with_viscosity = 2.49959e-7 / (0.06 + std::sqrt(1.0 + 0.06 * 0.06));
  expect_reference("step of a brick", "step of a 5 x 5 x 1.5 brick with Q2, run / TSSFAC [s]",
                   first_step(brick_part() + box_nodes(5, 5, 1.5)) / 0.9, with_viscosity, 1e-4);
}

TEST(TimeSteps, SingleHexStartsWithTheStepOfLsDyna) {
  const std::filesystem::path deck = NUGGET_SOURCE_DIR "/../shared/decks/single_hex/single_hex_tension.k";
  if (!std::filesystem::exists(deck)) GTEST_SKIP() << "no " << deck;
  std::ifstream file(deck);
  std::stringstream text;
  text << file.rdbuf();
  Experiment run(text.str());
  run.run([](const impact::Snapshot&) {}, 1e-3);
  expect_reference("step of a brick", "first step of single_hex, LS-DYNA R14.1 [ms]", run.simulation().first_step(),
                   1.40796e-4, 1e-4);
}

/// Largest kinetic energy of the last tenth of `cycles` cycles of free vibration over that of the first tenth.
double growth(const std::string& model, double step_scale, long cycles, double mass_step = 0.0) {
  Experiment run("*KEYWORD\n" + termination(1.0, step_scale, mass_step) + model + "*END\n");
  double first = 0.0, last = 0.0;
  const Watch watch = [&](const impact::Snapshot& now) {
    double& largest = now.state.cycle < cycles / 10 ? first : last;
    if (now.state.cycle >= cycles / 10 && now.state.cycle < 9 * cycles / 10) return;
    double energy = 0.0;
    for (std::size_t k = 0; k < now.system.nodes; ++k) {
      const Vec3d v = now.velocity(k);
      energy += now.system.mass[k] * dot(v, v);
    }
    largest = std::max(largest, energy);
  };
  struct Every : impact::Recorder {
    const Watch& watch;
    explicit Every(const Watch& w) : watch(w) {}
    bool due(const system::State&) override { return true; }
    void write(const impact::Snapshot& now, bool) override { watch(now); }
  } every(watch);
  run.simulation().run({0.0, cycles}, every, {});
  EXPECT_EQ(run.simulation().state().cycle, cycles);
  return last / first;
}

std::string velocity(int node, double x, double y = 0.0, double z = 0.0) {
  return "*INITIAL_VELOCITY_NODE\n" + fields({static_cast<double>(node), x, y, z});
}

// The axial mode of a free weld beam is the fastest there is: its limit is L / c exactly.
// Sabotage to be caught: a nodal mass of rho A L / 3; a force on the geometry of a step too late.
TEST(TimeSteps, StabilityLimitOfAWeldBeamIsExact) {
  const std::string model = lone_weld({.yield = 1e9}) + velocity(1, -1e-3) + velocity(2, 1e-3);
  expect_reference("step of a brick", "free weld beam at 0.95 of the limit, 1e5 steps: growth of the energy",
                   growth(model, 0.95, 100000), 1.0, 1e-2);
  EXPECT_GT(growth(model, 1.05, 30), 1e6);
}

// With DT2MS a weld that sheets hold is scaled to the step of the run; one with free ends would stand at its exact
// limit there and gain energy without end. Sabotage to be caught: free welds scaled like held ones.
TEST(TimeSteps, FreeWeldBeamUnderDt2msIsSteady) {
  const std::string model = lone_weld({.yield = 1e9}) + velocity(1, -1e-3) + velocity(2, 1e-3);
  expect_reference("mass scaling of a weld", "free weld beam with DT2MS, 22000 steps: growth of the energy",
                   growth(model, 0.9, 22000, -1e-6), 1.0, 1e-2);
}

/// A velocity without any symmetry: all modes of four nodes that repeat.
std::string kicks(int first, int nodes) {
  std::string text;
  for (int i = 0; i < nodes; ++i)
    text += velocity(first + i, std::sin(1.0 + 3.7 * i), std::cos(2.3 * i), 0.5 * std::sin(5.1 * i));
  return text;
}

// Sabotage to be caught: an estimate above the true limit (the longest side for the length, Q2 with the wrong sign).
TEST(TimeSteps, BrickAndSheetStayBoundedAt95Percent) {
  EXPECT_LT(growth(brick_part() + box_nodes(5, 5, 1.5) + kicks(1, 8), 0.95, 100000), 1.01);
  SheetMesh sheet;
  sheet.along = {5, 0, 0};
  sheet.across = {0, 5, 0};
  sheet.nx = sheet.ny = 4;
  EXPECT_LT(growth(sheet_part(1, 1.2) + sheet.text() + kicks(1, 25), 0.95, 20000), 1.01);
}

// A lone square shell has a mode that a mesh has not: it gets larger all round, against E / (1 - nu). Its limit is
// L sqrt(rho (1 - nu) / E), 1 / sqrt(1 + nu) = 0.877 of the step that everybody uses. So TSSFAC = 0.9 does not
// do there.
TEST(TimeSteps, LimitOfALoneShellIsThatOfItsDilatation) {
  // Past the limit it would be torn within 43 steps with the rates of the end of the step.
  const std::string model = lone_shell(5, 5) + kicks(1, 4) + "*CONTROL_ACCURACY\n" + fields({1});
  EXPECT_LT(growth(model, 0.99 / std::sqrt(1.3), 20000), 1.01);
  EXPECT_GT(growth(model, 1.02 / std::sqrt(1.3), 60), 1e3);
}

/// Two shells of `size`, 1.5 apart, with weld W1 between their middles.
std::string welded_pair(const WeldData& weld, double size) {
  SheetMesh lower, upper;
  lower.along = upper.along = {size, 0, 0};
  lower.across = upper.across = {0, size, 0};
  upper.first = 11;
  upper.part = 2;
  upper.corner = {0, 0, 1.5};
  return sheet_part(1, 1.5) + sheet_part(2, 1.5) + weld_part(3, weld) + lower.text() + upper.text() +
         beam_between(101, 3, 101, {0.5 * size, 0.5 * size, 0.0}, 102, {0.5 * size, 0.5 * size, 1.5}) +
         weld_contact_to_set(3, {1, 2});
}

double added_to_shells(system::System& system) {
  double added = 0.0;
  for (const auto& group : system.groups)
    if (group->kind == model::ElementKind::shell)
      for (std::size_t e = 0; e < group->size(); ++e) added += group->mass(e) * (group->mass_scale(e) - 1.0);
  return added;
}

double nodal_mass(const system::System& system) {
  double sum = 0.0;
  for (double m : system.mass) sum += m;
  return sum;
}

// The shells' own step is below DT too (9.2e-7): they must not be touched.
// Sabotage to be caught: the factor DT / dt instead of its square; DT obeyed by all elements.
TEST(TimeSteps, WeldsOwnDt) {
  const auto deck = [](const WeldData& weld) {
    return "*KEYWORD\n" + termination(1e-5) + welded_pair(weld, 5.0) + "*END\n";
  };
  // Lone shells: their stable step is looked for, and masses scaled for it, before the first cycle.
  Experiment without(deck({}));
  const double before = nodal_mass(without.system());
  WeldData weld;
  weld.mass_step = 1e-6;
  Experiment run(deck(weld));
  run.run([](const impact::Snapshot&) {});
  const system::System::Masses masses = run.system().masses();
  expect_reference("mass scaling of a weld", "mass added by DT to a weld [t]", masses.added_to_welds, 3.627597e-6,
                   1e-3);
  expect_reference("mass scaling of a weld", "mass added by DT, from the nodes [t]", nodal_mass(run.system()) - before,
                   3.627597e-6, 1e-3);
  const system::System::ElementLocation location = run.system().beam_location[0];
  const auto& group = *run.system().groups[location.group];
  expect_reference("mass scaling of a weld", "density factor", group.mass_scale(0), 11.9658, 1e-4);
  expect_reference("mass scaling of a weld", "modulus that would give DT without mass [MPa]",
                   210000.0 / group.mass_scale(0), 17550.0, 1e-4);
  EXPECT_EQ(masses.added, 0.0);  // it counts as physical
  EXPECT_EQ(added_to_shells(run.system()), 0.0);
  expect_reference("mass scaling of a weld", "the run's step is the shells' [s]", run.simulation().first_step(),
                   0.9 * 9.22180e-7, 1e-4);
}

// DT = 0: welds go to |DT2MS TSSFAC|; shells of 10 mm (1.84e-6 s) need nothing.
// Sabotage to be caught: TSSFAC left out of the welds' target, or taken twice.
TEST(TimeSteps, Dt2ms) {
  Experiment run("*KEYWORD\n" + termination(1e-5, 0.9, -1e-6) + welded_pair({}, 10.0) + "*END\n");
  run.run([](const impact::Snapshot&) {});
  const system::System::Masses masses = run.system().masses();
  const double factor = (9e-7 / 2.89087e-7) * (9e-7 / 2.89087e-7);
  expect_reference("mass scaling of a weld", "mass added by DT2MS to a weld [t]", masses.added,
                   3.308097e-7 * (factor - 1.0), 1e-3);
  EXPECT_EQ(masses.added, masses.added_to_welds);
  EXPECT_EQ(added_to_shells(run.system()), 0.0);
  expect_reference("mass scaling of a weld", "step with DT2MS = -1e-6 and TSSFAC = 0.9 [s]",
                   run.simulation().first_step(), 9e-7, 1e-4);
}

// Both: welds go to DT, which is physical mass, and then to |DT2MS TSSFAC|, which is added mass; the step is that of
// DT2MS. Sabotage to be caught: DT alone, as the step was then; all mass told as physical.
TEST(TimeSteps, DtBesideDt2ms) {
  WeldData weld;
  weld.mass_step = 5e-7;
  Experiment run("*KEYWORD\n" + termination(1e-5, 0.9, -1e-6) + welded_pair(weld, 10.0) + "*END\n");
  run.run([](const impact::Snapshot&) {});
  const system::System::Masses masses = run.system().masses();
  const auto factor = [](double step) { return (step / 2.89087e-7) * (step / 2.89087e-7); };
  expect_reference("mass scaling of a weld", "mass added by DT2MS beside DT [t]", masses.added,
                   3.308097e-7 * (factor(9e-7) - factor(5e-7)), 1e-3);
  expect_reference("mass scaling of a weld", "mass added by DT and DT2MS [t]", masses.added_to_welds,
                   3.308097e-7 * (factor(9e-7) - 1.0), 1e-3);
  expect_reference("mass scaling of a weld", "step with DT beside DT2MS [s]", run.simulation().first_step(), 9e-7,
                   1e-4);
}

// Without lateral contraction transverse shear and spin are faster than a wave across a square with inertia m A/8: all
// motions of a strip stay bounded at TSSFAC 0.9. Sabotage: that inertia.
TEST(TimeSteps, ShellsWithoutLateralContractionAreStable) {
  for (const double elform : {2.0, 16.0}) {
    SheetMesh mesh;
    mesh.nx = 10;
    std::string deck = "*KEYWORD\n" + termination(5e-3) + "*PART\nstrip\n" + fields({1, 1, 1}) + "*SECTION_SHELL\n" +
                       fields({1, elform, 1, 3}) + fields({1, 1, 1, 1}) + "*MAT_ELASTIC\n" +
                       fields({1, 7.85e-9, 210000.0, 0.0}) + "*INITIAL_VELOCITY_NODE\n";
    std::uint32_t random = 1;
    const auto next = [&random] { return 1e-3 * ((random = 1664525u * random + 1013904223u) >> 8) / 0x1p24; };
    for (int j = 0; j <= 1; ++j)
      for (int i = 0; i <= 10; ++i)
        deck += fields({1.0 * mesh.node(i, j), next(), next(), next(), 0.1 * next(), 0.1 * next()});
    Experiment run(deck + mesh.text() + "*END\n");
    double most = 0.0, first = 0.0;
    const impact::Outcome outcome = run.run([&](const impact::Snapshot& now) {
      if (now.state.cycle == 0) first = now.energy.kinetic;
      most = std::max(most, now.energy.kinetic);
    });
    EXPECT_EQ(outcome.termination, impact::Termination::normal) << outcome.message;
    EXPECT_LE(most, 1.01 * first) << elform;
  }
}

}  // namespace
}  // namespace nugget::verify
