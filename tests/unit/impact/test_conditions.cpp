// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/supports.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "base/index.hpp"
#include "deck/deck.hpp"
#include "impact/simulation/simulation.hpp"
#include "reading/build.hpp"

// Supports and loads on single masses, where every number has a closed form.
namespace nugget::impact {
namespace {

using Watch = std::function<void(const Snapshot&)>;

/// A run with a step of 1e-3 given by curve 90, watched in every cycle.
class Trial : public Recorder {
 public:
  explicit Trial(const std::string& deck) {
    const deck::Deck read = deck::read_text(
        "*KEYWORD\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,90\n*DEFINE_CURVE\n90\n0.0,1e-3\n100.0,1e-3\n" + deck + "*END\n",
        findings);
    model = std::make_unique<model::Model>(reading::build(read, findings));
    ties = std::make_unique<weld::Ties>(weld::tie(*model, findings));
    system = std::make_unique<system::System>(*model, *ties, findings);
    simulation = std::make_unique<Simulation>(*system, findings);
    for (const Finding& f : findings.all()) EXPECT_NE(f.severity, Severity::error) << to_string(f);
  }
  void run(const Watch& watch = {}) {
    watch_ = watch;
    EXPECT_EQ(simulation->run({}, *this, {}).termination, Termination::normal);
  }
  bool due(const system::State&) override { return true; }
  void write(const Snapshot& now, bool) override {
    worst = std::max(worst, std::abs(now.energy.total() - now.energy.initial - now.energy.external));
    if (watch_) watch_(now);
  }
  std::size_t node(int id) const { return at(system->node_of[model->node_index(id)]); }
  const Energy& energy() const { return simulation->energy(); }

  Findings findings;
  std::unique_ptr<model::Model> model;
  std::unique_ptr<weld::Ties> ties;
  std::unique_ptr<system::System> system;
  std::unique_ptr<Simulation> simulation;
  double worst = 0.0;  ///< of the energy balance

