// SPDX-License-Identifier: Apache-2.0
// The list of keywords as a whole, and the texts made of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "reading/describe.hpp"
#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(KeywordList, EveryRowIsComplete) {
  std::map<std::string_view, int> names;
  for (const Keyword& keyword : keywords()) {
    ++names[keyword.name];
    for (const auto alias : keyword.aliases) ++names[alias];
    if (keyword.status == KeywordStatus::used) {
      EXPECT_NE(keyword.read, nullptr) << keyword.name;
      EXPECT_FALSE(keyword.name.ends_with('*')) << keyword.name;
    } else {
      EXPECT_FALSE(keyword.why.empty()) << keyword.name << " has no reason";
      // An ignored one may have a reader that warns of what is missed.
      EXPECT_TRUE(keyword.read == nullptr || keyword.status == KeywordStatus::ignored) << keyword.name;
    }
    EXPECT_THAT(std::string(keyword.name), Not(testing::StartsWith("*")));
    EXPECT_EQ(keyword.name.substr(0, keyword.name.size() - 1).find('*'), std::string_view::npos)
        << keyword.name << ": a star stands at the end";
    for (const LayoutCard& card : keyword.layout) {
      ASSERT_NE(card.card, nullptr) << keyword.name;
      for (const Field& field : card.card->fields)
        EXPECT_TRUE(field.name.empty() || !field.meaning.empty())
            << keyword.name << ' ' << field.name << " has no meaning";
    }
  }
  for (const auto& [name, count] : names) EXPECT_EQ(count, 1) << name << " stands in the list more than once";
}

TEST(KeywordList, WhatIsBuiltOfAFamily) {
  EXPECT_EQ(built_of_family("INTEGRATION_"), "built are *INTEGRATION_BEAM and _SHELL");
  EXPECT_EQ(built_of_family("INITIAL_STRAIN_"), "built is *INITIAL_STRAIN_SHELL");
  EXPECT_THAT(built_of_family("PART_"), HasSubstr("_INERTIA"));  // an option of *PART
  EXPECT_THAT(built_of_family("SECTION_"), HasSubstr("_SOLID and _TSHELL"));
  EXPECT_EQ(built_of_family("MAT_"), "`nugget keywords MAT_` lists what is built");
  EXPECT_EQ(built_of_family("EM_"), "");
}

TEST(KeywordList, FieldNamesOfACardAreUnique) {
  for (const Keyword& keyword : keywords())
    for (const LayoutCard& card : keyword.layout) {
      std::map<std::string_view, int> names;
      for (const Field& field : card.card->fields)
        EXPECT_TRUE(field.name.empty() || ++names[field.name] == 1) << keyword.name << ' ' << field.name;
    }
}

TEST(KeywordList, LongestNameDecides) {
  const auto row = [](std::string_view written) {
    Options options;
    const Keyword* keyword = find_keyword(written, options);
    return keyword ? std::string(keyword->name) : std::string("unknown");
  };
  EXPECT_EQ(row("DATABASE_HISTORY_NODE_SET_ID"), "DATABASE_HISTORY_NODE_SET");
  EXPECT_EQ(row("BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL_ID"), "BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL");
  EXPECT_EQ(row("CONTACT_TIED_SHELL_EDGE_TO_SURFACE_MPP_ID"), "CONTACT_TIED_SHELL_EDGE_TO_SURFACE");
  EXPECT_EQ(row("CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET_ID"), "CONTACT_TIED_SHELL_EDGE_TO_SURFACE");
  EXPECT_EQ(row("CONTACT_TIED_NODES_TO_SURFACE_BEAM_OFFSET"), "CONTACT_TIED_NODES_TO_SURFACE_*");
  EXPECT_EQ(row("RIGIDWALL_GEOMETRIC_CYLINDER_DISPLAY_ID"), "RIGIDWALL_GEOMETRIC_CYLINDER");
  EXPECT_EQ(row("CONSTRAINED_TIE-BREAK"), "CONSTRAINED_TIE_BREAK");
  EXPECT_EQ(row("SENSOR_DEFINE_FORCE"), "SENSOR_DEFINE_FORCE");
  EXPECT_EQ(row("SENSOR_DEFINE_FORCE_TITLE"), "SENSOR_DEFINE_FORCE");
  EXPECT_EQ(row("SENSOR_DEFINE_NODE_SET"), "SENSOR_DEFINE_NODE_*");
  EXPECT_EQ(row("SENSOR_SWITCH_CALC_LOGIC"), "SENSOR_SWITCH_CALC-LOGIC");
  EXPECT_EQ(row("SENSOR_SWITCH_SHELL_TO_VENT"), "SENSOR_SWITCH_*");
  EXPECT_EQ(row("SENSOR_CPM_AIRBAG"), "SENSOR_*");
  EXPECT_EQ(row("MAT_NOBODY_KNOWS"), "MAT_*");
  EXPECT_EQ(row("AIRBAG_WANG_NEFSKE_ID"), "AIRBAG_WANG_NEFSKE");
  EXPECT_EQ(row("AIRBAG_WANG_NEFSKE_JETTING"), "AIRBAG_WANG_NEFSKE_*");
  EXPECT_EQ(row("AIRBAG_WANG_NEFSKE_MULTIPLE_JETTING_ID"), "AIRBAG_WANG_NEFSKE_*");
}

