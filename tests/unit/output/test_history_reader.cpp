// SPDX-License-Identifier: Apache-2.0
#include "output/history_reader.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "output/abstat.hpp"
#include "output/binout.hpp"
#include "output/dcfail.hpp"
#include "output/deforc.hpp"
#include "output/glstat.hpp"
#include "output/jntforc.hpp"
#include "output/matsum.hpp"
#include "output/ncforc.hpp"
#include "output/nodout.hpp"
#include "output/rbdout.hpp"
#include "output/rcforc.hpp"
#include "output/rwforc.hpp"
#include "output/secforc.hpp"
#include "output/sleout.hpp"
#include "output/spcforc.hpp"
#include "output/swforc.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::output {
namespace {

const Header header{"two plates", "nugget 0.1.0", "01/02/2026"};

/// Writes two states as text or as binout and reads the one file.
template <class State>
HistoryRecord written_and_read(const HistoryFormat<State>& format, const char* file, bool binary,
                               const std::vector<State>& states, std::span<const LegendEntry> legend = {}) {
  Scratch scratch;
  if (binary) {
    Binout binout(scratch.path(), header);
    binout.set_legend(file, {legend.begin(), legend.end()});
    for (const State& state : states) binout.write(format, state);
  } else {
    AsciiHistory ascii(format, scratch / file, header, legend);
    for (const State& state : states) ascii.write(state);
  }
  const std::string_view name = file;
  const std::vector<HistoryRecord> records = read_histories(scratch.path(), {&name, 1});
  EXPECT_EQ(records.size(), 1u) << file;
  return records.empty() ? HistoryRecord{} : records[0];
}

const Channel* find(const HistoryRecord& record, const std::string& entity, const std::string& quantity) {
  for (const Channel& channel : record.channels)
    if (channel.entity == entity && channel.quantity == quantity) return &channel;
  return nullptr;
}

/// Text and binout say the same, to the digits of the text: all channels of the text are in the binout.
template <class State>
HistoryRecord expect_both_alike(const HistoryFormat<State>& format, const char* file, const std::vector<State>& states,
                                std::span<const LegendEntry> legend = {}) {
  HistoryRecord text = written_and_read(format, file, false, states, legend);
  const HistoryRecord binary = written_and_read(format, file, true, states, legend);
  EXPECT_FALSE(text.channels.empty());
  EXPECT_EQ(text.times.size(), states.size()) << file;
  EXPECT_EQ(binary.times.size(), states.size()) << file;
  for (const Channel& channel : text.channels) {
    const Channel* other = find(binary, channel.entity, channel.quantity);
    EXPECT_NE(other, nullptr) << file << " " << channel.entity << " " << channel.quantity;
    if (other == nullptr) continue;
    EXPECT_EQ(other->dimension, channel.dimension) << channel.quantity;
    EXPECT_EQ(other->title, channel.title);
    for (std::size_t i = 0; i < channel.values.size(); ++i)
      EXPECT_NEAR(other->values[i], channel.values[i], 1e-4 * std::abs(other->values[i]) + 1e-12)
          << file << " " << channel.entity << " " << channel.quantity;
  }
  return text;
}

double value(const HistoryRecord& record, const std::string& entity, const std::string& quantity, std::size_t state) {
  const Channel* channel = find(record, entity, quantity);
  EXPECT_NE(channel, nullptr) << entity << " " << quantity;
  return channel == nullptr ? std::nan("") : channel->values.at(state);
}

TEST(HistoryReader, Swforc) {
  SwforcState first{.time = 0.001, .rows = {{}, {}, {}}, .resultant_force = true};
  first.rows[0].kind = WeldKind::beam;
  first.rows[0].id = 50001;
  first.rows[0].axial = 1234.5, first.rows[0].shear = -20.0, first.rows[0].failure = 0.25;
  first.rows[0].length = 1.5, first.rows[0].resultant_moment = 7.0, first.rows[0].torsion = -3.0;
  first.rows[1] = first.rows[0];
  first.rows[1].kind = WeldKind::solid, first.rows[1].id = 99999999;
  first.rows[2] = first.rows[0];
  first.rows[2].kind = WeldKind::generalized, first.rows[2].id = 3;
  SwforcState second = first;
  second.time = 0.002;
  second.rows[0].failure = 1.0, second.rows[0].failure_time = 0.0015, second.rows[0].axial = 0.0;
  second.rows[0].length = second.rows[0].resultant_moment = second.rows[0].torsion = 0.0;
  const HistoryRecord record = written_and_read(swforc(), "swforc", false, std::vector{first, second});
  EXPECT_THAT(record.times, testing::ElementsAre(0.001, 0.002));
  EXPECT_EQ(value(record, "weld 50001", "axial", 0), 1234.5);
  EXPECT_EQ(value(record, "weld 50001", "failure", 0), 0.25);
  EXPECT_EQ(value(record, "weld 50001", "failure", 1), 1.0);
  EXPECT_EQ(value(record, "weld 50001", "failure_time", 1), 0.0015);
  EXPECT_EQ(value(record, "weld 50001", "torsion", 0), -3.0);
  EXPECT_EQ(value(record, "weld 50001", "torsion", 1), 0.0);
  EXPECT_EQ(value(record, "weld 99999999", "resultant_moment", 1), 7.0);
  EXPECT_EQ(value(record, "weld 3", "axial", 1), 1234.5);
  EXPECT_EQ(find(record, "weld 50001", "axial")->dimension, dimension::force);
  EXPECT_EQ(find(record, "weld 50001", "torsion")->dimension, dimension::moment);
  EXPECT_NEAR(value(record, "weld 50001", "resultant_force", 0), std::hypot(1234.5, 20.0), 0.01);
}

TEST(HistoryReader, GlstatHasWallsOfTheirOwn) {
  GlstatState s;
  s.time = 0.5, s.time_step = 1e-6, s.kinetic = 12.0, s.internal = 3.0, s.ratio = 0.99, s.walls = {4.0, 5.0};
  s.velocity = {1.0, -2.0, 3.0};
  s.added_mass = 0.25, s.percent_increase = 1.5;
  s.cycle = 7;
  GlstatState t = s;
  t.time = 1.0, t.kinetic = 6.0;
  const HistoryRecord record = expect_both_alike(glstat(), "glstat", std::vector{s, t});
  EXPECT_EQ(value(record, "", "kinetic_energy", 1), 6.0);
  EXPECT_EQ(value(record, "wall 2", "stonewall_energy", 0), 5.0);
  EXPECT_EQ(value(record, "", "global_y_velocity", 0), -2.0);
  EXPECT_EQ(value(record, "", "percent_increase", 0), 1.5);
  EXPECT_EQ(value(record, "", "energy_ratio", 0), 0.99);
}

TEST(HistoryReader, FilesOfForces) {
  const LegendEntry legend[] = {{1, "barrier"}, {2, "bolster"}};
  RwforcState walls{0.25, {{1, 10.0, {1.0, 2.0, 3.0}}, {2, 20.0, {4.0, 5.0, 6.0}}}};
  RwforcState later = walls;
  later.time = 0.5;
  const HistoryRecord of_walls = expect_both_alike(rwforc(), "rwforc", std::vector{walls, later}, legend);
  EXPECT_EQ(value(of_walls, "wall 2", "normal_force", 1), 20.0);
  EXPECT_EQ(find(of_walls, "wall 1", "x_force")->title, "barrier");
  RcforcState contacts;
  contacts.time = 0.25;
  contacts.rows = {{}, {}};
  contacts.rows[0].contact = contacts.rows[1].contact = 12345;
  contacts.rows[0].side = ContactSide::tracked, contacts.rows[1].side = ContactSide::reference;
  contacts.rows[0].force = {1.0, -2.0, 3.0}, contacts.rows[1].force = {-1.0, 2.0, -3.0};
  RcforcState after = contacts;  // at the same printed time: still a state of its own
  after.rows[0].force.x = 9.0;
  const HistoryRecord of_contacts = written_and_read(rcforc(), "rcforc", false, std::vector{contacts, after});
  EXPECT_EQ(of_contacts.times.size(), 2u);
  EXPECT_EQ(value(of_contacts, "contact 12345 tracked side", "x_force", 1), 9.0);
  EXPECT_EQ(value(of_contacts, "contact 12345 reference side", "y_force", 0), 2.0);
  after.time = 0.5;
  expect_both_alike(rcforc(), "rcforc", std::vector{contacts, after});
  NcforcState by_node{
      0.25,
      {{7, ContactSide::tracked, {{12, {1, 2, -3}, 40.0, {10, 20, 30}}, {101, {-1, 0, 0.5}, 0.0, {0, 0, 1}}}},
       {7, ContactSide::reference, {{12, {0, -2, -3.5}, 8.0, {1, 1, 1}}}},
       {12345678, ContactSide::tracked, {{3, {4, 5, 6}, 7.0, {8, 9, 10}}}}}};
  NcforcState later_by_node = by_node;
  later_by_node.time = 0.5;
  const HistoryRecord of_nodes =
      expect_both_alike(ncforc(by_node.sides), "ncforc", std::vector{by_node, later_by_node});
  EXPECT_EQ(value(of_nodes, "contact 7 tracked side node 12", "z_force", 1), -3.0);
  EXPECT_EQ(value(of_nodes, "contact 7 tracked side node 12", "y", 0), 20.0);
  EXPECT_EQ(value(of_nodes, "contact 7 reference side node 12", "pressure", 0), 8.0);
  EXPECT_EQ(value(of_nodes, "contact 12345678 tracked side node 3", "x_force", 1), 4.0);
  const SecforcState sections{0.5,
                              {{7, {300, -400, 0}, {1, 2, 2}, {10, 20, 30}, 150.0, SectionAxes::global, 0},
                               {9, {0, 0, -6}, {0, 3, 4}, {1, 2, 3}, 2.0, SectionAxes::system, 33377}}};
  const HistoryRecord of_sections = expect_both_alike(secforc(), "secforc", std::vector{sections});
  EXPECT_EQ(value(of_sections, "section 7", "y_force", 0), -400.0);
  EXPECT_EQ(value(of_sections, "section 9", "z_moment", 0), 4.0);
  EXPECT_EQ(value(of_sections, "section 9", "area", 0), 2.0);
}

TEST(HistoryReader, MotionsOfNodesPartsAndBodies) {
  NodoutState nodes;
  nodes.time = 0.5;
  nodes.rotations = true;
  nodes.rows = {{}, {}};
  nodes.rows[0].node = 17, nodes.rows[1].node = 123456789;
  nodes.rows[0].displacement = {-1.5, 2.5, -3.5};
  nodes.rows[1].acceleration = {-1e10, -2e10, -3e10};
  nodes.rows[1].coordinate = {7.0, 8.0, 9.0};
  nodes.rows[1].rotational_velocity = {0.25, 0.5, 0.75};
  NodoutState then = nodes;
  then.time = 1.0;
  const HistoryRecord of_nodes = expect_both_alike(nodout(), "nodout", std::vector{nodes, then});
  EXPECT_EQ(value(of_nodes, "node 17", "z_displacement", 1), -3.5);
  EXPECT_EQ(value(of_nodes, "node 123456789", "y_acceleration", 0), -2e10);
  EXPECT_EQ(value(of_nodes, "node 123456789", "rz_velocity", 0), 0.75);
  MatsumState parts;
  parts.time = 0.5;
  parts.rows = {{}, {}};
  parts.rows[0].part = 4, parts.rows[1].part = 123456;
  parts.rows[0].internal = 1.0, parts.rows[0].kinetic = 2.0, parts.rows[1].hourglass = 3.0;
  parts.rows[1].momentum = {4.0, 5.0, 6.0}, parts.rows[1].velocity = {7.0, 8.0, 9.0}, parts.rows[0].added_mass = 0.5;
  const HistoryRecord of_parts = expect_both_alike(matsum(), "matsum", std::vector{parts});
  EXPECT_EQ(value(of_parts, "part 4", "kinetic_energy", 0), 2.0);
  EXPECT_EQ(value(of_parts, "part 123456", "z_rbvelocity", 0), 9.0);
  EXPECT_EQ(value(of_parts, "part 4", "mass", 0), 0.5);
  RbdoutState bodies;
  bodies.time = 0.5;
  bodies.parts = {{}}, bodies.nodal = {{}};
  bodies.parts[0].id = 3, bodies.nodal[0].id = 3;
  bodies.parts[0].velocity = {0.0, 0.0, -12.0}, bodies.nodal[0].rotation = {0.1, 0.2, 0.3};
  const HistoryRecord of_bodies = expect_both_alike(rbdout(), "rbdout", std::vector{bodies});
  EXPECT_EQ(value(of_bodies, "rigid body 3", "global_vz", 0), -12.0);
  EXPECT_EQ(value(of_bodies, "nodal rigid body 3", "global_rdy", 0), 0.2);
}

TEST(HistoryReader, SupportsSpringsJointsAndTheRest) {
  SpcforcState supports;
  supports.time = 0.5;
  supports.forces = {{}, {}}, supports.moments = {{}};
  supports.forces[0].node = 3, supports.forces[0].value = {1.0, 2.0, 3.0};
  supports.forces[1].node = 8, supports.forces[1].value = {-4.0, -5.0, -6.0};
  supports.moments[0].node = 5, supports.moments[0].value = {7.0, 8.0, 9.0};
  supports.resultant = {-3.0, -3.0, -3.0};
  const HistoryRecord of_supports = expect_both_alike(spcforc(), "spcforc", std::vector{supports});
  EXPECT_EQ(value(of_supports, "node 8", "z_force", 0), -6.0);
  EXPECT_EQ(value(of_supports, "node 5", "y_moment", 0), 8.0);
  EXPECT_EQ(value(of_supports, "", "x_resultant", 0), -3.0);
  DeforcState springs;
  springs.time = 0.5;
  springs.rows = {{}};
  springs.rows[0].spring = 6, springs.rows[0].force = {1.0, 2.0, 2.0}, springs.rows[0].resultant = 3.0;
  springs.rows[0].displacement = -0.5;
  const HistoryRecord of_springs = expect_both_alike(deforc(), "deforc", std::vector{springs});
  EXPECT_EQ(value(of_springs, "spring 6", "displacement", 0), -0.5);
  JntforcState joints;
  joints.time = 0.5;
  joints.rows = {{}, {}};
  joints.rows[0].joint = 1, joints.rows[1].joint = 2;
  joints.rows[1].force = {3.0, 4.0, 0.0}, joints.rows[1].moment = {0.0, 0.0, 2.0};
  const HistoryRecord of_joints = expect_both_alike(jntforc(), "jntforc", std::vector{joints});
  EXPECT_EQ(value(of_joints, "joint 2", "resultant_force", 0), 5.0);
  SleoutState contacts;
  contacts.time = 0.5;
  contacts.rows = {{}};
  contacts.rows[0].contact = 2, contacts.rows[0].tracked = 1.0, contacts.rows[0].reference = 2.0;
  contacts.rows[0].friction = 0.5;
  const HistoryRecord of_contacts = expect_both_alike(sleout(), "sleout", std::vector{contacts});
  EXPECT_EQ(value(of_contacts, "contact 2", "friction_energy", 0), 0.5);
}

TEST(HistoryReader, AStateThatIsCutOffIsLeftOut) {
  Scratch scratch;
  {
    AsciiHistory ascii(rwforc(), scratch / "rwforc", header);
    for (const double time : {0.25, 0.5})
      ascii.write({time, {{1, 10.0 * time, {1.0, 2.0, 3.0}}, {2, 5.0, {1.0, 2.0, 3.0}}}});
  }
  std::filesystem::resize_file(scratch / "rwforc", std::filesystem::file_size(scratch / "rwforc") - 5);
  const std::vector<HistoryRecord> records = read_histories(scratch.path());
  ASSERT_EQ(records.size(), 1u);
  EXPECT_THAT(records[0].times, testing::ElementsAre(0.25));
  for (const Channel& channel : records[0].channels) EXPECT_EQ(channel.values.size(), 1u);
  EXPECT_EQ(value(records[0], "wall 2", "normal_force", 0), 5.0);
}

TEST(HistoryReader, NothingOfAnEmptyFolder) {
  Scratch scratch;
  EXPECT_TRUE(read_histories(scratch.path()).empty());
}

}  // namespace
}  // namespace nugget::output
