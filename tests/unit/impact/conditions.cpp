// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "base/index.hpp"
#include "deck/deck.hpp"
#include "impact/simulation.hpp"
#include "model/builder.hpp"

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
    model = std::make_unique<model::Model>(model::build(read, findings));
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
  std::size_t node(int id) const { return at(system->node_of[at(model->node_index(id))]); }
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
  // A force that is there at once: the first kick takes half a step, its work is booked for a whole one. That is a step
  // that grows from nothing, 1/2 m (F dt / 2m)^2 (docs/decisions/0021).
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

// A mass that is driven from rest at once: the support does 1/2 m v^2, no more.
// Sabotage to be caught: the impulse of the first half kick times the full velocity (twice the energy).
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
      worst = std::max(worst, std::abs(now.supports.motion_reactions().at(0).force.x + 2.0 * w * w * std::sin(w * t)));
      EXPECT_NEAR(vec(now.state.x[run.node(1)]).x, std::sin(w * t), 3e-3);
    });
    EXPECT_LT(worst, 1e-2 * 2.0 * w * w) << "VAD " << kind;
    EXPECT_LT(run.worst, 1e-8) << "VAD " << kind;
  }
}

// A support that is born on a moving mass takes its energy out.
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
  run.run([&](const Snapshot& now) { reaction = now.supports.spc_reactions().at(0).force; });
  EXPECT_NEAR(reaction.y, -7.0, 1e-12);
  EXPECT_EQ(vec(run.simulation->state().x[run.node(1)]).y, 0.0);
  EXPECT_EQ(run.energy().external, 0.0);
}

}  // namespace
}  // namespace nugget::impact
