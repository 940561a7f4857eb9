// SPDX-License-Identifier: Apache-2.0
// Contact that node against segment cannot see: edge on edge; and faces that are exposed as bricks fail.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

/// Two plates of 60 x 30 x 1 that stand on each other crosswise, edge on edge, the upper one coming down. No node of
/// either is nearer than 1.5 thicknesses to the other plate.
struct CrossedPlates {
  Grid lower, upper;
  std::string deck;

  /// `contact`: its keyword and cards.
  CrossedPlates(const std::string& contact, double speed, double end) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.3});
    s.text("*SECTION_SHELL\n" + fields({1, 2, 1, 2}) + fields({1, 1, 1, 1})).part(1, 1, 1).part(2, 1, 1);
    lower = standing(s, 1, {-32.5, 0.0, -30.0}, {1.0, 0.0, 0.0});
    upper = standing(s, 2, {0.0, -32.5, 1.05}, {0.0, 1.0, 0.0});
    s.text(contact);
    s.card("CONTROL_ENERGY", {2, 2, 2, 2});
    s.card("INITIAL_VELOCITY_GENERATION", {2, 2, 0, 0, 0, -speed}).text(fields({}));
    s.card("CONTROL_TERMINATION", {end});
    deck = s.deck();
  }

  /// 13 x 6 shells of 5 mm from `corner` on, along `along` and upward.
  static Grid standing(Specimen& s, int part, const Vec3d& corner, const Vec3d& along) {
    Grid grid;
    grid.cells = {13, 6, 0};
    for (int j = 0; j <= 6; ++j)
      for (int i = 0; i <= 13; ++i) {
        const int id = s.node(corner + 5.0 * i * along + Vec3d{0.0, 0.0, 5.0 * j});
        if (i == 0 && j == 0) grid.first = id;
      }
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 13; ++i) s.shell(part, {grid(i, j), grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1)});
    return grid;
  }
};

struct Meeting {
  double nearest = 1e300;  ///< height of the upper plate's middle above the lower one's at the worst [mm]
  double apart = 0.0;      ///< speed at which they part at the end [mm/s]
  double momentum = 0.0;   ///< sum at the end over that at the start
  double energy = 1.0;     ///< energy ratio farthest from 1
  double contact = 0.0;    ///< energy left in the contact, over the first kinetic one
  double stored = 0.0;     ///< the greatest there, over the first kinetic one
  double stiffness = 0.0;  ///< of the contact as one spring, F^2/2E, where it stores most [force/length]
  double impulse = 0.0;    ///< of the force on SURFA that is written, upward, over what the lower plate has got
};

/// `bodies`: with grids of nodes `lower` and `upper`, and a deck.
template <class Bodies>
Meeting meet(const Bodies& bodies) {
  Experiment experiment(bodies.deck);
  Meeting m;
  double first = 0.0, kinetic = 0.0, impulse = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    Vec3d sum[2];
    double height[2] = {0.0, 0.0}, mass[2] = {0.0, 0.0};
    for (int p = 0; p < 2; ++p)
      for (int id : (p == 0 ? bodies.lower : bodies.upper).all()) {
        const std::size_t k = experiment.node(id);
        sum[p] += now.system.mass[k] * vec(now.state.v[k]);
        height[p] += now.system.mass[k] * now.state.x[k].z;
        mass[p] += now.system.mass[k];
      }
    if (now.state.cycle == 0) {
      first = (sum[0] + sum[1]).z;
      kinetic = now.energy.kinetic;
    }
    m.nearest = std::min(m.nearest, height[1] / mass[1] - height[0] / mass[0]);
    m.apart = sum[1].z / mass[1] - sum[0].z / mass[0];
    m.momentum = norm(sum[0] + sum[1] - Vec3d{0.0, 0.0, first}) / std::abs(first);
    m.contact = now.energy.contact / kinetic;
    if (m.contact > m.stored) {
      std::vector<unsigned char> lower(now.state.x.size(), 0);
      for (int id : bodies.lower.all()) lower[experiment.node(id)] = 1;
      const Vec3d force = now.components.contacts.all()[0].force_on(lower);
      m.stiffness = dot(force, force) / (2.0 * now.energy.contact);
    }
    m.stored = std::max(m.stored, m.contact);
    impulse += now.components.contacts.all()[0].resultant().z * now.velocity_interval();
    m.impulse = impulse / sum[0].z;
    if (std::abs(now.energy.ratio() - 1.0) > std::abs(m.energy - 1.0)) m.energy = now.energy.ratio();
  });
  return m;
}

Meeting meet(const std::string& contact, double speed, double end) {
  return meet(CrossedPlates(contact, speed, end));
}

std::string all_by_all(const std::string& keyword) {
  return "*" + keyword + "\n" + fields({0, 0, 5}) + fields({}) + fields({});
}

