// SPDX-License-Identifier: Apache-2.0
// Adhesive of cohesive bricks against closed forms: energies of failure, damage, what a free brick keeps, the frequency
// of two masses, Volkersen's lap joint, beams of two bonded sheets, the double cantilever beam.
// Units mm, t, s, N, MPa.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "experiment.hpp"
#include "linear.hpp"
#include "nvh/statics/statics.hpp"

namespace nugget::verify {
namespace {

constexpr double EN = 1e4, ET = 4e3, GIC = 2.0, GIIC = 6.0, T = 40.0, S = 30.0;

/// *MAT_138 with density per area.
std::string mixed_mode(double density, double xmu, double gamma = 1.0, int intfail = 1) {
  return "*MAT_COHESIVE_MIXED_MODE\n" + fields({1, density, 1, 1.0 * intfail, EN, ET, GIC, GIIC}) +
         fields({xmu, T, S, 0, 0, gamma});
}
/// *MAT_184 that does not fail.
std::string elastic_bond(double density, double en, double et) {
  return "*MAT_COHESIVE_ELASTIC\n" + fields({1, density, 1, 1, et, en});
}

/// One brick of `side` x `side` x `height`: nodes 1-4 below, 5-8 above.
std::string single(const std::string& material, int elform, double side, double height) {
  std::string deck =
      "*KEYWORD\n" + material + "*SECTION_SOLID\n" + fields({1, 1.0 * elform}) + "*PART\nbond\n1,1,1\n*NODE\n";
  int id = 0;
  for (const double z : {0.0, height})
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) deck += node_line(++id, side * x, side * y, z);
  return deck + "*ELEMENT_SOLID\n" + element_line(1, 1, {1, 2, 3, 4, 5, 6, 7, 8});
}

struct WeldState {
  double time, tension, shear, work;  ///< mean tractions, work done on the brick
  Vec3d apart;                        ///< of node 5 from node 1
};

/// The lower face stands, the upper goes as the curves say, z and x; a brick of 5 x 5.
std::vector<WeldState> driven(const std::string& material, const std::string& along_z, const std::string& along_x,
                              double end, double height = 0.0) {
  std::string deck = single(material, 19, 5.0, height) + along_z + along_x + "*BOUNDARY_SPC_NODE\n";
  for (int n = 1; n <= 4; ++n) deck += fields({1.0 * n, 0, 1, 1, 1});
  for (int n = 5; n <= 8; ++n) deck += fields({1.0 * n, 0, 0, 1, 0});
  deck += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n";
  for (int n = 5; n <= 8; ++n) deck += fields({1.0 * n, 3, 2, 93}) + fields({1.0 * n, 1, 2, 91});
  deck += "*CONTROL_TERMINATION\n" + fields({end}) + "*END\n";
  Experiment experiment(deck);
  std::vector<WeldState> seen;
  experiment.run([&](const impact::Snapshot& now) {
    const system::ElementGroup& group = *now.system.groups.front();
    const auto l = group.layer(0, 0, now.state);
    // The axes lie along x and y of the deck but for the sense of the second.
    seen.push_back({now.state.time, l.stress[2], std::hypot(l.stress[0], l.stress[1]), group.internal_energy(0),
                    experiment.displacement(now, 5)});
  });
  return seen;
}

/// A straight way to failure at an angle from the normal.
void expect_failure(double degrees, double xmu, double gamma = 1.0) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
  // The manual's remarks on *MAT_138, in its words: beta the mixity, delta0 and deltaF onset and failure.
  const double onset_n = T / EN, onset_t = S / ET;
  const double onset =
      degrees == 90.0
          ? onset_t
          : onset_n * onset_t * std::sqrt((c * c + s * s) / (onset_t * onset_t * c * c + onset_n * onset_n * s * s));
  const double k = EN * c * c + ET * s * s, share = ET * s * s / k;
  const double mean = std::pow(std::pow(EN, gamma) * c * c + std::pow(ET, gamma) * s * s, 1.0 / gamma);
  const double energy = xmu > 0.0
                            ? std::pow(std::pow((1.0 - share) / GIC, xmu) + std::pow(share / GIIC, xmu), -1.0 / xmu)
                            : GIC + (GIIC - GIC) * std::pow(share, -xmu);
  const double failure = 2.0 * energy / (mean * onset), end = 1e-3, reach = 1.05 * failure;
  const auto seen = driven(mixed_mode(3e-10, xmu, gamma), curve(93, {{0.0, 0.0}, {end, reach * c}}),
                           curve(91, {{0.0, 0.0}, {end, reach * s}}), end);
  double highest = 0.0, last = 0.0;
  for (const WeldState& at : seen) {
    highest = std::max(highest, std::hypot(at.tension, at.shear));
    if (std::hypot(at.tension, at.shear) > 0.0) last = norm(at.apart);
  }
  const auto what = [&](const char* text) {
    return fmt::format("{}, {:g} degrees, XMU {:g}, GAMMA {:g}", text, degrees, xmu, gamma);
  };
  expect_reference("adhesive: traction and failure", what("highest traction [MPa]"), highest,
                   onset * std::hypot(EN * c, ET * s), 5e-3);
  expect_reference("adhesive: traction and failure", what("separation at failure [mm]"), last, failure, 1e-3);
  // The triangle under the traction along the way.
  expect_reference("adhesive: traction and failure", what("energy [mJ]"), seen.back().work,
                   25.0 * 0.5 * k * onset * failure, 1e-3);
}

