// SPDX-License-Identifier: Apache-2.0
// Shares of force and mass, tolerance and free rotation of ties, the eight projection cases of S. Bala's talk as whole
// decks, and what a free welded assembly must conserve.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/index.hpp"
#include "experiment.hpp"
#include "momenta.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

using testing::HasSubstr;

std::string text(const Findings& findings) {
  std::string all;
  for (const Finding& f : findings.all()) all += to_string(f) + '\n';
  return all;
}

// ---- Tie: shares of force and mass

/// One held shell of 10 x 8, nodes 1 to 4; the weld's node 5 is tied to it at `place`, its node 6, 20 mm above, is
/// moved.
struct OneSegment {
  Experiment run;
  Vec3d place;

  explicit OneSegment(const Vec3d& at, double density = 7.8e-9)
      : run("*KEYWORD\n" + termination(2e-4) + sheet_part(1, 1.2) + weld_part(2, {.density = density, .yield = 1e9}) +
            SheetMesh{.corner = {}, .along = {10, 0, 0}, .across = {0, 8, 0}}.text() +
            beam_between(11, 2, 5, {at.x, at.y, 0.5}, 6, {at.x, at.y, 20.0}) + fixed({1, 2, 3, 4}) +
            weld_contact(2, 1) +
            // Displacements and angles in all directions, then held: the last forces are static.
            driven(
                6, [](double s) { return std::array{2e-2 * s, -1e-2 * s, 3e-2 * s, 1e-3 * s, -2e-3 * s, 1e-3 * s}; },
                1e-4, 1, 100) +
            "*END\n"),
        place(at) {}
};
// SheetMesh numbers nodes row by row: the segment's corners in order are 1 2 4 3.
constexpr int corners[4] = {1, 2, 4, 3};

/// Reactions at the corners over the force on the weld's other end must be the weights; moments must balance.
void expect_split(const std::string& test_case, const Vec3d& place, const std::array<double, 4>& weight) {
  OneSegment s(place);
  std::array<Vec3d, 4> reaction, couple;
  Vec3d pull, twist;
  s.run.run([&](const impact::Snapshot& now) {
    for (const auto& r : now.components.supports.spc_reactions())
      for (std::size_t i = 0; i < 4; ++i)
        if (at(r.node) == s.run.node(corners[i])) {
          reaction[i] = r.force;
          couple[i] = r.moment;
        }
    pull = twist = {};
    for (const auto& r : now.components.supports.motion_reactions()) {
      pull += r.force;
      twist += r.moment;
    }
  });
  const double scale = norm(pull);
  ASSERT_GT(scale, 1e3);
  const std::array<Vec3d, 4> x{{{0, 0, 0}, {10, 0, 0}, {10, 8, 0}, {0, 8, 0}}};
  Vec3d force = pull, moment = twist + cross(Vec3d{place.x, place.y, 20.0} + Vec3d{2e-2, -1e-2, 3e-2}, pull);
  for (std::size_t i = 0; i < 4; ++i) {
    expect_reference(test_case, fmt::format("share of the force at corner {}", i + 1),
                     -dot(reaction[i], pull) / (scale * scale), weight[i], 1e-10, 1.0);
    EXPECT_LT(norm(reaction[i] + weight[i] * pull), 1e-10 * scale);
    force += reaction[i];
    moment += couple[i] + cross(x[i], reaction[i]);
  }
  expect_reference(test_case, "sum of forces over the force", norm(force) / scale, 0.0, 1e-12, 1.0);
  expect_reference(test_case, "sum of moments over force x length", norm(moment) / (20.0 * scale), 0.0, 1e-12, 1.0);
}

// Sabotage to be caught: N2 and N3 exchanged; N_i squared; the moment at the tied node dropped.
TEST(Tie, ForceSplit) {
  expect_split("tie: shares of force and mass", {7, 2, 0}, {0.225, 0.525, 0.175, 0.075});
  expect_split("tie: shares of force and mass", {5, 4, 0}, {0.25, 0.25, 0.25, 0.25});
  expect_split("tie: shares of force and mass", {10, 8, 0}, {0.0, 0.0, 1.0, 0.0});
}

