// SPDX-License-Identifier: Apache-2.0
// What contact must keep: energy of elastic bodies that bounce off each other, their momentum, and where it is asked
// for, the moments of friction and of glue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double density = 7.85e-9;

Specimen steel_bodies(const std::string& contact, double end) {
  Specimen s;
  s.card("MAT_ELASTIC", {1, density, 210000.0, 0.3}).card("SECTION_SOLID", {1, 1});
  s.text("*SECTION_SHELL\n" + fields({2, 2, 1, 2}) + fields({1, 1, 1, 1}));
  s.text(contact).card("CONTROL_ENERGY", {2, 2, 2, 2}).card("CONTROL_TERMINATION", {end});
  return s;
}

std::string by_all(const std::string& form) {
  return "*CONTACT_AUTOMATIC_" + form + "\n" + fields({0, 0, 5}) + fields({}) + fields({});
}

std::string by_side(const std::string& form, double friction = 0.0) {
  return "*CONTACT_AUTOMATIC_" + form + "\n" + fields({2, 1, 3, 3}) + fields({friction, friction}) + fields({});
}

void velocity(Specimen& s, int part, const Vec3d& v) {
  s.card("INITIAL_VELOCITY_GENERATION", {1.0 * part, 2, 0, v.x, v.y, v.z}).text(fields({}));
}

/// The moment about the origin of what a contact does to all nodes, and the sum of their sizes [force length].
struct Moment {
  Vec3d sum;
  double sizes = 0.0;

  Moment(const impact::Snapshot& now, const contact::PenaltyContact& contact) {
    std::vector<unsigned char> marked(now.state.x.size(), 0);
    for (std::size_t n = 0; n < marked.size(); ++n) {
      marked[n] = 1;
      const Vec3d moment = cross(vec(now.state.x[n]), contact.force_on(marked));
      marked[n] = 0;
      sum += moment;
      sizes += norm(moment);
    }
  }
};

struct Bounce {
  double energy = 0.0;    ///< in the contact at the end, of the first kinetic one
  double momentum = 0.0;  ///< change of all, of the first
  double kinetic = 0.0;   ///< energy at the end
  double pull = 0.0;      ///< greatest force that draws the upper body down, of the greatest that presses it up
};

/// Part 2 comes down on part 1 and leaves again.
Bounce bounce(const std::string& deck) {
  Experiment experiment(deck);
  Bounce b;
  Vec3d first;
  double kinetic = 0.0, up = 0.0, down = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    Vec3d sum;
    for (std::size_t n = 0; n < now.state.v.size(); ++n) sum += now.system.mass[n] * vec(now.state.v[n]);
    if (now.state.cycle == 0) {
      first = sum;
      kinetic = now.energy.kinetic;
    }
    b.momentum = std::max(b.momentum, norm(sum - first) / norm(first));
    b.energy = now.energy.contact / kinetic;
    b.kinetic = now.energy.kinetic;
    const double force = -now.components.contacts.all()[0].resultant().z;  // on part 2, SURFA where there are sides
    up = std::max(up, -force);
    down = std::max(down, force);
  });
  b.pull = up > 0.0 ? down / up : 0.0;
  return b;
}

void expect_bounce(const std::string& what, const Bounce& b) {
  expect_reference("bounce", what + ", energy left in the contact, of the first", b.energy, 0.0, 0.01, 1.0);
  expect_reference("bounce", what + ", change of momentum, of the first", b.momentum, 0.0, 1e-12, 1.0);
}

// All nodes of a plate meet the other one in the same cycle, at any part of a step. Sabotage: force k depth in the
// first and the last cycle too (7 % too much energy).
TEST(ContactBalance, PlatesPartWithTheEnergyThatTheyCameWith) {
  for (const std::string form : {"SINGLE_SURFACE", "SURFACE_TO_SURFACE", "NODES_TO_SURFACE", "GENERAL"})
    for (const double shift : {0.0, 0.7, 2.5})
      for (const double speed : {15000.0, 30000.0}) {
        const bool alone = form == "SINGLE_SURFACE" || form == "GENERAL";
        Specimen s = steel_bodies(alone ? by_all(form) : by_side(form), 5e-5);
        s.part(1, 2, 1).part(2, 2, 1);
        s.shells(1, {0.0, 0.0, 0.0}, {30.0, 30.0, 0.0}, 6, 6);
        s.shells(2, {shift, 1.5 * shift, 1.05}, {30.0, 30.0, 0.0}, 6, 6);
        velocity(s, 2, {0.0, 0.0, -speed});
        expect_bounce("plates, " + form + ", " + std::to_string(shift).substr(0, 3) + " mm off, " +
                          std::to_string(static_cast<int>(speed / 1000.0)) + " m/s",
                      bounce(s.deck()));
      }
}

