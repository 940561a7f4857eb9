// SPDX-License-Identifier: Apache-2.0
#include "reading.hpp"

namespace nugget::deck {
namespace {

std::vector<std::string> titles(Reading& r) {
  std::vector<std::string> found;
  for (const Block& b : r.deck.blocks) {
    if (b.keyword == "TITLE") found.push_back(Cursor(r.deck, b, r.findings).read_text());
  }
  return found;
}

TEST(Include, SeveralNamesUnderOneKeywordInReadingOrder) {
  Folder f;
  f.write("a.k", "*KEYWORD\n*TITLE\na\n*END\nnot read\n");
  f.write("b.k", "*TITLE\nb\n");
  Reading r("*KEYWORD\n*TITLE\n1\n*INCLUDE\n$ first\na.k\nb.k   \n*TITLE\n2\n", f.path);
  EXPECT_CLEAN(r.findings);
  EXPECT_THAT(titles(r), testing::ElementsAre("1", "a", "b", "2"));
  EXPECT_THAT(r.deck.files, testing::ElementsAre("(text)", (f.path / "a.k").string(), (f.path / "b.k").string()));
  EXPECT_EQ(r.deck.blocks[1].file, 1u);
  EXPECT_EQ(r.deck.blocks[1].place.file, (f.path / "a.k").string());
}

TEST(Include, NamesAreContinuedUnquotedAndMayHaveBackslashes) {
  Folder f;
  f.write("parts/body/side panel, left.k", "*TITLE\nside\n");
  Reading r("*KEYWORD\n*INCLUDE\nparts\\body\\ +\nside panel, +\n left.k\n\"parts/body/side panel, left.k\"\n", f.path);
  // the continuation joins the pieces as they stand, without the blanks at their ends
  EXPECT_EQ(r.findings.errors(), 1) << listed(r.findings);
  EXPECT_THAT(listed(r.findings), testing::HasSubstr("cannot find the file 'parts/body/side panel,left.k'"));
  EXPECT_THAT(titles(r), testing::ElementsAre("side"));
  f.write("parts/x.k", "*TITLE\nx\n");
  Reading joined("*KEYWORD\n*INCLUDE\npar +\nts\\ +\nx.k\n", f.path);
  EXPECT_CLEAN(joined.findings);
  EXPECT_THAT(titles(joined), testing::ElementsAre("x"));
}

TEST(Include, NamesTakeParameters) {
  Folder f;
  f.write("hat_3.k", "*TITLE\nthree\n");
  Reading r("*KEYWORD\n*PARAMETER\nIn,3,Ckind,hat\n*INCLUDE\n&kind_&n.k\n", f.path);
  EXPECT_EQ(r.findings.errors(), 1);  // `kind_` is the name here
  EXPECT_THAT(listed(r.findings), testing::HasSubstr("the parameter 'kind_' in the file name is not defined"));
  Reading good("*KEYWORD\n*PARAMETER\nIn,3\n*INCLUDE\nhat_&n.k\n", f.path);
  EXPECT_CLEAN(good.findings);
  EXPECT_THAT(titles(good), testing::ElementsAre("three"));
}

TEST(Include, AMissingFileNamesTheFoldersThatWereSearched) {
  Folder f;
  f.write("sub/inner.k", "*KEYWORD\n*INCLUDE\nmissing.k\n");
  const Reading r("*KEYWORD\n*INCLUDE\nsub/inner.k\n", f.path);
  const std::string root = f.path.string();
  EXPECT_ONE_FINDING(
      r.findings, root + "/sub/inner.k:3: error: *INCLUDE: cannot find the file 'missing.k'; looked in " + root + ", " +
                      root + "/sub [put the file into one of these folders, or name its folder with *INCLUDE_PATH]");
}

TEST(Include, AMissingFileInOtherLettersIsPointedOut) {
  Folder f;
  f.write("Body.K", "*TITLE\nbody\n");
  const Reading r("*KEYWORD\n*INCLUDE\nbody.k\n", f.path);
  EXPECT_THAT(listed(r.findings),
              testing::HasSubstr("[there is a file 'Body.K' in " + f.path.string() + ": correct the name]"));
}

TEST(Include, AllMissingFilesAtOnce) {
  const Reading r("*KEYWORD\n*INCLUDE\nno_1.k\nno_2.k\n*INCLUDE\nno_3.k\n", "/nonexistent");
  EXPECT_EQ(r.findings.errors(), 3);
}

TEST(Include, AFolderIsNoFile) {
  Folder f;
  f.write("sub/x.k", "*TITLE\nx\n");
  EXPECT_ONE_FINDING(
      Reading("*KEYWORD\n*INCLUDE\nsub\n", f.path).findings,
      "(text):3: error: *INCLUDE: 'sub' is a folder, not a file [name a file in it; a folder to search is named with "
      "*INCLUDE_PATH]");
}

TEST(Include, NoNameIsAWarning) {
  EXPECT_ONE_FINDING(
      Reading("*KEYWORD\n*INCLUDE\n$a.k\n$b.k\n*INCLUDE_PATH\n").findings,
      "(text):2:1: warning: *INCLUDE: no file name stands under this keyword; nothing is included [remove the keyword, "
      "or take the $ from the names below it]");
}

TEST(Include, CirclesAreBroken) {
  Folder f;
  f.write("a.k", "*INCLUDE\nb.k\n");
  f.write("b.k", "*TITLE\nb\n*INCLUDE\n./a.k\n");
  Reading r("*KEYWORD\n*INCLUDE\na.k\n", f.path);
  ASSERT_EQ(r.findings.all().size(), 1u) << listed(r.findings);
  EXPECT_THAT(listed(r.findings), testing::HasSubstr("includes itself"));
  EXPECT_EQ(r.findings.all()[0].place.file, (f.path / "b.k").string());
  EXPECT_EQ(titles(r).size(), 1u);
  f.write("self.k", "*KEYWORD\n*INCLUDE\nself.k\n");
  Findings findings;
  read(f.path / "self.k", findings);
  EXPECT_EQ(findings.errors(), 1);
}

TEST(Include, TheSameFileTwiceIsNoCircle) {
  Folder f;
  f.write("a.k", "*TITLE\na\n");
  Reading r("*KEYWORD\n*INCLUDE\na.k\na.k\n", f.path);
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(titles(r).size(), 2u);
  EXPECT_EQ(r.deck.files.size(), 2u);
}

TEST(Include, PathsAreSearchedInTheirOrder) {
  Folder f;
  f.write("one/x.k", "*TITLE\none\n");
  f.write("two/x.k", "*TITLE\ntwo\n");
  f.write("two/y.k", "*TITLE\ny\n");
  f.write("main/main.k", "*KEYWORD\n*INCLUDE_PATH_RELATIVE\n../one\n../two\n*INCLUDE\nx.k\ny.k\n");
  Findings findings;
  const Deck deck = read(f.path / "main/main.k", findings);
  EXPECT_CLEAN(findings);
  EXPECT_THAT(deck.files, testing::ElementsAre((f.path / "main/main.k").string(), (f.path / "one/x.k").string(),
                                               (f.path / "two/y.k").string()));
  EXPECT_THAT(listed(Reading("*KEYWORD\n*INCLUDE_PATH\nnowhere\n", f.path).findings),
              testing::HasSubstr("warning: *INCLUDE_PATH: the folder 'nowhere' does not exist"));
}

TEST(Include, BesideTheIncludingFile) {
  Folder f;
  f.write("sub/a.k", "*INCLUDE\nb.k\n");
  f.write("sub/b.k", "*TITLE\nb\n");
  Reading r("*KEYWORD\n*INCLUDE\nsub/a.k\n", f.path);
  EXPECT_CLEAN(r.findings);
  EXPECT_THAT(titles(r), testing::ElementsAre("b"));
}

TEST(Include, FormatComesFromTheMasterOrTheSuffix) {
  Folder f;
  f.write("plain.k", "*KEYWORD\n*PART\n");
  f.write("own.k", "*KEYWORD I10=Y\n*PART\n");
  const Reading r("*KEYWORD LONG=Y\n*INCLUDE\nplain.k\n*INCLUDE %\nplain.k\n*PART\n", f.path);
  EXPECT_CLEAN(r.findings);
  ASSERT_EQ(r.deck.blocks.size(), 3u);
  EXPECT_EQ(r.deck.blocks[0].format, Format::long_format);
  EXPECT_EQ(r.deck.blocks[1].format, Format::i10);
  EXPECT_EQ(r.deck.blocks[2].format, Format::long_format);
  const Reading own("*KEYWORD\n*INCLUDE\nown.k\n*PART\n", f.path);
  EXPECT_EQ(own.findings.warnings(), 1);
  EXPECT_EQ(own.deck.blocks[0].format, Format::i10);
  EXPECT_EQ(own.deck.blocks[1].format, Format::standard);
}

TEST(Include, DataBeforeTheFirstKeywordOfAnIncludeIsAnError) {
  Folder f;
  f.write("rows.k", "       1       2\n");
  EXPECT_EQ(Reading("*KEYWORD\n*NODE\n*INCLUDE\nrows.k\n", f.path).findings.errors(), 1);
}

TEST(Include, OtherFormsAreRefusedByName) {
  EXPECT_THAT(listed(Reading("*KEYWORD\n*INCLUDE_STAMPED_PART\nx.k\n").findings),
              testing::HasSubstr("*INCLUDE_STAMPED_PART: this form of include is not supported"));
}

// ---- *INCLUDE_TRANSFORM

const Card sheet{{id("secid", IdSpace::other, required, "section"),
                  or_negative(id("lcid", IdSpace::function, 0, "curve"), IdSpace::function),
                  real("t", dimension::length, 2.0, any_value, "thickness"),
                  real("ro", dimension::density, 0.0, any_value, "density"), id("psid", IdSpace::set, 0, "set"),
                  integer("n", 0, any_value, "count")}};

TEST(IncludeTransform, IdsAndUnits) {
  Folder f;
  f.write("part.k", "*KEYWORD\n*X\n1,-5,1.5,7.8,0,3\n1,,,,4\n");
  Reading r(
      "*KEYWORD\n*INCLUDE_TRANSFORM\npart.k\n       100       200       300       400       500       600       700\n  "
      "     800\n"
      "     0.001       0.1      10.0\n*X\n1,1,1.0,1.0,1,1\n",
      f.path);
  Cursor c(r.deck, r.deck.blocks[0], r.findings);
  const Row row = c.read(sheet);
  EXPECT_EQ(row.entry("secid").integer(), 801);
  EXPECT_EQ(row.entry("lcid").integer(), -605);
  EXPECT_DOUBLE_EQ(row.entry("t").value, 15.0);
  EXPECT_DOUBLE_EQ(row.entry("ro").value, 7.8 * 0.001 / 1000.0);
  EXPECT_EQ(row.entry("psid").integer(), 0);
  EXPECT_EQ(row.entry("n").integer(), 3);
  const Row defaults = c.read(sheet);
  EXPECT_EQ(defaults.entry("t").value, 2.0);  // a default is in the units of the whole deck, and a warning says so
  EXPECT_THAT(listed(r.findings), testing::HasSubstr("the default, 2, is in the units of the whole deck"));
  EXPECT_EQ(defaults.entry("psid").integer(), 504);
  EXPECT_EQ(Cursor(r.deck, r.deck.blocks[1], r.findings).read(sheet).entry("secid").integer(), 1);
  EXPECT_EQ(r.findings.errors(), 0);
  EXPECT_EQ(r.findings.warnings(), 1);
}

TEST(IncludeTransform, NestedOnesAdd) {
  Folder f;
  f.write("outer.k",
          "*KEYWORD\n*INCLUDE_TRANSFORM\ninner.k\n        10\n\n                             2.0\n         1\n"
          "*DEFINE_TRANSFORMATION\n         1\nTRANSL           1.0\n");
  f.write("inner.k",
          "*KEYWORD\n*NODE\n       1             1.0             2.0             3.0       0       7\n2,1.,2.,3.\n");
  Reading r(
      "*KEYWORD\n*INCLUDE_TRANSFORM\nouter.k\n       "
      "100,0,0,0,0,0,1000\n\n,,10.\n2\n*DEFINE_TRANSFORMATION\n2\nROTATE,0,0,1,0,0,0,90\n",
      f.path);
  NodeTable nodes;
  read_nodes(r.deck, r.block("NODE"), nodes, r.findings);
  EXPECT_CLEAN(r.findings);
  EXPECT_THAT(nodes.id, testing::ElementsAre(111, 112));
  // inner: x -> 2x + (1,0,0), outer: x -> 90 degrees about z of 10 x
  for (const Vec3d& x : nodes.x) {
    EXPECT_NEAR(x.x, -40.0, 1e-12);
    EXPECT_NEAR(x.y, 30.0, 1e-12);
    EXPECT_NEAR(x.z, 60.0, 1e-12);
  }
  EXPECT_EQ(nodes.x[0].y, nodes.x[1].y);  // the fast and the careful path: the same bits
  EXPECT_EQ(nodes.rc[0], 7);
}

Vec3d transformed(const std::string& lines, const Vec3d& x) {
  Reading r("*KEYWORD\n*DEFINE_TRANSFORMATION\n5\n" + lines + "\n*NODE\n1,1.,0.,0.\n2,1.,3.,0.\n");
  EXPECT_CLEAN(r.findings);
  return r.deck.transformation(5)->point(x);
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  EXPECT_LT(norm(a - b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(IncludeTransform, Transformations) {
  expect_near(transformed("TRANSL,1,2,3", {1, 1, 1}), {2, 3, 4});
  expect_near(transformed("SCALE,2,3,4", {1, 1, 1}), {2, 3, 4});
  expect_near(transformed("ROTATE,0,0,1,1,0,0,90", {2, 0, 0}), {1, 1, 0});
  expect_near(transformed("MIRROR,1,0,0,2,0,0", {3, 5, 7}), {-1, 5, 7});
  expect_near(transformed("TRANSL2ND,1,2,10", {0, 0, 0}), {0, 10, 0});
  expect_near(transformed("ROTATE,1,2,90", {2, 0, 0}), {1, 0, -1});
  expect_near(
      transformed(
          "POINT,1,0,0,0\nPOINT,2,1,0,0\nPOINT,3,0,1,0\nPOINT,4,5,5,5\nPOINT,5,5,6,5\nPOINT,6,5,5,6\nPOS6P,1,2,3,4,5,6",
          {1, 2, 3}),
      {8, 6, 7});
  // the last line acts first
  expect_near(transformed("TRANSL,10,0,0\nROTATE,0,0,1,0,0,0,90", {1, 0, 0}), {10, 1, 0});
}

TEST(IncludeTransform, WhatIsRefused) {
  Folder f;
  f.write("a.k", "*KEYWORD\n");
  const auto findings = [&](const std::string& text) { return listed(Reading("*KEYWORD\n" + text, f.path).findings); };
  const std::string include = "*INCLUDE_TRANSFORM\na.k\n\n\n\n";
  EXPECT_THAT(findings(include + "7\n"), testing::HasSubstr("tranid = 7: no *DEFINE_TRANSFORMATION has this id"));
  EXPECT_THAT(findings(include + "7\n*DEFINE_TRANSFORMATION\n7\nMIRROR,0,0,0,1,0,0,1\n"),
              testing::HasSubstr("A7 = 1 of MIRROR, left-handed coordinate systems, is not built"));
  EXPECT_THAT(findings("*DEFINE_TRANSFORMATION\n7\nMATRIX\n"), testing::HasSubstr("option = MATRIX: this option"));
  EXPECT_THAT(findings("*DEFINE_TRANSFORMATION\n7\nROTATE,0,0,0,1,1,1,90\n"),
              testing::HasSubstr("span no axis or plane"));
  EXPECT_THAT(findings("*DEFINE_TRANSFORMATION\n7\nSCALE,2\n"), testing::HasSubstr("a scale factor is 0"));
  EXPECT_THAT(findings("*DEFINE_TRANSFORMATION\n7\nTRANSL2ND,1,2,3\n"),
              testing::HasSubstr("there is no such point or node"));
  EXPECT_THAT(findings("*DEFINE_TRANSFORMATION\n7\n*DEFINE_TRANSFORMATION\n7\n"), testing::HasSubstr("a second time"));
  EXPECT_THAT(findings("*INCLUDE_TRANSFORM\na.k\n\n\n,,,CtoF\n"), testing::HasSubstr("temperatures are not supported"));
  EXPECT_THAT(findings(include + "0\nb.k\n"), testing::HasSubstr("more lines than the five cards"));
  EXPECT_THAT(findings("*INCLUDE_TRANSFORM\n"), testing::HasSubstr("the name of the file is missing"));
}

TEST(IncludeTransform, AnIdThatLeavesTheIntegersIsAnError) {
  Folder f;
  f.write("a.k", "*KEYWORD\n*NODE\n       5             1.0             2.0             3.0\n");
  Reading r("*KEYWORD\n*INCLUDE_TRANSFORM\na.k\n2147483645\n", f.path);
  NodeTable nodes;
  read_nodes(r.deck, r.block("NODE"), nodes, r.findings);
  EXPECT_THAT(listed(r.findings), testing::HasSubstr("nid = 5: the id with the offset of *INCLUDE_TRANSFORM"));
  EXPECT_TRUE(nodes.id.empty());
}

}  // namespace
}  // namespace nugget::deck
