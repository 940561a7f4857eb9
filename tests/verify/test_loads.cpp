// SPDX-License-Identifier: Apache-2.0
// Loads, preloads and initial stresses against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/index.hpp"
#include "impact/recording/cross_sections.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double modulus = 210000.0, density = 7.85e-9, pi = std::numbers::pi;

/// A bar of 10 x 1 x 1 bricks, 100 x 10 x 10, nu = 0, that moves along x only.
struct Bar {
  Specimen specimen;
  Grid grid;
  explicit Bar(double end_time) {
    specimen.card("MAT_ELASTIC", {1, density, modulus, 0.0})
        .card("SECTION_SOLID", {1, 1})
        .card("CONTROL_TERMINATION", {end_time})
        .part(1, 1, 1);
    grid = specimen.bricks(1, {}, {100.0, 10.0, 10.0}, {10, 1, 1});
    specimen.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
  }
  Bar& hold(int i) {
    specimen.node_set(100 + i, grid.across(i)).card("BOUNDARY_SPC_SET", {100.0 + i, 0, 1});
    return *this;
  }
  Bar& section(double x) {
    specimen.text("*DATABASE_CROSS_SECTION_PLANE\n" + fields({0, x, 0, 0, x + 1, 0, 0}) + fields({0, 0, 0}));
    return *this;
  }
};

// The root of a bar that turns about z carries the sum of m w^2 x; brought up slowly and damped it is at rest.
// Sabotage: w instead of its square; the force along the arm with its part along the axis.
TEST(Loads, CentrifugalForceOfATurningBar) {
  constexpr double omega = 1000.0;
  Bar bar(4e-3);
  bar.hold(0).section(5.0).section(45.0);
  bar.specimen.text(smooth_ramp(1, 2e-3)).card("LOAD_BODY_RZ", {1, omega}).card("DAMPING_GLOBAL", {0, 2e4});
  Experiment experiment(bar.specimen.deck());
  const impact::CrossSections sections(experiment.system());
  double root = 0.0, middle = 0.0, balance = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const auto rows = sections.state(now).rows;
    root = rows.at(0).force.x, middle = rows.at(1).force.x;
    if (now.state.cycle > 10) balance = std::max(balance, std::abs(now.energy.total() - now.energy.external));
  });
  // The section at 5 has the nodes from x = 10 on on its far side: half of the first element's mass is held.
  const auto beyond = [](double from) { return 0.5 * density * 100.0 * omega * omega * (1e4 - from * from); };
  // Lumped: nodes at 10, 20, ... with full shares and the last with half, which is the integral by trapezoids from 10.
  const auto lumped = [&](int first) {
    double sum = 0.0;
    for (int i = first; i <= 10; ++i) sum += (i < 10 ? 1.0 : 0.5) * 10.0 * i;
    return density * 1000.0 * omega * omega * sum;
  };
  expect_reference("loads", "*LOAD_BODY_RZ: force at the root of a turning bar [N]", root, lumped(1), 1e-3);
  expect_reference("loads", "*LOAD_BODY_RZ: force at x = 45", middle, lumped(5), 1e-3);
  expect_reference("loads", "the same against rho A w^2 (L^2 - x^2)/2 of the continuum", middle, beyond(45.0), 5e-3);
  expect_reference("loads", "*LOAD_BODY_RZ: energy balance [N mm]", balance, 0.0, 1e-6, 1.0);
}

