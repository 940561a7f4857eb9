// SPDX-License-Identifier: Apache-2.0
// Transfer functions by modal superposition.
#include "nvh/response/frequency_response.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "linear.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

using Complex = std::complex<double>;
using Quantity = model::FrequencyResponse::Quantity;

constexpr double young = 210000.0, steel = 7.85e-9;        // steel A: mm, t, s, N
constexpr double decibel = 0.1087, half_decibel = 0.0559;  // 1 - 10^(-1/20), 1 - 10^(-1/40)

Complex at_frequency(const LinearExperiment& e, const nvh::Modes& modes, std::size_t curve, double frequency) {
  model::FrequencyResponse request = *e.system().model.frequency_response;
  request.frequency = {frequency};
  return nvh::frequency_response(e.matrices(), modes, request).curve[curve].value[0];
}

// Reference: double sine sum of the thin plate. Few modes: the static row holds by the residual vector only. Sabotage:
// no residual vector; damping omega instead of 2 omega.
TEST(FrequencyResponse, SimplySupportedPlate) {
  constexpr int n = 40;
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {12});
  s.card("MAT_ELASTIC", {1, steel, young, 0.3});
  s.text("*SECTION_SHELL\n" + fields({1, 16, 5.0 / 6.0, 2}) + fields({2, 2, 2, 2})).part(1, 1, 1);
  const Grid grid = s.shells(1, {}, {500.0, 400.0, 0.0}, n, n);
  std::vector<int> along_x, along_y;
  for (int i = 0; i <= n; ++i) {
    along_x.insert(along_x.end(), {grid(i, 0), grid(i, n)});
    along_y.insert(along_y.end(), {grid(0, i), grid(n, i)});
  }
  s.node_set(1, along_x).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 0, 1, 0});
  s.node_set(2, along_y).card("BOUNDARY_SPC_SET", {2, 0, 1, 1, 1, 1, 0, 0});
  const int drive = grid(n * 150 / 500, n * 120 / 400), other = grid(n * 350 / 500, n * 240 / 400);
  s.node_set(3, {drive, other});
  s.text("*FREQUENCY_DOMAIN_FRF\n" + fields({1.0 * drive, 0, 3, 3}) + fields({0.02}) + fields({3, 1, 3, 2}) +
         fields({0, 200, 201}));
  const LinearExperiment plate(s.deck());
  const nvh::Modes modes = plate.modes(12);
  expect_reference("response of a supported plate", "simply supported plate, 40 x 40 shells: mode 1 [Hz]",
                   modes.frequency(0), 50.4008, 1e-2);
  expect_reference("response of a supported plate", "simply supported plate, 40 x 40 shells: mode 2 [Hz]",
                   modes.frequency(1), 109.4066, 1e-2);
  const auto row = [&](double f, const std::string& name, double drive_point, double drive_phase, double transfer,
                       double transfer_phase, double gate) {
    const double value[] = {drive_point, transfer}, phase[] = {drive_phase, transfer_phase};
    for (std::size_t c = 0; c < 2; ++c) {
      const Complex u = at_frequency(plate, modes, c, f);
      expect_reference("response of a supported plate",
                       fmt::format("|u/F| {} at {} [mm/N]", c == 0 ? "drive point" : "transfer", name), std::abs(u),
                       value[c], gate);
      EXPECT_NEAR(std::remainder(nvh::degrees(u) - phase[c], 360.0), 0.0, 8.0) << name;
    }
  };
  row(0.0, "0 Hz", 9.46049e-3, 0, 4.36523e-3, 0, decibel);
  row(modes.frequency(0), "mode 1", 1.36194e-1, -88.05, 1.59884e-1, -90.93, half_decibel);
  row(100.0, "100 Hz", 1.11945e-2, -11.51, 1.38259e-2, 169.99, decibel);
  row(modes.frequency(1), "mode 2", 4.02229e-2, -86.28, 4.70165e-2, 93.08, half_decibel);
  row(150.0, "150 Hz", 8.38287e-3, -157.20, 7.24135e-3, 15.36, decibel);
  row(200.0, "200 Hz", 1.53349e-2, -70.78, 1.02499e-2, -61.11, decibel);
}

