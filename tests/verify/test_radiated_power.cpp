// SPDX-License-Identifier: Apache-2.0
// *FREQUENCY_DOMAIN_SSD_ERP: equivalent radiated power, against pistons and integrals on paper.
#include "nvh/response/radiated_power.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "nvh/response/steady_state.hpp"
#include "responses.hpp"

namespace nugget::verify {
namespace {

using Velocity = std::array<Complex, 3>;

constexpr double ratio = 0.05, rho = 1.2e-12, speed = 343000.0;
const double omega = 0.8 * Row::omega0(), frequency = cycles(omega);

/// One brick, held at the left and pushed at the free end, which radiates as a piston, as does a side of it, which
/// moves along itself. `fluid`: the card; `more`: the card of further panels.
std::string piston(const std::string& fluid, int panels = 2, const std::string& option = "_ERP") {
  Row row(1);
  row.hold(row.first);
  const auto face = [&](int id, std::array<int, 4> n) {
    return "*SET_SEGMENT\n" + fields({1.0 * id}) + fields({1.0 * n[0], 1.0 * n[1], 1.0 * n[2], 1.0 * n[3]});
  };
  const Grid& g = row.grid;
  row.specimen.text(face(51, {g(1, 0, 0), g(1, 1, 0), g(1, 1, 1), g(1, 0, 1)}));
  row.specimen.text(face(52, {g(0, 0, 0), g(1, 0, 0), g(1, 1, 0), g(0, 1, 0)}));
  row.specimen.text(curve(11, {{0.0, 3.0}, {10.0 * frequency, 3.0}}) +
                    curve(12, {{0.0, 0.25}, {10.0 * frequency, 0.25}}));
  row.specimen.text("*FREQUENCY_DOMAIN_SSD" + option + "\n" + fields({1}) + fields({ratio}) +
                    fields({0, 0, 0, 1.0 * panels}) + fluid + fields({51, 2}) + fields({52, 2}) +
                    fields({1.0 * row.last, 1, 1, 0, 11}));
  row.specimen.text("*DATABASE_FREQUENCY_BINARY_D3ERP\n" + fields({1}) + fields({frequency, 2.0 * frequency, 2}));
  return row.specimen.deck();
}

/// Power of the end: r rho c / 2 A |i omega u|^2.
double power_of_the_end(double omega_now, double r) {
  const double k = Row::spring(), m = 0.5 * Row::mass();
  const Complex u = 12.0 / (k - m * omega_now * omega_now + Complex(0.0, 2.0 * ratio * Row::omega0() * m * omega_now));
  return 0.5 * r * rho * speed * Row::h * Row::h * std::norm(omega_now * u);
}

// By modes and directly (with the same damping of one mode, as a matrix). Sabotage: the squared sum of all components;
// displacement for velocity; the factor 1/2; ERPRLF.
TEST(RadiatedPower, Piston) {
  const LinearExperiment e(piston(fields({rho, speed, 0.5, 1e-9})));
  const model::SteadyState& request = *e.system().model.steady_state;
  const nvh::RadiatedPower result = nvh::radiated_power(e.matrices(), e.modes(4), request);
  ASSERT_EQ(result.frequency.size(), 2u);
  ASSERT_EQ(result.panels.size(), 3u);
  EXPECT_EQ(result.panels[0].name, "segment set 51");
  EXPECT_NEAR(result.panels[0].area, Row::h * Row::h, 1e-9);
  EXPECT_NEAR(result.panels[2].area, 2.0 * Row::h * Row::h, 1e-9);
  for (std::size_t k = 0; k < 2; ++k) {
    const double expected = power_of_the_end(2.0 * std::numbers::pi * result.frequency[k], 0.5);
    EXPECT_NEAR(result.panels[0].power[k] / expected, 1.0, 1e-6);
    EXPECT_LT(result.panels[1].power[k], 1e-12 * expected);
    EXPECT_NEAR(result.panels[2].power[k] / expected, 1.0, 1e-6);
  }
  model::SteadyState direct = request;
  direct.direct = true;
  direct.damping = {};
  direct.damping.mass = 2.0 * ratio * Row::omega0();
  EXPECT_NEAR(nvh::radiated_power(e.matrices(), {}, direct).panels[0].power[0] / power_of_the_end(omega, 0.5), 1.0,
              1e-6);
}

// ERPRLF below 0: a curve over frequency. Sabotage: its number as the factor.
TEST(RadiatedPower, LossFactorOverFrequency) {
  const LinearExperiment e(piston(fields({rho, speed, -12.0})));
  const nvh::RadiatedPower result = nvh::radiated_power(e.matrices(), e.modes(4), *e.system().model.steady_state);
  EXPECT_NEAR(result.panels[0].power[0] / power_of_the_end(2.0 * std::numbers::pi * result.frequency[0], 0.25), 1.0,
              1e-6);
}

// Integrals of |v_n|^2 on paper: a square that tilts, one that twists with a quarter of a period between its parts, one
// that is inclined to a uniform motion, a triangle. Sabotage: the mean of the corners' squares; the real part alone.
TEST(RadiatedPower, IntegralOfTheNormalVelocity) {
  const double a = 3.0, b = 2.0;
  const std::array<Vec3d, 4> x{{{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}}};
  const auto integral = [](const std::array<Vec3d, 4>& at, auto normal) {
    std::array<Velocity, 4> v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = {5.0, Complex(0.0, 7.0), normal(at[i])};
    return nvh::square_of_normal_velocity(at, v);
  };
  EXPECT_NEAR(integral(x, [&](const Vec3d& p) { return Complex(p.x); }), a * a * a * b / 3.0, 1e-12);
  // v = x + i y: integral of x^2 + y^2
  EXPECT_NEAR(integral(x, [&](const Vec3d& p) { return Complex(p.x, p.y); }), a * b * (a * a + b * b) / 3.0, 1e-12);
  // v = x y: a^3 b^3 / 9
  EXPECT_NEAR(integral(x, [&](const Vec3d& p) { return Complex(p.x * p.y); }), std::pow(a * b, 3) / 9.0, 1e-12);
  // the triangle of half of it, v = x + i y: a^3 b (1/4) + a b^3 (1/12) with corners (0,0), (a,0), (a,b)
  const std::array<Vec3d, 4> triangle{x[0], x[1], x[2], x[2]};
  EXPECT_NEAR(integral(triangle, [&](const Vec3d& p) { return Complex(p.x, p.y); }),
              a * a * a * b / 4.0 + a * b * b * b / 12.0, 1e-12);
  const double angle = 0.6;
  std::array<Vec3d, 4> inclined = x;
  for (Vec3d& p : inclined) p = {p.x * std::cos(angle), p.y, p.x * std::sin(angle)};
  std::array<Velocity, 4> up;
  up.fill({0.0, 0.0, Complex(0.0, 2.0)});
  EXPECT_NEAR(nvh::square_of_normal_velocity(inclined, up), 4.0 * std::pow(std::cos(angle), 2) * a * b, 1e-12);
}

TEST(RadiatedPower, Decibels) {
  EXPECT_DOUBLE_EQ(nvh::decibels(2e-7, 2e-9), 20.0);
}

// A motion of the base: the panel moves absolutely, whatever RELATV says of the nodes. Sabotage: relative velocities.
TEST(RadiatedPower, AbsoluteMotion) {
  for (const double relatv : {0.0, 1.0}) {
    std::string deck = piston(fields({rho, speed}));
    const std::string plain = fields({1}) + fields({ratio}), load = fields({3, 1, 1, 0, 11});
    deck.replace(deck.find(plain), plain.size(), fields({1, 0, 0, 0, 0, 0, 0, relatv}) + fields({ratio}));
    deck.replace(deck.find(load), load.size(), fields({0, 0, 1, 4, 11}));
    const LinearExperiment e(deck);
    const nvh::RadiatedPower result = nvh::radiated_power(e.matrices(), e.modes(4), *e.system().model.steady_state);
    const double w = 2.0 * std::numbers::pi * result.frequency[0], k = Row::spring(), m = 0.5 * Row::mass();
    const Complex relative = w * w * m / (k - m * w * w + Complex(0.0, 2.0 * ratio * Row::omega0() * m * w));
    const double expected = 0.5 * rho * speed * Row::h * Row::h * std::norm(3.0 * w * (1.0 + relative));
    EXPECT_NEAR(result.panels[0].power[0] / expected, 1.0, 1e-6) << relatv;
  }
}

// Bad cards are refused at their field. Sabotage: none of it read.
TEST(RadiatedPower, RefusesBadCards) {
  const auto refusal = [](const std::string& deck) {
    try {
      const LinearExperiment e(deck);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(piston(fields({rho, speed}))), "");
  const std::string fluid = fields({rho, speed});
  std::string shells = piston(fluid), empty = piston(fluid);
  shells.replace(shells.find(fields({52, 2})), fields({52, 2}).size(), fields({1, 0}));
  empty.replace(empty.find(fields({52, 2})), fields({52, 2}).size(), fields({53, 2}));
  empty.insert(empty.find("*FREQUENCY"), "*SET_SEGMENT\n" + fields({53}));
  const std::pair<std::string, const char*> refused[] = {
      {refusal(piston(fields({0, speed}))), "ro = 0"},
      {refusal(piston(fields({rho, speed, 1, 0, 1}))), "radeff = 1"},
      {refusal(piston(fields({rho, speed, 1, 0, 2}))), "radeff = 2"},
      {refusal(piston(fields({rho, speed, -77.0}))), "curve 77 is not defined"},
      {refusal(piston(fluid, 0)), "no panel radiates"},
      {refusal(piston(fluid, 2, "")), "not by the keyword"},
      {refusal(shells), "part 1 has no shells"},
      {refusal(empty), "segment set 53 has no segments"}};
  for (const auto& [text, expected] : refused) EXPECT_NE(text.find(expected), std::string::npos) << expected << text;
}

}  // namespace
}  // namespace nugget::verify
