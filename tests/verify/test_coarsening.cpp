// SPDX-License-Identifier: Apache-2.0
// *CONTROL_COARSEN: plates of which four shells in the middle are one, and hanging nodes on the sides of merged shells.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "linear.hpp"
#include "nvh/statics/statics.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

constexpr double side = 200.0, thickness = 2.0, young = 210000.0, poisson = 0.3, density = 7.85e-9;
const std::string coarsen = "*CONTROL_COARSEN\n         1       8.0\n";
const std::string linear = "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n";

double bending_stiffness() {
  return young * std::pow(thickness, 3) / (12.0 * (1.0 - poisson * poisson));
}

SheetMesh plate(int n) {
  return {.first = 1, .part = 1, .corner = {}, .nx = n, .ny = n, .along = {side / n, 0, 0}, .across = {0, side / n, 0}};
}

/// Calls `at(id, i, j)` for the nodes of the plate's edges.
template <class At>
void for_edges(const SheetMesh& mesh, At at_edge) {
  for (int j = 0; j <= mesh.ny; ++j)
    for (int i = 0; i <= mesh.nx; ++i)
      if (i == 0 || j == 0 || i == mesh.nx || j == mesh.ny) at_edge(mesh.node(i, j), i, j);
}

std::size_t shells(const LinearExperiment& of) {
  return of.system().model.shells.size();
}

// A simply supported square plate: f = pi/a^2 sqrt(D/(rho t)). Its edges are held, so the ring of shells at them stays
// fine, and hanging nodes lie all around. Sabotage: hanging nodes left free; merged shells with their nodes in another
// order.
TEST(Coarsening, FirstModeOfASupportedPlate) {
  const SheetMesh mesh = plate(20);
  std::string deck = "*KEYWORD\n" + linear + "*CONTROL_IMPLICIT_EIGENVALUE\n         4\n" + sheet_part(1, thickness) +
                     mesh.text() + "*BOUNDARY_SPC_NODE\n";
  for_edges(mesh, [&](int id, int, int) { deck += fields({1.0 * id, 0, 1, 1, 1, 0, 0, 1}); });
  const double f = std::numbers::pi / (side * side) * std::sqrt(bending_stiffness() / (density * thickness));
  const LinearExperiment fine(deck + "*END\n"), merged(deck + coarsen + "*END\n");
  EXPECT_EQ(shells(fine), 400u);
  EXPECT_EQ(shells(merged), 76u + 81u);
  EXPECT_EQ(merged.system().model.hanging_nodes.size(), 36u);
  expect_reference("coarsened shells", "supported plate, 400 shells: first mode [Hz]", fine.modes(1).frequency(0), f,
                   1.5e-2);
  expect_reference("coarsened shells", "supported plate, 157 shells: first mode [Hz]", merged.modes(1).frequency(0), f,
                   2.5e-2);
}

// A free square plate: six rigid motions (asserted) and f = 13.468/(2 pi a^2) sqrt(D/(rho t)) (A. W. Leissa, J. Sound
// Vib. 31, 1973). An odd number of shells, so that a row and a column stay fine.
TEST(Coarsening, FirstModeOfAFreePlate) {
  const std::string deck = "*KEYWORD\n" + linear + "*CONTROL_IMPLICIT_EIGENVALUE\n        10\n" +
                           sheet_part(1, thickness) + plate(21).text() + coarsen + "*END\n";
  const LinearExperiment merged(deck);
  EXPECT_EQ(shells(merged), 100u + 41u);
  EXPECT_EQ(merged.system().model.hanging_nodes.size(), 20u);
  const double f =
      13.468 / (2.0 * std::numbers::pi * side * side) * std::sqrt(bending_stiffness() / (density * thickness));
  expect_reference("coarsened shells", "free plate, 141 shells: first mode [Hz]", merged.elastic_frequencies(1)[0], f,
                   2.5e-2);
}

// Patch test over fine and merged shells: a plate pulled at one edge has the stiffness E t of a bar. Sabotage: weights
// of hanging nodes that do not follow their place.
TEST(Coarsening, UniformTensionIsExact) {
  const SheetMesh mesh = plate(10);
  std::string deck = "*KEYWORD\n" + linear + "*CONTROL_IMPLICIT_SOLUTION\n         1\n" + termination(1.0) +
                     sheet_part(1, thickness) + mesh.text() + coarsen + curve(1, {{0, 0}, {1, 1}});
  std::string held = "*BOUNDARY_SPC_NODE\n", pulled;
  for_edges(mesh, [&](int id, int i, int j) {
    held += fields({1.0 * id, 0, i == 0 ? 1.0 : 0.0, i == 0 && j == 0 ? 1.0 : 0.0, 1, 1, 1, 1});
    if (i == mesh.nx) pulled += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + fields({1.0 * id, 1, 2, 1, 1e-3});
  });
  const LinearExperiment bar(deck + held + pulled + "*END\n");
  EXPECT_EQ(shells(bar), 36u + 16u);
  Findings findings;
  const double stiffness = 2.0 * nvh::solve_statics(bar.matrices(), findings).energy / 1e-6;
  expect_reference("coarsened shells", "plate pulled: stiffness [N/mm]", stiffness, young * thickness, 1e-9);
}

// Mass and its centre are those of the plate; momentum and energy are kept while it flies and turns.
TEST(Coarsening, AFreePlateKeepsMassMomentumAndEnergy) {
  Experiment run("*KEYWORD\n" + termination(1e-3) + sheet_part(1, thickness) + plate(9).text() + coarsen +
                 "*INITIAL_VELOCITY_GENERATION\n" + fields({1, 2, 200, 3000, -2000, 5000}) +
                 fields({100, 100, 0, 0.6, 0.8, 0}) + "*END\n");
  EXPECT_EQ(run.model().shells.size(), 16u + 17u);
  double mass = 0.0;
  Vec3d centre;
  for (std::size_t k = 0; k < run.system().nodes; ++k) {
    mass += run.system().mass[k];
    centre += run.system().mass[k] * run.system().ties.x[run.system().model_node[k]];
  }
  expect_reference("coarsened shells", "free plate: mass [t]", mass, density * thickness * side * side, 1e-12);
  expect_reference("coarsened shells", "free plate: centre of mass [mm]", (1.0 / mass) * norm(centre),
                   side / std::numbers::sqrt2, 1e-12);
  Vec3d linear_first, angular_first;
  double drift = 0.0, turn = 0.0, balance = 0.0;
  long cycles = 0;
  run.run([&](const impact::Snapshot& now) {
    Vec3d p, l;
    for (std::size_t k = 0; k < now.system.nodes; ++k) {
      const Vec3d x = vec(now.state.x[k]), v = now.velocity(k);
      p += now.system.mass[k] * v;
      l += now.system.mass[k] * cross(x, v) + now.system.inertia[k] * now.spin(k);
    }
    cycles = now.state.cycle;
    if (cycles == 0) linear_first = p, angular_first = l;
    drift = std::max(drift, norm(p - linear_first) / norm(linear_first));
    turn = std::max(turn, norm(l - angular_first) / norm(angular_first));
    balance = std::max(balance, std::abs(now.energy.total() / now.energy.initial - 1.0));
  });
  EXPECT_GT(cycles, 100);
  expect_reference("coarsened shells", "free plate: drift of the linear momentum", drift, 0.0, 1e-12, 1.0);
  expect_reference("coarsened shells", "free plate: drift of the angular momentum", turn, 0.0, 1e-10, 1.0);
  expect_reference("coarsened shells", "free plate: energy balance", balance, 0.0, 1e-9, 1.0);
}

}  // namespace
}  // namespace nugget::verify
