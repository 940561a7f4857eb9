// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Built built(const std::string& more) {
  return Built("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n" + more);
}

const char* const two_curves = "*DEFINE_CURVE\n10\n0.0,300.0\n1.0,400.0\n*DEFINE_CURVE\n11\n0.0,330.0\n1.0,440.0\n";

// ---- curves and tables

TEST(Curves, OffsetsComeBeforeFactors) {
  const auto b = built(
      "*DEFINE_CURVE_TITLE\nforce\n5,,2.0,3.0,1.0,10.0\n0.0,1.0\n1.0,2.0\n*DEFINE_CURVE_DUPLICATE\n6,5,1.0,2.0\n");
  ASSERT_EQ(b.model.curves.size(), 2u) << b.all_findings();
  EXPECT_THAT(b.model.curves[0].x, ElementsAre(2.0, 4.0));
  EXPECT_THAT(b.model.curves[0].y, ElementsAre(33.0, 36.0));
  EXPECT_THAT(b.model.curves[1].y, ElementsAre(66.0, 72.0));
  EXPECT_EQ(b.model.curve_index(6), 1);
}

/// Area under a curve, and its largest value.
std::pair<double, double> area_and_peak(const Curve& c) {
  double area = 0.0, peak = 0.0;
  for (std::size_t i = 1; i < c.x.size(); ++i) area += 0.5 * (c.x[i] - c.x[i - 1]) * (c.y[i] + c.y[i - 1]);
  for (const double y : c.y) peak = std::max(peak, std::abs(y));
  return {area, peak};
}

// Sabotage: the fall without its rise in the sum of times; a straight ramp fails the value at a quarter.
TEST(Curves, SmoothOnesGoTheirDistance) {
  // 40 between 1 and 6 with rises of 1: 40 / (6 - 1 - 1) in between; or 10 for as long as it takes.
  for (const char* card : {"5,0,40.0,1.0,6.0,1.0", "5,0,40.0,1.0,0.0,1.0,10.0"}) {
    const auto b = built(std::string("*DEFINE_CURVE_SMOOTH\n") + card + "\n");
    ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
    const Curve& c = b.model.curves.at(0);
    const auto [area, peak] = area_and_peak(c);
    EXPECT_NEAR(area, 40.0, 1e-12);
    EXPECT_DOUBLE_EQ(peak, 10.0);
    EXPECT_DOUBLE_EQ(c.x.back(), 6.0);
    EXPECT_EQ(c.zero_outside(0.5), 0.0);
    EXPECT_NEAR(c.zero_outside(1.25), 10.0 * 0.5 * (1.0 - std::sqrt(0.5)), 1e-12);
    EXPECT_NEAR(c.zero_outside(5.5), 5.0, 1e-12);
  }
  const auto backwards = built("*DEFINE_CURVE_SMOOTH_TITLE\nt\n5,,-40.0,0.0,5.0,1.0\n");
  EXPECT_NEAR(area_and_peak(backwards.model.curves.at(0)).first, -40.0, 1e-12);
  EXPECT_TRUE(built("*DEFINE_CURVE_SMOOTH\n5,0,40.0,1.0,0.0,1.0\n").error("neither TEND nor VMAX is given", "vmax"));
  EXPECT_TRUE(built("*DEFINE_CURVE_SMOOTH\n5,0,40.0,1.0,2.5,1.0\n").error("no room for a rise and a fall", "trise"));
  EXPECT_TRUE(built("*DEFINE_CURVE_SMOOTH\n5,0,40.0,1.0,6.0,1.0,3.0\n").warning("DIST and TEND give 10", "vmax"));
}

