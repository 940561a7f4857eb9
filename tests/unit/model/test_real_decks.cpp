// SPDX-License-Identifier: Apache-2.0
// Decks that nobody here wrote, and the benchmark decks: they must become models without errors.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "model/builder.hpp"

namespace nugget::model {
namespace {

namespace fs = std::filesystem;

const fs::path shared = fs::path(NUGGET_SOURCE_DIR) / ".." / "shared";

struct Read {
  Findings findings;
  Model model;
  explicit Read(const fs::path& path) {
    const deck::Deck deck = deck::read(path, findings);
    model = build(deck, findings);
  }
  std::string errors() const {
    std::string text;
    for (const Finding& f : findings.all())
      if (f.severity == Severity::error) text += to_string(f) + '\n';
    return text;
  }
};

TEST(RealDecks, Car6) {
  const fs::path path = shared / "decks" / "car6" / "main_v223.k";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not here";
  const Read car(path);
  ASSERT_EQ(car.findings.errors(), 0) << car.errors();
  const Model& model = car.model;
  EXPECT_EQ(model.shells.size(), 2424u);
  EXPECT_EQ(model.parts.size(), 7u);
  EXPECT_EQ(model.control.end_time, 0.2);
  EXPECT_EQ(model.requests.rwforc.interval, 1e-5);
  EXPECT_EQ(model.requests.history_nodes.size(), 5u);

  ASSERT_EQ(model.rigid_bodies.size(), 3u) << "generalized weld spots";
  for (const RigidBody& body : model.rigid_bodies) {
    EXPECT_EQ(body.origin, RigidBody::Origin::weld);
    EXPECT_EQ(body.nodes.size(), 2u);
  }
  ASSERT_EQ(model.walls.size(), 2u);
  EXPECT_EQ(model.walls[0].title, "ground");
  EXPECT_EQ(model.walls[0].friction, 0.2);
  EXPECT_FALSE(model.walls[0].nodes.empty());
  EXPECT_EQ(model.walls[1].shape, RigidWall::Shape::cylinder);
  EXPECT_EQ(model.walls[1].radius, 177.0);
  EXPECT_NEAR(model.walls[1].normal.z, 1.0, 1e-12);
  EXPECT_FALSE(model.walls[1].nodes.empty());

  ASSERT_EQ(model.contacts.size(), 1u);
  EXPECT_EQ(model.contacts[0].a.parts.size(), 5u);
  ASSERT_FALSE(model.initial_velocity.empty());
  for (const Index node : model.walls[1].nodes)
    EXPECT_EQ(model.initial_velocity[static_cast<std::size_t>(node)].x, -8333.0);
}

TEST(RealDecks, SingleHex) {
  const fs::path path = shared / "decks" / "single_hex" / "single_hex_tension.k";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not here";
  const Read hex(path);
  ASSERT_EQ(hex.findings.errors(), 0) << hex.errors();
  EXPECT_EQ(hex.model.solids.size(), 1u);
  EXPECT_EQ(hex.model.spcs.size(), 4u);
  EXPECT_EQ(hex.model.nodal_loads.size(), 4u);
  EXPECT_EQ(hex.model.nodal_loads[0].scale, 0.0025);
  EXPECT_EQ(hex.model.requests.glstat.interval, 0.01);
}

TEST(RealDecks, BallOnPlate) {
  const fs::path path = shared / "decks" / "ball_plate" / "ball_plate.k";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not here";
  const Read ball(path);
  ASSERT_EQ(ball.findings.errors(), 0) << ball.errors();
  ASSERT_EQ(ball.model.rigid_bodies.size(), 1u);
  // The deck gives a velocity to nodes 1 to 1651 only; those of the ball that it leaves out are a matter of momentum.
  for (std::size_t n = 0; n < ball.model.nodes.size(); ++n)
    EXPECT_EQ(ball.model.initial_velocity[n].z, ball.model.nodes.id[n] <= 1651 ? -10.0 : 0.0);
}

TEST(RealDecks, BenchmarkDecks) {
  const fs::path script = shared / "bench" / "gen_impact.py";
  if (!fs::exists(script)) GTEST_SKIP() << script << " is not here";
  const fs::path folder = fs::temp_directory_path() / "nugget_model_bench";
  fs::create_directories(folder);
  const std::string command =
      std::string(NUGGET_PYTHON) + " " + script.string() + " " + folder.string() + " > /dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  for (const char* name : {"tube3.k", "tube5.k", "tube5c.k", "hex_ihq2.k", "weld.k"}) {
    const Read read(folder / name);
    EXPECT_EQ(read.findings.errors(), 0) << name << '\n' << read.errors();
    EXPECT_EQ(read.model.motions.size(), 1u) << name;
    EXPECT_FALSE(read.model.spcs.empty()) << name;
  }
  const Read weld(folder / "weld.k");
  ASSERT_EQ(weld.model.contacts.size(), 1u);
  EXPECT_EQ(weld.model.contacts[0].kind, Contact::Kind::spotweld);
  EXPECT_EQ(weld.model.contacts[0].a.parts.size(), 1u);
  EXPECT_EQ(weld.model.contacts[0].b.parts.size(), 2u);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace nugget::model
