// SPDX-License-Identifier: Apache-2.0
// What responses over frequency are asked for: at which frequencies, for several excitations, with dashpots, as states.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "nvh/response/frequencies.hpp"
#include "nvh/response/response_states.hpp"
#include "responses.hpp"

namespace nugget::verify {
namespace {

constexpr double ratio = 0.02;

/// Natural frequencies of two bricks in a row, held at the left: masses m and m/2 on springs k, of which
/// (2 k - omega^2 m)(k - omega^2 m/2) = k^2.
std::array<double, 2> natural() {
  const double w = Row::spring() / Row::mass();  // omega^2 = w (2 +- sqrt 2)
  return {cycles(std::sqrt(w * (2.0 - std::sqrt(2.0)))), cycles(std::sqrt(w * (2.0 + std::sqrt(2.0))))};
}

/// Two masses under a force of each of four nodes at the free end, with the last card of *FREQUENCY_DOMAIN_FRF.
std::string two_masses(const std::string& frequencies, const std::string& more = "") {
  Row row(2);
  row.hold(row.first);
  row.specimen.text(more + "*FREQUENCY_DOMAIN_FRF\n" + fields({1.0 * row.last, 1, 1, 3}) + fields({ratio}) +
                    fields({1.0 * row.last, 1, 1, 2}) + frequencies);
  return row.specimen.deck();
}

std::vector<double> frequencies_of(const std::string& deck) {
  const LinearExperiment e(deck);
  return nvh::frequencies(*e.system().model.frequency_response, e.modes(8));
}

// FSPACE 3: the natural frequencies in the range, each once; those of the row among them. Sabotage: modes outside of
// it.
TEST(ResponseRequests, NaturalFrequencies) {
  const double first = natural()[0], second = natural()[1];
  const std::vector<double> all = frequencies_of(two_masses(fields({0.5 * first, 2.0 * second, 2, 3})));
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](double a, double b) { return a <= b; }));
  for (const double f : {first, second})
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](double g) { return std::abs(g - f) < 1e-6 * f; })) << f;
  const std::vector<double> low = frequencies_of(two_masses(fields({0.5 * first, 0.9 * second, 2, 3})));
  EXPECT_EQ(static_cast<std::ptrdiff_t>(low.size()),
            std::count_if(all.begin(), all.end(), [&](double f) { return f < 0.9 * second; }));
  EXPECT_THROW(frequencies_of(two_masses(fields({0.1 * first, 0.2 * first, 2, 3}))), nvh::Factorization::SolverError);
}

// FSPACE 2: ends and natural frequencies are there, steps shrink towards them, and there are as many as asked for.
// Sabotage: equal steps.
TEST(ResponseRequests, FrequenciesGatherAtTheNaturalOnes) {
  const auto [first, second] = natural();
  const std::vector<double> marks = frequencies_of(two_masses(fields({0.5 * first, 2.0 * second, 2, 3})));
  const std::vector<double> f = frequencies_of(two_masses(fields({0.5 * first, 2.0 * second, 90, 2})));
  ASSERT_EQ(f.size(), 90u);
  EXPECT_TRUE(std::is_sorted(f.begin(), f.end()));
  EXPECT_NEAR(f.front(), 0.5 * first, 1e-5 * first);
  EXPECT_NEAR(f.back(), 2.0 * second, 1e-5 * second);
  for (const double mark : marks) {
    const auto at = std::find(f.begin(), f.end(), mark);
    ASSERT_NE(at, f.end());
    EXPECT_LT(at[1] - at[0], 0.5 * (at[4] - at[3]));
    EXPECT_LT(at[0] - at[-1], 0.5 * (at[-3] - at[-4]));
  }
  EXPECT_THROW(frequencies_of(two_masses(fields({0.5 * first, 2.0 * second, 3, 2}))), nvh::Factorization::SolverError);
}

// LCFREQ: the abscissae of a curve, where its ordinates say nothing else. Sabotage: FMIN to FMAX all the same.
TEST(ResponseRequests, FrequenciesOfACurve) {
  const std::string card = fields({0, 0, 0, 0, 7});
  const auto with = [&](double a, double b) {
    return frequencies_of(two_masses(card, curve(7, {{10.0, a}, {35.0, b}})));
  };
  EXPECT_EQ(with(1.0, 1.0), (std::vector{10.0, 35.0}));
  EXPECT_EQ(with(10.0, 35.0), (std::vector{10.0, 35.0}));
  EXPECT_THROW(with(100.0, 200.0), std::runtime_error);
}