// The points of a function of time are within 1e-5 of its greatest value everywhere, against the function itself; the
// run ends at 1. Sabotage: integers that divide to integers; degrees; a cubic for the wave of HAVSIN.
TEST(Curves, FunctionsOfTime) {
  const auto made = [](const std::string& text) {
    return built("*DEFINE_CURVE_FUNCTION_TITLE\nf\n5,0,1.0,2.0\n" + text + "\n");
  };
  constexpr double pi = std::numbers::pi;
  const auto way = [](double t, double from, double to) { return std::clamp((t - from) / (to - from), 0.0, 1.0); };
  const std::vector<std::pair<std::string, std::function<double(double)>>> functions{
      {"3.*sin(2*PI*TIME)**2 + 1/2", [&](double t) { return 3.0 * std::pow(std::sin(2 * pi * t), 2) + 0.5; }},
      {"EXP(-5*Time)*COS(\n 90.0*DTOR*TIME*40)", [&](double t) { return std::exp(-5 * t) * std::cos(20 * pi * t); }},
      {"STEP(TIME, 0.2, 1.0, 0.6, -3)",
       [&](double t) { return 1.0 - 4.0 * std::pow(way(t, 0.2, 0.6), 2) * (3.0 - 2.0 * way(t, 0.2, 0.6)); }},
      {"havsin(time,0.2,1.0,0.6,-3)", [&](double t) { return 1.0 - 2.0 * (1.0 - std::cos(pi * way(t, 0.2, 0.6))); }},
      {"POLY(TIME,0.5,1,2,3)", [](double t) { return 1.0 + 2.0 * (t - 0.5) + 3.0 * (t - 0.5) * (t - 0.5); }},
      {"SHF(TIME,0.1,2,30,0.4,0.7)", [](double t) { return 2.0 * std::sin(30.0 * (t - 0.1) - 0.4) + 0.7; }},
      {"IF(TIME-0.3: 1.0, 2.0, 4*TIME)", [](double t) { return t < 0.3 ? 1.0 : 4.0 * t; }},
      {"max(2.0, 1.0)", [](double) { return 2.0; }}};
  for (const auto& [text, function] : functions) {
    const auto b = made(text);
    EXPECT_EQ(b.findings.errors(), 0) << text << '\n' << b.all_findings();
    const Curve& c = b.model.curves.at(0);
    EXPECT_LT(c.x.size(), 20000u) << text;
    for (int i = 0; i <= 1000; ++i) {
      const double t = 1e-3 * i;
      if (i == 300) continue;  // the jump
      EXPECT_NEAR(c.zero_outside(t), 2.0 * function(t), 1e-4) << text << ' ' << t;
    }
  }
  EXPECT_FALSE(made("TIME").model.curves.at(0).in_relaxation);
  EXPECT_TRUE(made("1/TIME").error("curve 5, '1/TIME', at the time 0: division by zero"));
  EXPECT_TRUE(made("DX(12)").error("the function 'DX' is not known"));
  EXPECT_TRUE(made("TIME*").error("ends too early"));
  EXPECT_TRUE(made("").error("ends too early"));
  EXPECT_TRUE(made("STEP(TIME,1)").error("step takes 5 argument(s), not 2"));
  EXPECT_TRUE(built("*DEFINE_CURVE_FUNCTION\n5,0,2.0\nTIME\n").error("only 1 is supported", "sfa"));
  EXPECT_TRUE(built("*PARAMETER\nRw,30.0\n*DEFINE_CURVE_FUNCTION\n5\nsin(&w*TIME)\n").findings.errors() == 0);
  const std::string copy = "*DEFINE_CURVE_DUPLICATE\n6,5,1.0,3.0\n", of = "*DEFINE_CURVE_FUNCTION\n5\nTIME\n";
  EXPECT_NEAR(built(of + copy).model.curves.at(1).zero_outside(0.5), 1.5, 1e-12);
  EXPECT_TRUE(built(copy + of).error("stands behind its copy", "rlcid"));
}

TEST(Curves, AbscissaeMustAscend) {
  const auto b = built("*DEFINE_CURVE\n5\n0.0,1.0\n1.0,2.0\n1.0,3.0\n");
  const Finding* f = b.find(Severity::error, "expected more than 1", "a");
  ASSERT_NE(f, nullptr) << b.all_findings();
  EXPECT_EQ(f->place.line, 8);
}