 private:
  Watch watch_;
};

/// Mass 2 at node 1.
const std::string mass = "*NODE\n1,0.0,0.0,0.0\n*ELEMENT_MASS\n1,1,2.0\n";
const std::string until_one = "*CONTROL_TERMINATION\n1.0\n";

// F = 6 t on a mass of 2: v = 1.5 t^2. Sabotage to be caught: the force at the end of the step for the mean of both.
TEST(Loads, RampDoesTheWorkThatMoves) {
  Trial run(until_one + mass + "*DEFINE_CURVE\n1\n0.0,0.0\n10.0,10.0\n*LOAD_NODE_POINT\n1,1,1,6.0\n");
  run.run();
  EXPECT_NEAR(run.energy().external, 2.25, 1e-5);
  EXPECT_LT(run.worst, 1e-13);
}

TEST(Loads, ConstantForceDoesTheWorkThatMoves) {
  Trial run(until_one + mass + "*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n*LOAD_NODE_POINT\n1,1,1,6.0\n");
  run.run();
  EXPECT_NEAR(vec(run.simulation->state().x[run.node(1)]).x, 0.5 * 3.0, 1e-12);
  EXPECT_NEAR(run.energy().external, 0.5 * 2.0 * 9.0, 1e-4);
  // A force that is there at once: the first update of the velocities takes half a step, its work is booked for a whole
  // one. That is a step that grows from nothing, 1/2 m (F dt / 2m)^2 (docs/decisions/0021).
  EXPECT_NEAR(run.energy().step_change, 2.25e-6, 1e-10);
  EXPECT_LT(run.worst, 1e-12);
}

TEST(Loads, BodyLoadIsABaseAcceleration) {
  Trial run(until_one + mass + "*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n*LOAD_BODY_Z\n1,9.81\n");
  run.run();
  EXPECT_NEAR(vec(run.simulation->state().x[run.node(1)]).z, -0.5 * 9.81, 1e-10);
  EXPECT_LT(run.worst, 1e-6 * run.energy().external);
}

// Sabotage to be caught: all nodes of the model for those of the set.
TEST(Loads, GeneralizedBodyLoadActsOnItsNodesOnly) {
  Trial run(until_one +
            "*NODE\n1,0.0,0.0,0.0\n2,5.0,0.0,0.0\n*ELEMENT_MASS\n1,1,2.0\n2,2,2.0\n*SET_NODE\n1\n2\n"
            "*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n*LOAD_BODY_GENERALIZED_SET_NODE\n1,0,1\n0.0,0.0,9.81\n");
  run.run();
  EXPECT_NEAR(vec(run.simulation->state().x[run.node(2)]).z, -0.5 * 9.81, 1e-10);
  EXPECT_EQ(vec(run.simulation->state().x[run.node(1)]).z, 0.0);
}

// A body of mass 5 whose nodes weigh 3 falls as fast as any; the SPC at its reference node keeps it from going along x.
TEST(Loads, GeneralizedBodyLoadPullsAHeldBodyByItsGivenMass) {
  Trial run(until_one +
            "*NODE\n1,0.0,0.0,0.0\n2,1.0,0.0,0.0\n3,0.0,1.0,0.0\n9,0.4,0.3,0.0\n"
            "*ELEMENT_MASS\n1,1,1.0\n2,2,1.0\n3,3,1.0\n*SET_NODE\n1\n1,2,3\n*SET_NODE\n2\n1,2,3,9\n"
            "*CONSTRAINED_NODAL_RIGID_BODY_INERTIA\n7,0,1,9\n0.4,0.3,0.0,5.0\n50.0,50.0,50.0,50.0,50.0,50.0\n\n"
            "*BOUNDARY_SPC_NODE\n9,0,1,0,0,1,1,1\n"
            "*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n*LOAD_BODY_GENERALIZED_SET_NODE\n2,0,1\n3.0,0.0,9.81\n");
  run.run();
  const Vec3d moved = vec(run.simulation->state().x[run.node(2)]) - Vec3d{1.0, 0.0, 0.0};
  EXPECT_NEAR(moved.z, -0.5 * 9.81, 1e-10);
  EXPECT_EQ(moved.x, 0.0);
  EXPECT_EQ(moved.y, 0.0);
  EXPECT_NEAR(run.energy().external, 0.5 * 5.0 * 9.81 * 9.81, 0.01 * run.energy().external);
}

// A ramp p(t) = t on a unit segment of four masses of 1: each feels -t/4 along the normal, so v = t^2/8.
TEST(Loads, PressurePushesOntoTheFace) {
  Trial run(until_one +
            "*NODE\n1,0.0,0.0,0.0\n2,1.0,0.0,0.0\n3,1.0,1.0,0.0\n4,0.0,1.0,0.0\n*ELEMENT_MASS\n1,1,1.0\n2,2,1.0\n3,3,1."
            "0\n4,4,1.0\n"
            "*DEFINE_CURVE\n1\n0.0,0.0\n10.0,10.0\n*LOAD_SEGMENT\n1,1.0,0.0,1,2,3,4\n");
  Vec3d v;
  run.run([&](const Snapshot& now) { v = now.velocity(run.node(3)); });
  EXPECT_NEAR(v.z, -0.125, 1e-6);
  EXPECT_NEAR(v.x, 0.0, 1e-14);
  EXPECT_NEAR(run.energy().external, 4.0 * 0.5 / 64.0, 1e-6);
  EXPECT_LT(run.worst, 1e-14);
}

// A traction t (1 + 2 x) along (0, 0.6, 0.8) on a unit square in the plane of x and y: 2 t in all, of which the edge
// x = 0 takes the integral of (1 - x)(1 + 2 x), 5/6, and x = 1 that of x (1 + 2 x), 7/6.
// Sabotage to be caught: each corner taking its own factor of a quarter of the area (1/2 and 3/2).
TEST(Loads, TractionBetweenCorners) {
  const std::string square =
      "*NODE\n1,0.0,0.0,0.0\n2,1.0,0.0,0.0\n3,1.0,1.0,0.0\n4,0.0,1.0,0.0\n*ELEMENT_MASS\n1,1,1e6\n2,2,1e6\n3,3,1e6\n"
      "4,4,1e6\n*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n";
  const std::string card = "*LOAD_SEGMENT_NONUNIFORM\n1,12.0,,,0,0.0,3.0,4.0\n";
  Trial run(until_one + square + card + "1,2,3,4\n1.0,3.0,3.0,1.0\n");
  std::array<Vec3d, 4> v;
  run.run([&](const Snapshot& now) {
    for (int i = 0; i < 4; ++i) v[i] = now.velocity(run.node(i + 1));
  });
  // The masses of 1e6 hardly move, so the square keeps its area.
  for (const auto& [node, edge] : {std::pair{0, 5.0 / 6.0}, {3, 5.0 / 6.0}, {1, 7.0 / 6.0}, {2, 7.0 / 6.0}}) {
    EXPECT_NEAR(v[node].x, 0.0, 1e-12);
    EXPECT_NEAR(1e6 * v[node].y, 0.6 * 6.0 * edge, 1e-3) << node;
    EXPECT_NEAR(v[node].z / v[node].y, 0.8 / 0.6, 1e-9) << node;
  }
  EXPECT_LT(run.worst, 1e-12);
}

TEST(Loads, LoadedAreasOfFaces) {
  const auto expect = [](const std::array<double, 4>& areas, const std::array<double, 4>& expected) {
    for (std::size_t a = 0; a < 4; ++a) EXPECT_NEAR(areas[a], expected[a], 1e-12) << a;
  };
  const std::array<Vec3d, 4> square{{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}};
  expect(loaded_areas(square, {1, 1, 1, 1}, false), {1.5, 1.5, 1.5, 1.5});
  // Integral of N_a N_b over a rectangle: area / 36 times 4, 2, 1, 2.
  expect(loaded_areas(square, {1, 0, 0, 0}, false), {4.0 / 6.0, 2.0 / 6.0, 1.0 / 6.0, 2.0 / 6.0});
  const std::array<Vec3d, 4> triangle{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {0, 3, 0}}};
  expect(loaded_areas(triangle, {1, 1, 1, 1}, true), {2, 2, 2, 0});
  expect(loaded_areas(triangle, {0, 6, 0, 0}, true), {3, 6, 3, 0});
}

// It acts from AT to DT, and its curve begins at AT.
TEST(Loads, TractionForATime) {
  Trial run(until_one +
            "*NODE\n1,0.0,0.0,0.0\n2,1.0,0.0,0.0\n3,0.0,1.0,0.0\n*ELEMENT_MASS\n1,1,1.0\n2,2,1.0\n3,3,1.0\n"
            "*DEFINE_CURVE\n1\n0.0,0.0\n10.0,10.0\n*LOAD_SEGMENT_NONUNIFORM_ID\n5,heading\n"
            "1,6.0,0.25,0.75,0,0.0,0.0,2.0\n1,2,3\n1.0,1.0,1.0\n");
  Vec3d v;
  run.run([&](const Snapshot& now) { v = now.velocity(run.node(3)); });
  EXPECT_NEAR(v.z, 0.5 * 0.5 * 0.5, 0.01);  // traction 6 t' on a third of the area of 1/2, for a time of 1/2
}

// A mass that is driven from rest at once: the support does 1/2 m v^2, no more.
// Sabotage to be caught: the impulse of the first half step times the full velocity (twice the energy).
TEST(Supports, DrivenFromRestAtOnceCostsItsKineticEnergy) {
  Trial run(until_one + mass + "*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,1,5.0\n");
  run.run();
  EXPECT_NEAR(vec(run.simulation->state().x[run.node(1)]).x, 5.0, 1e-10);
  EXPECT_NEAR(run.energy().external, 25.0, 1e-10);
  EXPECT_LT(run.worst, 1e-10);
}

// x = sin(2 pi t), as displacement, velocity and acceleration: the reaction is m a, the work m v^2 / 2.
TEST(Supports, MotionsOfEachKindGiveTheSameReaction) {
  for (int kind : {0, 1, 2}) {  // velocity, acceleration, displacement
    const double w = 2.0 * 3.14159265358979323846;
    std::string curve = "*DEFINE_CURVE\n1\n";
    for (int i = 0; i <= 2000; ++i) {
      const double t = 1e-3 * i;
      const double value = kind == 2 ? std::sin(w * t) : kind == 0 ? w * std::cos(w * t) : -w * w * std::sin(w * t);
      char line[64];
      std::snprintf(line, sizeof line, "%.10g,%.12g\n", t, value);
      curve += line;
    }
    Trial run(until_one + mass + curve +
              "*INITIAL_VELOCITY_NODE\n1,6.283185307\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1," + std::to_string(kind) +
              ",1,1.0\n");
    double worst = 0.0;
    run.run([&](const Snapshot& now) {
      if (now.state.cycle < 2 || now.state.time > 0.99) return;
      const double t = now.state.time;
      worst = std::max(
          worst, std::abs(now.components.supports.motion_reactions().at(0).force.x + 2.0 * w * w * std::sin(w * t)));
      EXPECT_NEAR(vec(now.state.x[run.node(1)]).x, std::sin(w * t), 3e-3);
    });
    EXPECT_LT(worst, 1e-2 * 2.0 * w * w) << "VAD " << kind;
    EXPECT_LT(run.worst, 1e-8) << "VAD " << kind;
  }
}

// A support that is activated on a moving mass takes its energy out.
TEST(Supports, BornLaterTakesTheEnergyOut) {
  Trial run(until_one + mass +
            "*INITIAL_VELOCITY_NODE\n1,3.0\n*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1,0,0,0,0,0\n0.5,0.8\n");
  double x = 0.0;
  run.run([&](const Snapshot& now) { x = vec(now.state.x[run.node(1)]).x; });
  EXPECT_NEAR(x, 1.5, 5e-3);
  EXPECT_NEAR(run.energy().external, -9.0, 1e-10);
  EXPECT_NEAR(run.energy().kinetic, 0.0, 1e-12);
  EXPECT_LT(run.worst, 1e-10);
}

TEST(Supports, HoldWhatTheLoadsPush) {
  Trial run(until_one + mass +
            "*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n*LOAD_NODE_POINT\n1,2,1,7.0\n*BOUNDARY_SPC_NODE\n1,0,0,1,0,0,0,0\n");
  Vec3d reaction;
  run.run([&](const Snapshot& now) { reaction = now.components.supports.spc_reactions().at(0).force; });
  EXPECT_NEAR(reaction.y, -7.0, 1e-12);
  EXPECT_EQ(vec(run.simulation->state().x[run.node(1)]).y, 0.0);
  EXPECT_EQ(run.energy().external, 0.0);
}

/// Node 1 of mass 2 at (1 + 3, -1 + 4, 0.5), 5 from the axis along z through (1, -1).
const std::string around_z = "*NODE\n1,4.0,3.0,0.5\n*ELEMENT_MASS\n1,1,2.0\n";
constexpr double way = 5.0;
Vec3d on_circle(double angle) {
  const double start = std::atan2(4.0, 3.0);
  return {1.0 + way * std::cos(start + angle), -1.0 + way * std::sin(start + angle), 0.5};
}
void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

// The angle goes as t^2, by its rate, by itself and by its acceleration: the node stays on its circle to round-off and
// is where it is to be, held by m w^2 r inwards and driven by m r a; the work is its kinetic energy. Sabotage:
// velocities along the tangent (the radius grows); the work of a step with the axes of another (1e-3 of it).
TEST(Supports, ANodeGoesAroundAnAxis) {
  const std::string square = [] {
    std::string curve = "*DEFINE_CURVE\n1\n";
    for (int i = 0; i <= 1100; ++i) curve += std::to_string(1e-3 * i) + ',' + std::to_string(1e-6 * i * i) + '\n';
    return curve;
  }();
  const std::string motions[] = {
      "*DEFINE_CURVE\n1\n0.0,0.0\n10.0,20.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,11,0,1\n1.0,-1.0\n",
      square + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,11,2,1\n1.0,-1.0\n",
      "*DEFINE_CURVE\n1\n0.0,2.0\n10.0,2.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,11,1,1\n1.0,-1.0\n"};
  for (const std::string& motion : motions) {
    Trial run(until_one + around_z + motion);
    double off = 0.0, wrong = 0.0;
    run.run([&](const Snapshot& now) {
      const Vec3d x = vec(now.state.x[run.node(1)]);
      off = std::max(off, norm(x - on_circle(now.state.time * now.state.time)));
      if (now.state.time < 0.5 || now.state.time > 0.99) return;
      const double w = 2.0 * now.state.time;
      const Vec3d out = (1.0 / way) * Vec3d{x.x - 1.0, x.y + 1.0, 0.0}, around{-out.y, out.x, 0.0};
      const Vec3d force = now.components.supports.motion_reactions().at(0).force;
      wrong = std::max(wrong, norm(force - (-2.0 * w * w * way) * out - (2.0 * way * 2.0) * around));
    });
    EXPECT_LT(off, 1e-9) << motion.substr(0, 60);
    EXPECT_LT(wrong, 1e-4 * 2.0 * 4.0 * way) << motion.substr(0, 60);
    EXPECT_NEAR(run.energy().external, 0.5 * 2.0 * 4.0 * way * way, 1e-3 * 100.0);
    EXPECT_LT(run.worst, 1e-9);
  }
}

// A bead on a straight wire that turns at w: r = r0 cosh(w t), pushed by 2 m w r'. Sabotage: the radius held.
TEST(Supports, ABeadSlidesAlongATurningWire) {
  constexpr double w = 2.0;
  Trial run(until_one + around_z +
            "*INITIAL_VELOCITY_NODE\n1,-8.0,6.0,0.0\n"
            "*DEFINE_CURVE\n1\n0.0,2.0\n10.0,2.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,-11,0,1\n1.0,-1.0\n");
  double angle = 0.0, radius = 0.0, push = 0.0;
  run.run([&](const Snapshot& now) {
    const Vec3d x = vec(now.state.x[run.node(1)]);
    const double t = now.state.time, start = std::atan2(4.0, 3.0), r = std::hypot(x.x - 1.0, x.y + 1.0);
    angle =
        std::max(angle, std::abs(std::remainder(std::atan2(x.y + 1.0, x.x - 1.0) - start - w * t, 6.283185307179586)));
    radius = std::max(radius, std::abs(r / (way * std::cosh(w * t)) - 1.0));
    if (t < 0.5 || t > 0.99) return;
    const double wanted = 2.0 * 2.0 * w * w * way * std::sinh(w * t);
    const Vec3d f = now.components.supports.motion_reactions().at(0).force;
    push = std::max(push, std::abs((f.y * (x.x - 1.0) - f.x * (x.y + 1.0)) / (r * wanted) - 1.0));
  });
  EXPECT_LT(angle, 1e-11);
  EXPECT_LT(radius, 1e-5);
  EXPECT_LT(push, 1e-5);
  const double c = std::cosh(w), s = std::sinh(w), ours = 0.5 * 2.0 * w * w * way * way;
  EXPECT_NEAR(run.energy().external, ours * (c * c + s * s - 1.0), 1e-3 * ours * c * c);
}

// The offsets are y, z about x, and z, x about y; along the axis the node is free. On the axis there is no way around
// it.
TEST(Supports, AxesStandWhereTheOffsetsSay) {
  for (const int dof : {9, 10}) {
    const std::string node = dof == 9 ? "1,0.25,4.0,3.0\n" : "1,3.0,0.25,4.0\n";
    Trial run(until_one + "*NODE\n" + node +
              "2,1.0,1.0,-1.0\n3,-1.0,1.0,1.0\n*ELEMENT_MASS\n1,1,2.0\n2,2,2.0\n3,3,2.0\n" +
              "*INITIAL_VELOCITY_NODE\n1,1.0,1.0,1.0\n*SET_NODE\n4\n1,2,3\n*DEFINE_CURVE\n1\n0.0,2.0\n10.0,2.0\n"
              "*BOUNDARY_PRESCRIBED_MOTION_SET\n4," +
              std::to_string(dof) + ",0,1\n1.0,-1.0\n");
    run.run();
    const Vec3d x = vec(run.simulation->state().x[run.node(1)]), round = on_circle(2.0);
    expect_near(x, dof == 9 ? Vec3d{1.25, round.x, round.y} : Vec3d{round.y, 1.25, round.x}, 1e-9);
    const Vec3d axis = dof == 9 ? Vec3d{1, 1, -1} : Vec3d{-1, 1, 1};
    expect_near(vec(run.simulation->state().x[run.node(dof == 9 ? 2 : 3)]), axis, 1e-12);
  }
}

// VID < 0: y of a system turned by 30 degrees about z.
TEST(Supports, MotionAlongAnAxisOfASystem) {
  Trial run(
      until_one + mass +
      "*DEFINE_COORDINATE_VECTOR\n5,0.8660254037844386,0.5,0.0,-0.5,0.8660254037844386,0.0\n*DEFINE_CURVE\n1\n0.0,2.0\n"
      "10.0,2.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,2,0,1,1.0,-5\n");
  run.run();
  expect_near(vec(run.simulation->state().x[run.node(1)]), {-1.0, std::sqrt(3.0), 0.0}, 1e-9);
}

/// Looks at each cycle, at energies at none.
class WithoutEnergies : public Trial {
 public:
  using Trial::Trial;
  bool energies_due(const system::State&) override { return false; }
};

// Energies are summed up where a file shows them, at the start, every 100 cycles and at the end, or where a limit of
// them is watched. The force 8 on mass 2 gives the work 16 t^2.
TEST(Energies, AreSummedUpWhereTheyAreLookedAt) {
  const std::string pull = mass + "*LOAD_NODE_POINT\n1,1,1\n*DEFINE_CURVE\n1\n0.0,8.0\n100.0,8.0\n";
  const auto lag = [&](const std::string& deck) {
    WithoutEnergies run(deck);
    double largest = 0.0;
    run.run([&](const Snapshot& now) {
      largest = std::max(largest, 16.0 * now.state.time * now.state.time - now.energy.external);
    });
    EXPECT_NEAR(run.energy().external, 16.0, 0.1);
    return largest;
  };
  EXPECT_GT(lag(pull + until_one), 2.0);  // the last but one: 16 (1 - 0.9^2)
  EXPECT_LT(lag(pull + "*CONTROL_TERMINATION\n1.0,0,0.0,50.0\n"), 0.1);
}

}  // namespace
}  // namespace nugget::impact