TEST(CohesiveBricks, FailAtTheEnergyOfTheirMode) {
  expect_failure(0.0, 1.0);
  expect_failure(90.0, 1.0);
  for (const double xmu : {1.0, 2.0, -1.5}) expect_failure(50.0, xmu);
  expect_failure(50.0, -1.5, 2.0);
}

TEST(CohesiveBricks, UnloadToTheOriginBearPressureAndDoNotHeal) {
  // Tension to 0.05, back through 0 to a pressure, then shear.
  const auto seen = driven(mixed_mode(3e-10, 1.0),
                           curve(93, {{0.0, 0.0}, {1e-3, 0.05}, {2e-3, 0.0}, {3e-3, -0.001}, {4e-3, 0.0}, {6e-3, 0.0}}),
                           curve(91, {{0.0, 0.0}, {4e-3, 0.0}, {5e-3, 0.01}, {6e-3, 0.0}}), 6e-3);
  // The widest opening is that of the last cycle before the turn.
  const double wide = std::max_element(seen.begin(), seen.end(), [](const WeldState& a, const WeldState& b) {
                        return a.apart.z < b.apart.z;
                      })->apart.z;
  EXPECT_NEAR(wide, 0.05, 1e-4);
  const double onset = T / EN, failure = 2.0 * GIC / T, damage = failure * (wide - onset) / (wide * (failure - onset));
  const auto at = [&](double time) {
    return *std::find_if(seen.begin(), seen.end(), [time](const WeldState& s) { return s.time >= time; });
  };
  const WeldState back = at(1.5e-3), pressed = at(2.5e-3), sheared = at(4.5e-3), end = seen.back();
  expect_reference("adhesive: unloading", "traction halfway back [MPa]", back.tension,
                   (1.0 - damage) * EN * back.apart.z, 1e-6);
  expect_reference("adhesive: unloading", "pressure of the damaged bond [MPa]", pressed.tension, EN * pressed.apart.z,
                   1e-6);
  // This shear alone would make less damage than tension has made.
  expect_reference("adhesive: unloading", "shear after tension [MPa]", sheared.shear,
                   (1.0 - damage) * ET * sheared.apart.x, 1e-6);
  // What is left after the way there and back is what the damage took: the triangle less the unloading.
  const double up = 0.5 * T * onset + 0.5 * (T + (1.0 - damage) * EN * wide) * (wide - onset);
  expect_reference("adhesive: unloading", "energy that is lost [mJ]", end.work,
                   25.0 * (up - 0.5 * (1.0 - damage) * EN * wide * wide), 2e-3);
}

