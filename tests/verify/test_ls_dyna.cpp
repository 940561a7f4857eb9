// SPDX-License-Identifier: Apache-2.0
// What LS-DYNA itself found for small public models, whose decks are written anew here: github.com/scheckmate/
// test_fe_simulation (a lecture of TU Graz; LS-DYNA R10.1, single precision). docs/evidence/ls_dyna.md has the decks
// as they stand there.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

/// What LS-DYNA wrote at one time: of a node at the middle of the free end and of the whole.
struct Written {
  double time, deflection, shortening, turn, drilling, kinetic, internal;
};

// A strip of 300 x 30 mm, 30 x 3 shells of ELFORM 2, hinged at one end, falls under its weight and a load at the other
// that rises to 5 ms and falls to 10 ms; 1 mm thick it yields. How its inner nodes turn about the normals of the shells
// (nothing resists that) is ruled by their rotary inertia alone. Sabotage to be caught: a rotary inertia of (t^2 +
// A)/12 (drilling 1.44 to 1.48 times as large, internal energy 0.3 % off); five points in the place of three; rates on
// the geometry in the middle of the step (shortening 0.025 to 0.17 % off).
void fall(const std::string& name, double thickness, int points, std::initializer_list<Written> written) {
  constexpr int along = 30, across = 3;
  Specimen s;
  s.text("*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + fields({1, 7.8e-6, 210.0, 0.3, 0.5, 20.0}) + "\n\n\n")
      .card("SECTION_SHELL", {1, 2, 0.833333, double(points)})
      .text(fields({thickness, thickness, thickness, thickness}))
      .card("CONTROL_TERMINATION", {10.0})
      .card("LOAD_BODY_Z", {2, 0.00981})
      .card("LOAD_NODE_SET", {2, 3, 3, 1.0})
      .text(curve(2, {{0.0, 1.0}, {100.0, 1.0}}) + curve(3, {{0.0, 0.0}, {5.0, -0.005}, {10.0, 0.0}}))
      .part(1, 1, 1);
  const Grid strip = s.shells(1, {0, 0, 0}, {300.0, 30.0, 0}, along, across);
  s.node_set(1, strip.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
  s.node_set(2, strip.across(along));
  Experiment experiment(s.deck());
  const int id = strip(along, 2);
  const std::size_t node = experiment.node(id);
  Vec3d turned{};
  auto next = written.begin();
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const system::State& state = now.state;
    const Vec3d turn = turned;
    turned += state.dt * vec(state.w[node]);  // spins of the step to come
    if (next == written.end() || state.time < next->time - 0.5 * state.dt) return;
    const auto expect = [&](const std::string& what, double value, double reference, double gate) {
      expect_reference("strip of shells beside LS-DYNA", fmt::format("{}, {} at {:.0f} ms", name, what, next->time),
                       value, reference, gate);
    };
    expect("deflection [mm]", experiment.displacement(now, id).z, next->deflection, 1e-4);
    expect("shortening [mm]", -experiment.displacement(now, id).x, next->shortening, 1.5e-4);
    expect("turn of the end [rad]", turn.y, next->turn, 2e-4);
    expect("turn about the normal [rad]", turn.z, next->drilling, 1e-3);
    expect("kinetic energy [kN mm]", now.energy.kinetic, next->kinetic, 1e-4);
    expect("internal energy [kN mm]", now.energy.internal, next->internal, 2e-4);
    ++next;
  });
  EXPECT_EQ(next, written.end());
}

TEST(LsDyna, StripOfShells) {
  fall("1 mm, 3 points", 1.0, 3,
       {{2.999837, -2.924012, 0.0589846, 0.0501571, 2.174078e-4, 0.01880040, 0.006493705},
        {4.998604, -10.477814, 0.589656, 0.1400641, 1.912839e-3, 0.1114776, 0.03905118},
        {9.998637, -38.630310, 5.47178, 0.2873796, 0.01665302, 0.2498335, 0.1906355}});
  fall("2 mm, 5 points", 2.0, 5,
       {{2.999840, -1.069388, 0.005194128, 0.01267904, 1.593107e-5, 0.007177738, 0.002191816},
        {4.998629, -3.863174, 0.05622557, 0.03593730, 1.353176e-4, 0.04138254, 0.01494690},
        {9.998907, -13.141395, 0.3164129, 0.06143740, 1.257017e-3, 0.1522713, 0.01331445}});
}

// A cube of 1 mm, Poisson's ratio 0.49, whose sides are free, pressed at 0.05 mm/ms. Sabotage to be caught: stress on
// the strain of the start; Q2 left out of the step.
TEST(LsDyna, PressedCube) {
  Specimen s;
  s.text("*MAT_ELASTIC\n" + fields({1, 2.7e-6, 70.0, 0.49}))
      .card("SECTION_SOLID", {1, 1})
      .card("CONTROL_TERMINATION", {1.0})
      .text(curve(1, {{0.0, 0.0}, {10.0, 1.0}}))
      .part(1, 1, 1);
  const Grid cube = s.bricks(1, {0, 0, 0}, {1, 1, 1}, {1, 1, 1});
  std::vector<int> left, front, below, above;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      left.push_back(cube(0, a, b)), front.push_back(cube(a, 0, b));
      below.push_back(cube(a, b, 0)), above.push_back(cube(a, b, 1));
    }
  s.node_set(1, left).card("BOUNDARY_SPC_SET", {1, 0, 1});
  s.node_set(2, front).card("BOUNDARY_SPC_SET", {2, 0, 0, 1});
  s.node_set(3, below).card("BOUNDARY_SPC_SET", {3, 0, 0, 0, 1});
  s.node_set(4, above).card("BOUNDARY_PRESCRIBED_MOTION_SET", {4, 3, 2, 1, -0.5});
  Experiment experiment(s.deck());
  double widening = 0.0, energy = 0.0, stress = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time > 0.999987) return;
    widening = experiment.displacement(now, cube(1, 0, 1)).x;
    energy = now.energy.internal;
    stress = brick_layer(experiment, now, 1).stress[2];
  });
  const std::string pressed = "pressed cube beside LS-DYNA";
  expect_reference(pressed, "first step [ms]", experiment.simulation().first_step(), 4.023983e-5, 1e-5);
  expect_reference(pressed, "widening at 1 ms [mm]", widening, 0.02545191, 1e-4);
  expect_reference(pressed, "internal energy at 1 ms [kN mm]", energy, 0.09201963, 1e-4);
  expect_reference(pressed, "stress at 1 ms [kN/mm²]", stress, -3.590471, 1e-4);
}

}  // namespace
}  // namespace nugget::verify
