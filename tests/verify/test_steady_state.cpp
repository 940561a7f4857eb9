// SPDX-License-Identifier: Apache-2.0
// *FREQUENCY_DOMAIN_SSD: loads with amplitude and phase over frequency, against one mass on a spring.
#include "nvh/response/steady_state.hpp"

#include "nvh/response/response_states.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "responses.hpp"

namespace nugget::verify {
namespace {

constexpr double ratio = 0.05;

/// Cards of the keyword with these loads; response of the free end at FMIN = `frequency`.
std::string deck(const std::string& options, const std::string& switches, const std::string& damping,
                 const std::string& loads, double frequency, const std::string& curves) {
  Row row(1);
  row.hold(row.first);
  row.specimen.text(curves + "*FREQUENCY_DOMAIN_SSD" + options + '\n' + switches + damping + fields({0}) + loads);
  row.specimen.text("*DATABASE_FREQUENCY_ASCII_NODOUT_SSD\n" + fields({frequency, 2.0 * frequency, 2}));
  row.specimen.text("*DATABASE_HISTORY_NODE\n" + fields({1.0 * row.grid(1, 0)}));
  return row.specimen.deck();
}

/// Displacement, velocity, acceleration along x at the first frequency.
std::array<Complex, 3> end_motion(const std::string& text) {
  const LinearExperiment e(text);
  const model::SteadyState& request = *e.system().model.steady_state;
  Findings findings;
  nvh::check_steady_state(e.matrices(), request, findings);
  EXPECT_EQ(findings.errors(), 0);
  const nvh::SteadyResult result = nvh::steady_state(e.matrices(), request.direct ? nvh::Modes{} : e.modes(4), request);
  std::array<Complex, 3> motion;
  for (std::size_t q = 0; q < 3; ++q) motion[q] = result.curve[0].value[q][0];
  return motion;
}

const double omega = 0.8 * Row::omega0(), frequency = cycles(omega);

std::string level(int id, double value) {
  return curve(id, {{0.0, value}, {4.0 * frequency, value}});
}

Complex flexibility() {
  const double k = Row::spring(), m = 0.5 * Row::mass();
  return 1.0 / (k - m * omega * omega + Complex(0.0, 2.0 * ratio * Row::omega0() * m * omega));
}

// Two loads on the four nodes of the end, of which one lags by a quarter of a period. Sabotage: phases in radians;
// loads of which each has its own response.
TEST(SteadyState, LoadsWithPhase) {
  const std::string curves = level(11, 3.0) + level(12, 2.0) + level(13, -90.0);
  const std::string loads = fields({3, 1, 1, 0, 11, 0, 10.0}) + fields({3, 1, 1, 0, 12, 13});
  const Complex force = 4.0 * Complex(30.0, -2.0);
  const auto found = end_motion(deck("", fields({1}), fields({ratio}), loads, frequency, curves));
  for (std::size_t q = 0; q < 3; ++q) {
    const Complex power = q == 0 ? 1.0 : q == 1 ? Complex(0.0, omega) : -omega * omega;
    EXPECT_LT(distance(found[q], power * force * flexibility()), 1e-6) << q;
  }
}

// The same force by real and imaginary part. Sabotage: the second curve as a phase.
TEST(SteadyState, LoadsByParts) {
  const std::string curves = level(11, 30.0) + level(12, -2.0);
  const auto found = end_motion(
      deck("", fields({1, 0, 0, 0, 0, 0, 1}), fields({ratio}), fields({3, 1, 1, 0, 11, 12}), frequency, curves));
  EXPECT_LT(distance(found[0], 4.0 * Complex(30.0, -2.0) * flexibility()), 1e-6);
}

// A curve acts where it is: the amplitude at this frequency, 0 outside. Sabotage: end values hold outside.
TEST(SteadyState, CurvesOverFrequency) {
  const auto with = [&](double last) {
    const std::string curves = curve(11, {{0.0, 0.0}, {last, last}});
    return end_motion(deck("", fields({1}), fields({ratio}), fields({3, 1, 1, 0, 11}), frequency, curves))[0];
  };
  EXPECT_LT(distance(with(2.0 * frequency), 4.0 * frequency * flexibility()), 1e-6);
  EXPECT_EQ(with(0.5 * frequency), Complex(0.0));
}

// Motion of the base, absolute and relative. Sabotage: base velocity taken for acceleration.
TEST(SteadyState, MotionOfTheBase) {
  const Complex relative = omega * omega * 0.5 * Row::mass() * flexibility();
  for (const int vad : {2, 3, 4})
    for (const int relatv : {0, 1}) {
      const auto found = end_motion(deck("", fields({1, 0, 0, 0, 0, 0, 0, 1.0 * relatv}), fields({ratio}),
                                         fields({0, 0, 1, 1.0 * vad, 11}), frequency, level(11, 5.0)));
      const Complex base = 5.0 / derivative(vad - 2, omega);
      EXPECT_LT(distance(found[0], base * (relatv == 1 ? relative : 1.0 + relative)), 1e-6) << vad << ' ' << relatv;
      EXPECT_LT(distance(found[2], -omega * omega * found[0]), 1e-8);  // FMIN has ten columns
    }
}

// _DIRECT: one solution for each frequency, structural damping. Sabotage: the modal route without modes.
TEST(SteadyState, DirectSolution) {
  const std::string curves = level(11, 1.0) + "*DAMPING_STRUCTURAL\n" + fields({0.1});
  const auto found = end_motion(deck("_DIRECT", fields({1}), fields({0}), fields({3, 1, 1, 0, 11}), frequency, curves));
  const Complex expected = 4.0 / (Row::spring() * Complex(1.0, 0.1) - 0.5 * Row::mass() * omega * omega);
  EXPECT_LT(distance(found[0], expected), 1e-6);
}

// Two loads that are the same, and one that no mode is missing for: residual vectors drop out. Sabotage: dividing by
// the mass of what is left.
TEST(SteadyState, DependentLoads) {
  const std::string curves = level(11, 1.0);
  const std::string load = fields({3, 1, 1, 0, 11});
  const auto found = end_motion(deck("", fields({1, 1}), fields({ratio}), load + load + load, frequency, curves));
  EXPECT_TRUE(std::isfinite(std::abs(found[0])));
  EXPECT_LT(distance(found[0], 12.0 * flexibility()), 1e-6);
}

// The base turns about an axis: a mass on a spring across it goes r times the angle, r from the axis, which lies where
// the vector lies or in the origin. Sabotage: the axis through the origin in any case; no rotation of bodies.
TEST(SteadyState, TurningBase) {
  const double length = 100.0, spring = 50.0, mass = 0.002, angle = 0.01;
  const double own = std::sqrt(spring / mass), now = 0.6 * own;
  for (const bool by_vector : {false, true}) {
    Specimen s;
    s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {4});
    const int tip = s.mass_point({20.0 + length, 30.0, 0.0}, mass), ground = s.node({20.0 + length, 0.0, 0.0});
    s.card("MAT_SPRING_ELASTIC", {1, spring}).card("SECTION_DISCRETE", {1}).part(1, 1, 1);
    s.text(fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}\n", 1, 1, tip, ground));
    s.card("BOUNDARY_SPC_NODE", {1.0 * ground, 0, 1, 1, 1, 1, 1, 1});
    s.card("BOUNDARY_SPC_NODE", {1.0 * tip, 0, 1, 0, 1, 1, 1, 1});
    s.card("DEFINE_VECTOR", {3, 20.0, 7.0, 0.0, 20.0, 7.0, 2.0});
    s.text(curve(11, {{0.0, angle}, {1e6, angle}}));
    for (const int vad : {9, 10, 11}) {
      Specimen deck = s;
      deck.text("*FREQUENCY_DOMAIN_SSD\n" + fields({1}) + fields({ratio}) + fields({0}) +
                fields({0, 0, by_vector ? 4.0 : 3.0, 1.0 * vad, 11, 0, 1, 3}));
      deck.text("*DATABASE_FREQUENCY_ASCII_NODOUT_SSD\n" + fields({cycles(now), 2.0 * cycles(now), 2}));
      deck.text("*DATABASE_HISTORY_NODE\n" + fields({1.0 * tip}));
      const LinearExperiment e(deck.deck());
      const nvh::SteadyResult result = nvh::steady_state(e.matrices(), e.modes(1), *e.system().model.steady_state);
      const double w = 2.0 * std::numbers::pi * result.frequency[0], arm = by_vector ? length : 20.0 + length;
      const Complex turn = angle / derivative(vad - 9, w);
      const Complex relative = w * w / (own * own - w * w + Complex(0.0, 2.0 * ratio * own * w));
      EXPECT_LT(distance(result.curve[1].value[0][0], arm * turn * (1.0 + relative)), 1e-6) << vad << by_vector;
    }
  }
}

/// Two cases: the base moves by 3; forces of 1 and 2 on each node of the end, the second a quarter of a period later.
std::string cases(const std::string& second = "turned") {
  Row row(1);
  row.hold(row.first);
  row.specimen.text(level(11, 1.0) + level(12, 90.0));
  row.specimen.text("*FREQUENCY_DOMAIN_SSD_SUBCASE\n" + fields({1}) + fields({ratio}) + fields({0}) +
                    fmt::format("{:<10}{:<60}{:>10}\n", "plain", "one motion", 1) + fields({0, 0, 1, 4, 11, 0, 3}) +
                    fmt::format("{:<10}{:<60}{:>10}\n", second, "", 2) + fields({3, 1, 1, 0, 11}) +
                    fields({3, 1, 1, 0, 11, 12, 2}));
  row.specimen.text("*DATABASE_FREQUENCY_ASCII_NODOUT_SSD_SUBCASE\n" + fields({frequency, 2.0 * frequency, 2}));
  row.specimen.text("*DATABASE_FREQUENCY_BINARY_D3SSD_SUBCASE\n" + fields({90}) +
                    fields({frequency, 2.0 * frequency, 2}));
  row.specimen.text("*DATABASE_HISTORY_NODE\n" + fields({1.0 * row.grid(1, 0)}));
  return row.specimen.deck();
}

// _SUBCASE: each case has its own loads, in curves and states. Sabotage: the loads of the first in all.
TEST(SteadyState, Subcases) {
  const LinearExperiment e(cases());
  const model::SteadyState& request = *e.system().model.steady_state;
  ASSERT_EQ(request.cases.size(), 2u);
  EXPECT_EQ(request.cases[0].title, "one motion");
  EXPECT_EQ(nvh::file_of_case("d3ssd", request.cases[1]), "d3ssd_turned");
  const nvh::Modes modes = e.modes(4);
  const nvh::SteadyResult result = nvh::steady_state(e.matrices(), modes, request);
  ASSERT_EQ(result.curve.size(), 6u);
  const double w = 2.0 * std::numbers::pi * result.frequency[0], k = Row::spring(), m = 0.5 * Row::mass();
  const Complex compliance = 1.0 / (k - m * w * w + Complex(0.0, 2.0 * ratio * Row::omega0() * m * w));
  for (const std::size_t c : {0u, 1u}) {
    const Complex expected = c == 0 ? 3.0 * (1.0 + w * w * m * compliance) : Complex(4.0, 8.0) * compliance;
    EXPECT_EQ(result.curve[3 * c].load_case, static_cast<int>(c) + 1);
    EXPECT_LT(distance(result.curve[3 * c].value[0][0], expected), 1e-6) << c;
    const auto visit = [&](const nvh::MotionAt& now) { EXPECT_LT(distance(now.u[1][0], expected), 1e-6) << c; };
    nvh::each_motion(e.matrices(), modes, request, request.cases[c], {result.frequency[0]}, visit);
  }
}

// Names of cases name files. Sabotage: none of it checked.
TEST(SteadyState, RefusesNamesOfCases) {
  const auto refused = [](const std::string& name) {
    try {
      const LinearExperiment e(cases(name));
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).find("caseid") != std::string::npos;
    }
    return false;
  };
  for (const char* name : {"", "a/b", "plain", "plain01"}) EXPECT_TRUE(refused(name)) << name;
  EXPECT_FALSE(refused("plain_b"));
}

