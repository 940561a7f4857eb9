// SPDX-License-Identifier: Apache-2.0
// *LOAD_BLAST_ENHANCED on a plate that flies off, against published impulses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

struct Flight {
  double speed = 0.0, start = std::numeric_limits<double>::infinity();  ///< at the end; when it began to move
};

/// A free square of steel of side `side` and thickness t, turned by `angle` about its first side, `distance` from the
/// charge along x; its normal looks to it. Units by `length`, `time`, `mass` of m, s, kg.
Flight plate(int unit, double mass, double distance, double angle, double m, double s, double kg) {
  const double side = 0.1 * m, t = 0.002 * m, density = 7850.0 * kg / (m * m * m), E = 2.1e11 * kg / (m * s * s);
  Specimen plate;
  plate.card("MAT_ELASTIC", {1, density, E, 0.3});
  plate.card("SECTION_SHELL", {1, 16, 0.833333, 2}).text(fields({t, t, t, t})).part(1, 1, 1);
  // The charge at (-distance, 0, 0): normals along -x cos, -y sin.
  std::vector<int> n;
  for (const auto& [v, w] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
    n.push_back(plate.node({-v * side * std::sin(angle), v * side * std::cos(angle), w * side}));
  plate.shell(1, {n[3], n[2], n[1], n[0]});
  const double arrival = 30e-3 * s;
  plate.card("CONTROL_TERMINATION", {arrival}).card("CONTROL_TIMESTEP", {0, 0.5});
  plate.text("*LOAD_BLAST_ENHANCED\n" + fields({1, mass * kg, -distance * m, 0, 0, 1e-3 * s, 1.0 * unit, 1}) +
             fields({0, 0, 0, 0, 0, 1e20, 1}));
  plate.card("LOAD_BLAST_SEGMENT", {1, 1.0 * n[3], 1.0 * n[2], 1.0 * n[1], 1.0 * n[0]});
  Experiment experiment(plate.deck());
  Flight flight;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    Vec3d v;
    for (const int node : n) v += 0.25 * experiment.velocity(now, node);
    flight.speed = norm(v) / (m / s);
    if (flight.speed > 0.0) flight.start = std::min(flight.start, now.state.time / s);
  });
  return flight;
}

// 125.6 kPa ms and an arrival of 8.242 ms behind the burst at 5 m from 1 kg on the ground (Swisdak 1994); the plate
// weighs 15.7 kg/m^2. Sabotage: a wrong unit; the incident wave for the reflected one; the burst at time 0.
TEST(Blast, APlateFliesOffWithItsImpulse) {
  for (const auto& [unit, m, s, kg] : {std::tuple{2, 1.0, 1.0, 1.0},
                                       {7, 1e3, 1.0, 1e-3},
                                       {6, 1e3, 1e3, 1.0},
                                       {8, 1e3, 1e3, 1e3},
                                       {4, 1e2, 1e6, 1e3}}) {
    const Flight flight = plate(unit, 1.0, 5.0, 0.0, m, s, kg);
    expect_reference("plate under a blast", fmt::format("plate 5 m from 1 kg of TNT, UNIT {}: speed [m/s]", unit),
                     flight.speed, 125.6 / 15.7, 0.01);
    expect_reference("plate under a blast", fmt::format("plate 5 m from 1 kg of TNT, UNIT {}: arrival [ms]", unit),
                     1e3 * flight.start, 1.0 + 8.242, 0.01);
  }
  // 8 kg at twice the distance: twice the impulse. Turned by 60 degrees: a quarter of the reflected impulse and a
  // quarter of the incident one, 59.31.
  expect_reference("plate under a blast", "plate 10 m from 8 kg of TNT: speed [m/s]",
                   plate(7, 8.0, 10.0, 0.0, 1e3, 1.0, 1e-3).speed, 2.0 * 125.6 / 15.7, 0.01);
  expect_reference("plate under a blast", "plate turned by 60 degrees, 5 m from 1 kg of TNT: speed [m/s]",
                   plate(7, 1.0, 5.0, M_PI / 3.0, 1e3, 1.0, 1e-3).speed, 0.25 * (125.6 + 59.31) / 15.7, 0.02);
}

}  // namespace
}  // namespace nugget::verify