// A rigid box of 40 x 10 x 10 that lies askew to the axis, 45 degrees up, turns down: its eight corners are pulled
// outwards by more the farther out they are. Sabotage: the whole force at the centre, which turned nothing.
TEST(Loads, CentrifugalForceTurnsABodyThatLiesAskew) {
  constexpr double omega = 100.0, time = 1e-3, long_side = 40.0, short_side = 10.0;
  for (const bool of_parts : {false, true}) {
    Specimen specimen;
    specimen.card("MAT_RIGID", {1, density, modulus, 0.3})
        .text("\n\n")
        .card("SECTION_SOLID", {1, 1})
        .card("CONTROL_TERMINATION", {time})
        .part(1, 1, 1);
    const double c = std::sqrt(0.5);
    specimen.bricks(1, {1, 1, 1}, [c](int i, int j, int k) {
      const double along = long_side * (i - 0.5), across = short_side * (k - 0.5);
      return Vec3d{30.0 + c * (along - across), short_side * j, c * (along + across)};
    });
    specimen.text(constant_curve(1, omega)).card("LOAD_BODY_RZ", {1, 1});
    if (of_parts) specimen.text("*SET_PART_LIST\n" + fields({5}) + fields({1})).card("LOAD_BODY_PARTS", {5});
    Experiment experiment(specimen.deck());
    Vec3d spin;
    double balance = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      spin = now.spin(at(now.system.bodies.at(0).node));
      balance = std::max(balance, std::abs(now.energy.total() - now.energy.initial - now.energy.external));
    });
    const double squares = long_side * long_side, fewer = short_side * short_side;
    const double expected = omega * omega * 0.5 * (squares - fewer) / (squares + fewer) * time;
    EXPECT_NEAR(spin.y, expected, 1e-2 * expected);
    EXPECT_NEAR(spin.x, 0.0, 1e-9);
    EXPECT_NEAR(spin.z, 0.0, 1e-9);
    EXPECT_LT(balance, 1e-9);
  }
}

// Gravity on one part only, which falls; the other stays. Rigid parts fall as well.
void expect_two_of_three_parts_to_fall(bool by_set) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("MAT_RIGID", {2, density, modulus, 0.3})
      .text("\n\n")
      .card("SECTION_SOLID", {1, 1})
      .card("CONTROL_TERMINATION", {1e-3})
      .part(1, 1, 1)
      .part(2, 1, 2)
      .part(3, 1, 1);
  const Grid first = specimen.bricks(1, {}, {10, 10, 10}, {1, 1, 1});
  specimen.bricks(2, {20, 0, 0}, {10, 10, 10}, {1, 1, 1});
  const Grid third = specimen.bricks(3, {40, 0, 0}, {10, 10, 10}, {1, 1, 1});
  specimen.text(constant_curve(1))
      .text(by_set ? "*SET_PART_LIST\n" + fields({5}) + fields({1, 2}) + "*LOAD_GRAVITY_PART_SET\n" +
                         fields({5, 3, 1, 9810})
                   : "*LOAD_GRAVITY_PART\n" + fields({1, 3, 1, 9810}) + fields({2, 3, 0, 9810}));
  Experiment experiment(specimen.deck());
  double falls = 0.0, body = 0.0, stays = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    falls = experiment.velocity(now, first(0, 0)).z;
    body = now.velocity(at(now.system.bodies.at(0).node)).z;
    stays = experiment.velocity(now, third(0, 0)).z;
  });
  const std::string keyword = by_set ? "*LOAD_GRAVITY_PART_SET" : "*LOAD_GRAVITY_PART";
  expect_reference("loads", keyword + ": velocity of its part [mm/s]", falls, -9.81, 1e-4);
  expect_reference("loads", keyword + ": velocity of a rigid part", body, -9.81, 1e-4);
  expect_reference("loads", keyword + ": velocity of another part", stays, 0.0, 1e-12, 1.0);
}

TEST(Loads, GravityOfOnePart) {
  expect_two_of_three_parts_to_fall(false);
}

TEST(Loads, GravityOfAPartSet) {
  expect_two_of_three_parts_to_fall(true);
}

// ---- initial stresses and preloads

