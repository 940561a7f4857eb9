// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_INTERPOLATION_SPOTWELD (SPR3) between two sheets, against its published law in closed form.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "linear.hpp"
#include "sheet_joints.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

const char* const spr3_case = "interpolation spot welds";

/// A card, in mm, t, s; `length` and `mass` are what 1 mm and 1 t are in other units.
struct Spr3Card {
  double thick = 3.0, radius = 3.0, stiffness = 2e4, alpha = 0.0;
  double rn = 1.2, rs = 0.8, beta = 2.0, density = 7.8e-9;
  double bending = 3e5, torsion = 4e5;
  double yield = 1000.0;                                   ///< F0, the same at all plastic displacements
  std::array<double, 2> begins{0.1, 0.2}, ends{0.5, 0.6};  ///< in shear and in tension; ends of 0: never
  double length = 1.0, mass = 1.0;

  double area() const { return std::numbers::pi * radius * radius; }
  /// With node set 7 and curves 61 to 63.
  std::string text() const {
    const double force = mass * length;  // of 1 N, since times stay
    const bool breaks = ends[0] > 0.0;
    std::string deck =
        "*CONSTRAINED_INTERPOLATION_SPOTWELD\n" +
        fields({1, 2, 7, thick * length, radius * length, stiffness * force / length, alpha / length, 1}) +
        fields({rn, rs, beta, 61, breaks ? 62.0 : 0, breaks ? 63.0 : 0, density * mass / (length * length * length)}) +
        fields({0, bending * force * length, torsion * force * length}) +
        curve(61, {{0.0, yield * force}, {1.0 * length, yield * force}});
    if (breaks)
      deck += curve(62, {{0.0, begins[0] * length}, {1.0, begins[1] * length}}) +
              curve(63, {{0.0, ends[0] * length}, {1.0, ends[1] * length}});
    return deck;
  }
};

std::string moved_sheet(const Spr3Card& card, const std::function<Vec3d(const Vec3d& x, double s)>& place) {
  return verify::moved_sheet(card.text(), place, card.length, card.mass);
}

// The sheets moved apart, and along each other: elastic, ideally plastic, damaged, broken, at the displacements that
// the card says, with the work of that curve. Sabotage: RN and RS exchanged; the mode mixity turned round; damage left
// out of the force.
TEST(InterpolationSpotwelds, TensionAndShear) {
  for (const bool tension : {true, false}) {
    const Spr3Card card;
    const double most = 0.9;
    Experiment run(moved_sheet(card, [&](const Vec3d& x, double s) {
      return x + (tension ? Vec3d{0, 0, most * s} : Vec3d{0.6 * most * s, -0.8 * most * s, 0});
    }));
    const std::vector<JointNow> seen = follow_joint(run);
    const std::string mode = tension ? "tension" : "shear";
    const double full = card.yield * (tension ? card.rn : card.rs), elastic = full / card.stiffness;
    const std::size_t k = tension ? 1 : 0;
    const auto force_at = [&](double u) {
      const double v = u - elastic;
      if (v < 0.0) return card.stiffness * u;
      return full * std::clamp((card.ends[k] - v) / (card.ends[k] - card.begins[k]), 0.0, 1.0);
    };
    for (const double u :
         {0.6 * elastic, elastic + 0.05, elastic + card.begins[k] + 0.1, elastic + card.ends[k] - 0.05}) {
      const JointNow& now = at_share(seen, u / most);
      expect_reference(spr3_case, fmt::format("{}: force at {:.3f} mm [N]", mode, u), tension ? now.r[0] : now.shear(),
                       force_at(most * now.s), 2e-3);
      EXPECT_NEAR(tension ? now.shear() : now.r[0], 0.0, 1e-3 * full);
    }
    const auto broken = std::find_if(seen.begin(), seen.end(), [](const JointNow& now) { return !now.alive; });
    ASSERT_NE(broken, seen.end());
    expect_reference(spr3_case, mode + ": displacement at rupture [mm]", most * broken->s, elastic + card.ends[k],
                     2e-3);
    expect_reference(spr3_case, mode + ": work until rupture [mJ]", seen.back().energy,
                     full * (0.5 * elastic + 0.5 * (card.begins[k] + card.ends[k])), 2e-3);
    const auto& record = *run.simulation().components().connectors.record(0);
    EXPECT_TRUE(record.failed);
    EXPECT_NEAR(record.mode_mixity, tension ? 1.0 : 0.0, 1e-2);
  }
}