// A free plate with a damping ratio for each mode (LCTYP 1). Reference: Ritz with 14 x 14 Legendre polynomials for
// Kirchhoff's plate; the acceleration at resonance is phi_i phi_j / (2 zeta). LS-DYNA's plot of this plate
// (docs/evidence/vibration.md) has its samples 1 Hz apart. Sabotage: damping of the mode before.
TEST(FrequencyResponse, ResonancesOfAFreePlateWithDampingByMode) {
  constexpr double a = 0.36, b = 0.24;
  constexpr int n = 30, m = 20;
  const double damping[] = {0.0045, 0.00713, 0.00386, 0.00328, 0.0034, 0.00624, 0.00072, 0.00083};
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {40});
  s.card("MAT_ELASTIC", {1, 7870.0, 2.07e11, 0.292});
  s.text("*SECTION_SHELL\n" + fields({1, 16, 5.0 / 6.0, 2}) + fields({0.002, 0.002, 0.002, 0.002})).part(1, 1, 1);
  const Grid grid = s.shells(1, {}, {a, b, 0.0}, n, m);
  std::string ratios = "*DEFINE_CURVE\n" + fields({1, 0, 1, 1, 0, 0, 0});
  const auto point = [](double mode, double ratio) { return fmt::format("{:20}{:20}\n", mode, ratio); };
  ratios += point(1.0, 0.0) + point(6.0, 0.0);
  for (int k = 0; k < 8; ++k) ratios += point(7.0 + k, damping[k]);
  const int drive = grid(n / 5, m / 5), corner = grid(n, m);
  s.text(ratios + point(15.0, 0.01) + point(200.0, 0.01)).node_set(2, {drive, corner});
  s.text("*FREQUENCY_DOMAIN_FRF\n" + fields({1.0 * drive, 0, 0, 3}) + fields({0, 1, 1}) + fields({2, 1, 3, 1}) +
         fields({1, 400, 400}));
  const LinearExperiment plate(s.deck());
  const nvh::Modes modes = plate.modes(40);
  const auto row = [&](std::size_t mode, double frequency, double here, double at_corner, double gate) {
    const double f = modes.frequency(mode - 1);
    expect_reference("resonances of a free plate", fmt::format("mode {} [Hz]", mode), f, frequency, 4e-3);
    const auto peak = [&](std::size_t c) { return std::abs(at_frequency(plate, modes, c, f)); };
    if (here > 0.0)
      expect_reference("resonances of a free plate", fmt::format("mode {}: |a/F| at the drive point [1/kg]", mode),
                       peak(0), here, gate);
    expect_reference("resonances of a free plate", fmt::format("mode {}: |a/F| at the corner [1/kg]", mode), peak(1),
                     at_corner, gate);
  };
  row(7, 76.81, 107.2, 249.3, 0.02);
  row(9, 176.96, 0.0, 84.2, 0.03);
  row(10, 189.85, 0.0, 67.5, 0.03);
  row(13, 327.47, 232.2, 979.5, 0.02);
  row(14, 377.05, 0.0, 310.0, 0.03);
}

/// One brick between a base and a free end that stretches only: a spring E A / h with the mass rho A h / 2.
struct Oscillator {
  static constexpr double h = 10.0, ratio = 0.05;
  static double omega0() { return std::sqrt(2.0 * young / steel) / h; }
  /// 1 + omega^2 / (omega0^2 - omega^2 + 2 i zeta omega0 omega): end over base, absolute.
  static Complex transmissibility(double omega) {
    return 1.0 + omega * omega / Complex(omega0() * omega0() - omega * omega, 2.0 * ratio * omega0() * omega);
  }

  static std::string deck(int base, int response, int relative, const std::string& damping) {
    Specimen s;
    s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {4});
    s.card("MAT_ELASTIC", {1, steel, young, 0.0}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
    const Grid grid = s.bricks(1, {}, {h, h, h}, {1, 1, 1});
    s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
    s.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1, 1, 1});
    s.text("*FREQUENCY_DOMAIN_FRF\n" + fields({0, 0, 1, 1.0 * base}) + damping +
           fields({1.0 * grid(1, 0), 0, 1, 1.0 * response, 0, 1.0 * relative}) + fields({1, 10, 2}));
    return s.deck();
  }
};