/// A strip of shells 20 x 10 x 2 of `nip` layers, all nodes held, with a stress in its layers.
double moment_of_initial_stress(double* force, double nip = 3, double rule = 0, const std::string& rules = {}) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("SECTION_SHELL", {1, 2, 1, nip, 0, rule})
      .text(fields({2, 2, 2, 2}) + rules)
      .card("CONTROL_TERMINATION", {1e-6})
      .part(1, 1, 1);
  const Grid grid = specimen.shells(1, {}, {20.0, 10.0, 0.0}, 2, 1);
  specimen.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  for (int e = 1; e <= 2; ++e)
    specimen.text("*INITIAL_STRESS_SHELL\n" + fields({1.0 * e, 1, 2}) + fields({-1, 40, 0, 0, 0, 0, 0, 0}) +
                  fields({1, 160, 0, 0, 0, 0, 0, 0}));
  specimen.text("*DATABASE_CROSS_SECTION_PLANE\n" + fields({0, 5, 0, 0, 6, 0, 0}) + fields({0, 0, 0}));
  Experiment experiment(specimen.deck());
  const impact::CrossSections sections(experiment.system());
  double moment = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const output::SecforcRow row = sections.state(now).rows.at(0);
    *force = row.force.x;
    moment = row.moment.y;
  });
  return moment;
}

// From 40 at the bottom to 160 at the top: force 100 b t, moment 60 b t^2/6 about y.
TEST(InitialStress, OfShellsGivesForceAndMoment) {
  double force = 0.0;
  const double moment = moment_of_initial_stress(&force);
  expect_reference("initial stress", "shell, 40 to 160 through the thickness: force [N]", force, 2000.0, 1e-10);
  expect_reference("initial stress", "shell: moment [N mm]", std::abs(moment), 60.0 * 10.0 * 4.0 / 6.0, 1e-10);
}

// The stress is 100 + 60 zeta, the moment b t^2/2 of the sum of w zeta sigma: 1200 N mm times that of w zeta^2, which
// is 1/3 by exact rules. Sabotage: the stress taken at Gauss places whatever the rule (as it was), the layers' shares
// equal, the order of the card kept.
TEST(InitialStress, OfLayersOfOtherRules) {
  const auto moment = [](double nip, double rule, const std::string& rules) {
    double force = 0.0;
    const double m = std::abs(moment_of_initial_stress(&force, nip, rule, rules));
    expect_reference("layers", "force, whatever the rule [N]", force, 2000.0, 1e-10);
    return m;
  };
  expect_reference("layers", "QR 1, three layers: moment [N mm]", moment(3, 1, ""), 1200.0 * 0.5, 1e-10);
  expect_reference("layers", "*INTEGRATION_SHELL, ESOP 1, two layers: moment",
                   moment(2, -7, "*INTEGRATION_SHELL\n" + fields({7, 2, 1})), 1200.0 * 0.25, 1e-10);
  expect_reference(
      "layers", "*INTEGRATION_SHELL, S and WF of three layers: moment",
      moment(3, -8,
             "*INTEGRATION_SHELL\n" + fields({8, 3}) + fields({0.8, 0.3}) + fields({-0.8, 0.3}) + fields({0.0, 0.4})),
      1200.0 * 0.384, 1e-10);
}

TEST(InitialStress, OfBricksGivesTheReaction) {
  Bar bar(1e-6);
  bar.hold(0).hold(10).section(45.0);
  for (int e = 1; e <= 10; ++e)
    bar.specimen.text("*INITIAL_STRESS_SOLID\n" + fields({1.0 * e, 1}) + fields({70, 20, 30, 0, 0, 0, 0}));
  Experiment experiment(bar.specimen.deck());
  const impact::CrossSections sections(experiment.system());
  double force = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) { force = sections.state(now).rows.at(0).force.x; });
  expect_reference("initial stress", "bricks, 70 along the bar: force [N]", force, 7000.0, 1e-9);
}

