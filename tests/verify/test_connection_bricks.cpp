// SPDX-License-Identifier: Apache-2.0
// MAT_100_DA on bricks beyond its strengths (DGTYP 1 and 2), its area in shear (MOARFL), its limit of distortion
// (JTOL), the couple of a shear force over a weld as thick as modelled (TRUE_T = 0); ASFF with damage of points. Closed
// forms: docs/theory/failure.md#worse-end, docs/theory/failure.md#damage-of-the-whole-weld and
// docs/theory/failure.md#connections.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "brick_decks.hpp"
#include "experiment.hpp"

namespace nugget::verify {
namespace {

constexpr double side = 5.317361, area = side * side, length = 1.5;  // the section of a disc of 6 mm
constexpr double modulus = area * 6.0 / 8.0;
constexpr double step = 1e-7, E = 210000.0, G = E / 2.6;

struct Sample {
  double s = 0.0, axial = 0.0, shear = 0.0, plastic_strain = 0.0;
  int living = 0;  ///< bricks
  bool failed = false;
  weld::FailureMode mode = weld::FailureMode::intact;
};

/// A weld of n x n bricks along z, of which both faces move as prescribed.
std::vector<Sample> run(const std::string& material, const Motion& top, const Motion& bottom, int n = 1,
                        int cycles = 4000) {
  const Prism prism = square_prism(side, length, n);
  const double end = cycles * step;
  Experiment run("*KEYWORD\n" + termination(end, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) +
                 "*PART\nweld\n" + fields({1, 1, 1, 0, 1}) + "*SECTION_SOLID\n" + fields({1, 1}) + "*HOURGLASS\n" +
                 fields({1, 6, 1.0, 0, 1e-6, 1e-6}) + material + prism.text() +
                 moved(prism, prism.bottom(), {1, 1, 1}, bottom, end, 1, 100) +
                 moved(prism, prism.top(), {1, 1, 1}, top, end, 1, 500) + "*END\n");
  std::vector<Sample> samples;
  run.run([&](const impact::Snapshot& now) {
    const weld::History& h = *now.components.welds.history(0);
    Sample s{now.state.time / end,
             h.resultants().axial,
             h.resultants().shear(),
             h.last_load().plastic_strain,
             0,
             h.failed(),
             h.mode()};
    for (const auto& group : now.system.groups)
      for (std::size_t e = 0; e < group->size(); ++e) s.living += group->alive(e);
    samples.push_back(s);
  });
  return samples;
}
Vec3d nowhere(const Vec3d&, double) {
  return {};
}
Motion up(double u) {
  return [=](const Vec3d&, double s) { return Vec3d{0, 0, s * u}; };
}
Motion aside(double u) {
  return [=](const Vec3d&, double s) { return Vec3d{s * u, 0, 0}; };
}

struct Connection {
  int dgtyp = 0, moarfl = 1;
  double yield = 0.0, tangent = 0.0;
  double normal = 0.0, bending = 0.0, shear = 0.0;  ///< strengths
  double rupture = 0.0, true_thickness = 0.0, jtol = 0.0;
  std::string text() const {
    return "*MAT_SPOTWELD_DAIMLERCHRYSLER_UNIAXIAL\n" + fields({1, 7.8e-9, E, 0.3}) + fields({0}) +
           fields({rupture, 0, 0, true_thickness, 7, 0, jtol}) + "*DEFINE_CONNECTION_PROPERTIES\n" +
           fields({7, 0, 0, 0, double(dgtyp), double(moarfl)}) +
           fields({0, yield, tangent, 0, 0, normal, bending, shear}) + fields({1, 1, 1});
  }
};
/// Tangent modulus of a plastic modulus.
double tangent(double hardening) {
  return E * hardening / (E + hardening);
}

const Sample& at_strain(const std::vector<Sample>& samples, double strain) {
  for (const Sample& s : samples)
    if (s.plastic_strain >= strain) return s;
  ADD_FAILURE() << "plastic strain " << strain << " is never reached";
  return samples.back();
}
/// The last one before failure.
const Sample& at_failure(const std::vector<Sample>& samples) {
  std::size_t i = 0;
  while (i + 1 < samples.size() && !samples[i + 1].failed) ++i;
  EXPECT_LT(i + 1, samples.size()) << "it does not fail";
  return samples[i];
}

// Yield 300, H = 2000, SN = 400: the surface is reached at plastic strain 0.05. DGTYP 1, RS = 0.1: w = (p - 0.05)/0.05.
// DGTYP 2: the load stays at SN A, until p = RS. Sabotage to be caught: damage from first yield on; the two exchanged.
TEST(ConnectionBricks, DamageOverStrainAndOnTheSurface) {
  Connection c{.dgtyp = 1, .yield = 300, .tangent = tangent(2000), .normal = 400, .rupture = 0.1};
  const auto fading = run(c.text(), up(0.2), nowhere);
  expect_reference("weld strengths by sheet", "DGTYP 1: N at the onset [N]", at_strain(fading, 0.0499).axial,
                   400 * area, 5e-3);
  for (const double p : {0.065, 0.08})
    expect_reference("weld strengths by sheet", fmt::format("DGTYP 1: N at plastic strain {} [N]", p),
                     at_strain(fading, p).axial, (1.0 - (p - 0.05) / 0.05) * (300 + 2000 * p) * area, 1e-2);
  expect_reference("weld strengths by sheet", "DGTYP 1: plastic strain at failure", at_failure(fading).plastic_strain,
                   0.1, 1e-2);
  c.dgtyp = 2;
  const auto kept = run(c.text(), up(0.2), nowhere);
  for (const double p : {0.06, 0.09})
    expect_reference("weld strengths by sheet", fmt::format("DGTYP 2: N at plastic strain {} [N]", p),
                     at_strain(kept, p).axial, 400 * area, 5e-3);
  expect_reference("weld strengths by sheet", "DGTYP 2: plastic strain at failure", at_failure(kept).plastic_strain,
                   0.1, 1e-2);
}

// Yield sqrt(3) 100, H = 300, sheared by u: tau = 100 + H p / sqrt 3, p = (u/L - tau/G)/sqrt 3. With MOARFL = 0 the
// area is A / sqrt(1 + (u/L)^2). Sabotage to be caught: the area along r, which shear leaves as it is.
TEST(ConnectionBricks, AreaFallsWithShear) {
  const double H = 300, SS = 167.7, u = 1.2;
  for (const int moarfl : {0, 1}) {
    const Connection c{
        .moarfl = moarfl, .yield = 100 * std::sqrt(3.0), .tangent = tangent(H), .shear = SS, .true_thickness = 1e-3};
    double low = 0.0, high = 1.0;  // shear angle at which tau / A = SS
    for (int i = 0; i < 60; ++i) {
      const double g = 0.5 * (low + high);
      const double tau = (100 + H / 3.0 * g) / (1.0 + H / (3.0 * G));
      (tau * (moarfl == 0 ? std::hypot(1.0, g) : 1.0) < SS ? low : high) = g;
    }
    expect_reference("weld strengths by sheet", fmt::format("shear angle at failure, MOARFL {}", moarfl),
                     at_failure(run(c.text(), aside(u), nowhere)).s * u / length, low, 5e-3);
  }
}

// The weld crushed to JTOL of its volume. Sabotage to be caught: the limit read as a change of volume.
TEST(ConnectionBricks, DistortionLimit) {
  const Connection c{.yield = 300, .jtol = 0.7};
  const auto samples = run(c.text(), up(-0.75), nowhere);
  expect_reference("weld strengths by sheet", "height at failure over that of the start, JTOL 0.7",
                   1.0 - at_failure(samples).s * 0.75 / length, 0.7, 5e-3);
  EXPECT_EQ(samples.back().mode, weld::FailureMode::distortion);
}

// The couple of V over half the length counts as bending: V (1 / (A SS) + L / (2 Z SB)) = 1; of TRUE_T a part.
TEST(ConnectionBricks, ShearBendsTheThickWeld) {
  for (const double true_t : {0.0, 0.3}) {
    const Connection c{.bending = 400, .shear = 300, .true_thickness = true_t};
    const double h = true_t > 0.0 ? true_t : length;
    expect_reference("brick weld: moments at the sheets", fmt::format("_DA, TRUE_T = {}: shear at failure [N]", true_t),
                     at_failure(run(c.text(), aside(8e-3), nowhere)).shear,
                     1.0 / (1.0 / (area * 300) + 0.5 * h / (modulus * 400)), 5e-3);
  }
}

// 2 x 2 bricks, of which those at x > 0 are pulled by p + q a/4, the others by p - q a/4; strain in one direction gives
// the plastic strain (2 G e - Y)/(3 G + H). Points damage from EFAIL = 0.01 on and fail at RS = 0.02. With ASFF = 1 the
// first bricks take the others with them. Sabotage to be caught: ASFF without effect on damage; failure at EFAIL.
TEST(ConnectionBricks, AsffWithDamageOfPoints) {
  const double Y = 400, H = 1000, rupture = 0.02, p = 0.1, q = 0.01;
  const double strain = (Y + (3 * G + H) * rupture) / (2 * G), stretch = length * (std::exp(strain) - 1.0);
  const auto half = [=](double sign) {
    return [=](const Vec3d& x, double s) { return Vec3d{0, 0, sign * 0.5 * s * (p + q * x.x)}; };
  };
  for (const int asff : {0, 1}) {
    const auto samples = run("*MAT_SPOTWELD_DAMAGE-FAILURE\n" + fields({1, 7.8e-9, E, 0.3, Y, H}) + fields({0.01}) +
                                 fields({rupture, 0, 0, 0, double(asff)}),
                             half(1.0), half(-1.0), 2);
    std::size_t first = 0;
    while (first + 1 < samples.size() && samples[first].living == 4) ++first;
    expect_reference("weld damage options", fmt::format("ASFF {}: path when the first bricks fail", asff),
                     samples[first].s, stretch / (p + q * side / 4.0), 1e-2);
    expect_reference("weld damage options", fmt::format("ASFF {}: path when the weld fails", asff),
                     at_failure(samples).s, stretch / (p + (asff == 1 ? 1.0 : -1.0) * q * side / 4.0), 1e-2);
    EXPECT_EQ(samples.back().mode, weld::FailureMode::plastic_strain);
  }
}

}  // namespace
}  // namespace nugget::verify