TEST(Curves, Faults) {
  EXPECT_TRUE(built("*DEFINE_CURVE\n5\n").error("curve 5 has no points"));
  EXPECT_TRUE(built("*DEFINE_CURVE_FUNCTION\n5\nsin(x)\n").error("'x' is not known: a function of TIME is built"));
  EXPECT_TRUE(built("*DEFINE_CURVE\n5\n0.0,1.0\n*DEFINE_CURVE\n5\n0.0,1.0\n").error("curve 5 is defined twice"));
  EXPECT_TRUE(built("*DEFINE_CURVE\n5\n0.0,1.0\n*DEFINE_TABLE_2D\n5\n0.0,5\n").error("5 is already the id of a curve"));
}

TEST(Curves, TablesTakeTheCurvesThatFollow) {
  const auto b = built("*DEFINE_CURVE\n1\n0.0,1.0\n*DEFINE_TABLE\n7\n0.001\n100.0\n" + std::string(two_curves) +
                       "*DEFINE_TABLE_2D\n8\n1.0,11\n2.0,1\n");
  ASSERT_EQ(b.model.tables.size(), 2u) << b.all_findings();
  EXPECT_THAT(b.model.tables[0].curve, ElementsAre(1, 2));
  EXPECT_THAT(b.model.tables[0].value, ElementsAre(0.001, 100.0));
  EXPECT_THAT(b.model.tables[1].curve, ElementsAre(2, 0));
  EXPECT_TRUE(built("*DEFINE_TABLE\n7\n0.0\n1.0\n*DEFINE_CURVE\n1\n0.0,1.0\n").error("2 values, but 1 curves follow"));
  EXPECT_TRUE(
      built("*DEFINE_TABLE_2D\n7\n1.0,1\n1.0,1\n*DEFINE_CURVE\n1\n0.0,1.0\n").error("values of table 7 must ascend"));
  EXPECT_TRUE(built("*DEFINE_TABLE_2D\n7\n1.0,99\n").error("curve 99 is not defined", "curveid"));
}

// ---- coordinate systems, vectors, boxes

const char* const three_nodes = "*NODE\n1,1.0,1.0,1.0\n2,1.0,3.0,1.0\n3,0.0,1.0,1.0\n";

void expect_axes(const CoordinateSystem& s, const Vec3d& x, const Vec3d& y) {
  EXPECT_NEAR(norm(s.axes.e1 - x), 0.0, 1e-15);
  EXPECT_NEAR(norm(s.axes.e2 - y), 0.0, 1e-15);
  EXPECT_NEAR(norm(s.axes.e3 - cross(x, y)), 0.0, 1e-15);
}

TEST(Frames, ThreeWaysToTheSameAxes) {
  const auto b = built(
      "*DEFINE_COORDINATE_SYSTEM\n1,1.0,1.0,1.0,1.0,5.0,1.0\n-3.0,2.0,1.0\n*DEFINE_COORDINATE_VECTOR\n"
      "2,0.0,2.0,0.0,-1.0,1.0,0.0\n*DEFINE_COORDINATE_NODES\n3,1,2,3\n" +
      std::string(three_nodes));
  ASSERT_EQ(b.model.systems.size(), 3u) << b.all_findings();
  for (const auto& s : b.model.systems) expect_axes(s, {0, 1, 0}, {-1, 0, 0});
  EXPECT_DOUBLE_EQ(b.model.systems[0].origin.x, 1.0);
}

TEST(Frames, InTheSpellingOfAnExampleOfLstc) {
  const auto b = built(std::string(three_nodes) + "*DEFINE_COORDINATE_NODE\n3,1,2,3\n");
  ASSERT_EQ(b.model.systems.size(), 1u) << b.all_findings();
  expect_axes(b.model.systems[0], {0, 1, 0}, {-1, 0, 0});
}

TEST(Frames, SecondNodeOnAnotherAxis) {
  const auto b = built(std::string(three_nodes) + "*DEFINE_COORDINATE_NODES\n1,1,2,3,,Y\n2,1,2,3,,Z\n");
  ASSERT_EQ(b.model.systems.size(), 2u) << b.all_findings();
  expect_axes(b.model.systems[0], {0, 0, 1}, {0, 1, 0});   // y along N1 N2, z towards N3
  expect_axes(b.model.systems[1], {-1, 0, 0}, {0, 0, 1});  // z along N1 N2, x towards N3
}