// A bolt of bricks between two walls: its section stress is what the curve says, and stays when the curve has ended.
// Sabotage: the stress added to what is there; the preload that does not end.
TEST(Preload, OfACrossSectionStaysWhenItsCurveEnds) {
  Bar bar(3e-3);
  bar.hold(0).hold(10);
  bar.specimen.text("*DATABASE_CROSS_SECTION_PLANE_ID\n         3bolt\n" + fields({0, 45, 0, 0, 46, 0, 0}) +
                    fields({0, 0, 0}));
  bar.section(75.0);
  // The curve ends at 2e-3.
  bar.specimen.text(curve(1, {{0.0, 0.0}, {1e-3, 100.0}, {2e-3, 100.0}}))
      .card("INITIAL_STRESS_SECTION", {1, 3, 1, 0, 0, 1})
      .card("DAMPING_GLOBAL", {0, 2e4});
  Experiment experiment(bar.specimen.deck());
  const impact::CrossSections sections(experiment.system());
  double during = 0.0, after = 0.0, elsewhere = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const auto rows = sections.state(now).rows;
    (now.state.time < 1.9e-3 ? during : after) = rows.at(0).force.x;
    elsewhere = rows.at(1).force.x;
  });
  expect_reference("preload", "*INITIAL_STRESS_SECTION: force while the curve lasts [N]", during, 1e4, 1e-3);
  expect_reference("preload", "*INITIAL_STRESS_SECTION: force when it has ended", after, 1e4, 1e-3);
  expect_reference("preload", "*INITIAL_STRESS_SECTION: force in the rest of the bar", elsewhere, 1e4, 2e-3);
}

// A weld beam between two fixed nodes carries the preload; N = F during and after.
TEST(Preload, OfAWeldBeam) {
  Specimen specimen;
  specimen.card("MAT_SPOTWELD", {1, density, modulus, 0.3, 500, 1000})
      .text("\n")
      .card("SECTION_BEAM", {1, 9, 1, 2, 1})
      .text(fields({6, 6, 0, 0}))
      .card("CONTROL_TERMINATION", {3e-5})
      .part(1, 1, 1);
  const int a = specimen.node({0, 0, 0}), b = specimen.node({0, 0, 2});
  specimen.text(fmt::format("*ELEMENT_BEAM\n{:8d}{:8d}{:8d}{:8d}{:8d}\n", 1, 1, a, b, 0))
      .text("*SET_BEAM\n" + fields({7}) + fields({1}))
      .node_set(1, {a, b})
      .card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1})
      .text(curve(1, {{0.0, 0.0}, {1e-5, 1.0}, {2e-5, 1.0}}))
      .card("INITIAL_AXIAL_FORCE_BEAM", {7, 1, 5000});
  Experiment experiment(specimen.deck());
  double during = 0.0, after = 0.0, shear = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const system::System::ElementLocation location = now.system.beam_location.at(0);
    const auto r = now.system.groups[location.group]->resultants(at(location.element));
    (now.state.time < 1.9e-5 ? during : after) = r[0];
    shear = std::abs(r[1]) + std::abs(r[2]);
  });
  expect_reference("preload", "*INITIAL_AXIAL_FORCE_BEAM: axial force while its curve lasts [N]", during, 5000.0, 1e-9);
  expect_reference("preload", "*INITIAL_AXIAL_FORCE_BEAM: axial force when it has ended", after, 5000.0, 1e-9);
  expect_reference("preload", "*INITIAL_AXIAL_FORCE_BEAM: shear", shear, 0.0, 1e-9, 1.0);
}

// ---- pressure

/// A quarter of the spherical cap: `along` shells on the meridian, `around` on 90 degrees, pole of triangles.
struct Cap {
  static constexpr double radius = 22.27, thickness = 0.41, half = 26.67 * pi / 180.0;
  Specimen specimen;
  int apex;

