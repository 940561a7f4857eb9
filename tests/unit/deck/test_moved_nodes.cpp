// SPDX-License-Identifier: Apache-2.0
#include "deck/moved_nodes.hpp"

#include "reading.hpp"

namespace nugget::deck {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The text after moving node 7, the only change.
std::string with_node_7(const std::string& text, const Vec3d& x, std::string_view remark = "") {
  Reading r(text);
  EditedText edited(r.deck);
  MovedNodes moved(r.deck, edited);
  EXPECT_TRUE(moved.can_move(7)) << text;
  moved.move(7, x);
  const auto files = edited.files("new.k", remark);
  EXPECT_EQ(files.size(), 1u);
  return files.at(0).text;
}

/// Where a node of a deck stands.
Vec3d place(const Deck& deck, int id) {
  NodeTable table;
  Findings findings;
  for (const Block& b : deck.blocks)
    if (b.keyword == "NODE") read_nodes(deck, b, table, findings);
  for (std::size_t i = 0; i < table.id.size(); ++i)
    if (table.id[i] == id) return table.x[i];
  throw std::runtime_error("no such node");
}

void expect_at(const Vec3d& x, double a, double b, double c) {
  EXPECT_NEAR(norm(x - Vec3d{a, b, c}), 0.0, 1e-12) << x.x << ' ' << x.y << ' ' << x.z;
}

TEST(MovedNodes, OnlyTheCoordinatesOfTheLineChange) {
  const std::string head =
                        "$ mine\n*KEYWORD\n*TITLE\r\nplate\n*NODE\n$#   nid               x\n       6             1.0  "
                        "           2.0\n",
                    tail = "\n       8             7.0\n*END\nrest\n";
  EXPECT_EQ(with_node_7(head + "       7             0.0             0.0             0.0       3       7" + tail,
                        {1.5, -2, 1.0 / 3.0}, "$ moved\n"),
            "$ mine\n*KEYWORD\n$ moved\n*TITLE\r\nplate\n*NODE\n$#   nid               x\n       6             1.0     "
            "        2.0\n"
            "       7             1.5            -2.0 0.3333333333333       3       7" +
                tail);
}

TEST(MovedNodes, ShortLinesOtherFormatsAndCommas) {
  EXPECT_EQ(with_node_7("*NODE\n       7\n", {1, 2, 3}),
            "*NODE\n       7             1.0             2.0             3.0\n");
  EXPECT_EQ(with_node_7("*NODE %\n         7             0.0             0.0             0.0\n", {1, 2, 3}),
            "*NODE %\n         7             1.0             2.0             3.0\n");
  EXPECT_EQ(with_node_7("*NODE+\n                   7                 0.0\n", {1, 2, 1.0 / 3.0}),
            "*NODE+\n                   7                 1.0                 2.0  0.3333333333333333\n");
  EXPECT_EQ(with_node_7("*NODE\n7,1,1,1,3,7\n6,,\n", {1, 2, 1.0 / 3.0}),
            "*NODE\n7,1.0,2.0,0.3333333333333333,3,7\n6,,\n");
  EXPECT_EQ(with_node_7("*NODE\n 7, 1.5\n", {1e-30, 2e7, 3}), "*NODE\n 7,1e-30,20000000.0,3.0\n");
}

TEST(MovedNodes, WhatStandsElsewhereOrTwiceCannotMove) {
  Reading r("*KEYWORD\n*PARAMETER\nRx,1.0\n*NODE\n7,&x,0,0\n8,0,0,0\n9,0,0,0\n9,1,0,0\n");
  EditedText edited(r.deck);
  const MovedNodes moved(r.deck, edited);
  EXPECT_FALSE(moved.can_move(7));
  EXPECT_TRUE(moved.can_move(8));
  EXPECT_FALSE(moved.can_move(9));
  EXPECT_FALSE(moved.can_move(10));
}

TEST(MovedNodes, FilesThatChangeStandBesideTheNewMaster) {
  Folder f;
  f.write("car/sheets.k", "*NODE\n7,1,1,1\n");
  f.write("car/more.k", "*INCLUDE\ncar/ +\nsheets.k\ncar/welds.k\n*TITLE\nx\n");
  f.write("car/welds.k", "*NODE\n8,0,0,0\n");
  f.write("other/welds.k", "*NODE\n9,0,0,0\n");
  Reading r("*KEYWORD\n*INCLUDE\ncar/more.k\n$ and\nother/welds.k\n*END\n", f.path);
  EXPECT_CLEAN(r.findings);
  EditedText edited(r.deck);
  MovedNodes moved(r.deck, edited);
  moved.move(7, {4, 5, 6});
  const auto files = edited.files(f.path / "new/car.k", "");
  std::vector<std::string> names;
  for (const auto& file : files) {
    names.push_back(std::filesystem::proximate(file.path, f.path).generic_string());
    f.write(names.back(), file.text);
  }
  EXPECT_THAT(names, ElementsAre("new/car.k", "new/car_more.k", "new/car_sheets.k"));
  EXPECT_THAT(files[0].text, HasSubstr("*INCLUDE\ncar_more.k\n$ and\n../other/welds.k\n*END\n"));
  EXPECT_EQ(files[1].text, "*INCLUDE\ncar_sheets.k\n../car/welds.k\n*TITLE\nx\n");
  Findings findings;
  const Deck again = read(f.path / "new/car.k", findings);
  EXPECT_CLEAN(findings);
  expect_at(place(again, 7), 4, 5, 6);
  expect_at(place(again, 8), 0, 0, 0);
  expect_at(place(again, 9), 0, 0, 0);
}

// Ids, unit of length and a motion of *INCLUDE_TRANSFORM: the text gets what they bring to the place. Sabotage: the
// inverse without the unit.
TEST(MovedNodes, UnderATransformTheTextGetsTheInverse) {
  const std::string transform =
      "*DEFINE_TRANSFORMATION\n1\nTRANSL,10.0,20.0,0.0\nROTATE,1.0,2.0,3.0,0.0,0.0,0.0,40.0\n"
      "*INCLUDE_TRANSFORM\nsheets.k\n100\n\n1.0,1.0,1000.0\n1\n";
  Folder f;
  f.write("sheets.k", "*NODE\n7,0.001,0.002,0.003\n");
  Reading r("*KEYWORD\n" + transform + "*END\n", f.path);
  EXPECT_CLEAN(r.findings);
  EditedText edited(r.deck);
  MovedNodes moved(r.deck, edited);
  ASSERT_TRUE(moved.can_move(107));
  moved.move(107, {3, -4, 5});
  for (const auto& file : edited.files(f.path / "new.k", "")) f.write(file.path.filename().string(), file.text);
  Findings findings;
  expect_at(place(read(f.path / "new.k", findings), 107), 3, -4, 5);
  EXPECT_CLEAN(findings);

  Reading twice("*KEYWORD\n" + transform + transform.substr(transform.find("*INCLUDE")) + "*END\n", f.path);
  EditedText of_twice(twice.deck);
  EXPECT_FALSE(MovedNodes(twice.deck, of_twice).can_move(107)) << "its line is that of two nodes";
}

}  // namespace
}  // namespace nugget::deck
