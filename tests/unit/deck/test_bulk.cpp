// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/index.hpp"
#include "reading.hpp"

// Tables of nodes and elements: the fast path, and the careful path for every line that is not plain.
namespace nugget::deck {
namespace {

struct Nodes : Reading {
  explicit Nodes(const std::string& text, const std::string& suffix = "")
      : Reading("*KEYWORD\n*NODE" + suffix + "\n" + text) {
    read_nodes(deck, block("NODE"), table, findings);
  }
  NodeTable table;
};

struct Elements : Reading {
  using Reader = void (*)(const Deck&, const Block&, ElementTable&, Findings&);
  Elements(Reader reader, const std::string& keyword, const std::string& text)
      : Reading("*KEYWORD\n*" + keyword + "\n" + text) {
    for (const Block& b : deck.blocks) {
      if (b.keyword.starts_with("ELEMENT")) reader(deck, b, table, findings);
    }
  }
  std::vector<int> nodes(std::size_t row) const {
    const auto n = at(table.nodes_per_element);
    return {table.node.begin() + static_cast<std::ptrdiff_t>(row * n),
            table.node.begin() + static_cast<std::ptrdiff_t>((row + 1) * n)};
  }
  ElementTable table;
};

TEST(BulkNodes, EverySpellingInOneTable) {
  const Nodes n(
      "$   nid               x\n"
      "       1             1.0             2.0             3.0       1       7\n"
      "       2            -1.5   -3.155446e-30            75.0\n"
      "$ a comment between\n"
      "50000003       -1819.511        295.2146        1498.789                \n"
      "       4             1.0                             2.0\n"
      "       5             1.0\n"
      "       6               1             1-3           1.d-3\n"
      "7       1.0             2.0             3.0\n"
      "8,1.0,,3.0,,5\n"
      "\t9             1.0             2.0             3.0\n"
      "\n"
      "      101.23456789012345-1.2345678901234            12.0\n"
      "      11             1.0             2.0             3.0     1.0     0.0        comment behind column 80\n");
  EXPECT_EQ(n.findings.errors(), 0) << listed(n.findings);
  EXPECT_EQ(n.findings.warnings(), 1) << listed(n.findings);  // of the tab
  const NodeTable& t = n.table;
  EXPECT_THAT(t.id, testing::ElementsAre(1, 2, 50000003, 4, 5, 6, 7, 8, 9, 10, 11));
  EXPECT_THAT(t.line, testing::ElementsAre(4, 5, 7, 8, 9, 10, 11, 12, 13, 15, 16));
  EXPECT_EQ(t.tc[0], 1);
  EXPECT_EQ(t.rc[0], 7);
  EXPECT_EQ(t.x[1].y, -3.155446e-30);
  EXPECT_EQ(t.x[2].x, -1819.511);
  EXPECT_EQ(t.x[3].z, 2.0);
  EXPECT_EQ(t.x[3].y, 0.0);
  EXPECT_EQ(t.x[4].z, 0.0);
  EXPECT_EQ(t.x[5].y, 1e-3);
  EXPECT_EQ(t.x[5].z, 1e-3);
  EXPECT_EQ(t.x[6].z, 3.0);
  EXPECT_EQ(t.x[7].z, 3.0);
  EXPECT_EQ(t.rc[7], 5);
  EXPECT_EQ(t.x[8].z, 3.0);
  EXPECT_EQ(t.x[9].x, 1.23456789012345);
  EXPECT_EQ(t.x[9].y, -1.2345678901234);
  EXPECT_EQ(t.tc[10], 1);
  EXPECT_EQ(t.file, std::vector<int>(11, 0));
}

TEST(BulkNodes, I10AndLongFormat) {
  const Nodes i10("1234567890            -1.0             2.0             3.0         0         7\n", " %");
  EXPECT_CLEAN(i10.findings);
  EXPECT_THAT(i10.table.id, testing::ElementsAre(1234567890));
  EXPECT_EQ(i10.table.x[0].x, -1.0);
  EXPECT_EQ(i10.table.rc[0], 7);
  const Nodes wide(
      "                  17                 1.0                 2.0                 3.0                   4            "
      "       0\n",
      "+");
  EXPECT_CLEAN(wide.findings);
  EXPECT_THAT(wide.table.id, testing::ElementsAre(17));
  EXPECT_EQ(wide.table.x[0].z, 3.0);
  EXPECT_EQ(wide.table.tc[0], 4);
}

TEST(BulkNodes, ParametersInAnyField) {
  Reading r("*KEYWORD\n*PARAMETER\nRx,1.5,In,3\n*NODE\n      &n              &x             -&x             2.0\n");
  NodeTable t;
  read_nodes(r.deck, r.block("NODE"), t, r.findings);
  EXPECT_CLEAN(r.findings);
  EXPECT_THAT(t.id, testing::ElementsAre(3));
  EXPECT_EQ(t.x[0].y, -1.5);
}

TEST(BulkNodes, FaultsNameTheirPlace) {
  const Nodes n(
      "       1             1.0             2.0             3.0\n"
      "       x             1.0             2.0             3.0\n"
      "       3            1.0e             2.0             3.0\n"
      "      -4             1.0             2.0             3.0\n"
      "       5             1.0             2.0             3.0       9\n");
  EXPECT_EQ(listed(n.findings),
            "(text):4:8: error: *NODE nid = x: an alphanumeric id is not supported, expected a whole number "
            "(node id) [give it a number for an id]\n"
            "(text):5:21: error: *NODE x = 1.0e: is not a number (coordinate x) [keep the number whole inside its "
            "columns, or separate the fields by commas]\n"
            "(text):6:7: error: *NODE nid = -4: expected 1 or more (node id)\n"
            "(text):7:64: error: *NODE tc = 9: expected 0 to 7 (constrained translations: 1 x, 2 y, 3 z, 4 xy, "
            "5 yz, 6 zx, 7 xyz)\n");
  EXPECT_THAT(n.table.id, testing::ElementsAre(1, 3, 5));
}

TEST(BulkNodes, FastAndCarefulPathGiveTheSameBits) {
  std::string plain, careful;
  for (int i = 1; i <= 2000; ++i) {
    char line[120];
    const double x = 1000.0 * std::sin(0.1 * i), y = std::exp(0.02 * i - 20.0), z = -0.37 * i;
    std::snprintf(line, sizeof line, i % 3 == 0 ? "%8d%16.9f%16.8e%16.6g" : "%8d%16.10g%16.4f%16.1f", i, x, y, z);
    plain += std::string(line) + '\n';
    careful += line + std::string(40, ' ') + "behind column 80\n";
  }
  const Nodes a(plain), b(careful);
  EXPECT_CLEAN(a.findings);
  EXPECT_CLEAN(b.findings);
  ASSERT_EQ(a.table.id, b.table.id);
  ASSERT_EQ(a.table.id.size(), 2000u);
  for (std::size_t i = 0; i < a.table.x.size(); ++i) {
    ASSERT_EQ(a.table.x[i].x, b.table.x[i].x);
    ASSERT_EQ(a.table.x[i].y, b.table.x[i].y);
    ASSERT_EQ(a.table.x[i].z, b.table.x[i].z);
  }
}

TEST(BulkShells, IdsWithoutBlanksCommasAndShortLines) {
  const Elements e(read_shells, "ELEMENT_SHELL",
                   "500000015000000150029261500296415002964350000001       0       0       0       0\n"
                   "       2       1      11      12      13\n"
                   "3,1,11,12,13,14\n"
                   "       4       1      11      12      13      14      15      16      17      18\n");
  EXPECT_CLEAN(e.findings);
  EXPECT_THAT(e.table.id, testing::ElementsAre(50000001, 2, 3, 4));
  EXPECT_THAT(e.table.part, testing::ElementsAre(50000001, 1, 1, 1));
  EXPECT_THAT(e.nodes(0), testing::ElementsAre(50029261, 50029641, 50029643, 50000001, 0, 0, 0, 0));
  EXPECT_THAT(e.nodes(1), testing::ElementsAre(11, 12, 13, 0, 0, 0, 0, 0));
  EXPECT_THAT(e.nodes(2), testing::ElementsAre(11, 12, 13, 14, 0, 0, 0, 0));
  EXPECT_THAT(e.nodes(3), testing::ElementsAre(11, 12, 13, 14, 15, 16, 17, 18));
  EXPECT_TRUE(e.table.thickness.empty());
}

TEST(BulkShells, ThicknessAngleAndOffset) {
  const Elements e(read_shells, "ELEMENT_SHELL_THICKNESS_OFFSET",
                   "       1       1      11      12      13      14\n"
                   "$         thic1           thic2           thic3           thic4            beta\n"
                   "             1.0             1.1             1.2             1.3            30.0\n"
                   "            -0.5\n"
                   "       2       1      11      12      13      14      15      16      17      18\n"
                   "             2.0             2.0             2.0             2.0\n"
                   "             2.0             2.0             2.0             2.0\n"
                   "             0.0\n"
                   "*ELEMENT_SHELL\n"
                   "       3       1      11      12      13      14\n");
  EXPECT_CLEAN(e.findings);
  ASSERT_EQ(e.table.id.size(), 3u);
  EXPECT_THAT(e.table.thickness[0], testing::ElementsAre(1.0, 1.1, 1.2, 1.3));
  EXPECT_EQ(e.table.angle[0], 30.0);
  EXPECT_EQ(e.table.offset[0], -0.5);
  EXPECT_THAT(e.table.thickness[1], testing::Each(2.0));
  EXPECT_TRUE(std::isnan(e.table.angle[1]));
  EXPECT_EQ(e.table.offset[1], 0.0);
  EXPECT_THAT(e.table.thickness[2], testing::Each(0.0));
  EXPECT_TRUE(std::isnan(e.table.offset[2]));
  EXPECT_EQ(e.table.file.size(), 3u);
}

TEST(BulkShells, OptionsOfALaterBlockOnly) {
  const Elements e(read_shells, "ELEMENT_SHELL",
                   "       1       1      11      12      13      14\n"
                   "*ELEMENT_SHELL_MCID\n"
                   "       2       1      11      12      13      14\n"
                   "             1.0             1.0             1.0             1.0               5\n"
                   "*ELEMENT_SHELL_BETA\n"
                   "3,1,11,12,13,14\n"
                   ",,,,45.\n");
  EXPECT_CLEAN(e.findings);
  EXPECT_THAT(e.table.system, testing::ElementsAre(0, 5, 0));
  ASSERT_EQ(e.table.angle.size(), 3u);
  EXPECT_TRUE(std::isnan(e.table.angle[1]));
  EXPECT_EQ(e.table.angle[2], 45.0);
  EXPECT_EQ(e.table.thickness.size(), 3u);
}

TEST(BulkShells, WhatIsRefused) {
  EXPECT_THAT(listed(Elements(read_shells, "ELEMENT_SHELL_COMPOSITE", "1,1,1,2,3,4\n").findings),
              testing::HasSubstr("*ELEMENT_SHELL_COMPOSITE: the option _COMPOSITE is not supported"));
  EXPECT_THAT(
      listed(Elements(read_shells, "ELEMENT_SHELL_THICKNESS", "       1       1       1       2       3       4\n")
                 .findings),
      testing::HasSubstr(
          "(text):3: error: *ELEMENT_SHELL_THICKNESS: the keyword ends before the thickness card of element 1"));
  const Elements e(read_shells, "ELEMENT_SHELL_THICKNESS",
                   "       1       1       1       2       3       4\n            -1.0             1.0             1.0 "
                   "            1.0\n"
                   "       2               1       2       3       4\n             1.0             1.0             1.0 "
                   "            1.0\n"
                   "       3       1       1      -2       3       4\n             1.0             1.0             1.0 "
                   "            1.0\n");
  EXPECT_EQ(
      listed(e.findings),
      "(text):4:13: error: *ELEMENT_SHELL_THICKNESS thic1 = -1.0: expected 0 or more (thickness at node 1; 0: of the "
      "section)\n"
      "(text):5:9: error: *ELEMENT_SHELL_THICKNESS pid = (blank): must be given (part id) [write its value there]\n"
      "(text):7:31: error: *ELEMENT_SHELL_THICKNESS n2 = -2: expected 0 or more (node 2)\n");
}

TEST(BulkSolids, ZerosBehindThePartAreNoNodes) {
  const Elements e(read_solids, "ELEMENT_SOLID (ten nodes format)",
                   "      13       6       0       0       0       0       0       0       0       0\n"
                   "       1       2       3       4       5       6       7       8       0       0\n"
                   "14,6,0,0\n"
                   "1,2,3,4,5,6,7,8\n");
  EXPECT_CLEAN(e.findings);
  EXPECT_THAT(e.table.id, testing::ElementsAre(13, 14));
  EXPECT_THAT(e.nodes(0), testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 0, 0));
  EXPECT_THAT(e.nodes(1), testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 0, 0));
}