/// *MAT_185: a trapezoid of 40, 0.1 to failure in tension and 0.15 in shear, peak at 0.1 and fall from 0.5 of that.
std::string scaled_bond() {
  return "*MAT_COHESIVE_TH\n" + fields({1, 3e-10, 1, 1, T, 0.1, 0.15}) + fields({0.2, 1.0, 2.0, 1.5});
}
/// *MAT_186 with a curve of area 0.515.
std::string general_bond(double tes, double xmu) {
  return "*MAT_COHESIVE_GENERAL\n" + fields({1, 3e-10, 1, 1, tes, 80, GIC, GIIC}) + fields({xmu, T, S}) +
         curve(80, {{0.0, 0.0}, {0.1, 1.0}, {0.4, 0.7}, {1.0, 0.0}});
}

struct Expected {
  double highest, failure, energy;  ///< traction, separation, energy per area
};

/// A straight way to failure at an angle from the normal.
void expect_parting(const std::string& name, const std::string& material, double degrees, const Expected& expected,
                    double height = 0.0) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
  const double end = 1e-3, reach = 1.05 * expected.failure;
  const auto seen = driven(material, curve(93, {{0.0, 0.0}, {end, reach * c}}),
                           curve(91, {{0.0, 0.0}, {end, reach * s}}), end, height);
  double highest = 0.0, last = 0.0;
  for (const WeldState& at : seen) {
    highest = std::max(highest, std::hypot(at.tension, at.shear));
    if (std::hypot(at.tension, at.shear) > 0.0) last = norm(at.apart);
  }
  const auto what = [&](const char* text) { return fmt::format("{}, {}, {:g} degrees", name, text, degrees); };
  expect_reference("adhesive: one curve", what("highest traction [MPa]"), highest, expected.highest, 5e-3);
  expect_reference("adhesive: one curve", what("separation at failure [mm]"), last, expected.failure, 1e-3);
  expect_reference("adhesive: one curve", what("energy [mJ]"), seen.back().work, 25.0 * expected.energy, 1e-3);
}

// Sabotage: LAMDA1 and LAMDA2 not divided by LAMDAF; shear of *MAT_185 by TLS alone; one stiffness in *MAT_186.
TEST(CohesiveBricks, PartAlongACurve) {
  for (const double degrees : {0.0, 50.0, 90.0}) {
    const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
    const double failure = 1.0 / std::hypot(c / 0.1, s / 0.15);
    expect_parting(
        "MAT_185", scaled_bond(), degrees,
        {T * failure * std::hypot(c / 0.1, 0.1 * s / (0.15 * 0.15)), failure, T * 0.1 * 0.5 * (1.0 - 0.1 + 0.5)});
    const double kt = 10.0 * T * 0.515 * T / GIC, ks = 10.0 * S * 0.515 * S / GIIC;  // from 0 to T and S in a tenth
    const double k = kt * c * c + ks * s * s, share = ks * s * s / k;
    const auto general = [&](const std::string& name, const std::string& material, double energy) {
      const double last = std::sqrt(energy / (0.515 * k / 10.0));
      expect_parting(name, material, degrees, {0.1 * last * std::hypot(kt * c, ks * s), last, energy});
    };
    for (const double xmu : {1.0, 1.7})
      general(fmt::format("MAT_186, power law {:g}", xmu), general_bond(0, xmu),
              std::pow(std::pow((1.0 - share) / GIC, xmu) + std::pow(share / GIIC, xmu), -1.0 / xmu));
    general("MAT_186, Benzeggagh and Kenane 1.5", general_bond(1, 1.5), GIC + (GIIC - GIC) * std::pow(share, 1.5));
  }
}

