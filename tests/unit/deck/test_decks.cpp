// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "deck/deck.hpp"

// Real public decks, read whole. Counts come from the files themselves (grep -c), not from this reader.
namespace nugget::deck {
namespace {

namespace fs = std::filesystem;

const fs::path decks = fs::path(NUGGET_SOURCE_DIR) / "../shared/decks";

struct Counts {
  std::size_t nodes = 0, shells = 0, solids = 0, beams = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& os, const Counts& c) {
    return os << c.nodes << " nodes, " << c.shells << " shells, " << c.solids << " solids, " << c.beams << " beams";
  }
};

struct Tables {
  NodeTable nodes;
  ElementTable shells, solids, beams;
};

Tables read_tables(const Deck& deck, Findings& findings) {
  Tables t;
  for (const Block& b : deck.blocks) {
    if (b.keyword == "NODE") read_nodes(deck, b, t.nodes, findings);
    if (b.keyword.starts_with("ELEMENT_SHELL")) read_shells(deck, b, t.shells, findings);
    if (b.keyword.starts_with("ELEMENT_SOLID")) read_solids(deck, b, t.solids, findings);
    if (b.keyword.starts_with("ELEMENT_BEAM")) read_beams(deck, b, t.beams, findings);
  }
  return t;
}

std::string all_findings(const Findings& findings) {
  std::string s;
  for (const Finding& f : findings.all()) s += to_string(f) + '\n';
  return s;
}

struct Known {
  std::string path;
  Counts counts;
  std::size_t blocks, consumed;
};

void PrintTo(const Known& known, std::ostream* os) {
  *os << known.path;
}

class PublicDeck : public testing::TestWithParam<Known> {};

TEST_P(PublicDeck, IsReadWhole) {
  const Known& known = GetParam();
  const fs::path path = decks / known.path;
  if (!fs::exists(path)) GTEST_SKIP() << path << " is absent";
  Findings findings;
  const Deck deck = read(path, findings);
  const Tables t = read_tables(deck, findings);
  EXPECT_EQ(findings.errors(), 0) << all_findings(findings);
  EXPECT_EQ(findings.warnings(), 0) << all_findings(findings);
  const Counts found{t.nodes.id.size(), t.shells.id.size(), t.solids.id.size(), t.beams.id.size()};
  EXPECT_EQ(found, known.counts);
  EXPECT_EQ(deck.blocks.size(), known.blocks);
  EXPECT_EQ(deck.consumed.size(), known.consumed);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, PublicDeck,
    testing::Values(Known{"ball_plate/ball_plate.k", {1940, 256, 1512, 0}, 21, 2},
                    Known{"box_drop/box_drop_openrs.k", {1452, 100, 1000, 0}, 20, 5},
                    Known{"box_drop/main.k", {1452, 100, 1000, 0}, 18, 2},
                    Known{"bumper_beam/Bumper_Beam_AP_meshed.k", {13832, 13626, 0, 78}, 145, 2},
                    Known{"camry_roof_crush_includes/501_RIG_BAR_roof_crush_platen5.key", {22080, 21755, 0, 0}, 3, 2},
                    Known{"camry_roof_crush_includes/roof_welds.k", {104, 0, 0, 52}, 4, 2},
                    Known{"camry_roof_crush_includes/weld7.k", {4005, 0, 0, 2235}, 2, 2},
                    Known{"camry_roof_crush_includes/xtra_sw.k", {613, 0, 0, 345}, 3, 2},
                    Known{"car6/main_v223.k", {2378, 2424, 0, 0}, 55, 6},
                    Known{"car6/main_v223_param.k", {2378, 2424, 0, 0}, 55, 6},
                    Known{"frf_column/frf_solid.k", {440, 0, 252, 0}, 22, 2},
                    Known{"hex_weld_fragment/rkrwelds.key", {6624, 0, 1019, 0}, 201, 2},
                    Known{"single_hex/single_hex_tension.k", {8, 0, 1, 0}, 13, 2},
                    Known{"tensile_test/zug_test3_RS.k", {981, 864, 0, 0}, 37, 2}),
    [](const auto& p) {
      std::string name = p.param.path;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
      return name;
    });

TEST(PublicDecks, TheCarsMeshIsMissing) {
  const fs::path path = decks / "camry_roof_crush_includes/Camry_RC_main.k";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is absent";
  if (fs::exists(path.parent_path() / "Camry_V1_NoSusAndPowerTrain_impl7.k"))
    GTEST_SKIP() << "the mesh is there after all";
  Findings findings;
  const Deck deck = read(path, findings);
  const Tables t = read_tables(deck, findings);
  EXPECT_EQ(findings.errors(), 2) << all_findings(findings);
  const std::string first = to_string(findings.all()[0]);
  EXPECT_EQ(first.find(path.string() +
                       ":10: error: *INCLUDE: cannot find the file 'Camry_V1_NoSusAndPowerTrain_impl7.k'; looked in "),
            0u)
      << first;
  EXPECT_NE(first.find(path.parent_path().string()), std::string::npos) << first;
  EXPECT_EQ(t.beams.id.size(), 2632u);  // the other includes are read all the same
  EXPECT_EQ(t.nodes.id.size(), 22080u + 613 + 4005 + 104);
  EXPECT_EQ(t.beams.node[0], 7000427);
}

TEST(PublicDecks, ParametersOfTheCar) {
  const fs::path path = decks / "car6/main_v223_param.k";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is absent";
  Findings findings;
  const Deck deck = read(path, findings);
  const Card yield{{id("mid", IdSpace::material, required, "material"),
                    real("ro", dimension::density, required, above_zero(), "density"),
                    real("e", dimension::stress, required, above_zero(), "modulus"),
                    real("pr", dimension::number, 0.0, any_value, "ratio"),
                    real("sigy", dimension::stress, 0.0, any_value, "yield stress")}};
  const Card thickness{{real("t1", dimension::length, 0.0, any_value, "thickness"),
                        real("t2", dimension::length, 0.0, any_value, "thickness")}};
  std::vector<double> yields, thicknesses;
  for (const Block& b : deck.blocks) {
    Cursor c(deck, b, findings);
    if (b.keyword == "MAT_PLASTIC_KINEMATIC") yields.push_back(c.read(yield).entry("sigy").value);
    if (b.keyword != "SECTION_SHELL") continue;
    c.skip();
    thicknesses.push_back(c.read(thickness).entry("t2").value);
  }
  const auto has = [](const std::vector<double>& v, double x) { return std::find(v.begin(), v.end(), x) != v.end(); };
  EXPECT_EQ(yields.size(), 7u);
  for (const double y : {317.975, 400.0}) EXPECT_TRUE(has(yields, y)) << y;
  for (const double t : {2.9785, 2.18735, 3.38227, 1.0}) EXPECT_TRUE(has(thicknesses, t)) << t;
}

}  // namespace
}  // namespace nugget::deck