// docs/theory/weld.md#reference-values.
TEST(Tie, ForceSplitOfTheTiePatch) {
  expect_split("tie: shares of force and mass", {6.5, 3.2, 0}, {0.21, 0.39, 0.26, 0.14});
}

// Sabotage to be caught: mass N_i^2 m, or the mass left on the tied node as well. Also
// docs/theory/weld.md#reference-values.
TEST(Tie, MassSplit) {
  OneSegment s({7, 2, 0});
  const system::System& system = s.run.system();
  const double weld_mass = 7.8e-9 * WeldData{}.area() * 20.0;  // length 20 after projection
  const double weight[4] = {0.225, 0.525, 0.175, 0.075};
  for (int i = 0; i < 4; ++i) {
    const std::size_t k = s.run.node(corners[i]);
    expect_reference("tie: shares of force and mass", fmt::format("share of the mass at corner {}", i + 1),
                     (system.mass[k] - system.own_mass[k]) / (0.5 * weld_mass), weight[i], 1e-10, 1.0);
  }
  EXPECT_EQ(system.mass[s.run.node(5)], 0.0);
  double after = 0.0;
  for (double m : system.mass) after += m;
  expect_reference("tie: shares of force and mass", "sum of nodal masses after tying over that of the parts", after,
                   7.85e-9 * 1.2 * 80.0 + weld_mass, 1e-12);
}

// ---- Tie: tolerance

/// t_s = 1.0 (a beam of that diameter), t_m = 1.2, segment 10 x 8: tolerance 1.32.
Experiment gap_deck(double gap, double sast = 0.0, double sbst = 0.0, double sheet = 1.2, double diameter = 1.0) {
  return Experiment("*KEYWORD\n" + termination(1e-6) + sheet_part(1, sheet) + weld_part(2, {.diameter = diameter}) +
                    SheetMesh{.corner = {}, .along = {10, 0, 0}, .across = {0, 8, 0}}.text() +
                    beam_between(11, 2, 5, {5, 4, gap}, 6, {5, 4, 20}) + weld_contact(2, 1, sast, sbst) +
                    "*CONTROL_CONTACT\n" + fields({0.1}) + fields({0}) + fields({0}) + fields({0, 0, 0, 1}) + "*END\n");
}

double largest_gap(double sheet, double diameter, double sast = 0.0, double sbst = 0.0) {
  double tied = 0.0, free = 3.0;
  while (free - tied > 1e-7) {
    const double gap = 0.5 * (tied + free);
    (gap_deck(gap, sast, sbst, sheet, diameter).ties().ties.empty() ? free : tied) = gap;
  }
  return tied;
}

// Sabotage to be caught: 0.5 in place of 0.6; the sum in place of the larger tolerance; SAST taken with its sign.
TEST(Tie, Tolerance) {
  const Experiment near = gap_deck(1.31);
  ASSERT_EQ(near.ties().ties.size(), 1u);
  EXPECT_THAT(text(near.findings()), HasSubstr("1 of them moved onto the mid-surface, at most by 1.31"));
  EXPECT_TRUE(near.model().control.list_ties);
  EXPECT_EQ(weld::describe(near.model(), near.ties().ties[0]),
            "node 5 on segment 1 2 4 3 (shell 1 of part 1), xi 0.000000 eta 0.000000, moved 1.31");

  const Experiment far = gap_deck(1.33);
  EXPECT_TRUE(far.ties().ties.empty());
  EXPECT_THAT(
      text(far.findings()),
      HasSubstr(
          "node 5 at (5, 4, 1.33): no segment in reach: the closest, shell 1 of part 1, is 1.33 away, tolerance 1.32"));

  expect_reference("tie: tolerance", "largest gap that is tied, 0.6 (t_s + t_m) [mm]", largest_gap(1.2, 1.0), 1.32,
                   1e-6);
  expect_reference("tie: tolerance", "largest gap that is tied, 0.05 of the shorter diagonal [mm]",
                   largest_gap(0.1, 0.1), 0.05 * std::hypot(10.0, 8.0), 1e-6);
  expect_reference("tie: tolerance", "largest gap that is tied, SAST = SBST = -1.2 [mm]",
                   largest_gap(1.2, 1.0, -1.2, -1.2), 1.44, 1e-6);
  EXPECT_EQ(gap_deck(1.43, -1.2, -1.2).ties().ties.size(), 1u);  // 0.6 (1.2 + 1.2) = 1.44
  EXPECT_TRUE(gap_deck(1.45, -1.2, -1.2).ties().ties.empty());
  EXPECT_TRUE(gap_deck(1.21, -1.0, -1.0).ties().ties.empty());  // downward too
}