/// *MAT_169 of 0.3 mm; with rates from 1 to 1000 per second.
std::string arup(double shrp, double slope, double pwrt, double pwrs, bool rates = false) {
  return "*MAT_ARUP_ADHESIVE\n" + fields({1, 1e-9, 3000, 0.3, T, GIC, S, GIIC}) +
         fields({pwrt, pwrs, shrp, slope, 1.0, rates ? 1000.0 : 0.0, 1, 2}) + (rates ? fields({1.5, 2.0}) : "") +
         fields({0.3});
}

// Sabotage: E for the wave modulus; SHRP as a share of the energy; the slope left out.
TEST(CohesiveBricks, ArupAdhesive) {
  const double kt = 3000.0 * 0.7 / (1.3 * 0.4) / 0.3, ks = 3000.0 / 2.6 / 0.3;
  for (const auto& [shrp, slope, pwrt, pwrs] : {std::array{0.0, 0.0, 2.0, 2.0}, {0.4, 0.2, 1.5, 3.0}})
    for (const double degrees : {0.0, 50.0, 90.0}) {
      const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
      // Onset on the surface, by small steps; then the trapezoid with the energy of the mode.
      double onset = 0.0;
      while (std::pow(kt * c * onset / T, pwrt) + std::pow(ks * s * onset / (S - slope * kt * c * onset), pwrs) < 1.0)
        onset += 1e-8;
      const double k = kt * c * c + ks * s * s, share = ks * s * s / k;
      const double energy = 1.0 / ((1.0 - share) / GIC + share / GIIC);
      const double soften_t = T / kt, soften_s = S / ks + shrp * 2.0 * GIIC / ((1.0 + shrp) * S);
      const double soften = std::max(onset, 1.0 / std::hypot(c / soften_t, s / soften_s));
      const double failure = 2.0 * energy / (k * onset) + onset - soften;
      expect_parting(fmt::format("MAT_169, SHRP {:g}, SHT_SL {:g}", shrp, slope), arup(shrp, slope, pwrt, pwrs),
                     degrees, {onset * std::hypot(kt * c, ks * s), failure, energy}, 0.3);
    }
  // At 100 per second two thirds of the way, by logarithms, to the factors 1.5 and 2.
  const auto fast = driven(arup(0.0, 0.0, 2.0, 2.0, true), curve(93, {{0.0, 0.0}, {1e-2, 0.3}}),
                           curve(91, {{0.0, 0.0}, {1.0, 0.0}}), 1e-2, 0.3);
  double highest = 0.0;
  for (const WeldState& at : fast) highest = std::max(highest, at.tension);
  expect_reference("adhesive: one curve", "MAT_169 at 100 per second, highest traction [MPa]", highest,
                   T * (1.0 + 0.5 * 2.0 / 3.0), 5e-3);
  expect_reference("adhesive: one curve", "MAT_169 at 100 per second, energy [mJ]", fast.back().work,
                   25.0 * GIC * (1.0 + 2.0 / 3.0), 2e-3);
}

