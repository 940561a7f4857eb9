// SPDX-License-Identifier: Apache-2.0
// Excitations, responses and kinds of damping of *FREQUENCY_DOMAIN_FRF against closed forms, by modes and directly.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "responses.hpp"

namespace nugget::verify {
namespace {

constexpr double young = 210000.0, steel = 7.85e-9;  // steel A: mm, t, s, N
constexpr double half_decibel = 0.0559;              // 1 - 10^(-1/40)

std::string structural(double g) {
  return "*DAMPING_STRUCTURAL\n" + fields({g});
}

/// DMPSTF as its ten columns have it.
double beta_of(const LinearExperiment& e) {
  return e.system().model.frequency_response->damping.stiffness;
}

Specimen strip(int along, int across, double nu, Grid& grid) {
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {12});
  s.card("MAT_ELASTIC", {1, steel, young, nu});
  s.text("*SECTION_SHELL\n" + fields({1, 16, 5.0 / 6.0, 2}) + fields({2, 2, 2, 2})).part(1, 1, 1);
  grid = s.shells(1, {}, {200.0, 20.0, 0.0}, along, across);
  s.node_set(1, grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  return s;
}

// Reference: eight modes of Euler's beam. Those at resonances are compared at the mesh's own. Sabotage: damping omega
// instead of 2 omega.
TEST(FrequencyResponse, CantileverTip) {
  Grid grid;
  Specimen s = strip(80, 8, 0.3, grid);
  const double tip = grid(80, 4);
  s.text("*FREQUENCY_DOMAIN_FRF\n" + fields({tip, 0, 3, 3}) + fields({0.02}) + fields({tip, 0, 3, 2}) +
         fields({0, 300, 2}));
  const LinearExperiment cantilever(s.deck());
  const nvh::Modes modes = cantilever.modes(5);
  const auto row = [&](double frequency, const char* name, double expected) {
    expect_reference("response of the cantilever strip",
                     fmt::format("cantilever strip, 80 x 8 shells, tip over tip at {} [mm/N]", name),
                     std::abs(response_at(cantilever, modes, frequency)[0]), expected, half_decibel);
  };
  row(0.0, "0 Hz", 0.952305);
  row(20.0, "20 Hz", 1.22696);
  row(modes.frequency(0), "mode 1", 23.1118);
  row(100.0, "100 Hz", 0.163517);
  row(modes.frequency(1), "mode 2", 0.589014);
}

// NAFEMS 13H. Sabotage: pressure on three of four corners.
TEST(FrequencyResponse, PlateUnderHarmonicPressure) {
  constexpr int n = 20;
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {10});
  s.card("MAT_ELASTIC", {1, 8000.0, 200e9, 0.3});
  s.text("*SECTION_SHELL\n" + fields({1, 16, 5.0 / 6.0, 2}) + fields({0.05, 0.05, 0.05, 0.05})).part(1, 1, 1);
  const Grid grid = s.shells(1, {}, {10.0, 10.0, 0.0}, n, n);
  std::vector<int> along_x, along_y;
  std::string segments = "*SET_SEGMENT\n" + fields({5});
  for (int i = 0; i <= n; ++i) {
    along_x.insert(along_x.end(), {grid(i, 0), grid(i, n)});
    along_y.insert(along_y.end(), {grid(0, i), grid(n, i)});
    for (int j = 0; i < n && j < n; ++j)
      segments += fields({1.0 * grid(i, j), 1.0 * grid(i + 1, j), 1.0 * grid(i + 1, j + 1), 1.0 * grid(i, j + 1)});
  }
  s.node_set(1, along_x).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 0, 1, 1});
  s.node_set(2, along_y).card("BOUNDARY_SPC_SET", {2, 0, 1, 1, 1, 1, 0, 1});
  s.text(segments + "*FREQUENCY_DOMAIN_FRF\n" + fields({5, 2, 0, 4}) + fields({0.02}) +
         fields({1.0 * grid(n / 2, n / 2), 0, 3, 2}) + fields({0, 4, 2}));
  const LinearExperiment plate(s.deck());
  const nvh::Modes modes = plate.modes(4);
  const double expected[] = {2.377, 5.961, 5.961, 9.483};
  for (std::size_t i = 0; i < 4; ++i)
    expect_reference("plate under harmonic pressure (13H)",
                     fmt::format("NAFEMS 13H, 20 x 20 shells: mode {} [Hz]", i + 1), modes.frequency(i), expected[i],
                     2e-2);
  const auto centre = [&](double f) { return 100.0 * 1000.0 * response_at(plate, modes, f)[0]; };  // 100 Pa, mm
  expect_reference("plate under harmonic pressure (13H)", "NAFEMS 13H: amplitude of the centre at its mode 1 [mm]",
                   std::abs(centre(modes.frequency(0))), 45.42, 2e-2);
  expect_reference("plate under harmonic pressure (13H)", "NAFEMS 13H: amplitude of the centre at 2.377 Hz [mm]",
                   std::abs(centre(2.377)), 45.42, 2e-2);
  // Against the normal, and a quarter of a period behind.
  EXPECT_NEAR(std::arg(-centre(modes.frequency(0))), -0.5 * std::numbers::pi, 0.02);
}