// ---- the projection cases

/// Two sheets of 3 x 3 shells of 10 mm, t = 1, `height` apart, a weld beam of 5 mm from n1 to n2 with nodes 901 and
/// 902.
struct ProjectionCase {
  SheetMesh lower{.first = 1, .part = 1, .corner = {}, .nx = 3, .ny = 3},
      upper{.first = 101, .part = 2, .corner = {}, .nx = 3, .ny = 3};
  std::string more;        ///< further sheets
  std::string beam_parts;  ///< of *ELEMENT_BEAM_PID
  std::vector<int> parts{1, 2};

  Experiment deck(const Vec3d& n1, const Vec3d& n2) const {
    std::string set = "*SET_PART_LIST\n" + fields({1});
    for (int p : parts) set += fmt::format("{:10d}", p);
    const std::string element = element_line(901, 9, {901, 902});
    return Experiment(
        "*KEYWORD\n" + termination(2e-5) + sheet_part(1, 1.0) + sheet_part(2, 1.0) + lower.text() + upper.text() +
        more + weld_part(9, {.diameter = 5.0}) + "*NODE\n" + node_line(901, n1.x, n1.y, n1.z) +
        node_line(902, n2.x, n2.y, n2.z) +
        (beam_parts.empty() ? "*ELEMENT_BEAM\n" + element : "*ELEMENT_BEAM_PID\n" + element + beam_parts) +
        "*CONTACT_SPOTWELD\n" + fields({9, 1, 3, 2}) + fields({0}) + fields({1, 1}) + set + "\n*END\n");
  }
};

ProjectionCase apart(double height) {
  ProjectionCase c;
  c.upper.corner = {0, 0, height};
  return c;
}

/// Runs ten cycles or so with one sheet moving; the run must end well and tied nodes must stay where their weights say.
void expect_runs(Experiment& run) {
  const impact::Outcome outcome = run.run([&](const impact::Snapshot& now) {
    for (const weld::Tie& tie : run.ties().ties) {
      Vec3d follows;
      for (std::size_t i = 0; i < 4; ++i)
        if (tie.weight[i] != 0.0) follows += tie.weight[i] * vec(now.state.x[now.system.node_of[tie.segment[i]]]);
      EXPECT_LT(norm(follows - vec(now.state.x[now.system.node_of[tie.node]])), 1e-12);
    }
  });
  EXPECT_EQ(outcome.termination, impact::Termination::normal) << outcome.message;
  EXPECT_GT(run.simulation().state().cycle, 5);
}

void expect_case(Experiment& run, int end1, int end2, bool tied) {
  const weld::Weld& weld = run.ties().welds.at(0);
  EXPECT_EQ(weld.ends[0].projection_case, end1) << text(run.findings());
  EXPECT_EQ(weld.ends[1].projection_case, end2) << text(run.findings());
  EXPECT_EQ(weld.tied, tied);
  expect_runs(run);
}

void expect_weights(const weld::Tie& tie, const std::array<double, 4>& weight) {
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(tie.weight[i], weight[i], 1e-12) << "corner " << i;
}