// *MAT_185 comes back on its curve, *MAT_186 in a straight line to the origin; both bear pressure.
TEST(CohesiveBricks, ComeBackOnTheCurveOrToTheOrigin) {
  const std::string way = curve(93, {{0.0, 0.0}, {1e-3, 0.06}, {2e-3, 0.0}, {3e-3, -0.001}});
  const std::string still = curve(91, {{0.0, 0.0}, {1.0, 0.0}});
  const auto at = [](const std::vector<WeldState>& seen, double time) {
    return *std::find_if(seen.begin(), seen.end(), [time](const WeldState& s) { return s.time >= time; });
  };
  const auto scaled = driven(scaled_bond(), way, still, 3e-3);
  const auto expect = [](const char* what, double value, double reference, double gate) {
    expect_reference("adhesive: way back", what, value, reference, gate);
  };
  const WeldState high = at(scaled, 0.95e-3), back = at(scaled, 1.05e-3);  // at 0.057, 0.05 and on is the fall
  expect("MAT_185, traction on the fall [MPa]", high.tension, T * (1.0 - high.apart.z / 0.1) / 0.5, 1e-6);
  expect("MAT_185, on the way back [MPa]", back.tension, T * (1.0 - back.apart.z / 0.1) / 0.5, 1e-6);
  expect("MAT_185, pressure [MPa]", at(scaled, 2.5e-3).tension, 1.5 * T / 0.01 * at(scaled, 2.5e-3).apart.z, 1e-6);
  const double stored = 25.0 * 0.1 * T * 0.5;  // of the order of what was stored
  expect_reference("adhesive: way back", "MAT_185, work on the way there and back [mJ]", at(scaled, 2e-3).work, 0.0,
                   2e-3, stored);

  const auto general = driven(general_bond(0, 1.0), way, still, 3e-3);
  const double failure = GIC / (0.515 * T);
  const double wide = std::max_element(general.begin(), general.end(), [](const WeldState& a, const WeldState& b) {
                        return a.apart.z < b.apart.z;
                      })->apart.z;
  const double traction = T * 0.7 * (1.0 - wide / failure) / 0.6;
  const WeldState half = at(general, 1.5e-3), pressed = at(general, 2.5e-3);
  EXPECT_GT(wide, 0.4 * failure);
  expect("MAT_186, halfway back [MPa]", half.tension, traction * half.apart.z / wide, 1e-6);
  expect("MAT_186, pressure [MPa]", pressed.tension, 10.0 * T / failure * pressed.apart.z, 1e-6);
}

TEST(CohesiveBricks, FreeOnesKeepMomentaAndEnergy) {
  for (const int elform : {19, 20}) {
    std::string deck = single(elastic_bond(3e-9, 5000.0, 2000.0), elform, 5.0, 1.2) + "*INITIAL_VELOCITY_NODE\n";
    const double v[8][3] = {{900, -2500, 1400}, {-600, 800, -1900}, {1700, 300, 500},   {-200, -1100, 700},
                            {-1500, 600, -800}, {400, 1900, 1000},  {-900, -700, 2300}, {1200, 100, -600}};
    for (int n = 0; n < 8; ++n)
      deck += fields({n + 1.0, v[n][0], v[n][1], v[n][2], 0.3 * v[n][2], -0.4 * v[n][0], 0.2 * v[n][1]});
    deck += "*CONTROL_TIMESTEP\n0.0,0.3\n*CONTROL_TERMINATION\n4e-3\n*END\n";
    Experiment experiment(deck);
    Vec3d first, first_turning;
    double drift = 0.0, turning_drift = 0.0, ratio = 0.0, turned = 0.0;
    Vec3d side_at_start;
    bool begun = false;
    experiment.run([&](const impact::Snapshot& now) {
      Vec3d momentum{}, turning{};
      for (int n = 1; n <= 8; ++n) {
        const std::size_t i = experiment.node(n);
        momentum += now.system.mass[i] * vec(now.state.v[i]);
        turning += now.system.mass[i] * cross(vec(now.state.x[i]), vec(now.state.v[i]));
        if (elform == 20) turning += now.system.inertia[i] * vec(now.state.w[i]);
      }
      const Vec3d side = unit(experiment.position(now, 2) + experiment.position(now, 6) - experiment.position(now, 1) -
                              experiment.position(now, 5));
      // At time 0 the velocities are those of the start, not of half a step before.
      if (now.state.time <= 0.0) side_at_start = side;
      if (now.state.time <= 0.0) return;
      if (!begun) first = momentum, first_turning = turning;
      begun = true;
      drift = std::max(drift, norm(momentum - first) / norm(first));
      turning_drift = std::max(turning_drift, norm(turning - first_turning) / norm(first_turning));
      ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
      turned = std::max(turned, std::acos(std::clamp(dot(side, side_at_start), -1.0, 1.0)));
    });
    EXPECT_GT(turned, 0.5) << elform;  // rad
    expect_reference("adhesive: free assembly", fmt::format("drift of the momentum, ELFORM {}", elform), drift, 0.0,
                     1e-9, 1.0);
    expect_reference("adhesive: free assembly", fmt::format("drift of the angular momentum, ELFORM {}", elform),
                     turning_drift, 0.0, 1e-9, 1.0);
    expect_reference("adhesive: free assembly", fmt::format("energy ratio, ELFORM {}", elform), ratio, 0.0, 1e-2, 1.0);
  }
}