TEST(BulkSolids, OneLineAndTwoLineMixed) {
  const Elements e(
      read_solids, "ELEMENT_SOLID (ten nodes format)",
      "$#   eid     pid\n"
      "51507736      10\n"
      "$#    n1      n2\n"
      "5142907251429073514290745142907551429076514290775142907851429079                \n"
      "       2      10       1       2       3       4       5       6       7       8\n"
      "3,10\n"
      "1,2,3,4,5,6,7,8,9,10\n"
      "4,10,1,2,3,4,4,4,4,4\n"
      "       5      10                                                                                    \n"
      "       1       2       3       4       5       6       7       8       9      10\n");
  EXPECT_CLEAN(e.findings);
  EXPECT_THAT(e.table.id, testing::ElementsAre(51507736, 2, 3, 4, 5));
  EXPECT_THAT(e.nodes(0), testing::ElementsAre(51429072, 51429073, 51429074, 51429075, 51429076, 51429077, 51429078,
                                               51429079, 0, 0));
  EXPECT_THAT(e.nodes(1), testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 0, 0));
  EXPECT_THAT(e.nodes(2), testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
  EXPECT_THAT(e.nodes(3), testing::ElementsAre(1, 2, 3, 4, 4, 4, 4, 4, 0, 0));
  EXPECT_THAT(e.nodes(4), testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
  EXPECT_THAT(e.table.line, testing::ElementsAre(4, 7, 8, 10, 11));
}

TEST(BulkSolids, OptionsAndRefusals) {
  const Elements ortho(read_solids, "ELEMENT_SOLID_ORTHO",
                       "1,1\n1,2,3,4,5,6,7,8\n1.,0.,0.\n0.,1.,0.\n2,1\n1,2,3,4,5,6,7,8\n1.,0.,0.\n0.,1.,0.\n");
  EXPECT_THAT(ortho.table.id, testing::ElementsAre(1, 2));
  EXPECT_EQ(ortho.findings.errors(), 0);
  EXPECT_EQ(ortho.findings.warnings(), 1);
  EXPECT_THAT(listed(Elements(read_solids, "ELEMENT_SOLID_H20", "").findings),
              testing::HasSubstr("the option _H20 is not supported"));
  const Elements cut(read_solids, "ELEMENT_SOLID", "       1       1\n");
  EXPECT_THAT(listed(cut.findings), testing::HasSubstr("the keyword ends before the line of nodes of element 1"));
  EXPECT_TRUE(cut.table.id.empty());
}

TEST(BulkBeams, NodesAndOptionCards) {
  const Elements plain(read_beams, "ELEMENT_BEAM",
                       "62000000500000026200000062000001       0       0       0       0       0       2\n"
                       "       2       1      11      12      13\n");
  EXPECT_CLEAN(plain.findings);
  EXPECT_THAT(plain.table.part, testing::ElementsAre(50000002, 1));
  EXPECT_THAT(plain.nodes(0), testing::ElementsAre(62000000, 62000001, 0));
  EXPECT_THAT(plain.nodes(1), testing::ElementsAre(11, 12, 13));
  EXPECT_TRUE(plain.table.tied_parts.empty());

  const Elements all(read_beams, "ELEMENT_BEAM_THICKNESS_PID_OFFSET_ORIENTATION",
                     "       1       5      11      12\n"
                     "             6.0             6.0\n"
                     "       3       4\n"
                     "       0.0       0.0\n"
                     "       0.0       1.0       0.0\n");
  EXPECT_CLEAN(all.findings);
  EXPECT_THAT(all.table.section[0], testing::ElementsAre(6.0, 6.0, 0.0, 0.0, 0.0));
  EXPECT_THAT(all.table.tied_parts[0], testing::ElementsAre(3, 4));
  EXPECT_THAT(all.table.orientation[0], testing::ElementsAre(0.0, 1.0, 0.0));
}

TEST(BulkBeams, ReleasesAndOffsetsAreRefused) {
  EXPECT_THAT(
      listed(Elements(read_beams, "ELEMENT_BEAM", "       1       5      11      12       0       7\n").findings),
      testing::HasSubstr(
          "(text):3:48: error: *ELEMENT_BEAM rt1 = 7: only 0 is supported (released translations at node 1)"));
  EXPECT_THAT(
      listed(Elements(read_beams, "ELEMENT_BEAM_OFFSET", "       1       5      11      12\n       1.0\n").findings),
      testing::HasSubstr("wx1 = 1.0: only 0 is supported (offset of the beam axis)"));
  EXPECT_THAT(listed(Elements(read_beams, "ELEMENT_BEAM_SECTION", "").findings),
              testing::HasSubstr("the option _SECTION is not supported"));
}

TEST(BulkElements, IdsMoveWithTheInclude) {
  Folder f;
  f.write("a.k",
          "*KEYWORD\n*ELEMENT_SHELL_THICKNESS\n       1       2       3       4       5       0\n             1.0      "
          "       1.0             1.0             1.0\n"
          "*ELEMENT_BEAM_PID\n1,2,3,4\n       5\n");
  Reading r("*KEYWORD\n*INCLUDE_TRANSFORM\na.k\n       100       200       300\n\n                          1000.0\n",
            f.path);
  ElementTable shells, beams;
  read_shells(r.deck, r.deck.blocks[0], shells, r.findings);
  read_beams(r.deck, r.deck.blocks[1], beams, r.findings);
  EXPECT_CLEAN(r.findings);
  EXPECT_THAT(shells.id, testing::ElementsAre(201));
  EXPECT_THAT(shells.part, testing::ElementsAre(302));
  EXPECT_THAT(shells.node, testing::ElementsAre(103, 104, 105, 0, 0, 0, 0, 0));
  EXPECT_EQ(shells.thickness[0][3], 1000.0);
  EXPECT_THAT(beams.node, testing::ElementsAre(103, 104, 0));
  EXPECT_THAT(beams.tied_parts[0], testing::ElementsAre(305, 0));
}

}  // namespace
}  // namespace nugget::deck