TEST(ProjectionDeck, Case1Centroid) {
  Experiment run = apart(1.0).deck({15, 15, 0.2}, {15, 15, 0.9});
  expect_case(run, 1, 1, true);
  for (const weld::Projection& p : run.ties().welds[0].ends) expect_weights(p.tie, {0.25, 0.25, 0.25, 0.25});
  EXPECT_NEAR(run.ties().welds[0].length, 1.0, 1e-12);
  EXPECT_EQ(run.findings().warnings(), 0) << text(run.findings());
  EXPECT_THAT(text(run.findings()),
              HasSubstr("2 nodes tied, 2 of them moved onto the mid-surface, at most by 0.2 (node 901"));
}

TEST(ProjectionDeck, Case2Edge) {
  Experiment run = apart(1.0).deck({17, 10, 0}, {17, 10, 1});
  expect_case(run, 2, 2, true);
  expect_weights(run.ties().welds[0].ends[0].tie, {0, 0, 0.7, 0.3});
  EXPECT_EQ(run.findings().warnings(), 0) << text(run.findings());
}

TEST(ProjectionDeck, Case3Corner) {
  Experiment run = apart(1.0).deck({10, 10, 0}, {10, 10, 1});
  expect_case(run, 3, 3, true);
  expect_weights(run.ties().welds[0].ends[0].tie, {0, 0, 1, 0});
  EXPECT_EQ(run.findings().warnings(), 0) << text(run.findings());
}

TEST(ProjectionDeck, Case4PenetratingSheets) {
  Experiment run = apart(0.6).deck({15, 15, -0.125}, {15, 15, 0.725});
  expect_case(run, 4, 4, true);
  EXPECT_NEAR(run.ties().welds[0].length, 0.6, 1e-12);
  EXPECT_THAT(text(run.findings()),
              HasSubstr("node 901 at (15, 15, -0.125): the sheets penetrate each other by 0.4; over shell 5 of part 1, "
                        "0.125 away, moved 0.125"));
}

TEST(ProjectionDeck, Case5NothingInReach) {
  Experiment run = apart(10.0).deck({45, 15, 0}, {15, 15, 10});
  expect_case(run, 5, 1, false);
  EXPECT_EQ(run.ties().ties.size(), 1u);
  EXPECT_THAT(text(run.findings()),
              HasSubstr("node 901 at (45, 15, 0): no segment in reach: the closest, shell 6 of part 1, is 15 away, "
                        "tolerance 3.6, not tied"));
  EXPECT_THAT(text(run.findings()), HasSubstr("beam weld 901 is not tied; it is kept, with free ends"));
}

TEST(ProjectionDeck, Case6AnotherSegmentInReach) {
  ProjectionCase c = apart(2.0);
  const SheetMesh wide_top{.first = 201, .part = 2, .corner = {30, 0, 2}, .nx = 3, .ny = 3};
  const SheetMesh below{.first = 301, .part = 3, .corner = {20, 0, -1}, .nx = 3, .ny = 3};
  c.more = sheet_part(3, 1.0) + wide_top.text() + below.text();
  c.parts = {1, 2, 3};
  Experiment run = c.deck({33, 15, 0}, {33, 15, 2});
  expect_case(run, 6, 1, true);
  EXPECT_EQ(run.model().parts[run.ties().welds[0].sheets[0]].id, 3);
  EXPECT_THAT(text(run.findings()),
              HasSubstr("node 901 at (33, 15, 0): over no segment of its own sheet; the closest is shell 305 of "
                        "part 3, 1 away, moved 1"));
}

/// Sheets that have passed through each other; end 1 belongs to the one that now lies above.
void expect_refused(const Vec3d& along, const Vec3d& across, int projection_case) {
  ProjectionCase c;
  c.lower.corner = {0, 0, 0.6};
  c.lower.along = along;
  c.lower.across = across;
  c.upper.corner = {0, 0, 0.4};
  c.beam_parts = fmt::format("{:8d}{:8d}\n", 1, 2);
  Experiment run = c.deck({15, 15, 0}, {15, 15, 1});
  expect_case(run, projection_case, projection_case, false);
  EXPECT_TRUE(run.ties().ties.empty());
  EXPECT_NEAR(run.ties().welds[0].length, 1.0, 1e-12);
  EXPECT_THAT(text(run.findings()),
              HasSubstr(fmt::format("would turn the weld over or crush it (case {}", projection_case)));
}