TEST(CohesiveBricks, TwoMassesSwingOnTheBond) {
  const double en = 500.0, et = 200.0, side = 4.0, mass = 1e-6, density = 1e-9;
  for (const int direction : {3, 1}) {
    std::string deck = single(elastic_bond(density, en, et), 19, side, 0.0) + "*ELEMENT_MASS\n";
    for (int n = 1; n <= 8; ++n) deck += fmt::format("{:8}{:8}{:16}\n", n, n, mass);
    deck += "*INITIAL_VELOCITY_NODE\n";
    for (int n = 1; n <= 8; ++n) {
      const double v = n > 4 ? 100.0 : -100.0;
      deck += direction == 3 ? fields({1.0 * n, 0, 0, v}) : fields({1.0 * n, v, 0, 0});
    }
    deck += "*CONTROL_TIMESTEP\n0.0,0.5\n*CONTROL_TERMINATION\n1e-3\n*END\n";
    Experiment experiment(deck);
    double before = 0.0, time_before = 0.0, half = 0.0;
    experiment.run([&](const impact::Snapshot& now) {
      const Vec3d u = experiment.displacement(now, 5) - experiment.displacement(now, 1);
      const double apart = direction == 3 ? u.z : u.x;
      if (before > 0.0 && apart <= 0.0 && half == 0.0)
        half = time_before + (now.state.time - time_before) * before / (before - apart);
      before = apart;
      time_before = now.state.time;
    });
    const double each = 4.0 * mass + 0.5 * density * side * side, k = (direction == 3 ? en : et) * side * side;
    expect_reference("adhesive: frequency", fmt::format("frequency of two masses, direction {} [Hz]", direction),
                     0.5 / half, std::sqrt(k / (0.5 * each)) / (2.0 * std::numbers::pi), 2e-3);
  }
}

/// Two sheets of shells along x, one element of 1 mm wide, with adhesive between them from a station on.
struct Pair {
  int count;  ///< elements along x
  double dx, thickness, gap, E, density;
  int elform, bonded_from;

  static int node(int sheet, int station, int row) { return 1 + 10000 * sheet + 2 * station + row; }
  std::string text(const std::string& bond) const {
    std::string deck = "*KEYWORD\n" + bond + "*MAT_ELASTIC\n" + fields({2, density, E, 0.0}) + "*SECTION_SHELL\n" +
                       fields({2, 16, 1.0, 3}) + fields({thickness, thickness, thickness, thickness}) +
                       "*SECTION_SOLID\n" + fields({1, 1.0 * elform}) +
                       "*PART\nbond\n1,1,1\n*PART\nsheet\n2,2,2\n*NODE\n";
    for (int sheet = 0; sheet < 2; ++sheet)
      for (int i = 0; i <= count; ++i)
        for (int row = 0; row < 2; ++row) deck += node_line(node(sheet, i, row), i * dx, row, sheet * gap);
    std::string shells, solids;
    for (int i = 0; i < count; ++i) {
      std::vector<int> corner;
      for (int sheet = 0; sheet < 2; ++sheet) {
        const int n[4] = {node(sheet, i, 0), node(sheet, i + 1, 0), node(sheet, i + 1, 1), node(sheet, i, 1)};
        shells += element_line(1 + i + 10000 * sheet, 2, {n[0], n[1], n[2], n[3]});
        corner.insert(corner.end(), n, n + 4);
      }
      if (i >= bonded_from)
        solids += element_line(
            1 + i, 1, {corner[0], corner[1], corner[2], corner[3], corner[4], corner[5], corner[6], corner[7]});
    }
    return deck + "*ELEMENT_SHELL\n" + shells + "*ELEMENT_SOLID\n" + solids;
  }
  /// *BOUNDARY_SPC_NODE: of all nodes `all`, of a station of sheets `ends`, x y z rx ry rz.
  std::string held(std::initializer_list<double> all, int station, std::vector<int> sheets,
                   std::initializer_list<double> ends) const {
    std::string deck = "*BOUNDARY_SPC_NODE\n";
    for (int sheet = 0; sheet < 2; ++sheet)
      for (int i = 0; i <= count; ++i)
        for (int row = 0; row < 2; ++row) {
          const bool at_end = i == station && std::find(sheets.begin(), sheets.end(), sheet) != sheets.end();
          std::vector<double> f{1.0 * node(sheet, i, row), 0};
          f.insert(f.end(), (at_end ? ends : all).begin(), (at_end ? ends : all).end());
          deck += fields({f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]});
        }
    return deck;
  }
};

