// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/placement.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "model/weld_section.hpp"
#include "unit/weld/assembly.hpp"
#include "weld/placement/deck_text.hpp"
#include "weld/placement/placement_deck.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::text;
using testing::HasSubstr;

/// Three sheets of 1, 2 and 0.8 that touch, and one further up that does not belong to them.
struct Stack : Assembly {
  Index low, middle, high, away;
  Stack()
      : low(sheet(1.0, {0, 0, 0}, 6, 6, 8.0)),
        middle(sheet(2.0, {0, 0, 1.5}, 6, 6, 8.0)),
        high(sheet(0.8, {0, 0, 2.9}, 3, 6, 8.0)),
        away(sheet(1.0, {0, 0, 12.0}, 6, 6, 8.0)) {}
};

struct Placed {
  Findings findings;
  std::vector<SpotPoint> points;
  std::vector<Spot> spots;
  Placed(const Assembly& a, std::vector<SpotPoint> list, const PlacementOptions& options = {})
      : points(std::move(list)) {
    spots = place(a.model, Sheets(a.model), points, options, findings);
  }
};

SpotPoint at(double x, double y, double z, std::vector<int> parts = {}) {
  SpotPoint p;
  p.x = {x, y, z};
  p.parts = std::move(parts);
  p.place = {"points.csv", 7, 0};
  return p;
}

TEST(Placement, AStackOfTouchingSheetsIsFound) {
  const Stack a;
  const Placed three(a, {at(12, 20, 1.0)});
  ASSERT_EQ(three.spots.size(), 1u) << text(three.findings);
  ASSERT_EQ(three.spots[0].sheets.size(), 3u);
  EXPECT_NEAR(norm(three.spots[0].sheets[2].point - three.spots[0].sheets[0].point), 2.9, 1e-12);
  EXPECT_NEAR(three.spots[0].diameter, 5.0 * std::sqrt(0.8), 1e-12);
  const Placed two(a, {at(36, 20, 1.0)});  // the high sheet ends at 24
  ASSERT_EQ(two.spots[0].sheets.size(), 2u);
  EXPECT_NEAR(two.spots[0].diameter, 5.0, 1e-12);
}

TEST(Placement, NamedPartsAreTakenAndNoOthers) {
  const Stack a;
  const Placed placed(a, {at(12, 20, 1.0, {2, 1})});
  ASSERT_EQ(placed.spots[0].sheets.size(), 2u);
  const Placed far(a, {at(12, 20, 1.0, {1, 4})});
  EXPECT_TRUE(far.spots.empty());
  EXPECT_THAT(text(far.findings),
              HasSubstr("points.csv:7: warning: the point (12, 20, 1): part 4 is 11 away; not placed"));
  EXPECT_EQ(Placed(a, {at(12, 20, 1.0, {1, 4})}, {20.0, 0.0}).spots.size(), 1u) << "a reach of 20 holds it";
  EXPECT_THAT(text(Placed(a, {at(12, 20, 1.0, {1, 9})}).findings), HasSubstr("part 9 is not in the model"));
}

// Two layers of part 1 that touch, and a sheet of another part on them. Shells beside each other are of one layer,
// also where the point is over the side between them. Sabotage: the best place of each part.
TEST(Placement, TwoLayersOfOnePartAreTwoSheets) {
  Assembly a;
  const Index both = a.sheet(1.0, {0, 0, 0}, 6, 6, 8.0);
  std::ranges::replace(a.model.shells.part, a.sheet(1.0, {0, 0, 1.0}, 6, 6, 8.0), both);
  const Index other = a.sheet(1.0, {0, 0, 2.0}, 3, 6, 8.0);
  for (const double y : {16.0, 20.0}) {
    for (const double z : {-0.3, 0.4, 1.2}) {
      const Placed two(a, {at(36, y, z)});
      ASSERT_EQ(two.spots.size(), 1u) << text(two.findings);
      ASSERT_EQ(two.spots[0].sheets.size(), 2u) << y << ' ' << z;
      for (const std::size_t k : {0u, 1u}) {
        EXPECT_EQ(two.spots[0].sheets[k].part, both);
        EXPECT_NEAR(two.spots[0].sheets[k].point.z, static_cast<double>(k), 1e-12);
      }
    }
    const Placed three(a, {at(12, y, 0.9)});
    ASSERT_EQ(three.spots[0].sheets.size(), 3u);
    for (const std::size_t k : {0u, 1u, 2u})
      EXPECT_NEAR(three.spots[0].sheets[k].point.z, static_cast<double>(k), 1e-12);
    EXPECT_EQ(three.spots[0].sheets[2].part, other);
  }
  const int id = a.model.parts[both].id;
  EXPECT_EQ(Placed(a, {at(12, 20, 0.4, {id, id})}).spots[0].sheets.size(), 2u);
  const Placed thrice(a, {at(12, 20, 0.4, {id, id, id})});
  EXPECT_TRUE(thrice.spots.empty());
  EXPECT_THAT(text(thrice.findings), HasSubstr("has no further layer there"));
}

