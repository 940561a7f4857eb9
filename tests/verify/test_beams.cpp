// SPDX-License-Identifier: Apache-2.0
// Beams of the structure: ELFORM 1 (Hughes-Liu), 2 (Belytschko-Schwer), 3 (truss), against beam theory.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "linear.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double young = 210000.0, nu = 0.3, steel = 7.85e-9, pi = std::numbers::pi;

/// *SECTION_BEAM 1: ELFORM 1 a rectangle (s along the third node), ELFORM 2 by its moments; shear factor 5/6.
void rectangle(Specimen& s, int elform, double along_s, double along_t, double quadrature = 2) {
  s.text("*SECTION_BEAM\n" + fields({1, double(elform), 5.0 / 6.0, quadrature, 0}));
  const double a = along_s * along_t, iss = along_s * along_t * along_t * along_t / 12.0,
               itt = along_t * along_s * along_s * along_s / 12.0;
  if (elform == 1)
    s.text(fields({along_s, along_s, along_t, along_t}));
  else
    s.text(fields({a, iss, itt, iss + itt, 5.0 / 6.0 * a}));
  s.part(1, 1, 1);
}

/// Beams along a curve; the third node of each lies in the direction `side`.
std::vector<int> beams(Specimen& s, int count, const std::function<Vec3d(double)>& place, const Vec3d& side) {
  std::vector<int> n;
  std::string text = "*ELEMENT_BEAM\n";
  for (int i = 0; i <= count; ++i) n.push_back(s.node(place(double(i) / count)));
  const int third = s.node(place(0.5) + 1e3 * side);
  s.card("BOUNDARY_SPC_NODE", {double(third), 0, 1, 1, 1, 1, 1, 1});
  for (int i = 0; i < count; ++i) text += element_line(i + 1, 1, {n[std::size_t(i)], n[std::size_t(i) + 1], third});
  s.text(text);
  return n;
}

std::string unit_load(int node, int dof, double value) {
  return "*LOAD_NODE_POINT\n" + fields({double(node), double(dof), 1, value});
}

// Bending of n one-point beams: P L^3 / (3 E I) (1 - 1 / (4 n^2)) + P L / (kappa G A), and an end moment exactly.
// Sabotage: the lever of the shear force in the end moments left out; s and t exchanged.
TEST(Beams, CantileversOfOnePointBeams) {
  const double length = 200.0, a = 6.0, b = 10.0, load = 10.0, G = young / (2.0 * (1.0 + nu));
  const double GA = 5.0 / 6.0 * G * a * b;
  for (const int n : {1, 4, 10})
    for (const bool about_t : {true, false}) {
      // s along y: bending in y is about t with I = t s^3 / 12.
      const double I = about_t ? b * a * a * a / 12.0 : a * b * b * b / 12.0;
      Specimen s;
      s.card("MAT_ELASTIC", {1, steel, young, nu});
      rectangle(s, 1, a, b);
      const auto nodes = beams(s, n, [&](double x) { return Vec3d{length * x, 0, 0}; }, {0, 1, 0});
      s.card("BOUNDARY_SPC_NODE", {double(nodes[0]), 0, 1, 1, 1, 1, 1, 1});
      s.text(unit_load(nodes.back(), about_t ? 2 : 3, load));
      const nvh::SixDof u = static_motion(s, nodes.back());
      const double expected =
          load * length * length * length / (3.0 * young * I) * (1.0 - 0.25 / (n * n)) + load * length / GA;
      expect_reference("bending of one-point elements",
                       fmt::format("ELFORM 1, cantilever of {} beams, bent about {} [mm]", n, about_t ? 't' : 's'),
                       u[about_t ? 1 : 2], expected, 1e-6);
    }
}