// A long pull at 45 degrees: the force comes to rest where the normal of the yield surface is the pull's direction.
// Sabotage: flow along the force.
TEST(InterpolationSpotwelds, PullAt45Degrees) {
  for (const double beta : {1.5, 2.0, 3.0}) {
    Spr3Card card;
    card.beta = beta;
    card.ends = {};
    Experiment run(moved_sheet(card, [&](const Vec3d& x, double s) { return x + Vec3d{0.7 * s, 0, 0.7 * s}; }));
    const JointNow last = follow_joint(run).back();
    const double ratio = std::pow(card.rn / card.rs, 1.0 / (beta - 1.0)),
                 y = std::pow(1.0 + std::pow(ratio, beta), -1.0 / beta);
    const std::string what = fmt::format("45 degrees, beta {:.1f}: ", beta);
    expect_reference(spr3_case, what + "normal force [N]", last.r[0], card.rn * card.yield * ratio * y, 2e-3);
    expect_reference(spr3_case, what + "shear force [N]", last.shear(), card.rs * card.yield * y, 2e-3);
  }
}

// Sheet 2 turned about an axis through the spot: a moment alone, elastic K angle, then R_n F0 / alpha.
// Sabotage: forces that act at one sheet in place of the middle; bending left out of the normal force of yield.
TEST(InterpolationSpotwelds, Moment) {
  Spr3Card card;
  card.alpha = 0.4;
  card.ends = {};
  const double most = 0.03;
  Experiment run(moved_sheet(card, [&](const Vec3d& x, double s) {
    const double c = std::cos(most * s), d = std::sin(most * s);
    const Vec3d r = x - joint_spot;
    return joint_spot + Vec3d{c * r.x + d * r.z, r.y, -d * r.x + c * r.z};
  }));
  const std::vector<JointNow> seen = follow_joint(run);
  const JointNow& early = at_share(seen, 0.2);
  expect_reference(spr3_case, "moment at an angle of 0.006 [N mm]", early.moment(), card.bending * most * early.s,
                   2e-3);
  expect_reference(spr3_case, "moment of yield [N mm]", seen.back().moment(), card.rn * card.yield / card.alpha, 2e-3);
  EXPECT_NEAR(seen.back().shear(), 0.0, 1e-2 * card.yield);
}

// The same deck in metres and kilograms gives the same forces. Sabotage: STIFF3 taken for STIFF; a length in the law.
TEST(InterpolationSpotwelds, SameInOtherUnits) {
  const auto path = [](const Vec3d& x, double s) {
    const Vec3d r = x - joint_spot;
    return x + Vec3d{0.3 * s + 0.01 * s * r.z, -0.1 * s, 0.2 * s - 0.01 * s * r.x};
  };
  Spr3Card card;
  card.alpha = 0.01;
  Experiment in_mm(moved_sheet(card, path));
  card.length = 1e-3;
  card.mass = 1e3;
  Experiment in_m(moved_sheet(card, path));
  const std::vector<JointNow> one = follow_joint(in_mm), other = follow_joint(in_m);
  ASSERT_EQ(one.size(), other.size());
  for (const double s : {0.1, 0.5, 0.9}) {
    const JointNow &a = at_share(one, s), &b = at_share(other, s);
    EXPECT_GT(a.moment(), 100.0);
    EXPECT_NEAR(b.r[0] / a.r[0], 1.0, 1e-6);
    EXPECT_NEAR(b.shear() / a.shear(), 1.0, 1e-6);
    EXPECT_NEAR(b.moment() / (1e-3 * a.moment()), 1.0, 1e-6);
  }
}

struct Spr3Momenta {
  Vec3d linear, angular;
};
Spr3Momenta spr3_momenta(const impact::Snapshot& now) {
  Spr3Momenta m;
  for (std::size_t k = 0; k < now.system.nodes; ++k) {
    const Vec3d x = vec(now.state.x[k]), v = now.velocity(k);
    m.linear += now.system.mass[k] * v;
    m.angular += now.system.mass[k] * cross(x, v) + now.system.inertia[k] * now.spin(k);
  }
  return m;
}

