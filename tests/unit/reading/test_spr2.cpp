// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_SPR2: what is made of it, and each way in which it can be wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;

std::string spr2_deck(const std::string& cards) {
  return deck_of_two_sheets("*CONSTRAINED_SPR2\n" + cards);
}
const std::string place = "4,1,7,2.4,0.6,3000.0,5000.0,2.0\n", shape = "3.0,0.4,0.5,0.8,0.9,-1.5,7.8e-9\n";

TEST(Spr2, RivetsBecomeBeamsWithATieToBothSheets) {
  const Built b(spr2_deck(place + shape + "6.0,,30\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Model& m = b.model;
  EXPECT_THAT(m.beams.id, ElementsAre(51, 52)) << "the ids of their location nodes";
  const Part& part = m.parts[m.beams.part[0]];
  EXPECT_EQ(part.id, 30);
  EXPECT_EQ(m.parts[m.beams.tied_parts[0][0]].id, 4) << "the upper sheet first";
  EXPECT_EQ(m.parts[m.beams.tied_parts[0][1]].id, 1);
  EXPECT_NEAR(m.beam_sections[part.section].volume, std::numbers::pi * 0.09 * 2.4, 1e-12);
  EXPECT_EQ(m.materials[part.material].keyword, "CONSTRAINED_SPR2");
  const auto& law = std::get<kernel::Spr2>(*std::get<kernel::DiscreteBeam>(m.materials[part.material].law).joint);
  EXPECT_EQ(law.normal_force, 3000.0);
  EXPECT_EQ(law.shear_force, 5000.0);
  EXPECT_EQ(law.normal_failure, 2.0);
  EXPECT_EQ(law.shear_failure, 3.0);
  EXPECT_EQ(law.normal_peak, 0.4);
  EXPECT_EQ(law.shear_peak, 0.5);
  EXPECT_THAT(law.alpha, ElementsAre(0.8, 0.9, 1.5)) << "the sign of ALPHA3 is no number";
  EXPECT_EQ(law.normal_exponent, 6.0);
  EXPECT_EQ(law.shear_exponent, 8.0);
  EXPECT_EQ(law.arm, 1.2);
  EXPECT_TRUE(b.find(Severity::note, "2 rivets, with the ids"));
}

TEST(Spr2, FaultsOfRivets) {
  const auto built = [](const std::string& cards) { return Built(spr2_deck(cards)); };
  EXPECT_EQ(built(place + shape).findings.errors(), 0) << "the third card may be missing";
  EXPECT_TRUE(built("4,4,7,2.4,0.6,3000.0,5000.0,2.0\n" + shape).error("both sides", "lpid"));
  EXPECT_TRUE(built("4,1,7,2.4,0.6,-9.0,5000.0,2.0\n" + shape).error("MAT_CONSTRAINED_SPR2", "fn"));
  EXPECT_TRUE(built("4,1,7,2.4,0.6,3000.0,5000.0\n" + shape).error("", "dn"));
  EXPECT_TRUE(built("4,99,7,2.4,0.6,3000.0,5000.0,2.0\n" + shape).error("99", "lpid"));
  EXPECT_TRUE(built(place + "3.0,1.0,0.5,0.8,0.9,1.5,7.8e-9\n").error("", "xin"));
  EXPECT_TRUE(built(place + "3.0,0.4,0.5,0.8,0.9,0.0,7.8e-9\n").error("", "alpha3"));
  EXPECT_TRUE(built(place + "3.0,0.4,0.5,0.8,0.9,1.5,7.8e-9,1\n").error("only 0", "intp"));
  EXPECT_TRUE(built(place + shape + "8.0,8.0,4\n").error("part 4 is in the deck", "pidvb"));
  EXPECT_TRUE(built(place + shape + "8.0,8.0\n3\n").error("only 0", "xpid1"));
}

}  // namespace
}  // namespace nugget::reading
