// SPDX-License-Identifier: Apache-2.0
// *FREQUENCY_DOMAIN_SSD: loads with amplitude and phase over frequency, against one mass on a spring.
#include "nvh/steady_state.hpp"

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
      {refusal(plain, damping, fields({3, 1, 1, 9, 11})), "rotations of the base"},
      {refusal(plain, damping, fields({3, 1, 1, 1, 11})), "pressure acts on segments"},
      {refusal(plain, damping, fields({3, 2, 1, 0, 11})), "only pressure acts on segment sets"},
      {refusal(fields({1, 0, 0, 0, 0, 1}), damping, load), "results of an earlier run"},
      {refusal(plain, damping, fields({0, 0, 1, 3, 11}) + fields({3, 1, 1, 7, 11})), "do not go together"},
      {refusal(plain, damping, ""), "no load is given"}};
  for (const auto& [text, expected] : refused) EXPECT_NE(text.find(expected), std::string::npos) << text;
}

}  // namespace
}  // namespace nugget::verify