// A force on the free end, carried by the support: -(k + i omega c) u. Sabotage: no damping in the force; no sign.
TEST(FrequencyResponse, ForceOfTheSupport) {
  Row row(1);
  const double omega = 0.7 * Row::omega0(), beta = 0.3 / Row::omega0();
  const LinearExperiment e(row.hold(row.first).frf(fields({1.0 * row.last, 1, 1, 3}), fields({0, 0, 0, 0, beta}),
                                                   fields({1.0 * row.first, 1, 1, 3})));
  const Complex k = Row::spring() * Complex(1.0, omega * beta_of(e));
  const Complex expected = -4.0 * k / (k - 0.5 * Row::mass() * omega * omega);  // one on each of four nodes
  for (const int modes : {4, 0})
    EXPECT_LT(distance(sum(response_at(e, modes, cycles(omega))), expected), 1e-6) << modes;
}

// The force that shakes the base: its own mass and the mass on the spring, each with its acceleration. Sabotage: the
// base's mass left out.
TEST(FrequencyResponse, ForceThatShakesTheBase) {
  const double omega = 1.3 * Row::omega0(), beta = 0.2 / Row::omega0();
  for (const int vad : {0, 1, 2}) {
    Row row(1);
    const LinearExperiment e(row.hold(row.first).frf(fields({0, 0, 1, 1.0 * vad}), fields({0, 0, 0, 0, beta}),
                                                     fields({1.0 * row.first, 1, 1, 3})));
    const Complex k = Row::spring() * Complex(1.0, omega * beta_of(e)),
                  carried = k / (k - 0.5 * Row::mass() * omega * omega);
    const Complex expected = 0.5 * Row::mass() * (1.0 + carried) * derivative(1, omega) / derivative(vad, omega);
    for (const int modes : {4, 0})
      EXPECT_LT(distance(sum(response_at(e, modes, cycles(omega))), expected), 1e-6) << vad << ' ' << modes;
  }
}

// Enforced motion of all nodes that would else be held is motion of the base. Sabotage: the sign of M s.
TEST(FrequencyResponse, EnforcedMotionOfTheWholeBase) {
  const double omega = 0.8 * Row::omega0(), ratio = 0.05;
  for (const int driven : {0, 1, 2})
    for (const int wanted : {0, 1, 2}) {
      Row row(1);
      const LinearExperiment e(row.frf(fields({1.0 * row.first, 1, 1, 5.0 + driven}), fields({ratio}),
                                       fields({1.0 * row.grid(1, 0), 0, 1, 1.0 * wanted})));
      const double w = Row::omega0();
      const Complex carried = 1.0 + omega * omega / Complex(w * w - omega * omega, 2.0 * ratio * w * omega);
      EXPECT_LT(distance(response_at(e, 4, cycles(omega))[0],
                         carried * derivative(wanted, omega) / derivative(driven, omega)),
                1e-6)
          << driven << ' ' << wanted;
    }
}