// ELFORM 2 is exact for any number of elements, with shear and in torsion and tension.
TEST(Beams, ResultantCantileverIsExact) {
  const double length = 200.0, a = 6.0, b = 10.0, load = 10.0, G = young / (2.0 * (1.0 + nu)), A = a * b;
  const double iss = a * b * b * b / 12.0, itt = b * a * a * a / 12.0;
  for (const int n : {1, 3}) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, steel, young, nu});
    rectangle(s, 2, a, b);
    // A beam askew in space, so that all axes take part.
    const Vec3d along = (1.0 / 3.0) * Vec3d{2, 1, 2}, side = (1.0 / 3.0) * Vec3d{-2, 2, 1}, third = cross(along, side);
    const auto nodes = beams(
        s, n, [&](double x) { return (length * x) * along; }, side);
    s.card("BOUNDARY_SPC_NODE", {double(nodes[0]), 0, 1, 1, 1, 1, 1, 1});
    const auto loaded = [&](const Vec3d& direction, bool moment) {
      Specimen one = s;
      const double c[3] = {direction.x, direction.y, direction.z};
      for (int i = 0; i < 3; ++i) one.text(unit_load(nodes.back(), (moment ? 5 : 1) + i, load * c[i]));
      return static_motion(one, nodes.back());
    };
    const auto part = [](const nvh::SixDof& u, const Vec3d& d, std::size_t first) {
      return u[first] * d.x + u[first + 1] * d.y + u[first + 2] * d.z;
    };
    const double cube = length * length * length / (3.0 * young), shear = length / (5.0 / 6.0 * G * A);
    const std::string name = fmt::format("ELFORM 2, cantilever of {} beams: ", n);
    expect_reference("bending of one-point elements", name + "along s [mm]", part(loaded(side, false), side, 0),
                     load * (cube / itt + shear), 1e-8);
    expect_reference("bending of one-point elements", name + "along t [mm]", part(loaded(third, false), third, 0),
                     load * (cube / iss + shear), 1e-8);
    expect_reference("bending of one-point elements", name + "stretch [mm]", part(loaded(along, false), along, 0),
                     load * length / (young * A), 1e-8);
    expect_reference("bending of one-point elements", name + "twist [rad]", part(loaded(along, true), along, 3),
                     load * length / (G * (iss + itt)), 1e-8);
    expect_reference("bending of one-point elements", name + "end moment, rotation [rad]",
                     part(loaded(side, true), side, 3), load * length / (young * iss), 1e-8);
  }
}

// A quarter circle bent out of its plane and in it (Roark, thin): the beams' curvature by straight pieces converges.
TEST(Beams, QuarterCircle) {
  const double R = 100.0, d = 4.0, load = 5.0, G = young / (2.0 * (1.0 + nu)), I = pi * d * d * d * d / 64.0,
               J = 2.0 * I, A = pi * d * d / 4.0;
  const double in_plane =
      pi * load * R * R * R / (4.0 * young * I) + pi * load * R / (4.0 * young * A) + pi * load * R / (4.0 * G * A);
  const double across =
      load * R * R * R * (pi / 4.0 / (young * I) + (3.0 * pi / 4.0 - 2.0) / (G * J)) + load * R * pi / 2.0 / (G * A);
  for (const int elform : {1, 2}) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, steel, young, nu});
    s.text("*SECTION_BEAM\n" + fields({1, double(elform), 1.0, 3, 1}));
    s.text(elform == 1 ? fields({d, d, 0, 0}) : fields({A, I, I, J, A})).part(1, 1, 1);
    const auto nodes = beams(s, 24,
                             [&](double x) {
                               return Vec3d{R * std::cos(0.5 * pi * x), R * std::sin(0.5 * pi * x), 0};
                             },
                             {0, 0, 1});
    s.card("BOUNDARY_SPC_NODE", {double(nodes[0]), 0, 1, 1, 1, 1, 1, 1});
    Specimen in = s, out = s;
    // At the free end (0, R): x is the tangent's direction there, y the radius.
    in.text(unit_load(nodes.back(), 2, load));
    out.text(unit_load(nodes.back(), 3, load));
    expect_reference("beams", fmt::format("quarter circle of 24 beams, ELFORM {}, in its plane [mm]", elform),
                     static_motion(in, nodes.back())[1], in_plane, 5e-3);
    expect_reference("beams", fmt::format("quarter circle of 24 beams, ELFORM {}, across it [mm]", elform),
                     static_motion(out, nodes.back())[2], across, 5e-3);
  }
}