// Meshes corner over corner, where edges as well as nodes meet. Sabotage: edges with all their stiffness there (16 %).
TEST(ContactBalance, EdgesLeaveNodesToNodes) {
  for (const std::string form : {"SINGLE_SURFACE", "GENERAL_INTERIOR"}) {
    const std::string card_a = form == "SINGLE_SURFACE" ? fields({2, 0.1, 0, 0, 2, 5}) : std::string{};
    Specimen s = steel_bodies(by_all(form) + card_a, 6e-5);
    s.part(1, 2, 1).part(2, 2, 1);
    s.shells(1, {0.0, 0.0, 0.0}, {30.0, 30.0, 0.0}, 6, 6);
    s.shells(2, {0.0, 0.0, 1.05}, {30.0, 30.0, 0.0}, 6, 6);
    velocity(s, 2, {0.0, 0.0, -15000.0});
    expect_bounce("plates corner over corner, edges, " + form, bounce(s.deck()));
  }
}

// Sheets that lie flat on each other, turned or aligned, at rest or sliding: nodes meet segments, and of the edges that
// cross there none has anything to add. Sabotage: edges of a flat sheet press as ridges do (aligned, sliding:
// 2.5 % of the energy of the approach).
TEST(ContactBalance, EdgesOfFlatSheetsHaveNothingToAdd) {
  for (const bool by_segments : {false, true})
    for (const double turn : {0.0, 0.3})
      for (const double slide : {0.0, 20000.0}) {
        const std::string contact =
            by_segments ? by_all("SINGLE_SURFACE") + fields({2, 0.1, 0, 0, 2, 5}) : by_all("GENERAL_INTERIOR");
        Specimen s = steel_bodies(contact, 6e-5);
        s.part(1, 2, 1).part(2, 2, 1);
        s.shells(1, {0.0, 0.0, 0.0}, {30.0, 30.0, 0.0}, 6, 6);
        const double c = 5.0 * std::cos(turn), d = 5.0 * std::sin(turn), off = turn > 0.0 ? 1.3 : 0.0;
        std::vector<int> node;
        for (int j = 0; j <= 6; ++j)
          for (int i = 0; i <= 6; ++i) node.push_back(s.node({off + c * i - d * j, 1.5 * off + d * i + c * j, 1.05}));
        for (std::size_t j = 0; j < 6; ++j)
          for (std::size_t i = 0; i < 6; ++i) {
            const std::size_t k = 7 * j + i;
            s.shell(2, {node[k], node[k + 1], node[k + 8], node[k + 7]});
          }
        velocity(s, 2, {slide, 0.6 * slide, -5000.0});
        const Bounce b = bounce(s.deck());
        const double approach = 1.0 / (1.0 + 1.36 * slide * slide / 25e6);  // its part of the first energy
        const std::string what = std::string(by_segments ? "SOFT 2" : "GENERAL_INTERIOR") +
                                 (turn > 0.0 ? ", turned" : ", aligned") + (slide > 0.0 ? ", sliding" : "");
        expect_reference("bounce", "sheets flat on each other, " + what + ", energy left, of that of the approach",
                         b.energy / approach, 0.0, 0.01, 1.0);
        expect_reference("bounce", "sheets flat on each other, " + what + ", change of momentum, of the first",
                         b.momentum, 0.0, 1e-12, 1.0);
      }
}