/// Displacements by linear statics.
class Static {
 public:
  explicit Static(const std::string& deck)
      : run_("*KEYWORD\n*CONTROL_IMPLICIT_GENERAL\n1,1.0\n*CONTROL_IMPLICIT_SOLUTION\n1\n*CONTROL_TERMINATION\n1.0\n" +
             curve(9, {{0.0, 0.0}, {1.0, 1.0}}) + deck.substr(deck.find('\n') + 1) + "*END\n") {
    Findings findings;
    nvh::check_statics(run_.system().model, findings);
    solved_.emplace(nvh::solve_statics(run_.matrices(), findings));
    EXPECT_EQ(findings.errors(), 0);
  }
  double displacement(int id, std::size_t direction) const {
    const auto node = at(run_.system().model.node_index(id));
    return solved_->motion[run_.system().node_of[node]][direction];
  }

 private:
  LinearExperiment run_;
  std::optional<nvh::Statics> solved_;
};

TEST(CohesiveBricks, VolkersensLapJoint) {
  const double E = 70000.0, t = 1.5, et = 2000.0, load = 1000.0, length = 40.0;
  const Pair joint{80, 0.5, t, 0.0, E, 2.7e-9, 19, 0};
  std::string deck = joint.text(elastic_bond(3e-10, 1e4, et)) +
                     joint.held({0, 1, 1, 1, 1, 1}, 0, {0}, {1, 1, 1, 1, 1, 1}) + "*LOAD_NODE_POINT\n";
  for (int row = 0; row < 2; ++row) deck += fields({1.0 * Pair::node(1, 80, row), 1, 9, 0.5 * load});
  const Static solved(deck);
  const auto shear = [&](int station) {
    return et * (solved.displacement(Pair::node(1, station, 0), 0) - solved.displacement(Pair::node(0, station, 0), 0));
  };
  const double w = std::sqrt(2.0 * et / (E * t)), half = 0.5 * length;
  const auto exact = [&](double x) { return 0.5 * load * w * std::cosh(w * (x - half)) / std::sinh(w * half); };
  expect_reference("adhesive: lap joint", "shear at the ends of a lap joint (Volkersen) [MPa]", shear(80),
                   exact(length), 5e-3);
  expect_reference("adhesive: lap joint", "shear at its other end [MPa]", shear(0), exact(0.0), 5e-3);
  expect_reference("adhesive: lap joint", "shear in its middle [MPa]", shear(40), exact(half), 5e-3);
}