TEST(Placement, TooFewSheetsAreToldWithDistances) {
  const Stack a;
  const Placed placed(a, {at(12, 20, 12.4), at(12, 20, 1.0)});
  EXPECT_EQ(placed.spots.size(), 1u);
  EXPECT_THAT(
      text(placed.findings),
      HasSubstr("found part 4 (0.4 away), expected two to four sheets; the next is part 3, 9.5 away; not placed"));
  EXPECT_THAT(text(Placed(a, {at(12, 20, 12.4)}).findings), HasSubstr("error: no point of the list found its sheets"));
}

TEST(Placement, AWallThatPassesByIsNoSheetOfTheStack) {
  Assembly a;
  a.sheet(1.0, {0, 0, 0}, 4, 4, 8.0);
  a.sheet(1.0, {0, 0, 1}, 4, 4, 8.0);
  a.sheet(1.0, {17, 0, -8}, 4, 4, 8.0, {0, 1, 0}, {0, 0, 1});
  const Placed placed(a, {at(16, 16, 0.5)});
  ASSERT_EQ(placed.spots.size(), 1u) << text(placed.findings);
  EXPECT_EQ(placed.spots[0].sheets.size(), 2u);
}

TEST(Placement, TheAxisIsNormalToCurvedSheetsAlsoFromAPointBesideThem) {
  Assembly a;
  const double radius = 60.0;
  for (const double r : {radius, radius + 1.0}) {
    const Index p = a.sheet_part();
    const auto first = static_cast<Index>(a.model.nodes.size());
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 6; ++j) a.node({r * std::cos(0.08 * i), r * std::sin(0.08 * i), 5.0 * j});
    for (int i = 0; i < 20; ++i)
      for (int j = 0; j < 6; ++j)
        a.shell(p, 1.0, {first + 7 * i + j, first + 7 * i + 7 + j, first + 7 * i + 8 + j, first + 7 * i + j + 1});
  }
  const double angle = 0.08 * 9.5;
  const Placed placed(a, {at((radius + 2.0) * std::cos(angle), (radius + 2.0) * std::sin(angle), 12.5)});
  ASSERT_EQ(placed.spots.size(), 1u) << text(placed.findings);
  EXPECT_NEAR(std::abs(dot(placed.spots[0].axis, Vec3d{std::cos(angle), std::sin(angle), 0})), 1.0, 1e-6);
}

TEST(Placement, SectionsHaveTheAreaOfTheCircleAndAreNumberedOneWay) {
  const double circle = 9.0 * std::acos(-1.0);
  for (const auto& [quads, points] : {std::pair{1, 4u}, {4, 9u}, {8, 12u}, {16, 22u}}) {
    const model::WeldSection s = model::weld_section(quads, circle);
    EXPECT_EQ(s.point.size(), points);
    ASSERT_EQ(s.quad.size(), std::size_t(quads));
    double sum = 0.0;
    std::array<double, 2> centre{};
    for (const auto& q : s.quad) {
      const auto d = [&](int i, int k) { return s.point[q[i]][k] - s.point[q[i - 2]][k]; };
      const double area = 0.5 * (d(2, 0) * d(3, 1) - d(2, 1) * d(3, 0));
      EXPECT_GT(area, 0.25 * circle / quads) << quads << ": none is thin";
      sum += area;
      for (std::size_t i = 0; i < 4; ++i) {  // and none has a corner that turns the other way
        const auto &a = s.point[q[i]], &b = s.point[q[(i + 1) % 4]], &c = s.point[q[(i + 2) % 4]];
        EXPECT_GT((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]), 0.0) << quads;
      }
    }
    EXPECT_NEAR(sum, circle, 1e-12) << quads;
    for (const auto& p : s.point)
      for (std::size_t k = 0; k < 2; ++k) centre[k] += p[k];
    EXPECT_NEAR(std::hypot(centre[0], centre[1]), 0.0, 1e-12) << quads;
  }
  const double unit = 0.25 * std::acos(-1.0);  // docs/theory/weld.md
  EXPECT_NEAR(model::weld_section(4, unit).point[1][0], 0.5270, 1e-4);
  EXPECT_NEAR(model::weld_section(1, unit).point[2][0], 0.5 * 0.8862, 1e-4);
}