// Closed form for every pair of quantities. Sabotage: the sign of the inertia load; absolute and relative exchanged.
TEST(FrequencyResponse, ShakenBase) {
  const double omega = 0.8 * Oscillator::omega0(), frequency = omega / (2.0 * std::numbers::pi);
  const auto derivative = [&](Quantity q) {
    return q == Quantity::displacement ? Complex(1.0) : q == Quantity::velocity ? Complex(0.0, omega) : -omega * omega;
  };
  for (const int base : {0, 1, 2})
    for (const int response : {0, 1, 2})
      for (const int relative : {0, 1}) {
        const LinearExperiment e(Oscillator::deck(base, response, relative, fields({Oscillator::ratio})));
        const Complex found = at_frequency(e, e.modes(4), 0, frequency);
        const Complex expected =
            (Oscillator::transmissibility(omega) - 1.0 * relative) *
            (derivative(static_cast<Quantity>(response)) / derivative(static_cast<Quantity>(base)));
        EXPECT_NEAR(std::abs(found - expected) / std::abs(expected), 0.0, 1e-6)
            << "base " << base << ", response " << response << ", relative " << relative;
      }
}

// A constant ratio, its curve over frequency, its curve over modes, Rayleigh's alpha and beta: the same damping of this
// oscillator. Sabotage: alpha / omega instead of alpha / (2 omega).
TEST(FrequencyResponse, KindsOfDampingAgree) {
  const double omega0 = Oscillator::omega0(), frequency = omega0 / (2.0 * std::numbers::pi);
  const std::string over_frequency = curve(7, {{0.0, 0.0}, {2.0 * frequency, 2.0 * Oscillator::ratio}}),
                    over_modes = curve(8, {{0.0, Oscillator::ratio}, {9.0, Oscillator::ratio}});
  const std::string cards[] = {fields({Oscillator::ratio}), fields({0, 7, 0}), fields({0, 8, 1}),
                               fields({0, 0, 0, 2.0 * Oscillator::ratio * omega0}),
                               fields({0, 0, 0, 0, 2.0 * Oscillator::ratio / omega0})};
  for (const std::string& damping : cards) {
    std::string deck = Oscillator::deck(1, 1, 0, damping);
    deck.insert(deck.find("*FREQUENCY_DOMAIN_FRF"), over_frequency + over_modes);
    const LinearExperiment e(deck);
    const Complex expected = Oscillator::transmissibility(omega0);
    EXPECT_NEAR(std::abs(at_frequency(e, e.modes(4), 0, frequency) - expected) / std::abs(expected), 0.0, 1e-4)
        << damping;
  }
}

// What is not built is refused at its field.
TEST(FrequencyResponse, RefusesWhatIsNotBuilt) {
  const auto refusal = [](const std::string& cards) -> std::string {
    std::string deck = Oscillator::deck(1, 1, 0, fields({0.05}));
    const std::size_t begin = deck.find("*FREQUENCY_DOMAIN_FRF\n") + 22, end = deck.find('*', begin);
    deck.replace(begin, end == std::string::npos ? end : end - begin, cards);
    try {
      const LinearExperiment e(deck);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  const std::string load = fields({0, 0, 1, 1}), damping = fields({0.05}), response = fields({2, 0, 1, 1}),
                    range = fields({1, 10, 2});
  EXPECT_EQ(refusal(load + damping + response + range), "");
  EXPECT_NE(refusal(fields({2, 0, 1, 4}) + damping + response + range).find("pressure acts on segments"),
            std::string::npos);
  EXPECT_NE(refusal(fields({2, 0, 1, 12}) + damping + response + range).find("torsion"), std::string::npos);
  EXPECT_NE(refusal(fields({2, 0, 1, 3}) + damping + fields({2, 0, 1, 1, 0, 1}) + range).find("no base moves"),
            std::string::npos);
  EXPECT_NE(refusal(load + damping + response + fields({10, 1, 2})).find("empty"), std::string::npos);
  EXPECT_NE(refusal(load + damping + fields({99, 0, 1, 1}) + range).find("99"), std::string::npos);
}

}  // namespace
}  // namespace nugget::verify