// A load without effect and a missing damping are reported. Sabotage: silence.
TEST(SteadyState, TellsWhatHasNoEffect) {
  const auto reported = [](const std::string& damping, double dof) {
    const LinearExperiment e(deck("", fields({1}), damping, fields({3, 1, dof, 0, 11}), frequency, level(11, 1.0)));
    Findings findings;
    nvh::check_steady_state(e.matrices(), *e.system().model.steady_state, findings);
    std::string all;
    for (const Finding& f : e.findings().all()) all += f.text + '\n';
    for (const Finding& f : findings.all()) all += f.text + '\n';
    return all;
  };
  const std::string plain = reported(fields({ratio}), 1);
  EXPECT_EQ(plain.find("nothing damps"), std::string::npos);
  EXPECT_EQ(plain.find("moves nothing"), std::string::npos);
  EXPECT_NE(reported(fields({0}), 1).find("nothing damps"), std::string::npos);
  EXPECT_NE(reported(fields({ratio}), 2).find("moves nothing"), std::string::npos);
}

// What is not built is refused at its field. Sabotage: none of it read.
TEST(SteadyState, RefusesWhatIsNotBuilt) {
  const auto refusal = [](const std::string& switches, const std::string& damping, const std::string& loads) {
    try {
      const LinearExperiment e(deck("", switches, damping, loads, 1.0, level(11, 1.0)));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string plain = fields({1}), damping = fields({ratio}), load = fields({3, 1, 1, 0, 11});
  EXPECT_EQ(refusal(plain, damping, load), "");
  const std::pair<std::string, const char*> refused[] = {
      {refusal(plain, damping, fields({9, 1, 1, 0, 11})), "node set 9 is not defined"},
      {refusal(fields({1, 0, 20.0, 10.0}), damping, load), "no mode is left"},
      {refusal(plain, damping, fields({3, 1, 1, 1, 11})), "pressure acts on segments"},
      {refusal(plain, damping, fields({3, 2, 1, 0, 11})), "only pressure acts on segment sets"},
      {refusal(fields({1, 0, 0, 0, 0, 1}), damping, load), "results of an earlier run"},
      {refusal(plain, damping, fields({0, 0, 1, 3, 11}) + fields({3, 1, 1, 7, 11})), "do not go together"},
      {refusal(plain, damping, ""), "no load is given"}};
  for (const auto& [text, expected] : refused) EXPECT_NE(text.find(expected), std::string::npos) << text;
}

}  // namespace
}  // namespace nugget::verify