/// Part of its velocity with which a mass leaves a spring and a dashpot of `damping` (1: critical) that press but do
/// not pull: force 2 damping w v + w^2 x, until it is 0.
double restitution(double damping) {
  const double s = std::sqrt(1.0 - damping * damping);
  return std::exp(-2.0 * damping / s * std::acos(damping));
}

/// Two shells of one element, `heavy` times as dense the lower one, come together node on node.
Bounce damped(const std::string& form, double heavy, double vdc, double slsfac) {
  Specimen s;
  s.card("MAT_ELASTIC", {1, heavy * density, 210000.0, 0.3}).card("MAT_ELASTIC", {2, density, 210000.0, 0.3});
  s.text("*SECTION_SHELL\n" + fields({2, 2, 1, 2}) + fields({1, 1, 1, 1}));
  s.text("*CONTACT_AUTOMATIC_" + form + "\n" + fields({2, 1, 3, 3}) + fields({0, 0, 0, 0, vdc}) + fields({}));
  s.text("*CONTROL_CONTACT\n" + fields({slsfac}) + fields({}));
  s.card("CONTROL_ENERGY", {2, 2, 2, 2}).card("CONTROL_TERMINATION", {slsfac < 0.01 ? 1e-3 : 2e-4});
  s.part(1, 2, 1).part(2, 2, 2);
  s.shells(1, {0.0, 0.0, 0.0}, {10.0, 10.0, 0.0}, 1, 1);
  s.shells(2, {0.0, 0.0, 1.05}, {10.0, 10.0, 0.0}, 1, 1);
  velocity(s, 2, {0.0, 0.0, -2000.0});
  return bounce(s.deck());
}

// VDC: percent of 2 m w with the lesser mass m, w of both masses (keyword manual). Sabotage: of 2 m* w (0.57 instead of
// 0.37 for masses alike, VDC = 20).
TEST(ContactBalance, DampingIsThatOfTheCard) {
  for (const double heavy : {1.0, 1000.0})
    for (const double vdc : {10.0, 20.0, 40.0}) {
      const Bounce b = damped("NODES_TO_SURFACE", heavy, vdc, 0.0001);
      // The lower shell stood still: of the first kinetic energy the motion of both about their centre has this part.
      const double share = heavy / (1.0 + heavy), e = restitution(0.01 * vdc * (1.0 + 1.0 / heavy));
      expect_reference("bounce",
                       "VDC " + std::to_string(static_cast<int>(vdc)) + (heavy > 1.0 ? ", on a heavy body" : "") +
                           ", energy taken, of the first",
                       b.energy, share * (1.0 - e * e), 0.02);
    }
}

// However strong, damping takes energy: also at full stiffness, where a pair of each side meets at every node.
// Sabotage: it acts on the velocity of the step before (the shells part at 2.7 times the speed with VDC = 100).
TEST(ContactBalance, DampingNeverGivesEnergy) {
  for (const std::string form : {"NODES_TO_SURFACE", "SURFACE_TO_SURFACE"})
    for (const double vdc : {20.0, 60.0, 100.0}) {
      const Bounce b = damped(form, 1.0, vdc, 0.1);
      EXPECT_GT(b.energy, 0.5 * (1.0 - 0.7 * 0.7)) << form << vdc;
      EXPECT_LT(b.energy, 0.5 + 1e-9) << form << vdc;
      expect_reference("bounce", form + ", VDC " + std::to_string(static_cast<int>(vdc)) + ", change of momentum",
                       b.momentum, 0.0, 1e-12, 1.0);
    }
}

// A contact that is activated while one plate is on its way through the other, beyond the middle already: it has
// nothing to give to a motion that leads out. Sabotage: the way of the step taken for a penetration, whichever its
// direction (the plate is thrown off with 2.5 times its energy).
TEST(ContactBalance, BirthWithinAnotherBodyGivesNothing) {
  for (const std::string form : {"SINGLE_SURFACE", "GENERAL"}) {
    const std::string contact =
        "*CONTACT_AUTOMATIC_" + form + "\n" + fields({0, 0, 5}) + fields({0, 0, 0, 0, 0, 0, 1.2e-4}) + fields({});
    Specimen s = steel_bodies(contact, 2e-4);
    s.part(1, 2, 1).part(2, 2, 1);
    s.shells(1, {0.0, 0.0, 0.0}, {30.0, 30.0, 0.0}, 6, 6);
    s.shells(2, {3.3, 2.1, 1.05}, {20.0, 20.0, 0.0}, 4, 4);
    velocity(s, 2, {0.0, 0.0, -10000.0});
    expect_bounce("starts within the other plate, " + form, bounce(s.deck()));
  }
}