// Two bricks between a driven end and a held one: half of the motion goes along at rest. Sabotage: a shape of 1 all
// over, as of a base.
TEST(FrequencyResponse, EnforcedMotionBesideASupport) {
  const double eta = 0.1, omega = 0.6 * Row::omega0();
  const Complex k = Row::spring() * Complex(1.0, eta);
  const Complex middle = k / (2.0 * k - Row::mass() * omega * omega);
  const auto find = [&](int modes, double node_or_set, int type, int wanted) {
    Row row(2);
    row.specimen.text(structural(eta));
    const double place = node_or_set > 0 ? node_or_set : row.grid(1, 0);
    const LinearExperiment e(row.hold(row.last).frf(fields({1.0 * row.first, 1, 1, 7}), fields({0}),
                                                    fields({place, 1.0 * type, 1, 1.0 * wanted})));
    return sum(response_at(e, modes, cycles(omega)));
  };
  for (const int modes : {4, 0}) {
    EXPECT_LT(distance(find(modes, 0, 0, 2), middle), 1e-6) << modes;
    EXPECT_LT(distance(find(modes, 3, 1, 3), -k * middle), 1e-6) << modes;
    EXPECT_LT(distance(find(modes, 2, 1, 3), k * (1.0 - middle) - 0.5 * Row::mass() * omega * omega), 1e-6) << modes;
  }
}

// Two masses, the loss factor a curve over frequency. Sabotage: the loss of the first frequency at all of them.
TEST(FrequencyResponse, StructuralDampingOfTwoMasses) {
  const double top = cycles(3.0 * Row::omega0());
  Row row(2);
  row.specimen.text(curve(6, {{0.0, 0.02}, {top, 0.32}}) + "*DAMPING_STRUCTURAL\n" + fields({0, 6, 0}));
  const LinearExperiment e(
      row.hold(row.first).frf(fields({1.0 * row.last, 1, 1, 3}), fields({0}), fields({1.0 * row.grid(2, 0), 0, 1, 2})));
  for (const double part : {0.0, 0.2, 0.5, 0.9}) {
    const double frequency = part * top, omega = 2.0 * std::numbers::pi * frequency;
    const Complex k = Row::spring() * Complex(1.0, 0.02 + 0.3 * part);
    const Complex inner = 2.0 * k - Row::mass() * omega * omega, outer = k - 0.5 * Row::mass() * omega * omega;
    const Complex expected = 4.0 * inner / (inner * outer - k * k);
    for (const int modes : {8, 0})
      EXPECT_LT(distance(response_at(e, modes, frequency)[0], expected), 1e-6) << part << ' ' << modes;
  }
}

// Rayleigh damping has a matrix: both routes agree. Sabotage: alpha on the stiffness; no residual vector.
TEST(FrequencyResponse, DirectSolutionAgreesWithModes) {
  Grid grid;
  Specimen s = strip(20, 2, 0.3, grid);
  const double tip = grid(20, 1), middle = grid(10, 0);
  s.node_set(7, {static_cast<int>(tip), static_cast<int>(middle)});
  s.text("*FREQUENCY_DOMAIN_FRF\n" + fields({tip, 0, 3, 3}) + fields({0, 0, 0, 20.0, 2e-5}) + fields({7, 1, 3, 0}) +
         fields({0, 1000, 2}));
  const LinearExperiment cantilever(s.deck());
  const nvh::Modes modes = cantilever.modes(20);
  for (const double frequency : {0.5, 30.0, 42.0, 150.0, 262.0, 500.0, 735.0, 900.0}) {
    const std::vector<Complex> direct = response_at(cantilever, 0, frequency),
                               modal = response_at(cantilever, modes, frequency);
    for (std::size_t c = 0; c < 2; ++c) EXPECT_LT(distance(modal[c], direct[c]), 1e-3) << frequency << ' ' << c;
  }
}