TEST(Placement, BeamsOfAStackShareTheNodesBetweenAndBricksTheirFaces) {
  const Stack a;
  const Placed placed(a, {at(12, 20, 1.0)});
  Findings findings;
  const Sheets sheets(a.model);
  const PlacementDeck beams = write_placement(a.model, sheets, placed.spots, WeldForm::beam, {}, "m.k", findings);
  const int n = static_cast<int>(a.model.nodes.size());
  EXPECT_EQ(beams.elements, 2u);
  EXPECT_THAT(beams.text, HasSubstr(fmt::format("{:8d}{:8d}       0", n + 1, n + 2)));
  EXPECT_THAT(beams.text, HasSubstr(fmt::format("{:8d}{:8d}       0", n + 2, n + 3)));
  EXPECT_THAT(beams.text, HasSubstr("*INCLUDE\nm.k\n"));
  EXPECT_EQ(write_placement(a.model, sheets, placed.spots, WeldForm::solid8, {}, "m.k", findings).elements, 16u);
  EXPECT_EQ(write_placement(a.model, sheets, placed.spots, WeldForm::solid16, {}, "m.k", findings).elements, 32u);
  const PlacementDeck laws =
      write_placement(a.model, sheets, placed.spots, WeldForm::interpolation, {}, "m.k", findings);
  EXPECT_EQ(laws.elements, 2u);
  EXPECT_THAT(laws.text, HasSubstr("*CONSTRAINED_INTERPOLATION_SPOTWELD"));
  EXPECT_THAT(laws.text, Not(HasSubstr("*ELEMENT")));
  EXPECT_EQ(findings.all().size(), 0u) << text(findings);
  EXPECT_THAT(
      write_placement(a.model, sheets, placed.spots, WeldForm::beam, {{{"", {{"nrr", 8000.0}}}}}, "m.k", findings).text,
      HasSubstr("         0      8000         0"));
}

/// The lines of the second card of each *MAT_SPOTWELD.
std::vector<std::string> strength_lines(const std::string& deck) {
  std::vector<std::string> lines;
  const std::string head = "mtt        nf\n";
  for (std::size_t at = deck.find(head); at != std::string::npos; at = deck.find(head, at + 1)) {
    const std::size_t begin = at + head.size();
    lines.push_back(deck.substr(begin, deck.find('\n', begin) - begin));
  }
  return lines;
}

TEST(Placement, StrengthsHoldForEveryDiameterUnlessTheirsIsGiven) {
  const Stack a;
  std::vector<SpotPoint> list{at(12, 20, 1.0, {1, 2}), at(36, 20, 1.0, {1, 2})};
  list[0].diameter = 4.0;
  list[1].diameter = 6.0;
  const Placed placed(a, list);
  ASSERT_EQ(placed.spots.size(), 2u) << text(placed.findings);
  const Sheets sheets(a.model);
  GivenMaterial given{{{"", {{"nrr", 7200.0}, {"mss", 27000.0}, {"efail", 0.25}, {"nf", 3.0}, {"sigy", 400.0}}}}};
  Findings same;
  const std::string as_given = write_placement(a.model, sheets, placed.spots, WeldForm::beam, given, "m.k", same).text;
  EXPECT_EQ(
      strength_lines(as_given),
      (std::vector<std::string>{"      0.25      7200         0         0         0     27000         0         3"}));
  EXPECT_EQ(same.warnings(), 1);
  EXPECT_THAT(text(same), HasSubstr("welds of diameters 4 to 6 have the same strengths, the smallest those of the "
                                    "largest: NRR = 7200, MSS = 27000 [--scale-strength"));
  given.strength_diameter = 6.0;
  Findings scaled;
  const std::string by = write_placement(a.model, sheets, placed.spots, WeldForm::beam, given, "m.k", scaled).text;
  EXPECT_EQ(
      strength_lines(by),
      (std::vector<std::string>{"      0.25      3200         0         0         0      8000         0         3",
                                "      0.25      7200         0         0         0     27000         0         3"}))
      << "forces by (4/6)^2, moments by (4/6)^3, the rest as given";
  EXPECT_EQ(scaled.warnings(), 0);
  EXPECT_THAT(text(scaled), HasSubstr("welds of diameter 4 have NRR = 3200, MSS = 8000, scaled from diameter 6: NRR = "
                                      "7200, MSS = 27000"));
}

