// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>

#include "output/binout.hpp"
#include "output/bndout.hpp"
#include "output/dcfail.hpp"
#include "output/glstat.hpp"
#include "output/matsum.hpp"
#include "output/nodout.hpp"
#include "output/rbdout.hpp"
#include "output/rcforc.hpp"
#include "output/rwforc.hpp"
#include "output/sleout.hpp"
#include "output/spcforc.hpp"
#include "output/swforc.hpp"
#include "unit/output/lsda.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::output {
namespace {

using testing::ElementsAre;

const Header header{"two plates", "nugget 0.1.0", "01/02/2026"};

SwforcState welds(double time) {
  return {time,
          {{90001, WeldKind::beam, 1000.0 * time, 50.0, 1.5, 7.0, 3.0, 0.25, 0.0},
           {90002, WeldKind::solid, -2.0, 60.0, 1.6, 8.0, 4.0, 1.0, 0.125}}};
}

TEST(Binout, HoldsEachStateOfSwforc) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  file.write(swforc(), welds(0.5));
  file.write(swforc(), welds(1.0));
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_EQ(lsda.text("/swforc/metadata/title"), "two plates" + std::string(70, ' '));
  EXPECT_EQ(lsda.text("/swforc/metadata/version"), "nugget 0.1.0");
  EXPECT_EQ(lsda.text("/swforc/metadata/date"), "01/02/2026");
  EXPECT_EQ(lsda.text("/swforc/metadata/typenames"), "constraint,weld,beam,solid,non nodal, ,solid assembly");
  EXPECT_THAT(lsda.integers("/swforc/metadata/ids"), ElementsAre(90001, 90002));
  EXPECT_THAT(lsda.integers("/swforc/metadata/types"), ElementsAre(2, 3));
  EXPECT_THAT(lsda.reals("/swforc/d000001/time"), ElementsAre(0.5));
  EXPECT_THAT(lsda.reals("/swforc/d000002/time"), ElementsAre(1.0));
  EXPECT_THAT(lsda.reals("/swforc/d000001/axial"), ElementsAre(500.0, -2.0));
  EXPECT_THAT(lsda.reals("/swforc/d000002/axial"), ElementsAre(1000.0, -2.0));
  EXPECT_THAT(lsda.reals("/swforc/d000002/shear"), ElementsAre(50.0, 60.0));
  EXPECT_THAT(lsda.reals("/swforc/d000002/failure"), ElementsAre(0.25, 1.0));
  EXPECT_THAT(lsda.reals("/swforc/d000002/failure_time"), ElementsAre(0.0, 0.125));
  EXPECT_THAT(lsda.reals("/swforc/d000002/length"), ElementsAre(1.5, 1.6));
  EXPECT_THAT(lsda.reals("/swforc/d000002/resultant_moment"), ElementsAre(7.0, 8.0));
  EXPECT_THAT(lsda.reals("/swforc/d000002/torsion"), ElementsAre(3.0, 4.0));
}

TEST(Binout, HoldsTheTermsOfConnections) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  file.write(dcfail(), {0.5, {{11, 7, 0.9, 0.4, 0.3, 0.2, 28.0, 25.0, 60.0, 1000.0, 200.0, 30.0, 4.0}}});
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_THAT(lsda.integers("/dcfail/metadata/ids"), ElementsAre(11));
  EXPECT_THAT(lsda.integers("/dcfail/metadata/type"), ElementsAre(7));
  const std::pair<const char*, double> values[] = {{"failure_function", 0.9},
                                                   {"normal_term", 0.4},
                                                   {"bending_term", 0.3},
                                                   {"shear_term", 0.2},
                                                   {"area", 28.0},
                                                   {"area_sol", 25.0},
                                                   {"axial_force", 1000.0},
                                                   {"shear_force", 200.0},
                                                   {"effective_strain_rate", 60.0},
                                                   {"bending_moment", 4.0},
                                                   {"torsional_moment", 30.0},
                                                   {"time", 0.5}};
  for (const auto& [name, value] : values)
    EXPECT_THAT(lsda.reals(std::string("/dcfail/d000001/") + name), ElementsAre(value)) << name;
}

TEST(Binout, EachTableIsAlphabetical) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  file.write(swforc(), welds(0.5));
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_TRUE(std::is_sorted(lsda.paths().begin(), lsda.paths().end()));
  EXPECT_EQ(lsda.paths().front(), "/swforc/d000001/axial");
}