// Modes of a pinned beam. The one-point beam is too soft by 1 / (1 - ...) of a wave: second order in the mesh.
TEST(Beams, ModesOfAPinnedBeam) {
  const double length = 500.0, a = 5.0, b = 8.0, EI = young * b * a * a * a / 12.0, per_length = steel * a * b;
  const double first = pi / (2.0 * length * length) * std::sqrt(EI / per_length);
  for (const int elform : {1, 2}) {
    Specimen s;
    s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {2});
    s.card("MAT_ELASTIC", {1, steel, young, nu});
    rectangle(s, elform, a, b);
    const auto nodes = beams(s, 40, [&](double x) { return Vec3d{length * x, 0, 0}; }, {0, 1, 0});
    for (const int n : nodes) {
      const bool end = n == nodes.front() || n == nodes.back();
      s.card("BOUNDARY_SPC_NODE", {double(n), 0, 1, end ? 1.0 : 0.0, 1, 1, 1, 0});
    }
    const LinearExperiment beam(s.deck());
    const nvh::Modes modes = beam.modes(2);
    for (int k = 1; k <= 2; ++k)
      expect_reference("beams", fmt::format("pinned beam of 40, ELFORM {}: mode {} [Hz]", elform, k),
                       modes.frequency(at(k - 1)), k * k * first, 5e-3);
  }
}

// A cantilever in the explicit run: its energy and period. Loaded at once it swings to twice the static deflection.
TEST(Beams, ExplicitCantileverSwings) {
  const double length = 100.0, a = 5.0, load = 20.0, I = a * a * a * a / 12.0;
  for (const int elform : {1, 2}) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, steel, young, nu});
    rectangle(s, elform, a, a);
    const auto nodes = beams(s, 8, [&](double x) { return Vec3d{0, length * x, 0}; }, {0, 0, 1});
    s.card("BOUNDARY_SPC_NODE", {double(nodes[0]), 0, 1, 1, 1, 1, 1, 1});
    s.text(smooth_ramp(1, 0.01)).text(unit_load(nodes.back(), 1, load)).card("CONTROL_TERMINATION", {0.013});
    Experiment experiment(s.deck());
    TimeMean tip;
    double drift = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      if (now.state.time > 0.01) tip.add(experiment.displacement(now, nodes.back()).x, now.state.dt);
      if (now.state.time > 0.002) drift = std::max(drift, std::abs(now.energy.ratio() - 1.0));
    });
    const double bending =
        load * length * length * length / (3.0 * young * I) * (elform == 1 ? 1.0 - 0.25 / 64.0 : 1.0);
    const double shear = load * length / (5.0 / 6.0 * young / 2.6 * a * a);
    expect_reference("bending of one-point elements",
                     fmt::format("explicit cantilever of 8 beams, ELFORM {} [mm]", elform), tip.value(),
                     bending + shear, 5e-3);
    EXPECT_NEAR(drift, 0.0, 1e-3);
  }
}