// Two free sheets, one of which is thrown away from the other; two welds, one near a corner, yield and break.
// Sabotage: the couple of the shear force left out; forces at other weights than velocities.
TEST(InterpolationSpotwelds, FreeAssemblyKeepsMomentumAndEnergy) {
  const double dt = 1.5e-7;
  Spr3Card card;
  card.thick = 2.0;
  card.alpha = 0.1;
  card.yield = 10.0;
  const SheetMesh lower{.first = 1, .part = 1, .corner = {}, .nx = 3, .ny = 3};
  const SheetMesh upper{.first = 101, .part = 2, .corner = {0, 0, 1}, .nx = 3, .ny = 3};
  Experiment run("*KEYWORD\n" + termination(8000 * dt, 0.9, 0.0, 90) + curve(90, {{0, dt}, {1, dt}}) +
                 sheet_part(1, 1.0) + sheet_part(2, 1.0) + lower.text() + upper.text() + "*NODE\n" +
                 node_line(901, 28.0, 17.0, 0.5) + node_line(902, 6.0, 12.0, 0.5) + "*SET_NODE_LIST\n" + fields({7}) +
                 fields({901, 902}) + card.text() + "*INITIAL_VELOCITY_GENERATION\n" +
                 fields({2, 2, 0, 700, -400, 3000}) + fields({0}) + "*END\n");
  ASSERT_EQ(run.ties().ties.size(), 4u);
  for (const weld::Tie& tie : run.ties().ties) ASSERT_TRUE(tie.by_area());
  std::vector<Spr3Momenta> seen;
  double worst = 0.0, scale = 0.0;
  run.run([&](const impact::Snapshot& now) {
    if (now.state.cycle % 50 != 0) return;
    seen.push_back(spr3_momenta(now));
    scale = std::max(scale, now.energy.initial);
    worst = std::max(worst, std::abs(now.energy.total() - now.energy.initial));
  });
  EXPECT_EQ(run.simulation().components().connectors.failed(), 2);
  double drift = 0.0, turn = 0.0;
  for (const Spr3Momenta& m : seen) {
    drift = std::max(drift, norm(m.linear - seen[0].linear) / norm(seen[0].linear));
    turn = std::max(turn, norm(m.angular - seen[0].angular) / norm(seen[0].angular));
  }
  expect_reference(spr3_case, "free assembly: drift of the linear momentum in 8,000 cycles", drift, 0.0, 1e-12, 1.0);
  expect_reference(spr3_case, "free assembly: drift of the angular momentum in 8,000 cycles", turn, 0.0, 1e-9, 1.0);
  expect_reference(spr3_case, "free assembly: energy balance in 8,000 cycles", worst / scale, 0.0, 1e-9, 1.0);
}

// A sheet, next to rigid, on one weld at its middle over a held one: it swings along the normal with the mass of the
// sheet and half of the weld's. Sabotage: STIFF2 for STIFF; the weld's mass left out.
TEST(InterpolationSpotwelds, ModeAlongTheNormal) {
  const Spr3Card card;
  const SheetMesh lower{.first = 1, .part = 1, .corner = {}, .nx = 2, .ny = 2};
  const SheetMesh upper{.first = 101, .part = 2, .corner = {0, 0, 1.5}, .nx = 2, .ny = 2};
  std::string held = "*BOUNDARY_SPC_NODE\n";
  for (int n = 1; n <= 9; ++n) held += fields({1.0 * n, 0, 1, 1, 1, 1, 1, 1});
  const double density = 7.8e-9;
  LinearExperiment linear("*KEYWORD\n" + termination(1.0) + "*PART\nfirst\n" + fields({1, 1, 1}) + "*PART\nsecond\n" +
                          fields({2, 1, 1}) + "*SECTION_SHELL\n" + fields({1, 16, 0.8333, 3}) +
                          fields({1.5, 1.5, 1.5, 1.5}) + "*MAT_ELASTIC\n" + fields({1, density, 2.1e9, 0.3}) +
                          lower.text() + upper.text() + "*NODE\n" + node_line(901, 10.0, 10.0, 0.75) +
                          "*SET_NODE_LIST\n" + fields({7}) + fields({901}) + held + card.text() + "*END\n");
  const nvh::Modes modes = linear.modes(6);
  const double mass = density * 1.5 * 400.0 + 0.5 * card.density * card.area() * card.thick;
  const double wanted = std::sqrt(card.stiffness / mass) / (2.0 * std::numbers::pi);
  double closest = 0.0;
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i)
    if (std::abs(modes.frequency(i) - wanted) < std::abs(closest - wanted)) closest = modes.frequency(i);
  expect_reference(spr3_case, "mode of a stiff sheet on one weld, along the normal [Hz]", closest, wanted, 2e-3);
}

}  // namespace
}  // namespace nugget::verify