TEST(Placement, StrengthsOfOneDiameterAreNoted) {
  const Stack a;
  const Placed placed(a, {at(12, 20, 1.0)}, {0.0, 4.0});
  Findings findings;
  write_placement(a.model, Sheets(a.model), placed.spots, WeldForm::beam, {{{"", {{"nrs", 6000.0}}}}}, "m.k", findings);
  EXPECT_EQ(findings.warnings(), 0);
  EXPECT_THAT(text(findings), HasSubstr("note: *MAT_SPOTWELD: welds of diameter 4 have the strengths as given: NRS = "
                                        "6000 [if these are of a weld of another diameter"));
}

TEST(Placement, BricksOverTheEdgeAreToldAndLeftOut) {
  const Stack a;
  const Placed placed(a, {at(12, 20, 1.0), at(1, 20, 1.0)});
  Findings findings;
  const PlacementDeck deck =
      write_placement(a.model, Sheets(a.model), placed.spots, WeldForm::solid, {}, "m.k", findings);
  EXPECT_EQ(deck.spots, 1u);
  EXPECT_THAT(text(findings),
              HasSubstr("points.csv:7: warning: bricks of diameter 4.472 reach over the edge of part 1"));
}

/// The nodes of a deck that was written.
std::vector<Vec3d> nodes_of(const std::string& deck) {
  std::istringstream lines(deck.substr(deck.find("*NODE")));
  std::vector<Vec3d> nodes;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line[0] != '*')
    if (line[0] != '$')
      nodes.push_back({std::stod(line.substr(8, 16)), std::stod(line.substr(24, 16)), std::stod(line.substr(40, 16))});
  return nodes;
}

TEST(Placement, BricksTurnWithTheModel) {
  const auto turned = [](const Vec3d& x) {  // by 0.7 about z, then by 1.1 about x
    const Vec3d a{std::cos(0.7) * x.x - std::sin(0.7) * x.y, std::sin(0.7) * x.x + std::cos(0.7) * x.y, x.z};
    return Vec3d{a.x, std::cos(1.1) * a.y - std::sin(1.1) * a.z, std::sin(1.1) * a.y + std::cos(1.1) * a.z};
  };
  const Stack as_built;
  Stack other;
  for (Vec3d& x : other.model.nodes.x) x = turned(x);
  SpotPoint spot = at(37, 20, 1.0);
  const Placed here(as_built, {spot});
  spot.x = turned(spot.x);
  const Placed there(other, {spot});
  for (const WeldForm form : {WeldForm::solid, WeldForm::solid4, WeldForm::solid8, WeldForm::solid16}) {
    Findings findings;
    const auto written = [&](const Stack& stack, const Placed& placed) {
      return nodes_of(write_placement(stack.model, Sheets(stack.model), placed.spots, form, {}, "m.k", findings).text);
    };
    const std::vector<Vec3d> a = written(as_built, here), b = written(other, there);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(norm(b[i] - turned(a[i])), 1e-6) << named(form).name << i;
  }
}