TEST(Binout, AHalfWrittenStateIsNotSeen) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  file.write(swforc(), welds(0.5));
  const std::string first = content(scratch / "binout0000");
  file.write(swforc(), welds(1.0));
  const std::string both = content(scratch / "binout0000");
  const Lsda killed(first + both.substr(first.size(), 100));
  EXPECT_TRUE(killed.has("/swforc/d000001/axial"));
  EXPECT_FALSE(killed.has("/swforc/d000002/axial"));
}

TEST(Binout, GlstatLeavesOutWhatIsAbsent) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  GlstatState s;
  s.cycle = 42;
  s.controlling = {ElementKind::shell, 17, 5};
  s.time = 0.5;
  s.kinetic = 3.0;
  s.walls = {1.0, 2.0};
  s.hourglass = 4.0;
  s.velocity = {1.0, 2.0, 3.0};
  file.write(glstat(), s);
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_EQ(lsda.text("/glstat/metadata/element_types"), "solid,beam,shell,thick shell,discrete");
  EXPECT_THAT(lsda.integers("/glstat/d000001/cycle"), ElementsAre(42));
  EXPECT_THAT(lsda.integers("/glstat/d000001/ts_eltype"), ElementsAre(3));
  EXPECT_THAT(lsda.integers("/glstat/d000001/ts_element"), ElementsAre(17));
  EXPECT_THAT(lsda.integers("/glstat/d000001/ts_part"), ElementsAre(5));
  EXPECT_THAT(lsda.reals("/glstat/d000001/kinetic_energy"), ElementsAre(3.0));
  EXPECT_THAT(lsda.reals("/glstat/d000001/stonewall_energy"), ElementsAre(1.0, 2.0));
  EXPECT_THAT(lsda.reals("/glstat/d000001/hourglass_energy"), ElementsAre(4.0));
  EXPECT_THAT(lsda.reals("/glstat/d000001/global_y_velocity"), ElementsAre(2.0));
  EXPECT_FALSE(lsda.has("/glstat/d000001/eroded_kinetic_energy"));
  EXPECT_FALSE(lsda.has("/glstat/d000001/added_mass"));
}

TEST(Binout, HoldsPartsNodesWallsAndContacts) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  file.set_legend("matsum", {{4, "hat"}});
  MatsumRow part;
  part.part = 4;
  part.internal = 1.0, part.momentum = {1.0, 2.0, 3.0}, part.velocity = {4.0, 5.0, 6.0}, part.added_mass = 7.0;
  file.write(matsum(), {0.5, {part}, 0.25});
  NodoutRow node;
  node.node = 605;
  node.displacement = {-641.87, 1.0, 2.0}, node.rotation = {0.1, 0.2, 0.3};
  file.write(nodout(), {7, 0.5, true, {node}});
  file.write(rwforc(), {0.5, {{1, 5.0, {3.0, 4.0, 0.0}}}});
  file.write(rcforc(), {0.5, {{3, ContactSide::reference, {1.0, 2.0, 3.0}, 4.0}}});
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_EQ(lsda.text("/matsum/metadata/legend"), "hat" + std::string(67, ' '));
  EXPECT_THAT(lsda.integers("/matsum/metadata/legend_ids"), ElementsAre(4));
  EXPECT_THAT(lsda.integers("/matsum/metadata/ids"), ElementsAre(4));
  EXPECT_THAT(lsda.reals("/matsum/d000001/internal_energy"), ElementsAre(1.0));
  EXPECT_THAT(lsda.reals("/matsum/d000001/lumped_kinetic_energy"), ElementsAre(0.25));
  EXPECT_THAT(lsda.reals("/matsum/d000001/z_momentum"), ElementsAre(3.0));
  EXPECT_THAT(lsda.reals("/matsum/d000001/x_rbvelocity"), ElementsAre(4.0));
  EXPECT_THAT(lsda.reals("/matsum/d000001/mass"), ElementsAre(7.0));
  EXPECT_THAT(lsda.integers("/nodout/metadata/ids"), ElementsAre(605));
  EXPECT_THAT(lsda.integers("/nodout/d000001/cycle"), ElementsAre(7));
  EXPECT_THAT(lsda.reals("/nodout/d000001/x_displacement"), ElementsAre(-641.87));
  EXPECT_THAT(lsda.reals("/nodout/d000001/rz_displacement"), ElementsAre(0.3));
  EXPECT_THAT(lsda.integers("/rwforc/forces/metadata/setid"), ElementsAre(1));
  EXPECT_THAT(lsda.reals("/rwforc/forces/d000001/normal_force"), ElementsAre(5.0));
  EXPECT_THAT(lsda.reals("/rwforc/forces/d000001/y_force"), ElementsAre(4.0));
  EXPECT_THAT(lsda.integers("/rcforc/metadata/side"), ElementsAre(1));
  EXPECT_THAT(lsda.reals("/rcforc/d000001/z_force"), ElementsAre(3.0));
}