/// *FREQUENCY_DOMAIN_FRF_SUBCASE with a force on either mass and the response of both.
std::string subcases() {
  Row row(2);
  row.hold(row.first);
  const int middle = 7;
  row.specimen.node_set(middle, row.grid.across(1)).node_set(8, {row.grid(1, 0), row.grid(2, 0)});
  row.specimen.text("*FREQUENCY_DOMAIN_FRF_SUBCASE\n" + fields({2}) + fields({ratio}) + fields({1, 10, 2}) +
                    "at the end\n" + fields({1.0 * row.last, 1, 1, 3}) + fields({8, 1, 1, 2}) + "at the middle\n" +
                    fields({1.0 * middle, 1, 1, 3}) + fields({8, 1, 1, 1}));
  return row.specimen.deck();
}

// Two masses: the receptances of both, and Maxwell's reciprocity between the cases. Sabotage: the first excitation in
// both cases; one quantity for all.
TEST(ResponseRequests, Subcases) {
  const LinearExperiment e(subcases());
  const double omega = 0.7 * std::sqrt(Row::spring() / Row::mass());
  model::FrequencyResponse request = *e.system().model.frequency_response;
  ASSERT_EQ(request.cases.size(), 2u);
  EXPECT_EQ(request.cases[1].title, "at the middle");
  request.frequency = {cycles(omega)};
  request.damping = {};
  for (const bool direct : {false, true}) {
    request.direct = direct;
    const nvh::FrfResult result = nvh::frequency_response(e.matrices(), direct ? nvh::Modes{} : e.modes(2), request);
    ASSERT_EQ(result.curve.size(), 4u);
    const double k = Row::spring(), m = Row::mass(), w = omega * omega;
    const double a = 2.0 * k - w * m, c = k - 0.5 * w * m, determinant = a * c - k * k;
    const double force = 4.0, expected[] = {force * k / determinant, force * a / determinant,
                                            -w * force * c / determinant, -w * force * k / determinant};
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(result.curve[i].load_case, i < 2 ? 1 : 2);
      EXPECT_LT(distance(result.curve[i].value[0], expected[i]), 1e-6) << i << ' ' << direct;
    }
  }
}

/// Two masses with a dashpot between the free end and the ground and *DAMPING_PART_... of the bricks, by
/// *FREQUENCY_DOMAIN_SSD with DMPFLG 1; each of the four nodes at the end carries a force of 1.
std::string damped(const std::string& option, double dashpot, double alpha, double beta, double frequency) {
  Row row(2);
  row.hold(row.first);
  Specimen& s = row.specimen;
  int element = 100;
  if (dashpot > 0.0) {
    s.card("MAT_DAMPER_VISCOUS", {9, dashpot}).card("SECTION_DISCRETE", {9}).part(9, 9, 9);
    s.text("*DEFINE_SD_ORIENTATION\n" + fields({1, 0, 1, 0, 0}));
    std::string lines;
    for (const int node : row.grid.across(2)) lines += fmt::format("{:8}{:8}{:8}{:8}{:8}\n", ++element, 9, node, 0, 1);
    s.text("*ELEMENT_DISCRETE\n" + lines);
  }
  if (alpha > 0.0) s.text(constant_curve(21, alpha)).card("DAMPING_PART_MASS", {1, 21});
  if (beta > 0.0) s.card("DAMPING_PART_STIFFNESS", {1, -beta});
  s.text(curve(11, {{0.0, 1.0}, {10.0 * frequency, 1.0}}));
  s.text("*FREQUENCY_DOMAIN_SSD" + option + "\n" + fields({1}) + fields({0, 0, 0, 0, 0, 1}) + fields({0}) +
         fields({1.0 * row.last, 1, 1, 0, 11}));
  s.text("*DATABASE_FREQUENCY_ASCII_NODOUT_SSD\n" + fields({frequency, 2.0 * frequency, 2}));
  s.text("*DATABASE_FREQUENCY_BINARY_D3SSD\n" + fields({90}) + fields({frequency, 2.0 * frequency, 2}));
  s.text("*DATABASE_HISTORY_NODE\n" + fields({1.0 * row.grid(2, 0)}));
  return s.deck();
}