TEST(Frames, TurningWithItsNodes) {
  const auto b = built(std::string(three_nodes) + "*DEFINE_COORDINATE_NODES\n5,1,2,3,1,Y\n");
  ASSERT_EQ(b.model.systems.size(), 1u) << b.all_findings();
  const CoordinateSystem& s = b.model.systems[0];
  EXPECT_TRUE(s.turning);
  ASSERT_TRUE(s.nodes);
  EXPECT_EQ(s.nodes->axis, 1);
  EXPECT_EQ(s.nodes->in_plane, 2);
  EXPECT_TRUE(built(std::string(three_nodes) + "*DEFINE_COORDINATE_NODES\n5,1,2,3,1\n*BOUNDARY_SPC_NODE\n1,5,1\n")
                  .error("turns with its nodes", "cid"));
}

TEST(Frames, Faults) {
  EXPECT_TRUE(built("*DEFINE_COORDINATE_VECTOR\n2,0.0,2.0,0.0,0.0,1.0,0.0\n").error("must differ in direction"));
  EXPECT_TRUE(built(std::string(three_nodes) + "*DEFINE_COORDINATE_NODES\n1,1,2,3,2\n").error("", "flag"));
  EXPECT_TRUE(built(std::string(three_nodes) + "*DEFINE_COORDINATE_NODES\n1,1,2,2\n").error("lie on a line", "n1"));
  EXPECT_TRUE(built("*DEFINE_COORDINATE_NODES\n1,1,2,3\n").error("node 1 is not defined", "n1"));
  EXPECT_TRUE(built("*DEFINE_VECTOR\n1\n").error("head and tail of a vector must differ"));
  EXPECT_TRUE(built("*DEFINE_BOX\n1,2.0,1.0\n").error("smallest value is larger", "xmn"));
}

// ---- sets

/// A strip of three shells (ids 1 2 3; parts 1 1 2) along x and a brick (part 3) that stands on the last of them.
/// Nodes 1..8 below y = 0 and y = 1 in pairs, 11..14 on top of the brick.
Built strip(const std::string& more) {
  return built(R"(*NODE
1,0.0,0.0,0.0
2,0.0,1.0,0.0
3,1.0,0.0,0.0
4,1.0,1.0,0.0
5,2.0,0.0,0.0
6,2.0,1.0,0.0
7,3.0,0.0,0.0
8,3.0,1.0,0.0
11,2.0,0.0,1.0
12,3.0,0.0,1.0
13,3.0,1.0,1.0
14,2.0,1.0,1.0
*PART
a
1,1,1
b
2,1,1
c
3,3,1
*SECTION_SHELL
1,2
1.0
*SECTION_SOLID
3
*MAT_ELASTIC
1,7.85e-9,210000.0,0.3
*ELEMENT_SHELL
1,1,1,3,4,2
2,1,3,5,6,4
3,2,5,7,8,6
*ELEMENT_SOLID
9,3,5,7,8,6,11,12,13,14
*DEFINE_BOX
1,-0.5,1.5,-0.5,1.5,-0.5,0.5
)" + more);
}

std::vector<int> ids(const Built& b, const std::vector<Index>& members) {
  std::vector<int> out;
  for (const Index n : members) out.push_back(b.model.nodes.id[n]);
  return out;
}