TEST(ProjectionDeck, Case7CrossingSheets) {
  expect_refused({10, 0, 0}, {0, 10, 0}, 7);
}
TEST(ProjectionDeck, Case8CrossingSheetsNormalsOutward) {
  expect_refused({0, 10, 0}, {10, 0, 0}, 8);
}

// ---- free assemblies

/// Two sheets of nx x nx shells of 10 mm, t = 1, 1 mm apart, one weld.
std::string two_sheets(int nx, const WeldData& weld, double x, double y) {
  const SheetMesh lower{.first = 1, .part = 1, .corner = {}, .nx = nx, .ny = nx};
  const SheetMesh upper{.first = 101, .part = 2, .corner = {0, 0, 1}, .nx = nx, .ny = nx};
  return sheet_part(1, 1.0) + sheet_part(2, 1.0) + lower.text() + upper.text() + weld_part(9, weld) +
         beam_between(901, 9, 901, {x, y, 0}, 902, {x, y, 1}) + weld_contact_to_set(9, {1, 2});
}

// The weld breaks on the way. At a constant step the balance is exact but for round-off, and forces come in pairs.
// Sabotage to be caught: a force on only one end of anything; the weld's moment lost in the tie (energy); energy that
// does not erode.
TEST(FreeAssembly, KeepsMomentumAndEnergyToRoundOff) {
  const double dt = 1.5e-7;
  Experiment run("*KEYWORD\n" + termination(20000 * dt, 0.9, 0.0, 90) + curve(90, {{0, dt}, {1, dt}}) +
                 two_sheets(3, {.length = 1.0, .yield = 1e9, .strength = {1500.0, 3000.0, 3000.0}}, 13.0, 17.0) +
                 "*INITIAL_VELOCITY_GENERATION\n" + fields({2, 2, 0, 700, -400, 3000}) + fields({0}) + "*END\n");
  const FreeDrift drift = free_drift(run);
  ASSERT_TRUE(run.simulation().components().welds.history(0)->failed());
  EXPECT_GT(run.simulation().energy().eroded, 0.0);
  expect_reference("free assembly", "drift of the linear momentum in 20,000 cycles", drift.linear, 0.0, 1e-12, 1.0);
  expect_reference("free assembly", "drift of the angular momentum in 20,000 cycles", drift.angular, 0.0, 1e-12, 1.0);
  expect_reference("free assembly", "energy balance in 20,000 cycles, weld broken", drift.energy, 0.0, 1e-10, 1.0);
}