TEST(CohesiveBricks, BondedSheetsBendAsOne) {
  const double E = 210000.0, t = 1.0, load = 1.0, length = 50.0;
  for (const int elform : {19, 20}) {
    const double stiff = elform == 19 ? 3e5 : 1e6;
    const Pair beam{50, 1.0, t, t, E, 7.85e-9, elform, 0};
    // Stiff: the slip of the bond counts little.
    std::string deck = beam.text(elastic_bond(3e-10, stiff, stiff)) +
                       beam.held({0, 1, 0, 1, 0, 1}, 0, {0, 1}, {1, 1, 1, 1, 1, 1}) + "*LOAD_NODE_POINT\n";
    for (int sheet = 0; sheet < 2; ++sheet)
      for (int row = 0; row < 2; ++row) deck += fields({1.0 * Pair::node(sheet, 50, row), 3, 9, 0.25 * load});
    const Static solved(deck);
    // In a brick of 19 the axes are the same all over, so that a curvature is a separation on either side of its
    // middle: it adds ET gap^2 dx^2 / 12 to the bending stiffness (docs/manual/adhesive.md).
    const double inertia = 8.0 * t * t * t / 12.0 + (elform == 19 ? stiff * t * t / 12.0 / E : 0.0);
    const double exact =
        load * length * length * length / (3.0 * E * inertia) + load * length / (5.0 / 6.0 * 0.5 * E * 2.0 * t);
    expect_reference("adhesive: bonded sheets in bending",
                     fmt::format("tip of two sheets bonded to one, ELFORM {} [mm]", elform),
                     solved.displacement(Pair::node(0, 50, 0), 2), exact, 5e-3);
  }
}

TEST(CohesiveBricks, DoubleCantileverBeam) {
  const double E = 210000.0, t = 1.0, end = 8e-3, opening = 2.2, energy = 0.5;
  for (const int elform : {19, 20}) {
    const Pair beam{80, 0.5, t, elform == 19 ? 0.0 : t, E, 7.85e-9, elform, 20};
    const std::string law =
        "*MAT_COHESIVE_MIXED_MODE\n" + fields({1, 3e-9, 1, 1, 4e4, 4e4, energy, energy}) + fields({1.0, 40.0, 40.0});
    std::string deck = beam.text(law) + beam.held({0, 1, 0, 1, 0, 1}, 80, {0, 1}, {1, 1, 1, 1, 1, 1}) +
                       curve(93, {{0.0, 0.0}, {0.25 * end, 0.25 * opening}, {end, 0.5 * opening}}) +
                       curve(94, {{0.0, 0.0}, {0.25 * end, -0.25 * opening}, {end, -0.5 * opening}}) +
                       curve(95, {{0.0, 800.0}, {1.0, 800.0}}) +
                       "*DAMPING_GLOBAL\n95\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n";
    for (int row = 0; row < 2; ++row)
      deck += fields({1.0 * Pair::node(1, 0, row), 3, 2, 93}) + fields({1.0 * Pair::node(0, 0, row), 3, 2, 94});
    deck += "*CONTROL_TERMINATION\n" + fields({end}) + "*END\n";
    Experiment experiment(deck);
    double sum = 0.0, ratio = 0.0;
    int count = 0;
    experiment.run([&](const impact::Snapshot& now) {
      ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
      if (now.state.time < 0.5 * end) return;
      // Force on the upper arm: that of its shell on the driven nodes.
      double force = 0.0;
      const auto location = now.system.shell_location[80];
      force += now.system.nodal_force(location, 0).z + now.system.nodal_force(location, 3).z;
      const double apart = 2.0 * experiment.displacement(now, Pair::node(1, 0, 0)).z;
      sum += force * std::sqrt(apart);
      ++count;
    });
    // P = sqrt(G b E I) / a and opening 2 P a^3 / (3 E I) of both arms leave P sqrt(opening) the same at any crack
    // length.
    const double stiffness = E * t * t * t / 12.0;
    const double exact = std::pow(energy * stiffness, 0.75) * std::sqrt(2.0 / (3.0 * stiffness)) * 1.0;
    expect_reference("adhesive: double cantilever",
                     fmt::format("double cantilever, force times root of opening, ELFORM {}", elform), sum / count,
                     exact, 0.05);
    EXPECT_LT(ratio, 0.02);
  }
}

}  // namespace
}  // namespace nugget::verify