  Cap(int along, int around, const std::string& material, double layers = 5, double end = 6.5e-4) {
    specimen.text(material)
        .card("SECTION_SHELL", {1, 2, 0.8333, layers})
        .text(fields({thickness, thickness, thickness, thickness}))
        .card("CONTROL_TERMINATION", {end})
        .part(1, 1, 1);
    apex = specimen.node({0, 0, radius});
    std::vector<std::vector<int>> ring(at(along + 1));
    std::vector<int> sides_x, sides_y, clamped;
    for (int i = 1; i <= along; ++i)
      for (int j = 0; j <= around; ++j) {
        const double theta = half * i / along, phi = 0.5 * pi * j / around;
        const int id = specimen.node({radius * std::sin(theta) * std::cos(phi),
                                      radius * std::sin(theta) * std::sin(phi), radius * std::cos(theta)});
        ring[i].push_back(id);
        if (i == along)
          clamped.push_back(id);
        else if (j == 0)
          sides_y.push_back(id);
        else if (j == around)
          sides_x.push_back(id);
      }
    // Normals point outwards; the pressure pushes inwards.
    for (int j = 0; j < around; ++j) {
      const auto k = at(j);
      specimen.shell(1, {apex, ring[1][k], ring[1][k + 1], ring[1][k + 1]});
      for (int i = 1; i < along; ++i) {
        const auto &inner = ring[i], &outer = ring[i + 1];
        specimen.shell(1, {inner[k], outer[k], outer[k + 1], inner[k + 1]});
      }
    }
    // Symmetry about x = 0 and y = 0; clamped edge; the apex moves along z only.
    specimen.node_set(1, sides_x).card("BOUNDARY_SPC_SET", {1, 0, 1, 0, 0, 0, 1, 1});
    specimen.node_set(2, sides_y).card("BOUNDARY_SPC_SET", {2, 0, 0, 1, 0, 1, 0, 1});
    specimen.node_set(3, clamped).card("BOUNDARY_SPC_SET", {3, 0, 1, 1, 1, 1, 1, 1});
    specimen.node_set(4, {apex}).card("BOUNDARY_SPC_SET", {4, 0, 1, 1, 0, 1, 1, 1});
    specimen.text("*SET_SHELL_GENERAL\n         5\n       ALL\n").text(constant_curve(1));
    specimen.card("LOAD_SHELL_SET", {5, 1, 600.0});
  }

  /// Time and deflection of the apex.
  std::vector<std::pair<double, double>> path() {
    Experiment experiment(specimen.deck());
    std::vector<std::pair<double, double>> path;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      path.push_back({now.state.time, experiment.displacement(now, apex).z});
    });
    return path;
  }
};

// The amplitudes of a run of CalculiX, in their order, within 5 %. Its times are not taken: ours are
// sqrt(2) times them, as those of the Abaqus record that they were compared with; the time scale is held against the
// closed form instead. Until the edge is felt the apex moves as a whole sphere breathes, w = w0 (1 - cos wt), w0 = p
// R^2 (1 - nu) / (2 E t), w^2 = 2 E / (rho (1 - nu) R^2). Sabotage: the pressure's share on three of four nodes, its
// sign.
TEST(Pressure, StepOnASphericalCap) {
  constexpr double E = 10.5e6, nu = 0.3, rho = 2.45e-4;
  Cap cap(20, 8, "*MAT_ELASTIC\n" + fields({1, rho, E, nu}));
  const auto path = cap.path();
  const double w0 = 600.0 * Cap::radius * Cap::radius * (1.0 - nu) / (2.0 * E * Cap::thickness);
  const double omega = std::sqrt(2.0 * E / (rho * (1.0 - nu))) / Cap::radius;
  const auto early = std::find_if(path.begin(), path.end(), [](const auto& p) { return p.first > 4e-5; });
  expect_reference("spherical cap under a pressure step",
                   "cap, before the edge is felt: apex at 4e-5 s as of a sphere [in]", early->second,
                   -w0 * (1.0 - std::cos(omega * early->first)), 1e-2);
  const auto lowest = [&](double from, double to) {
    double value = 0.0;
    for (const auto& [time, w] : path)
      if (time > from && time < to) value = std::min(value, w);
    return value;
  };
  expect_reference("spherical cap under a pressure step", "cap, elastic: first extremum of the apex [in]",
                   lowest(0.0, 2.2e-4), -0.0524, 5e-2);
  expect_reference("spherical cap under a pressure step", "cap, elastic: second", lowest(2.5e-4, 5.0e-4), -0.0929,
                   5e-2);
  double highest = 0.0;
  for (const auto& [time, w] : path) highest = std::max(highest, w);
  expect_reference("spherical cap under a pressure step", "cap, elastic: third", highest, 0.0433, 5e-2);
}