TEST(Sets, ListsRangesAndColumns) {
  const auto b = strip(
      "*SET_NODE_LIST_TITLE\nsome\n1\n5,1,,1,0,7\n*SET_NODE_LIST_GENERATE\n2\n1,3,8,11\n*SET_NODE_GENERATE_"
      "INCREMENT\n3\n2,8,3\n"
      "*SET_NODE_COLUMN\n4\n8,1.0\n7,1.0\n*SET_SHELL_GENERATE\n5\n2,99\n*SET_PART\n6\n3,1\n*SET_SOLID\n7\n9\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& sets = b.model.sets;
  ASSERT_EQ(sets.nodes.size(), 4u);
  EXPECT_THAT(ids(b, sets.nodes[0].members), ElementsAre(5, 1, 7));
  EXPECT_THAT(ids(b, sets.nodes[1].members), ElementsAre(1, 2, 3, 8, 11));
  EXPECT_THAT(ids(b, sets.nodes[2].members), ElementsAre(2, 5, 8));
  EXPECT_THAT(ids(b, sets.nodes[3].members), ElementsAre(8, 7));
  EXPECT_THAT(sets.shells.at(0).members, ElementsAre(1, 2));
  EXPECT_THAT(sets.parts.at(0).members, ElementsAre(2, 0));
  EXPECT_THAT(sets.solids.at(0).members, ElementsAre(0));
}

TEST(Sets, SetsOfSetsInAnyOrder) {
  const auto b = strip(
      "*SET_NODE_ADD\n1\n2,3\n*SET_NODE_INTERSECT\n4\n1,2\n*SET_NODE\n2\n1,2,3\n*SET_NODE_ADD\n3\n5\n*SET_NODE\n5\n3,"
      "4\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_THAT(ids(b, b.model.sets.nodes[0].members), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(ids(b, b.model.sets.nodes[1].members), ElementsAre(1, 2, 3));
}

TEST(Sets, GeneralAddsAndTakesAway) {
  const auto b = strip(
      "*SET_NODE_GENERAL\n1\nPART,1\nNODE,13\nDNODE,1,2\nDBOX,1\n*SET_NODE_GENERAL\n2\nALL\nDPART,1,2\n"
      "*SET_NODE_GENERAL\n3\nSET_SHELL,4\nSET_SEGMENT,5\n*SET_SHELL_GENERAL\n4\nELEM,3\nPART,1\nDELEM,2\nBOX,1\n"
      "*SET_SEGMENT\n5\n11,12,13\n*SET_PART_GENERAL\n6\nALL\nDPART,2\n*SET_SHELL_GENERAL\n7\nSET,4\nDSET,8\n*SET_"
      "SHELL\n8\n3\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& sets = b.model.sets;
  EXPECT_THAT(ids(b, sets.nodes[0].members), ElementsAre(5, 6, 13));
  EXPECT_THAT(ids(b, sets.nodes[1].members), ElementsAre(11, 12, 13, 14));
  EXPECT_THAT(ids(b, sets.nodes[2].members), ElementsAre(5, 7, 8, 6, 1, 3, 4, 2, 11, 12, 13));
  EXPECT_THAT(sets.shells[0].members, ElementsAre(2, 0));
  EXPECT_THAT(sets.shells[1].members, ElementsAre(0));
  EXPECT_THAT(sets.parts[0].members, ElementsAre(0, 2));
}

TEST(Sets, SegmentsOfShellsAndOfTheSkinOfSolids) {
  const auto b = strip(
      "*SET_SEGMENT_GENERAL\n1\nPART,3\n*SET_SEGMENT_GENERAL\n2\nPART,1,,,0.5\nSEG,5,7,8,6\nSHELL,3\nDSHELL,1\n"
      "*SET_SEGMENT_GENERAL\n3\nBOX,1\n*SET_SEGMENT_GENERAL\n4\nBOX_SOLID,1\n*SET_SEGMENT\n5\n1,3,4,0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& s = b.model.sets.segments;
  ASSERT_EQ(s.size(), 5u);
  EXPECT_EQ(s[0].members.size(), 6u);
  // Outward: the top of the brick looks up, the bottom down.
  for (const Segment& f : s[0].members) {
    const auto x = [&](std::size_t i) { return b.model.nodes.x[f[i]]; };
    const Vec3d normal = cross(x(2) - x(0), x(3) - x(1)), centre = 0.25 * (x(0) + x(1) + x(2) + x(3));
    EXPECT_GT(dot(normal, centre - Vec3d{2.5, 0.5, 0.5}), 0.0);
  }
  EXPECT_EQ(s[1].members.size(), 2u);  // shells 2 and 3, the latter once
  EXPECT_EQ(s[2].members.size(), 1u);
  EXPECT_THAT(s[3].members, IsEmpty());
  EXPECT_THAT(s[4].members[0], ElementsAre(0, 2, 3, 3));
}

TEST(Sets, NodesOfSetsOfSeveralKinds) {
  const auto b = strip(
      "*SET_NODE_ADD_ADVANCED_TITLE\nmixed\n1\n2,1,3,2,4,5,5,4\n*SET_NODE\n2\n6\n*SET_SHELL\n3\n1\n*SET_SEGMENT_"
      "GENERAL\n4\nSHELL,3\n*SET_SOLID\n5\n9\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_THAT(ids(b, b.model.sets.nodes.at(0).members), ElementsAre(6, 1, 3, 4, 2, 5, 7, 8, 11, 12, 13, 14));
  EXPECT_TRUE(strip("*SET_NODE_ADD_ADVANCED\n1\n2,7\n").error("thick shells are not built", "type1"));
}

TEST(Sets, TreesOfParts) {
  const auto b = strip(
      "*SET_PART_TREE\n7\nall\n8,-3\n*SET_PART_TREE\n8\nsheets\n-1,-2\n*SET_PART\n8\n3\n"
      "*SET_SEGMENT_GENERAL\n1\nBRANCH,8\nDBRANCH,9\n*SET_PART_TREE\n9\none sheet\n-2\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& sets = b.model.sets;
  ASSERT_EQ(sets.branches.size(), 3u);
  EXPECT_THAT(sets.branches[0].members, ElementsAre(0, 1, 2));
  EXPECT_THAT(sets.parts.at(0).members, ElementsAre(2)) << "branches have ids of their own";
  EXPECT_EQ(sets.segments.at(0).members.size(), 2u);
  EXPECT_TRUE(strip("*SET_PART_TREE\n7\n\n8\n").error("branch of parts set 8 is not defined"));
  EXPECT_TRUE(strip("*SET_PART_TREE\n7\n\n7\n").error("contains itself"));
  EXPECT_TRUE(strip("*SET_PART_TREE\n7\n\n-5\n").error("part 5 is not defined"));
}

TEST(Sets, CollectJoinsTheSameId) {
  const auto b = strip("*SET_NODE_LIST_COLLECT\n1\n1\n*SET_NODE_LIST_COLLECT\n1\n2,1\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_THAT(ids(b, b.model.sets.nodes.at(0).members), ElementsAre(1, 2));
}

TEST(Sets, Faults) {
  EXPECT_TRUE(strip("*SET_NODE\n1\n1\n*SET_NODE\n1\n2\n").error("node set 1 is defined twice"));
  EXPECT_TRUE(strip("*SET_NODE\n1\n1,404\n").error("node 404 is not defined"));
  EXPECT_TRUE(strip("*SET_NODE_ADD\n1\n9\n").error("node set 9 is not defined"));
  EXPECT_TRUE(strip("*SET_NODE_ADD\n1\n2\n*SET_NODE_ADD\n2\n1\n").error("contains itself"));
  EXPECT_TRUE(strip("*SET_NODE_GENERAL\n1\nVOL,1\n").error("this option is not supported", "option"));
  EXPECT_TRUE(strip("*SET_SHELL_GENERAL\n1\nBOX,7\n").error("box 7 is not defined"));
  // ID4 to ID7 may be attributes and are read as reals; as ids they are whole. Sabotage: 2.5 is node 2, 1e30 node 0.
  for (const char* id : {"2.5", "1e30", "-3e9"}) {
    const auto set = [id](const char* option) {
      return fmt::format("*SET_NODE_GENERAL\n1\n{},1,1,1,{}\n", option, id);
    };
    EXPECT_TRUE(strip(set("NODE")).error("expected an id: a whole number", "id4")) << id;
    EXPECT_TRUE(strip(set("DPART")).error("expected an id: a whole number", "id4")) << id;
  }
  EXPECT_TRUE(strip("*SET_SEGMENT\n1\n1,2,1,2\n").error("three or four different nodes"));
  EXPECT_TRUE(strip("*SET_NODE_GENERATE\n1\n500,600\n").warning("node set 1 has no members"));
  EXPECT_GT(strip("*SET_NODE_LIST_SMOOTH\n1\n1,2\n").findings.errors(), 0);
}

}  // namespace
}  // namespace nugget::reading