// Blocks whose sides are flush: a node that leaves the face that it came onto is level with those beside it, before or
// behind them by round-off, which is another one in each direction. Sabotage: its distance from their edge taken for
// its depth (11 % lost, and blocks that stick); the closest face taken for the one that it came through (2 %, turned).
TEST(ContactBalance, FlushBlocksDoNotStick) {
  for (const std::string form : {"SURFACE_TO_SURFACE", "NODES_TO_SURFACE"}) {
    double straight = 0.0;
    for (const double turn : {0.0, 0.5}) {
      const auto turned = [turn](const Vec3d& p) {
        return Vec3d{std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y, p.z};
      };
      Specimen s = steel_bodies(by_side(form), 4e-5);
      s.part(1, 1, 1).part(2, 1, 1);
      for (const int part : {1, 2})
        s.bricks(part, {4, 4, 2}, [&](int i, int j, int k) {
          return turned({5.0 * i, 5.0 * j, 5.0 * k + (part == 1 ? -10.0 : 0.02)});
        });
      velocity(s, 2, {0.0, 0.0, -5000.0});
      const Bounce b = bounce(s.deck());
      const std::string what = "flush blocks, " + form + (turn > 0.0 ? ", turned" : "");
      expect_bounce(what, b);
      expect_reference("bounce", what + ", pull between them, of the greatest push", b.pull, 0.0, 1e-3, 1.0);
      if (turn > 0.0)
        expect_reference("bounce", what + ", kinetic energy at the end", b.kinetic, straight, 1e-4);
      else
        straight = b.kinetic;
    }
  }
}

// Sheets that slide on each other: friction acts at both mid-surfaces, a millimetre apart. With FTORQ that couple is
// balanced; without, it is friction times that millimetre. Sabotage: the couple in the other direction.
TEST(ContactBalance, MomentsOfFriction) {
  for (const bool balanced : {false, true})
    for (const bool bricks : {false, true}) {
      // Cards A to E: SOFT 0, FRICSF 1, FTORQ.
      const std::string cards =
          fields({0}) + fields({}) + fields({}) + fields({}) + fields({0, 0, 0, 0, 1, 0, balanced ? 1.0 : 0.0});
      Specimen s = steel_bodies(by_side("SURFACE_TO_SURFACE", 0.3) + cards, 2e-5);
      s.part(1, bricks ? 1 : 2, 1).part(2, 2, 1);
      if (bricks)
        s.bricks(1, {0.0, 0.0, -9.5}, {30.0, 30.0, 10.0}, {6, 6, 2});
      else
        s.shells(1, {0.0, 0.0, 0.0}, {30.0, 30.0, 0.0}, 6, 6);
      s.shells(2, {4.0, 3.0, 1.01}, {20.0, 20.0, 0.0}, 5, 5);
      velocity(s, 2, {3000.0, 2000.0, -4000.0});
      Experiment experiment(s.deck());
      double worst = 0.0, energy = 1.0;
      run_to_end(experiment, [&](const impact::Snapshot& now) {
        const Moment moment(now, now.components.contacts.all()[0]);
        if (moment.sizes > 0.0) worst = std::max(worst, norm(moment.sum) / moment.sizes);
        energy = now.energy.ratio();
      });
      const std::string what = bricks ? "a sheet on a block" : "a sheet on a sheet";
      if (balanced)
        expect_reference("bounce", "FTORQ, " + what + ", moment of contact, of the sizes", worst, 0.0, 1e-12, 1.0);
      else
        EXPECT_GT(worst, 1e-3) << what;
      EXPECT_NEAR(energy, 1.0, 1e-6) << what;
    }
}

