// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "output/binout.hpp"
#include "output/elout.hpp"
#include "output/nodfor.hpp"
#include "output/secforc.hpp"
#include "unit/output/lsda.hpp"
#include "unit/output/scratch.hpp"

// secforc, nodfor and elout: lines as LSTC's translator l2a writes them, branches as it reads them.
namespace nugget::output {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Header header{"two plates", "nugget 0.1.0", "01/02/2026"};

SecforcState sections() {
  return {0.5,
          {{7, {300, 400, 0}, {1, 2, 2}, {10, 20, 30}, 150.0, SectionAxes::global, 0},
           {9, {0, 0, -6}, {0, 3, 4}, {1, 2, 3}, 2.0, SectionAxes::system, 33377}}};
}

TEST(Secforc, HasThreeLinesForEachSection) {
  Scratch scratch;
  const std::vector<LegendEntry> legend{{7, "rail"}};
  AsciiHistory(secforc(), scratch / "secforc", header, legend).write(sections());
  const std::string text = content(scratch / "secforc");
  EXPECT_THAT(text, HasSubstr("        7     rail"));
  EXPECT_THAT(text, HasSubstr("\n\n line#1  section#     time        x-force     y-force     z-force    magnitude\n"
                              " line#2  resultant  moments       x-moment    y-moment    z-moment   magnitude\n"
                              " line#3  centroids                x           y           z            area  \n"
                              "           7    5.00000E-01     3.0000E+02  4.0000E+02  0.0000E+00  5.0000E+02\n"
                              "global system                   1.0000E+00  2.0000E+00  2.0000E+00  3.0000E+00\n"
                              "                                1.0000E+01  2.0000E+01  3.0000E+01  1.5000E+02\n\n"
                              "           9    5.00000E-01     0.0000E+00  0.0000E+00 -6.0000E+00  6.0000E+00\n"
                              "cs ID =   33377                 0.0000E+00  3.0000E+00  4.0000E+00  5.0000E+00\n"));
}

TEST(Secforc, StandsInBinout) {
  Scratch scratch;
  Binout(scratch.path(), header).write(secforc(), sections());
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_THAT(lsda.integers("/secforc/metadata/ids"), ElementsAre(7, 9));
  EXPECT_THAT(lsda.integers("/secforc/metadata/rigidbody"), ElementsAre(0, 0));
  EXPECT_THAT(lsda.integers("/secforc/metadata/accelerometer"), ElementsAre(0, 0));
  EXPECT_THAT(lsda.integers("/secforc/metadata/coordinate_system"), ElementsAre(0, 33377));
  EXPECT_THAT(lsda.reals("/secforc/d000001/y_force"), ElementsAre(400.0, 0.0));
  EXPECT_THAT(lsda.reals("/secforc/d000001/total_force"), ElementsAre(500.0, 6.0));
  EXPECT_THAT(lsda.reals("/secforc/d000001/total_moment"), ElementsAre(3.0, 5.0));
  EXPECT_THAT(lsda.reals("/secforc/d000001/z_centroid"), ElementsAre(30.0, 3.0));
  EXPECT_THAT(lsda.reals("/secforc/d000001/area"), ElementsAre(150.0, 2.0));
}

NodforState groups() {
  NodforState s{0.25, {{4, {{101, {1, 2, 3}, 10.0}, {102, {4, 5, 6}, 20.0}}, {}}, {5, {{103, {7, 0, 0}, 1.0}}, {}}}};
  s.groups[1].axes = Frame3d{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  return s;
}

TEST(Nodfor, ListsGroupsWithTheirSums) {
  Scratch scratch;
  AsciiHistory(nodfor(), scratch / "nodfor", header).write(groups());
  const std::string text = content(scratch / "nodfor");
  EXPECT_THAT(text,
              HasSubstr("\n\n\n\n\n n o d a l   f o r c e   g r o u p    o u t p u t   t=2.500E-01\n"
                        "\n\n\n\n\n nodal group output number  1\n\n"
                        " nd#     101  xforce=   1.0000E+00   yforce=   2.0000E+00  zforce=   3.0000E+00   energy="
                        "   1.0000E+01   setid =       4\n"));
  EXPECT_THAT(text,
              HasSubstr("              xtotal=   5.0000E+00   ytotal=   7.0000E+00  ztotal=   9.0000E+00   etotal="
                        "   3.0000E+01\n"));
  EXPECT_THAT(text, HasSubstr("              xlocal=   0.0000E+00   ylocal=  -7.0000E+00  zlocal=   0.0000E+00\n"));
}

TEST(Nodfor, StandsInBinout) {
  Scratch scratch;
  Binout(scratch.path(), header).write(nodfor(), groups());
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_THAT(lsda.integers("/nodfor/metadata/ids"), ElementsAre(101, 102, 103));
  EXPECT_THAT(lsda.integers("/nodfor/metadata/groups"), ElementsAre(2, 1));
  EXPECT_THAT(lsda.integers("/nodfor/metadata/local"), ElementsAre(0, 1));
  EXPECT_THAT(lsda.reals("/nodfor/d000001/x_force"), ElementsAre(1.0, 4.0, 7.0));
  EXPECT_THAT(lsda.reals("/nodfor/d000001/y_total"), ElementsAre(7.0, 0.0));
  EXPECT_THAT(lsda.reals("/nodfor/d000001/etotal"), ElementsAre(30.0, 1.0));
  EXPECT_THAT(lsda.reals("/nodfor/d000001/y_local"), ElementsAre(-7.0));
}

EloutState elements() {
  EloutState s;
  s.cycle = 12;
  s.time = 0.5;
  s.strains = true;
  s.solids = {{3, 1, {{300, 0, 0, 0, 0, 0}, 0.0}, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}}};
  s.beams = {{11, 5, 100, 1, 2, 3, 4, 5, 6, {{10, 20, 30, 0.125}}}};
  s.shells = {{21, 2, {{{1, 2, 0, 3, 4, 5}, 0.0}, {{6, 7, 0, 8, 9, 10}, 0.25}}, {}, {0.5, 0, 0, 0, 0, 0}}};
  return s;
}

TEST(Elout, ListsBricksBeamsAndShells) {
  Scratch scratch;
  AsciiHistory(elout(), scratch / "elout", header).write(elements());
  const std::string text = content(scratch / "elout");
  EXPECT_THAT(text,
              HasSubstr(" e l e m e n t   s t r e s s   c a l c u l a t i o n s   f o r   t i m e  s t e p       12   "
                        "( at time  5.00000E-01 )\n"));
  EXPECT_THAT(text, HasSubstr("       3-      1\n       1 elastic   3.0000E+02  0.0000E+00  0.0000E+00  0.0000E+00"
                              "  0.0000E+00  0.0000E+00    3.0000E+02    0.0000E+00\n"));
  EXPECT_THAT(text,
              HasSubstr("      1  elastic   1.0000E-01  2.0000E-01  3.0000E-01  4.0000E-01  5.0000E-01  6.0000E-01\n"));
  EXPECT_THAT(text, HasSubstr("\n\n beam/truss # =      11      part ID  =         5      material type=     100\n"
                              "\n resultants      axial    shear-s    shear-t    moment-s   moment-t   torsion\n"
                              "             1.000E+00  2.000E+00  3.000E+00  4.000E+00  5.000E+00  6.000E+00\n"));
  EXPECT_THAT(text, HasSubstr("    1              1.000000E+01   2.000000E+01   3.000000E+01   1.250000E-01\n"));
  EXPECT_THAT(text,
              HasSubstr("      21-      2\n"
                        "   1-  0 elastic   1.0000E+00  2.0000E+00  0.0000E+00  3.0000E+00  4.0000E+00  5.0000E+00"
                        "    0.0000E+00\n"
                        "   2-  0 plastic   6.0000E+00  7.0000E+00  0.0000E+00  8.0000E+00  9.0000E+00  1.0000E+01"
                        "    2.5000E-01\n"));
  EXPECT_THAT(text, HasSubstr(" upper ipt         5.0000E-01  0.0000E+00"));
}

TEST(Elout, StandsInBinoutKindByKind) {
  Scratch scratch;
  Binout file(scratch.path(), header);
  file.set_legend("elout/shell", {{21, "door"}});
  file.write(elout(), elements());
  file.write(elout(), elements());
  const Lsda lsda(content(scratch / "binout0000"));
  EXPECT_THAT(lsda.integers("/elout/shell/d000002/ids"), ElementsAre(21));
  EXPECT_THAT(lsda.integers("/elout/shell/d000001/nip"), ElementsAre(2));
  EXPECT_THAT(lsda.integers("/elout/shell/d000001/state"), ElementsAre(1, 2));
  EXPECT_THAT(lsda.reals("/elout/shell/d000001/sig_xx"), ElementsAre(1.0, 6.0));
  EXPECT_THAT(lsda.reals("/elout/shell/d000001/sig_zx"), ElementsAre(5.0, 10.0));
  EXPECT_THAT(lsda.reals("/elout/shell/d000001/plastic_strain"), ElementsAre(0.0, 0.25));
  EXPECT_THAT(lsda.reals("/elout/shell/d000001/upper_eps_xx"), ElementsAre(0.5));
  EXPECT_EQ(lsda.text("/elout/shell/metadata/states"), "elastic,plastic");
  EXPECT_EQ(lsda.text("/elout/shell/metadata/legend").substr(0, 4), "door");
  EXPECT_FALSE(lsda.has("/elout/solid/metadata/legend"));
  EXPECT_THAT(lsda.reals("/elout/solid/d000001/effsg"), ElementsAre(300.0));
  EXPECT_THAT(lsda.reals("/elout/solid/d000001/eps_zx"), ElementsAre(0.6));
  EXPECT_THAT(lsda.integers("/elout/beam/d000001/mtype"), ElementsAre(100));
  EXPECT_THAT(lsda.reals("/elout/beam/d000001/torsion"), ElementsAre(6.0));
  EXPECT_THAT(lsda.reals("/elout/beam/d000001/sigma_31"), ElementsAre(30.0));
}

/// Each row a state of its own.
std::vector<EloutState> row_by_row(const EloutState& s) {
  EloutState head = s;
  head.solids.clear(), head.beams.clear(), head.shells.clear(), head.thick_shells.clear();
  std::vector<EloutState> rows;
  for (const auto list : {&EloutState::shells, &EloutState::thick_shells})
    for (const EloutShell& row : s.*list) (rows.emplace_back(head).*list).push_back(row);
  for (const EloutSolid& row : s.solids) rows.emplace_back(head).solids.push_back(row);
  for (const EloutBeam& row : s.beams) rows.emplace_back(head).beams.push_back(row);
  return rows;
}

// Sabotage: a row at the place of the one before it, or of another branch.
TEST(Elout, RowsOneByOneGiveTheBytesOfAll) {
  EloutState s = elements();
  s.solids.push_back({4, 1, {{1, 2, 3, 4, 5, 6}, 0.5}, {6, 5, 4, 3, 2, 1}});
  s.beams.push_back({12, 5, 100, 7, 8, 9, 10, 11, 12, {}});
  s.beams.push_back({13, 6, 1, 1, 1, 1, 1, 1, 1, {{1, 2, 3, 4}, {5, 6, 7, 8}}});
  s.shells.push_back({22, 3, {{{9, 8, 7, 6, 5, 4}, 1.0}}, {1, 2, 3, 4, 5, 6}, {}});
  s.thick_shells = {{31, 4, {{{1, 1, 2, 3, 5, 8}, 0.0}}, {}, {}}};
  Scratch whole, pieces;
  Binout one(whole.path(), header), some(pieces.path(), header);
  HistoryShape<EloutState> shape(elout());
  std::vector<EloutState> first(elout().branches.size());
  for (const EloutState& row : row_by_row(s)) {
    shape.add(elout(), row);
    for (std::size_t b = 0; b < first.size(); ++b)
      if (elout().branches[b].is_in(row)) first[b] = row;
  }
  for (int state = 0; state < 2; ++state) {
    one.write(elout(), s);
    some.begin_pieces(elout(), shape, first);
    for (const EloutState& row : row_by_row(s)) some.put_piece(elout(), row);
    some.end_pieces();
    EXPECT_EQ(content(pieces / "binout0000"), content(whole / "binout0000"));
  }
  some.begin_pieces(elout(), shape, first);
  EXPECT_THROW(some.end_pieces(), std::logic_error);

  AsciiHistory(elout(), whole / "elout", header).write(s);
  AsciiHistory(elout(), pieces / "elout", header).write_by([&](AsciiFile& file) {
    for (const EloutTable table : elout_tables) {
      print_head(file, table, s);
      for (const EloutState& row : row_by_row(s)) print_rows(file, table, row);
      file.end_part();
    }
  });
  EXPECT_EQ(content(pieces / "elout"), content(whole / "elout"));
}

TEST(Elout, EffectiveStressOfShear) {
  EXPECT_DOUBLE_EQ(effective({0, 0, 0, 1, 0, 0}), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(effective({5, 5, 5, 0, 0, 0}), 0.0);
}

}  // namespace
}  // namespace nugget::output