// The same with yield at 24000 psi and a tangent modulus of 0.21e6: all five extrema of that run, its times multiplied
// by sqrt(2) as above. On 20 shells the later ones are 6 % too large; 40 and nine layers meet the gate.
// Sabotage: no hardening.
TEST(Pressure, StepOnAPlasticSphericalCap) {
  Cap cap(40, 12, "*MAT_PLASTIC_KINEMATIC\n" + fields({1, 2.45e-4, 10.5e6, 0.3, 24000.0, 0.21e6, 1.0}), 9, 9.2e-4);
  const auto path = cap.path();
  struct Extremum {
    const char* name;
    double from, to, time, deflection;
    bool low;
  };
  const Extremum extrema[] = {{"first", 0.0, 2.1e-4, 1.28e-4, -0.0556, true},
                              {"second", 2.1e-4, 3.2e-4, 1.86e-4, -0.0589, true},
                              {"third", 4.0e-4, 5.5e-4, 3.19e-4, -0.0674, true},
                              {"fourth, a rise", 5.5e-4, 7.5e-4, 4.59e-4, -0.0158, false},
                              {"fifth", 7.5e-4, 9.2e-4, 6.11e-4, -0.0696, true}};
  for (const Extremum& e : extrema) {
    std::pair<double, double> found{0.0, e.low ? 1.0 : -1.0};
    for (const auto& p : path)
      if (p.first > e.from && p.first < e.to && (e.low ? p.second < found.second : p.second > found.second)) found = p;
    const std::string name = std::string("cap, plastic: ") + e.name;
    expect_reference("spherical cap under a pressure step", name + " extremum of the apex [in], of the largest",
                     found.second, e.deflection, 5e-2, 0.0696);
    expect_reference("spherical cap under a pressure step", name + ", its time, of CalculiX's times sqrt 2 [s]",
                     found.first, std::sqrt(2.0) * e.time, 4e-2);
  }
}

// ---- deletion

/// A brick whose upper face is driven through its lower one.
std::string crushed(const std::string& more) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.0})
      .card("SECTION_SOLID", {1, 1})
      .card("CONTROL_TERMINATION", {1e-4})
      .part(1, 1, 1)
      .text(constant_curve(1))
      .text(more.find("CONTROL_TIMESTEP") == std::string::npos ? "*CONTROL_TIMESTEP\n" + fields({0, 0.5}) : "")
      .text(more);
  const Grid grid = specimen.bricks(1, {}, {10, 10, 20}, {1, 1, 2});
  std::vector<int> low, high;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) low.push_back(grid(i, j, 1)), high.push_back(grid(i, j, 2));
  specimen.node_set(1, low).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
  specimen.node_set(2, high).card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 3, 0, 1, -1.5e5});
  return specimen.deck();
}

impact::Outcome outcome_of(const std::string& deck, impact::Erosion::Count* count = nullptr) {
  Experiment experiment(deck);
  const impact::Outcome outcome = experiment.run([](const impact::Snapshot&) {});
  if (count) *count = experiment.simulation().components().erosion.deleted();
  return outcome;
}

