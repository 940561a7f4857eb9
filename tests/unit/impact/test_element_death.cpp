// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "deck/deck.hpp"
#include "impact/simulation/simulation.hpp"
#include "reading/build.hpp"

// *DEFINE_ELEMENT_DEATH: a mass on a bar goes on with the velocity that it has when the bar is deleted.
// Sabotage that this catches: a death that is read and not obeyed; elements deleted in the first step instead of before
// it.
namespace nugget::impact {
namespace {

class Silent : public Recorder {
 public:
  bool due(const system::State&) override { return false; }
  void write(const Snapshot&, bool) override {}
};

struct Ended {
  double velocity = std::nan("");
  std::string findings;
};

/// A mass of 2 on a bar of stiffness 8 pi^2, period 1, thrown with 1e-3 along the bar; at time 1. Another bar stands
/// by.
Ended run(const std::string& cards) {
  Findings findings;
  const deck::Deck read = deck::read_text(
      "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*CONTROL_TIMESTEP\n0,0.5,0,0,0,0\n"
      "*NODE\n1,0.0,0.0,0.0,7,7\n2,1.0,0.0,0.0,5,7\n3,0.0,1.0,0.0,7,7\n4,0.0,-1.0,0.0,7,7\n"
      "*MAT_ELASTIC\n1,1e-4,78.956835208714868,0.0\n*SECTION_BEAM\n1,3\n1.0\n*PART\nbar\n1,1,1\n"
      "*ELEMENT_BEAM\n7,1,1,2,3\n8,1,1,4,2\n*SET_BEAM\n9\n7\n*ELEMENT_MASS\n1,2,2.0\n*INITIAL_VELOCITY_NODE\n2,1e-3,0."
      "0,0.0\n" +
          cards + "*END\n",
      findings);
  const model::Model model = reading::build(read, findings);
  const weld::Ties ties = weld::tie(model, findings);
  Ended end;
  for (const Finding& f : findings.all()) end.findings += to_string(f) + '\n';
  if (findings.errors() > 0) return end;
  system::System system(model, ties, findings);
  Simulation simulation(system, findings);
  Silent silent;
  simulation.run({}, silent, {});
  end.velocity = vec(simulation.state().v[system.node_of[model.node_index(2)]]).x;
  return end;
}

TEST(ElementDeath, TheMassKeepsTheVelocityOfThatTime) {
  EXPECT_NEAR(run("").velocity / 1e-3, 1.0, 1e-3);  // a whole period
  const double at_an_eighth = std::cos(0.25 * std::numbers::pi);
  EXPECT_NEAR(run("*DEFINE_ELEMENT_DEATH_BEAM\n7,0.125\n").velocity / 1e-3, at_an_eighth, 1e-2);
  EXPECT_NEAR(run("*DEFINE_ELEMENT_DEATH_BEAM_SET\n9,0.5\n").velocity / 1e-3, -1.0, 1e-2);
}

TEST(ElementDeath, AtZeroItNeverWasThere) {
  EXPECT_DOUBLE_EQ(run("*DEFINE_ELEMENT_DEATH_BEAM\n7,0.0\n").velocity, 1e-3);
}

TEST(ElementDeath, WhatIsNotBuiltIsRefusedByName) {
  EXPECT_NE(run("*DEFINE_ELEMENT_DEATH_BEAM\n7,0.1,4\n").findings.find("boxid"), std::string::npos);
  EXPECT_NE(run("*DEFINE_ELEMENT_DEATH_BEAM\n7,0.1,0,0,3\n").findings.find("idgrp"), std::string::npos);
  EXPECT_NE(run("*DEFINE_ELEMENT_DEATH_BEAM\n9,0.1\n").findings.find("beam 9"), std::string::npos);
}

}  // namespace
}  // namespace nugget::impact