/// Both bodies have turned back, with momentum and energy kept, and their middles came no nearer than `nearest`.
void expect_rebound(const std::string& what, const Meeting& m, double nearest = 29.0) {
  EXPECT_GT(m.apart, 0.0) << what;
  EXPECT_GT(m.nearest, nearest) << what;
  expect_reference("edges", what + ", sum of momenta less the first, of the first", m.momentum, 0.0, 1e-12, 1.0);
  expect_reference("edges", what + ", worst energy ratio", m.energy, 1.0, 0.01);
  expect_reference("edges", what + ", energy left in the contact, of the first", m.contact, 0.0, 0.01, 1.0);
}

// Sabotage: *CONTACT_AUTOMATIC_GENERAL read as *CONTACT_AUTOMATIC_SINGLE_SURFACE; reactions on the second edge left
// out.
TEST(EdgeContact, APlateDroppedOnAnEdgeDoesNotTunnel) {
  for (const double speed : {15000.0, 30000.0}) {
    const std::string which = std::to_string(static_cast<int>(speed / 1000.0)) + " m/s";
    expect_rebound("crossed plates, " + which, meet(all_by_all("CONTACT_AUTOMATIC_GENERAL"), speed, 2e-4));
  }
}

// SOFT = 2 with DEPTH = 5, of a surface with itself and of two surfaces. Sabotage: edges left out; edges of one side
// against their like.
TEST(EdgeContact, SegmentBasedContactSeesEdges) {
  const std::string card_a = fields({2, 0.1, 0, 0, 2, 5});
  const std::string two_sides =
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + fields({1, 2, 3, 3}) + fields({}) + fields({});
  expect_rebound("crossed plates, 15 m/s, SOFT 2",
                 meet(all_by_all("CONTACT_AUTOMATIC_SINGLE_SURFACE") + card_a, 15000.0, 2e-4));
  const Meeting of_two = meet(two_sides + card_a, 15000.0, 2e-4);
  expect_rebound("crossed plates, 15 m/s, SOFT 2 of two surfaces", of_two);
  expect_reference("edges", "crossed plates, two surfaces, impulse on SURFA over its momentum", of_two.impulse, 1.0,
                   1e-9);
}

/// Two upright plates, crosswise, edge over edge, the upper one coming down. The edges cross `a` and `b` of an element
/// from a node of either.
struct UprightPlates {
  Grid lower, upper;
  std::string deck;

  UprightPlates(const std::string& contact, double a, double b, double angle) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.3});
    s.text("*SECTION_SHELL\n" + fields({1, 16, 1, 3}) + fields({1, 1, 1, 1}));
    s.part(1, 1, 1).part(2, 1, 1).text(contact);
    s.card("CONTROL_ENERGY", {2, 2, 2, 2}).card("CONTROL_TERMINATION", {2e-4});
    const auto plate = [&s](int part, double along_x, double along_y, double shift, double z) {
      Grid grid;
      grid.cells = {6, 6, 0};
      for (int j = 0; j <= 6; ++j)
        for (int i = 0; i <= 6; ++i) {
          const double along = 5.0 * (i - 3 + shift);
          const int id = s.node({along * along_x, along * along_y, z + 5.0 * j});
          if (i == 0 && j == 0) grid.first = id;
        }
      for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i) s.shell(part, {grid(i, j), grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1)});
      return grid;
    };
    lower = plate(1, 1.0, 0.0, a, -30.0);
    upper = plate(2, std::cos(angle), std::sin(angle), b, 1.05);
    s.card("INITIAL_VELOCITY_GENERATION", {2, 2, 0, 0, 0, -10000.0}).text(fields({}));
    deck = s.deck();
  }
};

// Edges that cross at nodes, beside them or over the middle of an element keep the energy, and are as soft everywhere.
/// Upright plates whose edges cross at an angle [degrees], `a` and `b` of an element off their nodes.
Meeting meet_upright(bool by_segments, double angle, double a, double b, std::string& what) {
  const std::string contact = by_segments
                                  ? all_by_all("CONTACT_AUTOMATIC_SINGLE_SURFACE") + fields({2, 0.1, 0, 0, 2, 5})
                                  : all_by_all("CONTACT_AUTOMATIC_GENERAL");
  char text[120];
  std::snprintf(text, sizeof text, "upright plates%s, %g degrees, %g and %g off nodes", by_segments ? ", SOFT 2" : "",
                angle, a, b);
  what = text;
  const Meeting m = meet(UprightPlates(contact, a, b, angle * std::numbers::pi / 180.0));
  expect_rebound(text, m);
  return m;
}