TEST(Deletion, NegativeVolumeStopsTheRunUnlessTheDeckDeletesIt) {
  // Mass scaling keeps the step, else it would shrink with the brick and never pass the point of no volume.
  const auto scaled = [](double erode) { return "*CONTROL_TIMESTEP\n" + fields({0, 0.5, 0, 0, -1.5e-6, 0, erode}); };
  const impact::Outcome stopped = outcome_of(crushed(scaled(0)));
  EXPECT_EQ(stopped.termination, impact::Termination::error);
  EXPECT_NE(stopped.message.find("negative volume"), std::string::npos) << stopped.message;
  impact::Erosion::Count count;
  EXPECT_EQ(outcome_of(crushed(scaled(1)), &count).termination, impact::Termination::normal);
  EXPECT_EQ(count.negative_volume, 1);
  const std::string others =
      "*SET_PART_LIST\n" + fields({9}) + fields({1}) + "*CONTROL_SOLID\n" + fields({0, 0, 0, 0, 9}) + scaled(0);
  EXPECT_EQ(outcome_of(crushed(others), &count).termination, impact::Termination::normal) << "PSFAIL";
  EXPECT_EQ(count.negative_volume, 1);
}

TEST(Deletion, StepsBelowDtminDeleteWhereErodeSaysSo) {
  const std::string limit = "*CONTROL_TERMINATION\n" + fields({1e-4, 0, 0.2});
  const impact::Outcome stopped = outcome_of(crushed(limit));
  EXPECT_EQ(stopped.termination, impact::Termination::error);
  EXPECT_NE(stopped.message.find("DTMIN"), std::string::npos) << stopped.message;
  impact::Erosion::Count count;
  EXPECT_EQ(outcome_of(crushed(limit + "*CONTROL_TIMESTEP\n" + fields({0, 0.5, 0, 0, 0, 0, 1})), &count).termination,
            impact::Termination::normal);
  EXPECT_EQ(count.small_step, 1);
  EXPECT_EQ(count.negative_volume, 0);
}

/// A shell, one corner of which is driven across its diagonal; a second one beside it.
std::string crossed(int rule, int part_set = 0) {
  Specimen specimen;
  specimen.card("MAT_ELASTIC", {1, density, modulus, 0.3})
      .card("SECTION_SHELL", {1, 2, 1, 3})
      .text(fields({1, 1, 1, 1}))
      .card("CONTROL_TERMINATION", {1e-4})
      .text("*CONTROL_SHELL\n" + fields({0}) + fields({0}) + fields({0}) + fields({1.0 * rule, 0, 1.0 * part_set}))
      .part(1, 1, 1)
      .part(2, 1, 1)
      .text("*SET_PART_LIST\n" + fields({1}) + fields({1}) + "*SET_PART_LIST\n" + fields({2}) + fields({2}))
      .text(constant_curve(1));
  const Grid grid = specimen.shells(1, {}, {20.0, 10.0, 0.0}, 2, 1);
  specimen.node_set(1, {grid(0, 0), grid(1, 0), grid(0, 1)}).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  specimen.node_set(2, {grid(1, 1)})
      .card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 1, 0, 1, -0.8e5})
      .card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 2, 0, 1, -0.8e5});
  return specimen.deck();
}

TEST(Deletion, ShellsWhoseSidesCrossFollowNfail1) {
  impact::Erosion::Count count;
  outcome_of(crossed(1), &count);
  EXPECT_EQ(count.distorted, 1);
  outcome_of(crossed(1, 1), &count);
  EXPECT_EQ(count.distorted, 1);
  outcome_of(crossed(1, 2), &count);  // the other part
  EXPECT_EQ(count.distorted, 0);
  const impact::Outcome stopped = outcome_of(crossed(2), &count);
  EXPECT_EQ(stopped.termination, impact::Termination::error);
  EXPECT_NE(stopped.message.find("NFAIL1"), std::string::npos) << stopped.message;
  EXPECT_EQ(count.distorted, 0);
}

