// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_INTERPOLATION_SPOTWELD: what is made of it, and each way in which it can be wrong.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <variant>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;

/// Three cards of ten columns each.
struct Spr3Cards {
  std::string join = "         1         4         7       2.4       0.3    1000.0       0.5         1";
  std::string yield = "       1.2       0.8       2.0        61        62        63    7.8e-9         0";
  std::string stiffness = "     900.0      50.0      60.0         0       0.1         0        30";
  std::string more;
};

std::string spr3_deck(const Spr3Cards& cards, const std::string& begins = "0.1", const std::string& ends = "0.5",
                      const std::string& last_abscissa = "1.0") {
  return deck_of_two_sheets(R"(*DEFINE_CURVE
        61
                 0.0               100.0
                 1.0               150.0
*DEFINE_CURVE
        62
                 0.0                 )" +
                            begins + "\n                 " + last_abscissa + "                 " + begins + R"(
*DEFINE_CURVE
        63
                 0.0                 )" +
                            ends + "\n                 1.0                 " + ends +
                            "\n*CONSTRAINED_INTERPOLATION_SPOTWELD\n" + cards.join + "\n" + cards.yield + "\n" +
                            (cards.stiffness.empty() ? "" : cards.stiffness + "\n") + cards.more);
}

TEST(InterpolationSpotwelds, BecomeBeamsWithATieToBothSheets) {
  const Built b(spr3_deck({}));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Model& m = b.model;
  EXPECT_THAT(m.beams.id, ElementsAre(51, 52)) << "the ids of their location nodes";
  const Part& part = m.parts[m.beams.part[0]];
  EXPECT_EQ(part.id, 30);
  for (std::size_t e = 0; e < 2; ++e) {
    EXPECT_EQ(m.nodes.x[m.beams.node[e][0]].x, e == 0 ? 0.4 : 0.6);
    EXPECT_EQ(m.parts[m.beams.tied_parts[e][0]].id, 1);
    EXPECT_EQ(m.parts[m.beams.tied_parts[e][1]].id, 4);
    EXPECT_GT(m.beams.place[e].line, 0);
  }
  const SectionBeam& section = m.beam_sections[part.section];
  EXPECT_EQ(section.elform, 6);
  EXPECT_EQ(section.outer[0], 0.6);
  EXPECT_NEAR(section.volume, std::numbers::pi * 0.09 * 2.4, 1e-12);
  const auto& law = std::get<kernel::DiscreteBeam>(m.materials[part.material].law);
  ASSERT_TRUE(law.joint);
  const auto& joint = std::get<kernel::Spr3>(*law.joint);
  EXPECT_THAT(joint.stiffness(), ElementsAre(1000.0, 900.0, 900.0, 60.0, 50.0, 50.0));
  EXPECT_EQ(joint.normal_strength, 1.2);
  EXPECT_EQ(joint.shear_strength, 0.8);
  EXPECT_EQ(joint.exponent, 2.0);
  EXPECT_EQ(joint.bending_share, 0.5);
  EXPECT_EQ(joint.torsion_share, 0.1);
  EXPECT_EQ(joint.yield.yield(0.5), 125.0);
  EXPECT_EQ(joint.rupture.clamped(0.3), 0.5);
  EXPECT_EQ(law.dof[4].initial_stiffness(), 50.0);
  ASSERT_EQ(m.contacts.size(), 1u);
  EXPECT_TRUE(m.contacts[0].tie());
  EXPECT_NEAR(0.6 * -m.contacts[0].thickness_a, 2.4, 1e-12) << "reach";
}

TEST(InterpolationSpotwelds, BlankStiffnessesAreTheNumberStiff) {
  Spr3Cards cards;
  cards.stiffness = "";
  const Built b(spr3_deck(cards));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = std::get<kernel::DiscreteBeam>(b.model.materials.back().law);
  EXPECT_THAT(std::get<kernel::Spr3>(*law.joint).stiffness(), testing::Each(1000.0));
  EXPECT_TRUE(b.find(Severity::note, "another stiffness in other units", "stiff"));
}

TEST(InterpolationSpotwelds, OfSeveralPartsTheClosestIsTheSheet) {
  Spr3Cards cards;
  cards.join = "        -9         4         7       2.4       0.3    1000.0       0.5         3";
  cards.more = "*SET_PART_LIST\n         9\n         2         1\n";
  const Built b(spr3_deck(cards));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(b.model.parts[b.model.beams.tied_parts[0][0]].id, 1);
}

TEST(InterpolationSpotwelds, IdsOfBeamsThatAreTaken) {
  Spr3Cards cards;
  cards.more = R"(*PART
bar
        70        70         1
*SECTION_BEAM
        70         3
      0.01
*ELEMENT_BEAM
      60      70      31      33
)";
  const Built b(spr3_deck(cards));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_THAT(b.model.beams.id, ElementsAre(60, 61, 62));
}

TEST(InterpolationSpotwelds, RefusedByName) {
  const auto error = [](const std::string& what, std::string Spr3Cards::*card, const std::string& line,
                        const std::string& field) {
    Spr3Cards cards;
    cards.*card = line;
    const Built b(spr3_deck(cards));
    EXPECT_TRUE(b.error(what, field)) << what << '\n' << b.all_findings();
  };
  const std::string head = "         1         4         7       2.4       0.3    1000.0       0.5";
  error("SPR4", &Spr3Cards::join, head + "         2", "model");
  error("what it does other than 11", &Spr3Cards::join, head + "        21", "model");
  error("*DEFINE_FUNCTION 1000.0 is not in the deck", &Spr3Cards::join, head + "        11", "stiff");
  error("both sides", &Spr3Cards::join, "         1         1         7       2.4       0.3    1000.0", "pid2");
  error("not defined", &Spr3Cards::join, "         1         4         8       2.4       0.3    1000.0", "nsid");
  error("peel ratio", &Spr3Cards::yield, "     -61.0       0.8       2.0        61        62        63    7.8e-9",
        "rn");
  error("", &Spr3Cards::yield, "       1.2       0.8       0.5        61        62        63    7.8e-9", "beta");
  error("", &Spr3Cards::yield, "       1.2       0.8       2.0        61        62        63          ", "dens");
  error("", &Spr3Cards::yield, "       1.2       0.8       2.0        61        62        63    7.8e-9         1",
        "intp");
  error("both", &Spr3Cards::yield, "       1.2       0.8       2.0        61        62         0    7.8e-9", "lcupr");
  error("angle of the load", &Spr3Cards::stiffness, "     -61.0", "stiff2");
  error("exponent of damage", &Spr3Cards::stiffness, "       0.0       0.0       0.0        61", "lcdexp");
  error("is in the deck", &Spr3Cards::stiffness,
        "       0.0       0.0       0.0         0       0.0         0         1", "pidvb");
  error("", &Spr3Cards::more, "       2.0\n", "scarn");
  error("", &Spr3Cards::more, "       1.0       1.0       0.1\n", "damp");
  error("", &Spr3Cards::more, "       1.0       1.0\n     500.0\n", "ffn");
  EXPECT_TRUE(Built(spr3_deck({}, "0.5", "0.5")).error("breaks at", "lcupr"));
  EXPECT_TRUE(Built(spr3_deck({}, "0.1", "0.5", "90.")).error("mode mixity", "lcupf"));
}

}  // namespace
}  // namespace nugget::reading
