// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>
#include <cstdint>
#include <fstream>

#include "base/index.hpp"
#include "output/d3plot_reader.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::output {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

D3plotGeometry brick_beam_and_shells() {
  D3plotGeometry g;
  g.title = "small model";
  g.node_ids = {11, 12, 13, 14, 15, 16, 17, 18, 101, 102, 103, 104};
  g.x = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1},
         {1, 1, 1}, {0, 1, 1}, {0, 0, 3}, {1, 0, 3}, {1, 1, 3}, {0, 1, 3}};
  g.solids = {{7, {0, 1, 2, 3, 4, 5, 6, 7}, 1}};
  g.beams = {{900, {4, 8}, 3}};
  g.shells = {{51, {8, 9, 10, 11}, 0}, {52, {8, 9, 10, 10}, 0}};
  g.parts = {{5, "lid"}, {2, "brick"}, {9, "spare"}, {100, "weld"}};
  return g;
}

/// Numbers that a float holds, each a different one.
struct Counter {
  double value = 0.0;
  double next() { return value += 0.25; }
  std::array<double, 6> six() { return {next(), next(), next(), next(), next(), next()}; }
  Vec3d vector() { return {next(), next(), next()}; }
};

void fill(Counter& c, StressRecord& r, int histories) {
  r.stress = c.six();
  r.plastic_strain = c.next();
  for (std::size_t i = 0; i < at(histories); ++i) r.history[i] = c.next();
}

D3plotState counted_state(const D3plotGeometry& g, double time) {
  Counter c{100.0 * time};
  D3plotState s;
  s.time = time;
  s.kinetic = c.next(), s.internal = c.next(), s.total = c.next();
  s.velocity = c.vector();
  s.parts.resize(g.parts.size() + at(g.nodal_rigid_bodies));
  for (D3plotPartState& p : s.parts) p = {c.next(), c.next(), c.next(), c.next(), c.vector()};
  for (int wall = 0; wall < g.rigid_walls; ++wall) s.wall_forces.push_back(c.next());
  for (auto* vectors : {&s.x, &s.v, &s.a})
    for (std::size_t i = 0; i < g.x.size(); ++i) vectors->push_back(c.vector());
  if (g.family == D3plotGeometry::Family::d3eigv) s.v.clear(), s.a.clear();
  s.solids.resize(g.solids.size());
  for (SolidRecord& r : s.solids) {
    fill(c, r, g.solid_histories);
    if (g.strains) r.strain = c.six();
  }
  s.beams = {{c.next(), c.next(), c.next(), c.next(), c.next(), c.next()}};
  for (std::size_t i = 0; i < g.beams.size() * at(g.beam_points); ++i)
    s.beam_points.push_back({c.next(), c.next(), c.next(), c.next(), c.next()});
  s.shell_layers.resize(g.shells.size() * at(g.layers_of_shells()));
  for (StressRecord& r : s.shell_layers) fill(c, r, g.shell_histories);
  for (std::size_t e = 0; e < g.shells.size(); ++e) {
    ShellRecord& r = s.shells.emplace_back(ShellRecord{c.next(), c.next(), c.next(), c.next(), c.next(), c.next(),
                                                       c.next(), c.next(), c.next(), c.next()});
    if (g.strains) r.inner_strain = c.six(), r.outer_strain = c.six();
    if (!g.shell_stresses) r = {.thickness = r.thickness, .internal_energy = r.internal_energy};
  }
  s.solid_alive = {1}, s.beam_alive = {0}, s.shell_alive = {1, 0};
  return s;
}

void expect_equal(const StressRecord& a, const StressRecord& b) {
  EXPECT_EQ(a.stress, b.stress);
  EXPECT_EQ(a.plastic_strain, b.plastic_strain);
  EXPECT_EQ(a.history, b.history);
}