// A mass that a force has pushed is caught, or driven on from the speed that it has: what is held takes its energy to
// round-off, and a motion by acceleration goes on from there (activated between two steps, where both speeds are
// known). Before, the forces of the first step counted twice.
TEST(Supports, BirthTakesWhatMoves) {
  const double mass = 1e-3, force = 2.0, birth = 4.05e-3, step = 1e-4, a = -300.0, end = 8e-3;
  const auto mass_pushed = [&](Specimen& s) {
    const int id = s.mass_point({0, 0, 0}, mass);
    s.text(constant_curve(1)).card("LOAD_NODE_POINT", {double(id), 1, 1, force});
    s.text(constant_curve(90, step)).card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 90}).card("CONTROL_TERMINATION", {end});
    return id;
  };
  Specimen caught;
  const int held = mass_pushed(caught);
  caught.node_set(1, {held}).text("*BOUNDARY_SPC_SET_BIRTH_DEATH\n" + fields({1, 0, 1}) + fields({birth, 1.0}));
  Experiment first(caught.deck());
  double lost = 0.0, kinetic = 0.0, speed = 0.0;
  run_to_end(first, [&](const impact::Snapshot& now) {
    kinetic = std::max(kinetic, now.energy.kinetic);
    lost = std::abs(now.energy.total() - now.energy.external);
    speed = first.velocity(now, held).x;
  });
  expect_reference("loads", "a flying mass that is caught by an SPC: energy lost, of its own", lost, 0.0, 1e-9,
                   kinetic);
  expect_reference("loads", "the same: its speed", speed, 0.0, 1e-12, 1.0);

  Specimen driven;
  const int moved = mass_pushed(driven);
  driven.text(constant_curve(2))
      .text("*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + fields({double(moved), 1, 1, 2, a, 0, 1e28, birth}));
  Experiment second(driven.deck());
  double balance = 0.0, left = 0.0;
  run_to_end(second, [&](const impact::Snapshot& now) {
    left = now.state.time;
    speed = second.velocity(now, moved).x;
    balance = std::abs(now.energy.total() - now.energy.external);
  });
  const double reached = force / mass * birth;
  expect_reference("loads", "a flying mass that is driven on by VAD 1: its speed [mm/s]", speed,
                   reached + a * (left - birth), 1e-9);
  EXPECT_NEAR(balance, 0.0, 1e-9 * kinetic);

  // A way that begins within a step arrives where its curve does.
  Specimen brought;
  const int led = brought.mass_point({0, 0, 0}, mass);
  brought.text(constant_curve(90, step)).card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 90});
  brought.card("CONTROL_TERMINATION", {end}).text(curve(2, {{0.0, 0.0}, {2e-3, 7.0}}));
  brought.text("*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + fields({double(led), 1, 2, 2, 1, 0, 1e28, birth}));
  Experiment third(brought.deck());
  double way = 0.0;
  run_to_end(third, [&](const impact::Snapshot& now) { way = third.displacement(now, led).x; });
  expect_reference("loads", "a mass that is driven by VAD 2 from within a step on: its way [mm]", way, 7.0, 1e-9);
}

// A rigid sheet that its material holds along z and a motion drives there at 500 mm/s. Sabotage: both act, and each
// step counts the work of setting it in motion again.
TEST(RigidMotion, WhatIsDrivenIsNotHeld) {
  Specimen specimen;
  specimen.card("MAT_RIGID", {1, density, modulus, 0.3})
      .text(fields({1, 5, 7}) + fields({0}))
      .card("SECTION_SHELL", {1, 2})
      .text(fields({1, 1, 1, 1}))
      .card("CONTROL_TERMINATION", {1e-3})
      .part(1, 1, 1)
      .text(constant_curve(1))
      .card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {1, 3, 0, 1, 500.0});
  const Grid grid = specimen.shells(1, {}, {20.0, 20.0, 0.0}, 2, 2);
  Experiment experiment(specimen.deck());
  double external = 0.0, height = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    external = now.energy.external;
    height = experiment.position(now, grid(0, 0)).z;
  });
  EXPECT_NEAR(external, 0.5 * density * 400.0 * 500.0 * 500.0, 1e-9);
  EXPECT_NEAR(height, 0.5, 1e-9);
  EXPECT_EQ(experiment.findings().warnings(), 1);
}

}  // namespace
}  // namespace nugget::verify