// Welded sheets in free rotation. Two sheets, each with its centre of mass 0.5 mm off the common one, do load their
// weld: a force m a, with a the acceleration of a sheet's centre in torque-free motion of a symmetric top, h (-w_p^2 e3
// + (I3 / I1) w_3 w_p), w_p the spin across the normal e3. That is 0.09 N axially and 0.24 N in shear at 200 rad/s:
// more than 1e-6 NRR = 0.008 N, so the gate is on what the weld carries beyond it, averaged over the vibration that the
// sudden start leaves. Growth would show as a difference between the halves. Sabotage to be caught: rates on the
// geometry of the end of the step; a weld frame that does not follow the spin.
TEST(FreeAssembly, SpinningSheets) {
  const double omega = 200.0, end = 2.0 * 2.0 * 3.14159265358979 / omega;
  Experiment run("*KEYWORD\n" + termination(end) +
                 two_sheets(4, {.length = 1.0, .strength = {8000, 6000, 6000, 9000, 7000, 7000}}, 20.0, 20.0) +
                 "*INITIAL_VELOCITY_GENERATION\n" + fields({0, 0, omega, 1000, -2000, 500}) +
                 fields({20, 20, 0.5, 1, 2, 3}) + "*CONTROL_ACCURACY\n" + fields({1}) + "*END\n");
  const system::System& system = run.system();
  // Inertias of the lumped masses about the common centre.
  Momenta start;
  double i1 = 0.0, i3 = 0.0, sheet = 0.0;
  for (std::size_t k = 0; k < system.nodes; ++k) {
    const Vec3d r = run.ties().x[system.model_node[k]] - Vec3d{20, 20, 0.5};
    i1 += system.mass[k] * (r.y * r.y + r.z * r.z) + system.inertia[k];
    i3 += system.mass[k] * (r.x * r.x + r.y * r.y) + system.inertia[k];
    if (r.z > 0.0) sheet += system.mass[k];
  }
  const double h = 0.5, normal_spin = omega * 3.0 / std::sqrt(14.0), across = omega * std::sqrt(5.0 / 14.0);
  const double axial = sheet * h * across * across, shear = sheet * h * (i3 / i1) * normal_spin * across;

  struct Mean {
    double axial = 0.0, shear = 0.0, count = 0.0;
  } halves[2];
  double peak[2] = {0.0, 0.0}, moment_peak[2] = {0.0, 0.0};
  double linear = 0.0, angular = 0.0, kinetic = 0.0, path = 0.0;
  const impact::Outcome outcome = run.run([&](const impact::Snapshot& now) {
    const weld::Resultants& r = run.weld(now, 901);
    const int half = now.state.time < 0.5 * end ? 0 : 1;
    halves[half].axial += r.axial;
    halves[half].shear += r.shear();
    halves[half].count += 1.0;
    peak[half] = std::max(peak[half], std::hypot(r.axial, r.shear()));
    moment_peak[half] = std::max(moment_peak[half], std::hypot(r.moment(), r.torsion));
    if (now.state.cycle % 100 != 0) return;
    const Momenta m = momenta(now);
    if (now.state.cycle == 0) start = m;
    linear = std::max(linear, norm(m.linear - start.linear) / norm(start.linear));
    angular = std::max(angular, norm(m.angular - start.angular) / norm(start.angular));
    kinetic = std::max(kinetic, std::abs(m.kinetic - start.kinetic) / start.kinetic);
    path = std::max(path, norm(m.centre - start.centre - now.state.time * Vec3d{1000, -2000, 500}) / norm(m.centre));
  });
  EXPECT_EQ(outcome.termination, impact::Termination::normal);
  RecordProperty("cycles", static_cast<int>(run.simulation().state().cycle));
  const double gate = 1e-6 * 8000.0;
  for (int i = 0; i < 2; ++i) {
    const char* revolution = i == 0 ? "first" : "second";
    expect_reference("welded sheets in free rotation",
                     fmt::format("mean N_rr over the {} revolution, physical value as reference [N]", revolution),
                     halves[i].axial / halves[i].count, axial, gate, 1.0);
    expect_reference("welded sheets in free rotation",
                     fmt::format("mean shear over the {} revolution, physical value as reference [N]", revolution),
                     halves[i].shear / halves[i].count, shear, gate, 1.0);
  }
  EXPECT_LE(peak[1], peak[0]);
  expect_reference("welded sheets in free rotation",
                   "peak force in the second revolution, physical value as reference [N]", peak[1],
                   std::hypot(axial, shear), gate, 1.0);
  expect_reference("welded sheets in free rotation", "largest moment of the weld over 1e-6 MSS",
                   std::max(moment_peak[0], moment_peak[1]) / (1e-6 * 7000.0), 0.0, 1.0, 1.0);
  expect_reference("welded sheets in free rotation", "drift of the linear momentum", linear, 0.0, 1e-10, 1.0);
  expect_reference("welded sheets in free rotation", "drift of the angular momentum", angular, 0.0, 1e-4, 1.0);
  expect_reference("welded sheets in free rotation", "drift of the kinetic energy", kinetic, 0.0, 1e-4, 1.0);
  expect_reference("welded sheets in free rotation", "centre of mass off its straight path", path, 0.0, 1e-10, 1.0);
}

}  // namespace
}  // namespace nugget::verify