/// A list in a file of its own.
struct List {
  std::filesystem::path path = std::filesystem::temp_directory_path() /
                               fmt::format("nugget_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
  Findings findings;
  std::vector<SpotPoint> points;
  explicit List(const std::string& content, const model::Model& model = model::Model()) {
    std::ofstream(path) << content;
    points = read_spots(path, model, findings);
  }
  ~List() { std::filesystem::remove(path); }
};

TEST(SpotList, ATableWithAndWithoutNames) {
  for (const std::string content :
       {"# remark\nx, y, z, diameter, parts, class\n1,2,3,5.5,1+2,a\n4,5,6\n", "1\t2\t3\t5.5\t1 2\ta\r\n4\t5\t6\r\n",
        "1;2;3;5.5;1/2;a\n\n4;5;6;;;\n", "Parts;class;z;y;x;Diameter\n1 2;a;3;2;1;5.5\n;;6;5;4;\n"}) {
    const List list(content);
    ASSERT_EQ(list.points.size(), 2u) << content << text(list.findings);
    EXPECT_EQ(list.points[0].x.z, 3.0);
    EXPECT_EQ(list.points[0].diameter, 5.5);
    EXPECT_EQ(list.points[0].parts, (std::vector<int>{1, 2}));
    EXPECT_EQ(list.points[0].spot_class, "a");
    EXPECT_EQ(list.points[1].x.x, 4.0);
    EXPECT_EQ(list.points[1].diameter, 0.0);
  }
}

TEST(SpotList, RefusalsNameFileAndLine) {
  for (const auto& [content, wanted] : std::vector<std::pair<std::string, std::string>>{
           {"x,y,z\n1,2,3\n1,two,3\n", ":3: error: y = two: expected a number"},
           {"1,2,3\n1,2\n", ":2: error: z = (blank): expected a number"},
           {"1,2,3,-5\n", ":1: error: diameter = -5: expected a number above 0"},
           {"1,2,3,5,1-2\n", ":1: error: parts = 1-2: expected part ids above 0"},
           {"1,2,3,4,5,6,7\n", ":1: error: 7 cells, expected at most 6"},
           {"x,y,height\n1,2,3\n", ":1: error: the column 'height' is not known"},
           {"x,y\n1,2\n", ":1: error: the column 'z' stands 0 times"},
           {"# nothing\n", "error: the list has no points"}})
    EXPECT_THAT(text(List(content).findings), HasSubstr(wanted)) << content;
}

TEST(SpotList, XmcfSpotsInTheUnitsOfTheModel) {
  Assembly a;
  a.model.parts[a.sheet(0.001, {0, 0, 0}, 2, 2, 0.01)].title = "floor";
  a.model.materials.back().density = 7850.0;
  a.model.materials.back().law = kernel::Elastic{2.1e11, 0.3};
  const List list(R"(<?xml version="1.0"?>
<xmcf><version>3.1.1</version><units length="mm"/>
 <connection_group id="1">
  <connected_to><part index="1" pname="floor"/><part index="2" pid="7"/></connected_to>
  <connection_list>
   <connection_0d label="a"><loc>10 20.5 -3e1</loc><spotweld diameter="5" technology="resistance"/></connection_0d>
   <connection_0d><loc>1 2 3</loc><rivet hardness="3"/></connection_0d>
   <connection_1d><loc_list><loc v="2">100 0 0</loc><loc v="1">0 0 0</loc></loc_list>
    <sequence_connection_0d spacing="30" margin="5"><spotweld/></sequence_connection_0d></connection_1d>
  </connection_list></connection_group></xmcf>)",
                  a.model);
  ASSERT_EQ(list.points.size(), 5u) << text(list.findings);
  EXPECT_NEAR(list.points[0].x.y, 0.0205, 1e-15);
  EXPECT_NEAR(list.points[0].x.z, -0.03, 1e-15);
  EXPECT_NEAR(list.points[0].diameter, 0.005, 1e-15);
  EXPECT_EQ(list.points[0].parts, (std::vector<int>{1, 7}));
  EXPECT_EQ(list.points[0].place.line, 6);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(list.points[1 + k].x.x, 0.005 + 0.03 * k, 1e-15);
  EXPECT_THAT(text(list.findings), HasSubstr(":7: warning: <rivet>: 1 connection of this kind, the first here"));
}

/// Sabotage: an exponent with its sign and zero, which leaves four digits. A stiffness in N/m then changed the energies
/// of two welds by 2e-3.
TEST(PlacementDeck, FieldsKeepDigitsInAnyUnits) {
  for (int power = -12; power <= 14; ++power)
    for (const double mantissa : {2.0174411043, -7.7593886519, 9.9999976, 1.0}) {
      const double value = mantissa * std::pow(10.0, power);
      const std::string field = real_field(value);
      EXPECT_EQ(field.size(), 10u) << field;
      EXPECT_EQ(field.front(), ' ') << field;
      EXPECT_NEAR(std::stod(field) / value, 1.0, mantissa < 0.0 || power < -9 ? 3e-4 : 3e-5) << field;
    }
  EXPECT_EQ(real_field(7.85e-09), "  7.85e-09");
  EXPECT_EQ(real_field(0.0), "         0");
}

TEST(SpotList, XmcfThatIsNotSound) {
  for (const auto& [content, wanted] : std::vector<std::pair<std::string, std::string>>{
           {"<xmcf>\n<connection_group>\n</xmcf>", ":3: error: this is no sound XML"},
           {"<html></html>", "error: the root element is not <xmcf>"},
           {"<xmcf><units length='cm'/></xmcf>", "length unit 'cm', expected mm, m, in or ft"},
           {"<xmcf>\n<connection_group><connected_to><part label='x'/></connected_to></connection_group></xmcf>",
            ":2: error: <part>: no pid"},
           {"<xmcf><connection_group><connected_to/><connection_list>\n<connection_0d><loc>1 2</loc><spotweld/>"
            "</connection_0d></connection_list></connection_group></xmcf>",
            ":2: error: <loc>: '1 2', expected three numbers"}})
    EXPECT_THAT(text(List(content).findings), HasSubstr(wanted)) << content;
}

}  // namespace
}  // namespace nugget::weld