TEST(KeywordList, UnsupportedPhysicsIsRefusedAllAtOnce) {
  const Built built(
      small_deck("*AIRBAG_HYBRID\n         1\n*EM_CONTROL\n         1\n*CONTROL_THERMAL_SOLVER\n       "
                 "  1\n*MAT_NOBODY_KNOWS\n         9\n"));
  EXPECT_EQ(built.findings.errors(), 4) << built.all_findings();
  EXPECT_TRUE(built.error("airbag"));
  EXPECT_TRUE(built.error("electromagnetics"));
  EXPECT_TRUE(built.error("heat"));
  EXPECT_TRUE(built.error("this material is not built"));
  const Built skipped(small_deck("*AIRBAG_HYBRID\n         1\n"), true);
  EXPECT_EQ(skipped.findings.errors(), 0) << skipped.all_findings();
  EXPECT_TRUE(skipped.warning("airbag"));
}

TEST(KeywordList, IgnoredKeywordsMakeNoFindingButStandInTheTable) {
  const Built built(
      small_deck("*SENSOR_DEFINE_FORCE\n         1RWALL              2X                  0\n*CONTROL_PARALLEL\n        "
                 " 2\n*CONTROL_PARALLEL\n         2\n"));
  EXPECT_EQ(built.findings.errors() + built.findings.warnings(), 0) << built.all_findings();
  const std::string table = keyword_use_table(built.model);
  EXPECT_THAT(table, HasSubstr("*SENSOR_DEFINE_FORCE"));
  EXPECT_THAT(table, testing::ContainsRegex("\\*CONTROL_PARALLEL +2 ignored +threads"));
  EXPECT_THAT(table, testing::ContainsRegex("\\*ELEMENT_SHELL +1 used"));
}

TEST(KeywordList, DynamicRelaxation) {
  const auto card = [](int flag) {
    return Built(small_deck("*CONTROL_DYNAMIC_RELAXATION\n100,0.01,0.98,0.0,0.0,0,0.0," + std::to_string(flag) + "\n"));
  };
  const Built asked = card(1);
  EXPECT_EQ(asked.findings.errors(), 0) << asked.all_findings();
  EXPECT_TRUE(asked.model.control.relaxation.on());
  EXPECT_EQ(asked.model.control.relaxation.factor, 0.98);
  EXPECT_FALSE(card(0).model.control.relaxation.on());
  EXPECT_TRUE(card(5).error("not built", "idrflg"));
  const std::string curve = "*DEFINE_CURVE\n90,2\n0.0,1.0\n1.0,1.0\n";
  EXPECT_TRUE(Built(small_deck(curve)).model.control.relaxation.on()) << "SIDR asks for it";
  EXPECT_FALSE(Built(small_deck(curve + "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,-999\n")).model.control.relaxation.on());
}

TEST(KeywordList, MisspeltNamesAreGuessed) {
  EXPECT_EQ(similar_keyword("CONTACT_SPOTWELDS_ID"), "CONTACT_SPOTWELD_ID");
  EXPECT_EQ(similar_keyword("initial_velocty"), "INITIAL_VELOCITY");
  EXPECT_EQ(similar_keyword("MAT_101"), "") << "numbers are not guessed at";
  EXPECT_EQ(similar_keyword("AIRBAG_SIMPLE"), "");
  EXPECT_TRUE(Built(small_deck("*INITIAL_VELOCTY\n         0\n       1.0\n")).error("is it *INITIAL_VELOCITY?"));
  EXPECT_TRUE(Built(small_deck("*INITAL_VELOCITY\n         0\n       1.0\n")).error("is it *INITIAL_VELOCITY?"));
  EXPECT_TRUE(Built(small_deck("*MAT_ELASTC_TITLE\nsteel\n         9\n")).error("is it *MAT_ELASTIC_TITLE?"));
}

/// Sabotage: options are not compared, and not said.
TEST(KeywordList, MisspeltOptionsAreGuessed) {
  EXPECT_EQ(similar_keyword("CONTACT_SPOTWELD_WITH_TORSON"), "CONTACT_SPOTWELD_WITH_TORSION");
  EXPECT_EQ(similar_keyword("SET_NODE_LIST_GENERTE"), "SET_NODE_LIST_GENERATE");
  EXPECT_EQ(similar_keyword("CONTACT_TIED_NODES_TO_SURFACE_OFSET_ID"), "CONTACT_TIED_NODES_TO_SURFACE_OFFSET_ID");
  const Built far(small_deck("*BOUNDARY_SPC_SET_BIRTH\n1\n"));
  EXPECT_TRUE(far.error("this form of *BOUNDARY_SPC_SET is not supported")) << far.all_findings();
  EXPECT_TRUE(far.error("its options are _ID, _BIRTH_DEATH; remove it")) << far.all_findings();
  EXPECT_FALSE(Built(small_deck("*MAT_ELASTIC_PLASTIC_HYDRO\n9\n")).error("its options are"));
}

TEST(KeywordList, DescribesCardsFieldByField) {
  const std::string text = describe_keyword("*boundary_prescribed_motion_set_id");
  EXPECT_THAT(text, HasSubstr("*BOUNDARY_PRESCRIBED_MOTION_SET: used"));
  EXPECT_THAT(text, HasSubstr("options: _ID"));
  EXPECT_THAT(text, testing::ContainsRegex("31-40  lcid +id +required"));
  EXPECT_THAT(text, testing::ContainsRegex("71-80  birth +real +0 +>= 0 +T "));
  EXPECT_THAT(describe_keyword("CONTACT_ENTITY"), HasSubstr("refused"));
  EXPECT_THAT(describe_keyword("boundary_spc"), HasSubstr("*BOUNDARY_SPC_SET\n"));
  EXPECT_THAT(describe_keyword("NONSENSE"), HasSubstr("not a keyword"));
  const std::string all = describe_keywords();
  for (const Keyword& keyword : keywords()) EXPECT_THAT(all, HasSubstr('*' + std::string(keyword.name)));
}

}  // namespace
}  // namespace nugget::reading