// Nodes on an edge of the section (NSLOC, NTLOC): a pull along their line bends the beam, a force across it twists it.
// N e L / (E I), N e L^2 / (2 E I), F e L / (G J) by J of Roark.
// Sabotage: the twist of the middle left out of its shear; the shear factor on one side of that only.
TEST(Beams, NodesOnTheEdgeOfTheSection) {
  const double length = 200.0, a = 6.0, b = 10.0, load = 10.0, G = young / (2.0 * (1.0 + nu));
  const double itt = b * a * a * a / 12.0, iss = a * b * b * b / 12.0;
  const double q = a / b, torsion = b * a * a * a * (1.0 / 3.0 - 0.21 * q * (1.0 - q * q * q * q / 12.0));
  Specimen s;
  s.card("MAT_ELASTIC", {1, steel, young, nu});
  s.text("*SECTION_BEAM\n" + fields({1, 1, 5.0 / 6.0, 2, 0}) + fields({a, a, b, b, 1, -1})).part(1, 1, 1);
  const auto nodes = beams(s, 4, [&](double x) { return Vec3d{length * x, 0, 0}; }, {0, 1, 0});
  s.card("BOUNDARY_SPC_NODE", {double(nodes[0]), 0, 1, 1, 1, 1, 1, 1});
  const auto motion = [&](int dof) {
    Specimen one = s;
    one.text(unit_load(nodes.back(), dof, load));
    return static_motion(one, nodes.back());
  };
  // The section lies 3 below the nodes along s and 5 above them along t.
  const nvh::SixDof pulled = motion(1), along_s = motion(2);
  expect_reference("beams", "NSLOC 1: pulled on its upper side, deflection along s [mm]", pulled[1],
                   -load * 0.5 * a * length * length / (2.0 * young * itt), 1e-6);
  expect_reference("beams", "NTLOC -1: pulled on its lower side, deflection along t [mm]", pulled[2],
                   load * 0.5 * b * length * length / (2.0 * young * iss), 1e-6);
  expect_reference("beams", "NTLOC -1: force along s on its lower side, twist [rad]", along_s[3],
                   load * 0.5 * b * length / (G * torsion), 1e-6);
}

// Beams as short as they like, nodes on the middle and on an edge, thrown about at TSSFAC 0.9: their energy stays.
// Sabotage: rotary inertia of nodes on an edge as it is by the section alone.
TEST(Beams, FreeStubsKeepTheirEnergy) {
  for (const double location : {0.0, 1.0})
    for (const double factor : {5.0 / 6.0, 1.0})
      for (const double cell : {0.5, 2.0, 5.0, 10.0, 40.0}) {
        Specimen s;
        s.card("MAT_ELASTIC", {1, steel, young, 0.0});
        s.text("*SECTION_BEAM\n" + fields({1, 1, factor, 2, 0}) + fields({10, 10, 5, 5, location, location}));
        s.part(1, 1, 1);
        const auto nodes = beams(s, 4, [&](double x) { return Vec3d{4.0 * cell * x, 0, 0}; }, {0, 1, 0});
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const double x = double(i);
          s.card("INITIAL_VELOCITY_NODE", {double(nodes[i]), std::sin(3 * x), std::cos(2 * x), std::sin(5 * x + 1),
                                           std::cos(7 * x) / cell, std::sin(4 * x) / cell, std::cos(6 * x + 2) / cell});
        }
        const double wave = std::sqrt(steel / young) * cell;
        s.card("CONTROL_TERMINATION", {2000 * wave});
        Experiment experiment(s.deck());
        double drift = 0.0;
        run_to_end(experiment,
                   [&](const impact::Snapshot& now) { drift = std::max(drift, std::abs(now.energy.ratio() - 1.0)); });
        EXPECT_LT(drift, 1e-3) << location << ' ' << factor << ' ' << cell;
      }
}

// A whole turn of a free beam: nothing comes up in it. Sabotage: nodal axes that stay in space.
TEST(Beams, RigidTurnsMakeNoForce) {
  for (const int elform : {1, 2, 3}) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, steel, young, nu});
    if (elform < 3)
      rectangle(s, elform, 4.0, 7.0);
    else
      s.text("*SECTION_BEAM\n" + fields({1, 3}) + fields({28.0})).part(1, 1, 1);
    const auto nodes = beams(s, 1, [&](double x) { return Vec3d{100.0 * (x - 0.5), 0, 0}; }, {0, 1, 0});
    const double omega = 10.0;
    for (const int n : nodes)
      s.card("INITIAL_VELOCITY_NODE", {double(n), 0, omega * (n == nodes[0] ? -50.0 : 50.0), 0, 0, 0, omega});
    s.card("CONTROL_TERMINATION", {0.2 * pi});
    Experiment experiment(s.deck());
    double worst = 0.0;
    Vec3d place;
    long cycles = 0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      const auto r = now.system.groups.at(0)->resultants(0);
      for (int i = 1; i < 6; ++i) worst = std::max(worst, std::abs(r[std::size_t(i)]));
      place = experiment.position(now, nodes[1]);
      ++cycles;
    });
    EXPECT_NEAR(worst, 0.0, 0.1) << elform;  // of E I / L = 2.4e5 N mm a radian
    EXPECT_NEAR(place.x, 50.0, 1e-3) << elform;
    EXPECT_NEAR(place.y, 0.0, 1e-2) << elform;
  }
}