void expect_equal(const D3plotState& a, const D3plotState& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.total, b.total);
  EXPECT_EQ(a.wall_forces, b.wall_forces);
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    EXPECT_EQ(a.parts[i].internal, b.parts[i].internal);
    EXPECT_EQ(a.parts[i].hourglass, b.parts[i].hourglass);
    EXPECT_EQ(a.parts[i].velocity.z, b.parts[i].velocity.z);
  }
  for (const auto& [ours, theirs] : {std::pair{&a.x, &b.x}, {&a.v, &b.v}, {&a.a, &b.a}}) {
    ASSERT_EQ(ours->size(), theirs->size());
    for (std::size_t i = 0; i < ours->size(); ++i) EXPECT_EQ(norm((*ours)[i] - (*theirs)[i]), 0.0);
  }
  ASSERT_EQ(a.solids.size(), b.solids.size());
  expect_equal(a.solids[0], b.solids[0]);
  EXPECT_EQ(a.solids[0].strain, b.solids[0].strain);
  EXPECT_EQ(a.beams.at(0).torsion, b.beams.at(0).torsion);
  ASSERT_EQ(a.beam_points.size(), b.beam_points.size());
  for (std::size_t i = 0; i < a.beam_points.size(); ++i)
    EXPECT_EQ(a.beam_points[i].axial_strain, b.beam_points[i].axial_strain);
  ASSERT_EQ(a.shell_layers.size(), b.shell_layers.size());
  for (std::size_t i = 0; i < a.shell_layers.size(); ++i) expect_equal(a.shell_layers[i], b.shell_layers[i]);
  for (std::size_t i = 0; i < a.shells.size(); ++i) {
    EXPECT_EQ(a.shells[i].mx, b.shells[i].mx);
    EXPECT_EQ(a.shells[i].thickness, b.shells[i].thickness);
    EXPECT_EQ(a.shells[i].internal_energy, b.shells[i].internal_energy);
    EXPECT_EQ(a.shells[i].outer_strain, b.shells[i].outer_strain);
  }
  EXPECT_EQ(a.solid_alive, b.solid_alive);
  EXPECT_EQ(a.beam_alive, b.beam_alive);
  EXPECT_EQ(a.shell_alive, b.shell_alive);
}

/// Thick shells among bricks: each has its block in the file (words 23, 40 to 42 of the control section count them),
/// and both come back by rising id.
TEST(D3plotReader, ThickShellsAmongBricks) {
  for (const bool strains : {false, true}) {
    Scratch scratch;
    D3plotGeometry g = brick_beam_and_shells();
    g.solids = {{3, {0, 1, 2, 3, 4, 5, 6, 7}, 2}, {7, {1, 2, 3, 0, 5, 6, 7, 4}, 1}, {9, {2, 3, 0, 1, 6, 7, 4, 5}, 2}};
    g.thick = {1, 0, 1};
    g.layers = 3, g.strains = strains;
    D3plotState s = counted_state(g, 1.0);
    Counter c{5000.0};
    s.thick_shells.resize(2);
    s.thick_layers.resize(6);
    for (StressRecord& r : s.thick_layers) fill(c, r, 0);
    for (ThickShellRecord& r : s.thick_shells) {
      r.internal_energy = c.next();
      if (strains) r.inner_strain = c.six(), r.outer_strain = c.six();
    }
    s.solid_alive = {1, 1, 0};
    D3plot(scratch.path(), g).write(s);

    std::ifstream file(scratch.path() / "d3plot", std::ios::binary);
    std::array<std::int32_t, 64> control{};
    file.read(reinterpret_cast<char*>(control.data()), sizeof control);
    EXPECT_EQ(control[23], 1);
    EXPECT_EQ(control[40], 2);
    EXPECT_EQ(control[41], 1);
    EXPECT_EQ(control[42], 3 * 7 + (strains ? 12 : 0) + 1);

    const D3plotReader reader(scratch.path(), g.family);
    const D3plotGeometry& back = reader.geometry();
    EXPECT_EQ(back.thick, g.thick);
    EXPECT_EQ(back.strains, strains);
    for (std::size_t e = 0; e < 3; ++e) {
      EXPECT_EQ(back.solids[e].id, g.solids[e].id);
      EXPECT_EQ(back.solids[e].nodes, g.solids[e].nodes);
      EXPECT_EQ(back.solids[e].part, g.solids[e].part);
    }
    const D3plotState read = reader.read(0);
    EXPECT_EQ(read.solid_alive, s.solid_alive);
    expect_equal(read.solids[1], s.solids[1]);
    expect_equal(read.solids[2], s.thick_layers[3]);
    ASSERT_EQ(read.thick_layers.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) expect_equal(read.thick_layers[i], s.thick_layers[i]);
    ASSERT_EQ(read.thick_shells.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(read.thick_shells[i].outer_strain, s.thick_shells[i].outer_strain);
      EXPECT_EQ(read.thick_shells[i].internal_energy, s.thick_shells[i].internal_energy);
    }
    EXPECT_EQ(read.beams.at(0).torsion, s.beams[0].torsion);
    EXPECT_EQ(read.shells.at(1).internal_energy, s.shells[1].internal_energy);
  }
}