/// Momentum of nodes, by their ids.
Vec3d momentum_of(const Experiment& experiment, const impact::Snapshot& now, const std::vector<int>& ids) {
  Vec3d sum;
  for (const int id : ids) sum += now.system.mass[experiment.node(id)] * vec(now.state.v[experiment.node(id)]);
  return sum;
}

/// An elastic plate, of part 2, above a rigid one of `density`, of part 1; the rigid one's *MAT_RIGID card is `held`.
Grid plate_over_tool(Specimen& s, double tool, const std::string& held) {
  s.text("*MAT_RIGID\n" + fields({1, tool, 210000.0, 0.3}) + held + fields({}));
  s.card("MAT_ELASTIC", {2, density, 210000.0, 0.3});
  s.text("*SECTION_SHELL\n" + fields({2, 2, 1, 2}) + fields({1, 1, 1, 1}));
  s.card("CONTROL_ENERGY", {2, 2, 2, 2}).part(1, 2, 1).part(2, 2, 2);
  s.shells(1, {-15.0, -15.0, 0.0}, {60.0, 60.0, 0.0}, 12, 12);
  return s.shells(2, {0.7, 1.05, 1.02}, {30.0, 30.0, 0.0}, 6, 6);
}

// A plate comes down obliquely, slides all the time, and leaves: friction has taken the coefficient times what it has
// changed its velocity by across (Coulomb, integrated over the touch). It lasts four cycles or so. Sabotage: friction
// from the second cycle on (0.159 to 0.197 of 0.2).
TEST(ContactBalance, FrictionOfABounce) {
  constexpr double friction = 0.2;
  for (const std::string form : {"SINGLE_SURFACE", "SURFACE_TO_SURFACE", "NODES_TO_SURFACE", "GENERAL"})
    for (const Vec3d& v : {Vec3d{10000.0, 0.0, -1000.0}, Vec3d{40000.0, 0.0, -5000.0}, Vec3d{40000.0, 15000.0, -2e4}}) {
      const bool alone = form == "SINGLE_SURFACE" || form == "GENERAL";
      Specimen s;
      const Grid plate = plate_over_tool(s, density, fields({1, 7, 7}));
      s.text("*CONTACT_AUTOMATIC_" + form + "\n" + (alone ? fields({0, 0, 5}) : fields({2, 1, 3, 3})) +
             fields({friction, friction}) + fields({}));
      velocity(s, 2, v);
      s.card("CONTROL_TERMINATION", {4e-5});
      Experiment experiment(s.deck());
      Vec3d first, last;
      run_to_end(experiment, [&](const impact::Snapshot& now) {
        last = momentum_of(experiment, now, plate.all());
        if (now.state.cycle == 0) first = last;
      });
      const Vec3d change = last - first;
      expect_reference("bounce",
                       "oblique plate, " + form + ", " + std::to_string(static_cast<int>(-v.z / 1000.0)) +
                           " m/s, impulse along the surface, of that across",
                       std::hypot(change.x, change.y) / change.z, friction, 0.02);
    }
}

// Nothing can move a tool that is held, or driven, whatever its density: a plate comes back from the one, and leaves
// the other at twice its speed (less what goes into its own vibration). Sabotage: the mass of its mesh (the plate goes
// through).
TEST(ContactBalance, ToolsThatAreHeldNeedNoMass) {
  constexpr double speed = 5000.0;
  for (const double soft : {0.0, 1.0, 2.0})
    for (const bool driven : {false, true}) {
      Specimen s;
      const Grid plate = plate_over_tool(s, 1e-18, fields({1, driven ? 4.0 : 7.0, 7}));
      s.text(by_side("SURFACE_TO_SURFACE") + fields({soft}));
      if (driven)
        s.card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {1, 3, 0, 8, 1}).text(constant_curve(8, speed));
      else
        velocity(s, 2, {0.0, 0.0, -speed});
      s.card("CONTROL_TERMINATION", {6e-5});
      Experiment experiment(s.deck());
      double last = 0.0, mass = 0.0;
      run_to_end(experiment, [&](const impact::Snapshot& now) {
        last = momentum_of(experiment, now, plate.all()).z;
        mass = 0.0;
        for (const int id : plate.all()) mass += now.system.mass[experiment.node(id)];
      });
      expect_reference("bounce",
                       std::string(driven ? "plate pushed by a tool" : "plate on a tool") + " without mass, SOFT " +
                           std::to_string(static_cast<int>(soft)) + ", mean velocity after, of the first",
                       last / (mass * speed), driven ? 2.0 : 1.0, 0.05);
    }
}