// Sabotage: lines that bend at a node meet twice (up to 12 times the energy); nodes on an edge meet the other plate's
// edge as well (3 times as stiff); a bound of the stiffness that changes along the edge (36 to 62 N/um).
TEST(EdgeContact, EdgesCrossAnywhereAlongThem) {
  std::string what;
  for (const bool by_segments : {false, true})
    for (const double angle : {90.0, 50.0}) {
      double between_nodes = 0.0;
      for (const auto& [a, b] : {std::pair{0.3, 0.4}, {0.0, 0.0}, {0.01, 0.0}, {0.02, 0.03}, {0.0, 0.5}, {0.0, 0.25}}) {
        const Meeting m = meet_upright(by_segments, angle, a, b, what);
        if (between_nodes == 0.0) between_nodes = m.stiffness;
        expect_reference("edges", what + ", stiffness of the contact", m.stiffness, between_nodes, 0.02);
      }
    }
}

// Edges that cross at small angles lie close to each other over a long way, and have more than one place where they
// are closest once they bend. Sabotage: a spring at each of these (7 degrees: 5.4 % of the energy).
TEST(EdgeContact, EdgesCrossAtSmallAngles) {
  std::string what;
  for (const bool by_segments : {false, true})
    for (const double angle : {20.0, 13.0, 9.0, 7.0, 5.0, 1.0, 0.0})
      for (const auto& [a, b] : {std::pair{0.0, 0.0}, {0.0, 0.5}, {0.25, 0.1}, {0.02, 0.03}})
        meet_upright(by_segments, angle, a, b, what);
}

// Nodes against segments alone let the plates cut into each other: the case is one for edges.
TEST(EdgeContact, NodesAgainstSegmentsDoNotSeeIt) {
  EXPECT_LT(meet(all_by_all("CONTACT_AUTOMATIC_SINGLE_SURFACE"), 15000.0, 2e-4).nearest, 29.0);
}

/// Two bars of 66 x 12 x 12 that stand on an edge, crosswise and ridge on ridge, `over` above each other, the upper one
/// coming down; its place may be taken by an upright plate. The ridges cross between their nodes.
struct CrossedRidges {
  static constexpr double half = 6.0, over = 0.05, speed = 5000.0;
  const double ridge = half * std::sqrt(2.0);
  Grid lower, upper;
  std::string deck;

  CrossedRidges(const std::string& contact, bool plate) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.3}).card("SECTION_SOLID", {1, 1});
    s.text("*SECTION_SHELL\n" + fields({2, 2, 1, 2}) + fields({1, 1, 1, 1})).part(1, 1, 1).part(2, plate ? 2 : 1, 1);
    lower = s.bricks(1, {11, 4, 4}, [this](int i, int j, int k) {
      const Vec3d p = across(j, k);
      return Vec3d{6.0 * i - 33.0, p.y, p.z - ridge};
    });
    if (plate)
      upper = CrossedPlates::standing(s, 2, {0.0, -32.5, 0.5 + over}, {0.0, 1.0, 0.0});
    else
      upper = s.bricks(2, {11, 4, 4}, [this](int i, int j, int k) {
        const Vec3d p = across(j, k);
        return Vec3d{-p.y, 6.0 * i - 33.0, p.z + ridge + over};
      });
    s.text(contact).card("CONTROL_ENERGY", {2, 2, 2, 2}).text("*HOURGLASS\n" + fields({1, 6, 0.1}));
    s.card("INITIAL_VELOCITY_GENERATION", {2, 2, 0, 0, 0, -speed}).text(fields({})).card("CONTROL_TERMINATION", {4e-4});
    deck = s.deck();
  }
  /// A square of 12 x 12 on its corner.
  static Vec3d across(int j, int k) {
    const double u = 3.0 * j - half, v = 3.0 * k - half;
    return {0.0, (u - v) * std::sqrt(0.5), (u + v) * std::sqrt(0.5)};
  }
  /// Height of the upper middle over the lower one when the ridges just touch.
  double touching(bool plate) const { return plate ? 15.5 + ridge : 2.0 * ridge; }
};

// SOFT = 2 with DEPTH = 5: edges of bricks on each other, and an edge of shells on one of bricks. With DEPTH = 2 they
// pass through each other. Sabotage: reactions on the second edge left out; normals of one brick alone.
TEST(EdgeContact, BricksMeetEdgeOnEdge) {
  const std::string by_all = all_by_all("CONTACT_AUTOMATIC_SINGLE_SURFACE");
  const std::string by_side =
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + fields({1, 2, 3, 3}) + fields({}) + fields({});
  for (const bool plate : {false, true}) {
    const std::string what = plate ? "plate on a ridge of bricks" : "crossed ridges of bricks";
    for (const auto& [name, contact] : {std::pair{", one surface", by_all}, std::pair{", two surfaces", by_side}}) {
      const CrossedRidges bodies(contact + fields({2, 0.1, 0, 0, 2, 5}), plate);
      expect_rebound(what + name, meet(bodies), bodies.touching(plate) - 0.9);
    }
    const CrossedRidges unseen(by_all + fields({2, 0.1, 0, 0, 2, 2}), plate);
    EXPECT_LT(meet(unseen).nearest, unseen.touching(plate) - 0.9);
  }
}

}  // namespace
}  // namespace nugget::verify