// A beam under a moment at its end turns by M L / (E I) there. Sabotage: the torque as a force.
TEST(FrequencyResponse, TorqueTurnsTheTip) {
  Grid grid;
  Specimen s = strip(40, 1, 0.0, grid);
  s.node_set(7, grid.across(40));
  s.text("*FREQUENCY_DOMAIN_FRF\n" + fields({7, 1, 2, 8}) + fields({0}) + fields({1.0 * grid(40, 0), 0, 8, 2}) +
         fields({0, 1, 2}));
  const LinearExperiment cantilever(s.deck());
  const double inertia = 20.0 * 8.0 / 12.0;
  for (const int modes : {3, 0}) {
    const std::vector<Complex> turn = response_at(cantilever, modes, 0.0);
    ASSERT_EQ(turn.size(), 3u);
    EXPECT_NEAR(turn[1].real(), 2.0 * 200.0 / (young * inertia), 1e-3 * turn[1].real()) << modes;
    // Nothing along the strip, beside what it bends: M L^2 / (2 E I).
    EXPECT_NEAR(std::abs(turn[0]), 0.0, 1e-6 * 100.0 * turn[1].real());
  }
}

// What the equations cannot answer is refused at its card.
TEST(FrequencyResponse, RefusesWhatTheModelCannotAnswer) {
  const auto refusal = [](const model::FrequencyResponse::Quantity quantity, bool rotation, bool torque, bool direct) {
    Row row(1);
    const LinearExperiment e(
        row.hold(row.first).frf(fields({1.0 * row.last, 1, 1, 3}), fields({0.02}), fields({1.0 * row.last, 1, 1, 2})));
    model::FrequencyResponse request = *e.system().model.frequency_response;
    request.cases[0].response.quantity = quantity;
    request.cases[0].response.rotation = rotation;
    request.direct = direct;
    if (torque) request.cases[0].excitation.kind = model::FrequencyResponse::Excitation::Kind::torque;
    Findings findings;
    nvh::check_frequency_response(e.matrices(), request, findings);
    return findings.errors() > 0 ? findings.all().front().text : std::string();
  };
  using Quantity = model::FrequencyResponse::Quantity;
  EXPECT_EQ(refusal(Quantity::displacement, false, false, false), "");
  EXPECT_NE(refusal(Quantity::force, false, false, false).find("none holds it"), std::string::npos);
  EXPECT_NE(refusal(Quantity::displacement, true, false, false).find("nothing turns"), std::string::npos);
  EXPECT_NE(refusal(Quantity::displacement, false, true, false).find("carries a torque"), std::string::npos);
  EXPECT_NE(refusal(Quantity::displacement, false, false, true).find("has no matrix"), std::string::npos);
}

// A base that turns about z by 1 carries a mass r from the axis along by r, which a spring across r adds to. Sabotage:
// the codes of translations.
TEST(FrequencyResponse, TurningBase) {
  const double r = 70.0, spring = 50.0, mass = 0.002, own = std::sqrt(spring / mass), omega = 0.6 * own;
  for (const int vad : {9, 10, 11}) {
    Specimen s;
    s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {4});
    const int tip = s.mass_point({r, 0, 0}, mass), ground = s.node({r, -30.0, 0});
    s.card("MAT_SPRING_ELASTIC", {1, spring}).card("SECTION_DISCRETE", {1}).part(1, 1, 1);
    s.text(fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}\n", 1, 1, tip, ground));
    s.card("BOUNDARY_SPC_NODE", {1.0 * ground, 0, 1, 1, 1, 1, 1, 1});
    s.card("BOUNDARY_SPC_NODE", {1.0 * tip, 0, 1, 0, 1, 1, 1, 1});
    s.text("*FREQUENCY_DOMAIN_FRF\n" + fields({0, 0, 3, 1.0 * vad}) + fields({0.05}) + fields({1.0 * tip, 0, 2, 2}) +
           fields({1, 10, 2}));
    const LinearExperiment e(s.deck());
    const Complex relative = omega * omega / (own * own - omega * omega + Complex(0.0, 2.0 * 0.05 * own * omega));
    const Complex expected = r / derivative(vad - 9, omega) * (1.0 + relative);
    EXPECT_LT(distance(response_at(e, 1, cycles(omega))[0], expected), 1e-6) << vad;
  }
}

}  // namespace
}  // namespace nugget::verify