// Fully plastic hinge of a rectangle, b h^2 / 4 sigma: ELFORM 1 by its points, 2x2 Gauss gives b h^2 / (2 sqrt 3).
TEST(Beams, PlasticHinge) {
  const double a = 10.0, b = 6.0, yield = 300.0, length = 20.0;
  for (const auto& [quadrature, moment] :
       {std::pair{2.0, a * a * b / (2.0 * std::sqrt(3.0)) * yield}, {5.0, a * a * b * yield * 0.260634}}) {
    Specimen s;
    s.card("MAT_PLASTIC_KINEMATIC", {1, steel, young, nu, yield, 0.0, 1.0}).text(fields({}));
    rectangle(s, 1, a, b, quadrature);
    const auto nodes = beams(s, 1, [&](double x) { return Vec3d{length * x, 0, 0}; }, {0, 1, 0});
    s.card("BOUNDARY_SPC_NODE", {double(nodes[0]), 0, 1, 1, 1, 1, 1, 1});
    s.card("BOUNDARY_SPC_NODE", {double(nodes[1]), 0, 0, 0, 1, 1, 1, 0});
    s.text(smooth_ramp(1, 2e-3, 0.3));
    s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(nodes[1]), 7, 2, 1, 1.0});
    s.card("CONTROL_TERMINATION", {2.2e-3});
    Experiment experiment(s.deck());
    double reached = 0.0;
    run_to_end(experiment,
               [&](const impact::Snapshot& now) { reached = std::abs(now.system.groups.at(0)->resultants(0)[5]); });
    expect_reference("beams", fmt::format("plastic hinge, QR {}: moment [N mm]", quadrature), reached, moment, 1e-2);
  }
}

// A truss pulled through yield: logarithmic strain, linear hardening; back by kinematic hardening.
TEST(Beams, TrussOverACycle) {
  const double A = 12.0, yield = 300.0, tangent = 2000.0, length = 100.0;
  for (const double beta : {0.0, 1.0}) {
    Specimen s;
    s.card("MAT_PLASTIC_KINEMATIC", {1, steel, young, nu, yield, tangent, beta}).text(fields({}));
    s.text("*SECTION_BEAM\n" + fields({1, 3}) + fields({A})).part(1, 1, 1);
    const int first = s.node({0, 0, 0}), second = s.node({length, 0, 0});
    s.text("*ELEMENT_BEAM\n" + element_line(1, 1, {first, second}));
    s.card("BOUNDARY_SPC_NODE", {double(first), 0, 1, 1, 1}).card("BOUNDARY_SPC_NODE", {double(second), 0, 0, 1, 1});
    s.text(curve(9, {{0, 0}, {1e-3, 2}, {2e-3, 0}}));
    s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(second), 1, 2, 9, 1});
    s.text(constant_curve(8, 1e-6)).card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 8}).card("CONTROL_TERMINATION", {2e-3});
    Experiment experiment(s.deck());
    double at_top = 0.0, at_end = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      const double N = now.system.groups.at(0)->resultants(0)[0];
      if (now.state.time <= 1e-3) at_top = N;
      at_end = N;
    });
    const double strain = std::log(1.02), top = yield + tangent * (strain - yield / young);
    // Back by `strain`: yields again at -yield + 2 (top - yield)(1 - beta) ... on the shifted or widened range.
    const double again = beta == 0.0 ? top - 2.0 * yield : -top;
    const double rest = strain - (top - again) / young;
    expect_reference("beams", fmt::format("truss, BETA {}: force at the top [N]", beta), at_top, A * top, 2e-3);
    expect_reference("beams", fmt::format("truss, BETA {}: force after the way back [N]", beta), at_end,
                     A * (again - tangent * rest), 2e-3);
  }
}

}  // namespace
}  // namespace nugget::verify