TEST(Binout, HoldsTheEnergiesOfContacts) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  file.write(sleout(), {0.5, 7, {{3, 2.0, 0.0, true, 1.5}, {4, 5.0, -1.0, false, 0.25}}});
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_THAT(lsda.integers("/sleout/metadata/ids"), ElementsAre(3, 4));
  EXPECT_THAT(lsda.integers("/sleout/metadata/single_sided"), ElementsAre(1, 0));
  EXPECT_THAT(lsda.reals("/sleout/d000001/slave"), ElementsAre(2.0, 5.0));
  EXPECT_THAT(lsda.reals("/sleout/d000001/master"), ElementsAre(0.0, -1.0));
  EXPECT_THAT(lsda.reals("/sleout/d000001/total_energy"), ElementsAre(6.0));
  EXPECT_THAT(lsda.reals("/sleout/d000001/friction_energy"), ElementsAre(1.5, 0.25));
  EXPECT_THAT(lsda.reals("/sleout/d000001/total_friction"), ElementsAre(1.75));
}

TEST(Binout, HoldsSupportsAndRigidBodies) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  SpcforcState spc;
  spc.forces = {{2, {1.0, 2.0, 3.0}, 9}};
  spc.moments = {{1, {0.0, 0.0, 4.0}, 8}};
  spc.resultant = {1.0, 2.0, 3.0};
  file.write(spcforc(), spc);
  BndoutState bnd;
  bnd.nodes = {{11, {1.0, 2.0, 3.0}, 4.0, 5}, {12, {1.0, 0.0, 0.0}, 2.0, 5}};
  bnd.bodies = {{7, {10.0, 20.0, 30.0}, {1.0, 0.0, 0.5}, 40.0}};
  file.write(bndout(), bnd);
  RbdoutState rbd;
  rbd.parts.resize(1), rbd.nodal.resize(1);
  rbd.parts[0].id = 4, rbd.nodal[0].id = 9;
  rbd.nodal[0].velocity = {1.0, 2.0, 3.0};
  rbd.nodal[0].axes = {{0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
  file.write(rbdout(), rbd);
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_THAT(lsda.integers("/spcforc/metadata/force_ids"), ElementsAre(2));
  EXPECT_THAT(lsda.integers("/spcforc/metadata/moment_ids"), ElementsAre(1));
  EXPECT_THAT(lsda.integers("/spcforc/metadata/spc_ids"), ElementsAre(9));
  EXPECT_THAT(lsda.integers("/spcforc/metadata/spc_mids"), ElementsAre(8));
  EXPECT_THAT(lsda.reals("/spcforc/d000001/z_moment"), ElementsAre(4.0));
  EXPECT_THAT(lsda.reals("/spcforc/d000001/y_resultant"), ElementsAre(2.0));
  EXPECT_THAT(lsda.integers("/bndout/velocity/nodes/metadata/ids"), ElementsAre(11, 12));
  EXPECT_THAT(lsda.reals("/bndout/velocity/nodes/d000001/x_total"), ElementsAre(2.0));
  EXPECT_THAT(lsda.reals("/bndout/velocity/nodes/d000001/etotal"), ElementsAre(6.0));
  EXPECT_THAT(lsda.reals("/bndout/velocity/rigidbodies/d000001/zmoment"), ElementsAre(0.5));
  EXPECT_THAT(lsda.integers("/rbdout/metadata/ids"), ElementsAre(4, 9));
  EXPECT_THAT(lsda.integers("/rbdout/metadata/num_nodal"), ElementsAre(1));
  EXPECT_THAT(lsda.reals("/rbdout/d000001/global_vx"), ElementsAre(0.0, 1.0));
  EXPECT_THAT(lsda.reals("/rbdout/d000001/local_vx"), ElementsAre(0.0, 2.0));
  EXPECT_THAT(lsda.reals("/rbdout/d000001/dircos_21"), ElementsAre(0.0, 1.0));
}

TEST(Binout, RefusesEntitiesThatChange) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  file.write(swforc(), welds(0.5));
  SwforcState fewer = welds(1.0);
  fewer.rows.pop_back();
  EXPECT_THROW(file.write(swforc(), fewer), std::logic_error);
}

}  // namespace
}  // namespace nugget::output