/// Everything that is written comes back, whatever the deck asks to have in a state.
TEST(D3plotReader, ReadsWhatIsWritten) {
  struct Case {
    int layers, points, solid_histories, shell_histories, walls, bodies;
    bool strains, one_state_a_file;
    D3plotGeometry::Family family;
    bool shell_stresses = true;
  };
  for (const Case& c : {Case{3, 0, 0, 0, 0, 0, false, false, D3plotGeometry::Family::d3plot},
                        Case{5, 4, 2, 3, 2, 1, true, true, D3plotGeometry::Family::d3plot},
                        Case{1, 1, 3, 0, 1, 0, false, false, D3plotGeometry::Family::d3eigv},
                        Case{3, 0, 0, 2, 0, 0, false, false, D3plotGeometry::Family::d3eigv, false},
                        Case{3, 0, 0, 0, 0, 2, true, false, D3plotGeometry::Family::d3ssd}}) {
    Scratch scratch;
    D3plotGeometry g = brick_beam_and_shells();
    g.layers = c.layers, g.beam_points = c.points, g.solid_histories = c.solid_histories;
    g.shell_histories = c.shell_histories, g.rigid_walls = c.walls, g.nodal_rigid_bodies = c.bodies;
    g.strains = c.strains, g.one_state_a_file = c.one_state_a_file, g.family = c.family;
    g.shell_stresses = c.shell_stresses;
    D3plot file(scratch.path(), g);
    for (const double time : {0.0, 1.0, 2.0}) file.write(counted_state(g, time));
    const D3plotReader reader(scratch.path(), c.family);
    EXPECT_EQ(reader.geometry().title, g.title);
    EXPECT_EQ(reader.geometry().node_ids, g.node_ids);
    EXPECT_EQ(reader.geometry().shells[1].nodes, g.shells[1].nodes);
    EXPECT_EQ(reader.geometry().shells[1].id, 52);
    EXPECT_EQ(reader.geometry().beams[0].id, 900);
    EXPECT_EQ(reader.geometry().parts[3].id, 100);
    EXPECT_EQ(reader.geometry().parts[3].title, "weld");
    EXPECT_EQ(reader.times(), (std::vector{0.0, 1.0, 2.0}));
    for (std::size_t i = 0; i < reader.times().size(); ++i)
      expect_equal(reader.read(i), counted_state(g, reader.times()[i]));
  }
}

TEST(D3plotReader, AStateCutOffIsNone) {
  Scratch scratch;
  const D3plotGeometry g = brick_beam_and_shells();
  D3plot file(scratch.path(), g);
  for (const double time : {0.0, 1.0}) file.write(counted_state(g, time));
  const auto size = 4 * 2 * (D3plotReader(scratch.path()).times().size() == 2 ? 1 : 0);
  std::filesystem::resize_file(scratch / "d3plot01", std::filesystem::file_size(scratch / "d3plot01") / 2 + size);
  EXPECT_EQ(D3plotReader(scratch.path()).times().size(), 1u);
}

TEST(D3plotReader, RefusesWithTheFileAndTheReason) {
  Scratch scratch;
  EXPECT_THAT([&] { D3plotReader(scratch.path()); }, ThrowsMessage<std::runtime_error>(HasSubstr("no such file")));
  D3plot(scratch.path(), brick_beam_and_shells());
  std::filesystem::resize_file(scratch / "d3plot", 500);
  EXPECT_THAT([&] { D3plotReader(scratch.path()); }, ThrowsMessage<std::runtime_error>(HasSubstr("d3plot: cut off")));
  std::filesystem::rename(scratch / "d3plot", scratch / "d3eigv");
  EXPECT_THAT([&] { D3plotReader(scratch.path(), D3plotGeometry::Family::d3eigv); },
              ThrowsMessage<std::runtime_error>(HasSubstr("d3eigv")));
}

/// A file of LS-DYNA R14 itself: a state's energy is that of the glstat beside it.
TEST(D3plotReader, ReadsAFileOfLsDyna) {
  if (!std::filesystem::exists(shared("decks/single_hex/d3plot"))) GTEST_SKIP() << "no ../shared/decks/single_hex here";
  const D3plotReader reader(shared("decks/single_hex"));
  EXPECT_EQ(reader.geometry().parts.at(0).title, "Single hex part");
  ASSERT_GT(reader.times().size(), 9u);
  EXPECT_NEAR(reader.times().back(), 1.0, 0.1);
  EXPECT_NEAR(reader.read(reader.times().size() - 1).total, -3.94264e-2, 1e-7);
  const D3plotState first = reader.read(0);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(norm(first.x[i] - reader.geometry().x[i]), 0.0);
}

}  // namespace
}  // namespace nugget::output
