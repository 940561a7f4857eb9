// SPDX-License-Identifier: Apache-2.0
// Whole files: decks that nobody here wrote, benchmarks, examples and transformed includes must become models without
// errors.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "model/history_files.hpp"
#include "reading/build.hpp"
#include "reading/builder/builder.hpp"

namespace nugget::reading {
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
  EXPECT_EQ(model.requests["rwforc"].interval, 1e-5);
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
  for (const Index node : model.walls[1].nodes) EXPECT_EQ(model.initial_velocity[node].x, -8333.0);
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
  EXPECT_EQ(hex.model.requests["glstat"].interval, 0.01);
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

/// A folder of its own for each test, gone at the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / fs::path("nugget_model_" + std::to_string(::getpid()) + '_' +
                                                       testing::UnitTest::GetInstance()->current_test_info()->name());
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

bool run_python(const fs::path& script, const fs::path& folder) {
  const std::string command =
      std::string(NUGGET_PYTHON) + " " + script.string() + " " + folder.string() + " > /dev/null";
  return std::system(command.c_str()) == 0;
}

TEST(Transform, TurnsWallsAndVelocitiesAndMovesIds) {
  const Folder folder;
  std::ofstream(folder.path / "part.k") << R"(*KEYWORD
*NODE
       1             1.0             0.0             0.0
*SET_NODE_LIST
         1
         1
*INITIAL_VELOCITY_GENERATION
         1         3       2.0       4.0
       0.0       0.0       0.0       1.0       0.0       0.0
*RIGIDWALL_PLANAR
         1
       1.0       0.0       0.0       2.0       0.0       0.0
*END
)";
  std::ofstream(folder.path / "main.k") << R"(*KEYWORD
*CONTROL_TERMINATION
       1.0
*DEFINE_TRANSFORMATION
         1
TRANSL          10.0       0.0       0.0
ROTATE           0.0       0.0       1.0       0.0       0.0       0.0      90.0
*INCLUDE_TRANSFORM
part.k
       100         0         0         0      1000

       1.0       1.0    1000.0
         1
*END
)";
  const Read read(folder.path / "main.k");
  ASSERT_EQ(read.findings.errors(), 0) << read.errors();
  const Model& model = read.model;
  ASSERT_EQ(model.node_index(101), 0);
  EXPECT_NEAR(model.nodes.x[0].x, 10.0, 1e-9);
  EXPECT_NEAR(model.nodes.x[0].y, 1000.0, 1e-9);
  ASSERT_EQ(model.walls.size(), 1u);
  EXPECT_NEAR(model.walls[0].origin.x, 10.0, 1e-9) << "lengths to millimetres, then turned, then moved";
  EXPECT_NEAR(model.walls[0].origin.y, 1000.0, 1e-9);
  EXPECT_NEAR(model.walls[0].normal.y, 1.0, 1e-12);
  EXPECT_EQ(model.walls[0].nodes.size(), 1u);
  // v = (0, 4000, 0) + 2 e_y x (x - c), where x - c = (0, 1000, 0) is on the axis.
  EXPECT_NEAR(model.initial_velocity[0].x, 0.0, 1e-9);
  EXPECT_NEAR(model.initial_velocity[0].y, 4000.0, 1e-9);
  EXPECT_NEAR(model.initial_spin[0].y, 2.0, 1e-12);
}

TEST(RealDecks, Examples) {
  for (const char* example : {"double_hat", "weld_placement"}) {
    const Folder folder;
    ASSERT_TRUE(run_python(fs::path(NUGGET_SOURCE_DIR) / "examples" / example / "make.py", folder.path)) << example;
    int decks = 0;
    for (const auto& entry : fs::directory_iterator(folder.path)) {
      if (entry.path().extension() != ".k") continue;
      ++decks;
      const Read read(entry.path());
      EXPECT_EQ(read.findings.errors(), 0) << entry.path() << '\n' << read.errors();
      EXPECT_FALSE(read.model.contacts.empty()) << entry.path();
    }
    EXPECT_GT(decks, 0) << example;
  }
}

TEST(RealDecks, BenchmarkDecks) {
  const fs::path script = shared / "bench" / "gen_impact.py";
  if (!fs::exists(script)) GTEST_SKIP() << script << " is not here";
  const Folder folder;
  ASSERT_TRUE(run_python(script, folder.path));
  for (const char* name : {"tube3.k", "tube5.k", "tube5c.k", "hex_ihq2.k", "weld.k"}) {
    const Read read(folder.path / name);
    EXPECT_EQ(read.findings.errors(), 0) << name << '\n' << read.errors();
    EXPECT_EQ(read.model.motions.size(), 1u) << name;
    EXPECT_FALSE(read.model.spcs.empty()) << name;
  }
  const Read weld(folder.path / "weld.k");
  ASSERT_EQ(weld.model.contacts.size(), 1u);
  EXPECT_EQ(weld.model.contacts[0].kind, Contact::Kind::spotweld);
  EXPECT_EQ(weld.model.contacts[0].a.parts.size(), 1u);
  EXPECT_EQ(weld.model.contacts[0].b.parts.size(), 2u);
}

}  // namespace
}  // namespace nugget::reading