// *PART_INERTIA gives a rigid plate a seventieth of the mass of its mesh; it comes back from an elastic one. Sabotage:
// the mass of its mesh, for which the contact is stiff, while it is the body that must bear it (ten times its energy).
TEST(ContactBalance, LightRigidBodyOfAHeavyMesh) {
  constexpr double speed = 5000.0, mass = 1e-7, above = 1.12;
  for (const int cells : {4, 6, 12}) {
    Specimen s;
    s.card("MAT_ELASTIC", {1, 2.7e-9, 70000.0, 0.33});
    s.text("*MAT_RIGID\n" + fields({2, density, 210000.0, 0.3}) + fields({}) + fields({}));
    s.text("*SECTION_SHELL\n" + fields({2, 2, 1, 2}) + fields({1, 1, 1, 1})).part(1, 2, 1);
    s.text("*PART_INERTIA\nlight\n" + fields({2, 2, 2}) + fields({15.0, 15.0, above, mass}) +
           fields({75.0 * mass, 0, 0, 75.0 * mass, 0, 150.0 * mass}) + fields({0, 0, -speed}));
    s.text(by_side("SURFACE_TO_SURFACE")).card("CONTROL_ENERGY", {2, 2, 2, 2}).card("CONTROL_TERMINATION", {2e-4});
    s.shells(1, {-10.3, -10.7, 0.0}, {50.0, 50.0, 0.0}, 10, 10);
    s.shells(2, {0.0, 0.0, above}, {30.0, 30.0, 0.0}, cells, cells);
    Experiment experiment(s.deck());
    double first = 0.0, left = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      if (now.state.cycle == 0) first = now.energy.kinetic;
      left = now.energy.contact;
    });
    expect_reference("bounce",
                     "light rigid body of a heavy mesh of " + std::to_string(cells * cells) +
                         " shells, energy left in the contact, of the first",
                     left / first, 0.0, 0.05, 1.0);
  }
}

// Sheets that slide over each other without friction, nodes over the segments of a larger sheet. Sabotage: a pair that
// parts in the middle of a step leaves what its spring still has (1.9 %).
TEST(ContactBalance, NodesThatSlideOverSegments) {
  for (const std::string form : {"SINGLE_SURFACE", "SURFACE_TO_SURFACE", "NODES_TO_SURFACE", "GENERAL"})
    for (const double slide : {0.0, 20000.0, 60000.0, 150000.0})
      for (const double speed : {2000.0, 5000.0, 15000.0}) {
        const bool alone = form == "SINGLE_SURFACE" || form == "GENERAL";
        Specimen s = steel_bodies(alone ? by_all(form) : by_side(form), 6e-5);
        s.part(1, 2, 1).part(2, 2, 1);
        s.shells(1, {-15.0, -15.0, 0.0}, {60.0, 60.0, 0.0}, 12, 12);
        s.shells(2, {0.7, 1.05, 1.02}, {30.0, 30.0, 0.0}, 6, 6);
        velocity(s, 2, {slide, 0.6 * slide, -speed});
        const Bounce b = bounce(s.deck());
        const double approach = 1.0 / (1.0 + 1.36 * slide * slide / (speed * speed));  // its part of the first energy
        expect_reference("bounce",
                         "sheet over a larger one, " + form + ", " + std::to_string(static_cast<int>(slide / 1000.0)) +
                             " m/s along, " + std::to_string(static_cast<int>(speed / 1000.0)) +
                             " m/s across, energy left, of that of the approach",
                         b.energy / approach, 0.0, 0.01, 1.0);
      }
}