// Non-proportional damping: (K + i omega C - omega^2 M) u = f of two masses, in which no mode is alone. By modes and
// directly; and the states hold the same motion. Sabotage: the diagonal of phi^t C phi alone; beta of the stiffness of
// all parts; amplitudes in the state file.
TEST(ResponseRequests, DashpotsAndDampedParts) {
  const double k = Row::spring(), m = Row::mass(), frequency = 70000.0, omega = 2.0 * std::numbers::pi * frequency,
               w = omega * omega;
  const double dashpot = 0.4, beta = 2e-7, alpha = 40000.0;  // as ten columns have them
  for (const std::string option : {"", "_DIRECT"}) {
    const LinearExperiment e(damped(option, dashpot, alpha, beta, frequency));
    const model::SteadyState& request = *e.system().model.steady_state;
    Findings findings;
    nvh::check_steady_state(e.matrices(), request, findings);
    EXPECT_EQ(findings.errors(), 0);
    const nvh::Modes modes = request.direct ? nvh::Modes{} : e.modes(2);
    const nvh::SteadyResult result = nvh::steady_state(e.matrices(), modes, request);
    const Complex stiff = k * Complex(1.0, omega * beta), mass = m * Complex(-w, omega * alpha),
                  damper(0.0, 4.0 * omega * dashpot);
    const Complex a = 2.0 * stiff + mass, c = stiff + 0.5 * mass + damper;
    const Complex end = 4.0 * a / (a * c - stiff * stiff), middle = 4.0 * stiff / (a * c - stiff * stiff);
    EXPECT_LT(distance(result.curve[0].value[0][0], end), 1e-5) << option;
    std::vector<nvh::MotionAt> states;
    nvh::each_motion(e.matrices(), modes, request, request.cases.front(), nvh::frequencies(*request.states, modes),
                     [&](const nvh::MotionAt& now) { states.push_back(now); });
    ASSERT_EQ(states.size(), 2u);
    const auto node = [&](int id) {
      const std::vector<int>& ids = e.system().model.nodes.id;
      return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
    };
    EXPECT_LT(distance(states[0].u[node(3)][0], end), 1e-5) << option;
    EXPECT_LT(distance(states[0].u[node(2)][0], middle), 1e-5) << option;
  }
}

// The base moves and the state file has all nodes go along with it. Sabotage: relative motions.
TEST(ResponseRequests, StatesOfABaseMotion) {
  Row row(1);
  row.hold(row.first);
  const double omega = 0.8 * Row::omega0(), frequency = cycles(omega);
  row.specimen.text(curve(11, {{0.0, 2.0}, {4.0 * frequency, 2.0}}));
  row.specimen.text("*FREQUENCY_DOMAIN_SSD\n" + fields({1}) + fields({0}) + fields({0}) + fields({0, 0, 1, 4, 11}));
  row.specimen.text("*DATABASE_FREQUENCY_BINARY_D3SSD\n" + fields({1}) + fields({frequency, 2.0 * frequency, 2}));
  const LinearExperiment e(row.specimen.deck());
  const nvh::Modes modes = e.modes(1);
  const model::SteadyState& request = *e.system().model.steady_state;
  const std::vector<double> steps = nvh::frequencies(*request.states, modes);
  nvh::each_motion(e.matrices(), modes, request, request.cases.front(), steps, [&](const nvh::MotionAt& now) {
    const double r = std::pow(now.frequency / cycles(Row::omega0()), 2);
    EXPECT_LT(distance(now.u[0][0], 2.0), 1e-6);
    EXPECT_LT(distance(now.u[1][0], 2.0 / (1.0 - r)), 1e-6);
    EXPECT_EQ(now.u[1][1], Complex(0.0));
  });
}

// A damping that is no matrix is refused where DMPFLG asks for it. Sabotage: COEF as beta whatever its sign.
TEST(ResponseRequests, RefusesDampingThatIsNoMatrix) {
  const auto refusal = [](const std::string& cards) {
    std::string deck = damped("", 0.0, 1e-9, 0.0, 10.0);
    deck.insert(deck.find("*FREQUENCY_DOMAIN_SSD"), cards);
    const LinearExperiment e(deck);
    Findings findings;
    nvh::check_steady_state(e.matrices(), *e.system().model.steady_state, findings);
    return findings.errors() > 0 ? findings.all().front().text : std::string();
  };
  EXPECT_EQ(refusal(""), "");
  EXPECT_NE(refusal("*DAMPING_PART_STIFFNESS\n" + fields({1, 0.1})).find("share of critical"), std::string::npos);
  EXPECT_NE(
      refusal(curve(31, {{0.0, 1.0}, {1.0, 2.0}}) + "*DAMPING_PART_MASS\n" + fields({1, 31})).find("changes over time"),
      std::string::npos);
}

}  // namespace
}  // namespace nugget::verify