/// A block that lies on a larger one, their common face an arc of `radius` (0: plane), the upper one turned by `turn`.
/// It is pressed onto it by 20 N/mm2 and slides along x; the lower one may be two blocks, with a `joint` of that width
/// between them.
Specimen block_on_block(const std::string& contact, double turn, double radius, double slide, double joint = 0.0) {
  constexpr double pressure = 20.0, height = 10.0;
  Specimen s = steel_bodies(contact, 6e-4);
  s.part(1, 1, 1).part(2, 1, 1);
  const auto arc = [radius](const Vec3d& p) {
    return radius == 0.0 ? p : Vec3d{p.x, p.y, p.z - 0.5 * (p.x - 10.0) * (p.x - 10.0) / radius};
  };
  std::vector<int> held;
  const auto lower = [&](double from, int cells) {
    const Grid block = s.bricks(1, {cells, 10, 2}, [&](int i, int j, int k) {
      return arc({from + 5.0 * i, 5.0 * j - 15.0, 5.0 * k - 10.0});
    });
    for (int j = 0; j <= 10; ++j)
      for (int i = 0; i <= cells; ++i) held.push_back(block(i, j, 0));
  };
  if (joint > 0.0) {
    lower(-15.0, 7);
    lower(20.0 + joint, 5);
  } else {
    lower(-15.0, 12);
  }
  const double start = joint > 0.0 ? -5.7 : 3.3;
  s.bricks(2, {4, 4, 2}, [&](int i, int j, int k) {
    const double x = 5.0 * i, y = 5.0 * j;
    return arc({start + std::cos(turn) * x - std::sin(turn) * y, -6.7 + std::sin(turn) * x + std::cos(turn) * y,
                5.0 * k + 0.001});
  });
  s.node_set(1, held).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  s.text("*LOAD_BODY_Z\n" + fields({1, std::round(pressure / (density * height))}));
  s.text("*DEFINE_CURVE\n" + fields({1}) + "0.0, 0.0\n6e-5, 1.0\n1.0, 1.0\n");
  velocity(s, 2, {slide, 0.0, 0.0});
  return s;
}

/// Momentum of all nodes along x.
double momentum_along(const impact::Snapshot& now) {
  double sum = 0.0;
  for (std::size_t n = 0; n < now.state.v.size(); ++n) sum += now.system.mass[n] * now.state.v[n].x;
  return sum;
}

// Without friction nothing holds a block that slides on another one: its nodes pass the borders of faces, and its sides
// run over those of the other; with friction, the coefficient times the load does. Sabotage: nodes that were run over
// pressed out through the side; nodes that left a face pressed back over its border (either turns the block back).
TEST(ContactBalance, BlocksSlideOverBlocks) {
  constexpr double slide = 20000.0, coefficient = 0.05, load = 20.0 * 400.0, loaded = 6e-4 - 0.5 * 6e-5;
  for (const double friction : {0.0, coefficient})
    for (const std::string form : {"SINGLE_SURFACE", "SURFACE_TO_SURFACE", "NODES_TO_SURFACE", "SOFT 2"})
      for (const double turn : {0.0, 0.4}) {
        const std::string contact =
            form == "SOFT 2" ? by_side("SURFACE_TO_SURFACE", friction) + fields({2})
            : form == "SINGLE_SURFACE"
                ? "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + fields({0, 0, 5}) + fields({friction, friction}) + fields({})
                : by_side(form, friction);
        Experiment experiment(block_on_block(contact, turn, 0.0, slide).deck());
        double first = 0.0, last = 0.0;
        run_to_end(experiment, [&](const impact::Snapshot& now) {
          last = momentum_along(now);
          if (now.state.cycle == 0) first = last;
        });
        const std::string what = "block on a block, " + form + (turn > 0.0 ? ", turned" : "");
        if (friction == 0.0)
          expect_reference("bounce", what + ", momentum along, of the first", last / first, 1.0, 1e-3);
        else
          expect_reference("bounce", what + ", impulse of friction, of the coefficient's times the load's",
                           (first - last) / (friction * load * loaded), 1.0, 0.02);
      }
}

// Two blocks side by side, level, a slit between them: the one that slides over them does not catch on the second.
// Sabotage: its leading nodes, which are pressed a little below the level of the second block, pressed out of that
// one's side (it turns back).
TEST(ContactBalance, BlocksSlideOverJoints) {
  constexpr double slide = 20000.0;
  for (const std::string form : {"SINGLE_SURFACE", "NODES_TO_SURFACE"})
    for (const double turn : {0.0, 0.4})
      for (const double joint : {0.02, 1.0}) {
        const std::string contact = form == "SINGLE_SURFACE" ? by_all(form) : by_side(form);
        Experiment experiment(block_on_block(contact, turn, 0.0, slide, joint).deck());
        double first = 0.0, last = 0.0;
        run_to_end(experiment, [&](const impact::Snapshot& now) {
          last = momentum_along(now);
          if (now.state.cycle == 0) first = last;
        });
        expect_reference("bounce",
                         "block over a " + std::string(joint < 0.1 ? "joint" : "slit of 1 mm") + ", " + form +
                             (turn > 0.0 ? ", turned" : "") + ", momentum along, of the first",
                         last / first, 1.0, 5e-3);
      }
}

// The same on an arc, hollow or not: what contact does not give back, or makes, is missing in its energy. Sabotage: a
// face that goes on beyond the border to the next one of an arc (14 % made).
TEST(ContactBalance, BlocksSlideOverArcs) {
  constexpr double slide = 20000.0;
  for (const std::string form : {"SINGLE_SURFACE", "NODES_TO_SURFACE"})
    for (const double turn : {0.0, 0.4})
      for (const double radius : {-300.0, 300.0}) {
        const std::string contact = form == "SINGLE_SURFACE" ? by_all(form) : by_side(form);
        const Bounce b = bounce(block_on_block(contact, turn, radius, slide).deck());
        expect_reference("bounce",
                         std::string("block on ") + (radius < 0.0 ? "a hollow" : "an arch") + ", " + form +
                             (turn > 0.0 ? ", turned" : "") + ", energy in the contact, of the first kinetic one",
                         b.energy, 0.0, 0.01, 1.0);
      }
}

// Two sheets glued together slide against each other in their planes, freely. With OPTION -2 the lever between them
// counts, and glue makes no moment; with 2 it does. Sabotage: OPTION -2 read as 2.
TEST(ContactBalance, GlueThatHandsOverMoments) {
  const auto tiebreak = [](double option) {
    return "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n" + fields({2, 1, 3, 3}) + fields({}) + fields({}) +
           fields({option, 1e9, 1e9});
  };
  const auto tied = [](const std::string& form, double strength, double birth) {
    return "*CONTACT_TIED_" + form + "\n" + fields({2, 1, 3, 3}) + fields({strength, strength, 0, 0, 0, 0, birth}) +
           fields({});
  };
  const std::tuple<std::string, std::string, bool> contacts[] = {
      {"glue, OPTION 2", tiebreak(2), false},
      {"glue, OPTION -2", tiebreak(-2), true},
      {"failing tie", tied("SURFACE_TO_SURFACE_FAILURE", 1e9, 0.0), true},
      {"tie from 0.01 ms on", tied("NODES_TO_SURFACE", 0.0, 1e-5), true},
      {"tie by springs from 0.01 ms on", tied("NODES_TO_SURFACE_OFFSET", 0.0, 1e-5), false},
  };
  for (const auto& [name, contact, balanced] : contacts) {
    Specimen s = steel_bodies(contact, 5e-5);
    s.part(1, 2, 1).part(2, 2, 1);
    s.shells(1, {0.0, 0.0, 0.0}, {20.0, 20.0, 0.0}, 4, 4);
    s.shells(2, {0.0, 0.0, 1.0}, {20.0, 20.0, 0.0}, 5, 5);
    velocity(s, 2, {3000.0, 2000.0, 0.0});
    Experiment experiment(s.deck());
    double worst = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      const Moment moment(now, now.components.contacts.all()[0]);
      if (moment.sizes > 0.0) worst = std::max(worst, norm(moment.sum) / moment.sizes);
    });
    if (balanced)
      expect_reference("bounce", name + ", moment of it, of the sizes", worst, 0.0, 1e-12, 1.0);
    else
      EXPECT_GT(worst, 1e-3) << name;
  }
}

}  // namespace
}  // namespace nugget::verify
