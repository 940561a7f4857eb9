// SPDX-License-Identifier: Apache-2.0
#include "reading.hpp"

// *CASE: several analyses in one deck.
namespace nugget::deck {
namespace {

using testing::ElementsAre;

/// Titles tell which blocks are read. Lower case, nested and overlapping subcases, a case without one.
constexpr const char* text =
    "*KEYWORD\n*TITLE\nall\n"
    "*CASE\n         1     front\nmemory=20m\n        11        12\n"
    "*CASE\n         2\n\n        13\n"
    "*case\n3,bare\n"
    "*case_begin_11\n*TITLE\nof 11\n*CASE_BEGIN_12\n*TITLE\nof 11 and 12\n*CASE_END_11\n*TITLE\nof 12\n*CASE_END_12\n"
    "*CASE_BEGIN_13\n*TITLE\nof 13\n*CASE_BEGIN_12\n*TITLE\nof 12 and 13\n*CASE_END_12\n*CASE_END_13\n"
    "*TITLE\nall again\n*END\n";

std::vector<std::string> titles(int load_case, Findings& findings) {
  const Deck deck = read_text(text, findings, ".", load_case);
  std::vector<std::string> out;
  for (const Block& b : deck.blocks) out.push_back(Cursor(deck, b, findings).read_text());
  return out;
}

TEST(Cases, EachTakesWhatIsOutsideAndItsSubcases) {
  Findings one, two, three;
  EXPECT_THAT(titles(1, one), ElementsAre("all", "of 11", "of 11 and 12", "of 12", "of 12 and 13", "all again"));
  EXPECT_ONE_FINDING(one,
                     "(text):4:1: warning: *CASE: 'memory=20m' of its command line is not obeyed [give options to "
                     "nugget run]");
  EXPECT_THAT(titles(2, two), ElementsAre("all", "of 13", "of 12 and 13", "all again"));
  EXPECT_CLEAN(two);
  EXPECT_THAT(titles(3, three), ElementsAre("all", "all again"));
  EXPECT_CLEAN(three);
}

TEST(Cases, OneMustBeTaken) {
  Findings none, unknown, without;
  titles(0, none);
  EXPECT_ONE_FINDING(none,
                     "(text):4:1: error: *CASE: the deck has the cases 1 (front), 2, 3 (bare) [take one with --case N; "
                     "nugget run and nugget check without it take one after the other]");
  titles(4, unknown);
  EXPECT_ONE_FINDING(unknown, "(text):4:1: error: --case: there is no case 4 [the deck has 1 (front), 2, 3 (bare)]");
  read_text("*KEYWORD\n*TITLE\na\n*END\n", without, ".", 1);
  EXPECT_ONE_FINDING(without, "(text): error: --case: the deck has no *CASE [leave the option out]");
}

TEST(Cases, SubcasesWithoutCasesAreCases) {
  Findings findings;
  const std::string subcases =
      "*KEYWORD\n*CASE_BEGIN_7\n*TITLE\nseven\n*CASE_END_7\n*CASE_BEGIN_9\n*TITLE\nnine\n*CASE_END_9\n*CASE_BEGIN_7\n"
      "*CASE_END_7\n*END\n";
  const Deck deck = read_text(subcases, findings, ".", 9);
  EXPECT_CLEAN(findings);
  ASSERT_EQ(deck.cases.size(), 2u);
  EXPECT_EQ(deck.cases[0].id, 7);
  EXPECT_EQ(deck.cases[1].id, 9);
  ASSERT_EQ(deck.blocks.size(), 1u);
  EXPECT_EQ(deck.blocks[0].place.line, 7);
}

TEST(Cases, ParametersAndIncludesActInTheirCaseOnly) {
  const Folder folder;
  folder.write("more.k", "*TITLE\n&who\n");
  const std::string with =
      "*KEYWORD\n*CASE_BEGIN_1\n*PARAMETER\nIwho              1\n*CASE_END_1\n*CASE_BEGIN_2\n*PARAMETER\n"
      "Iwho              2\n*INCLUDE\nmore.k\n*CASE_END_2\n*END\n";
  Findings one, two;
  EXPECT_EQ(read_text(with, one, folder.path, 1).blocks.size(), 0u);
  const Deck deck = read_text(with, two, folder.path, 2);
  EXPECT_CLEAN(one);
  EXPECT_CLEAN(two);
  ASSERT_EQ(deck.blocks.size(), 1u);
  EXPECT_EQ(Cursor(deck, deck.blocks[0], two).read_text(), "2");
}

TEST(Cases, FaultsAreNamed) {
  Findings f;
  const Folder folder;
  folder.write("inside.k", "*CASE_BEGIN_2\n*CASE_END_2\n");
  read_text(
      "*KEYWORD\n*CASE\n         1\n         8\n*CASE\n         "
      "1\n*CASE\nfirst\n*CASE_END_3\n*CASE_BEGIN_4\n*CASE_OF_4\n"
      "*CASE_END_4\n*INCLUDE\ninside.k\n*CASE_BEGIN_5\n",
      f, folder.path, 1);
  std::string all;
  for (const Finding& finding : f.all()) all += std::to_string(finding.place.line) + ' ' + finding.text + '\n';
  EXPECT_EQ(
      all,
      "2 there is no *CASE_BEGIN_8\n5 there is a case 1 before\n7 CASEID must be a whole number above 0\n"
      "9 nothing begins that could end here\n11 this form of *CASE is not known\n"
      "1 cases stand in the master file only, as in LS-DYNA\n2 cases stand in the master file only, as in LS-DYNA\n"
      "15 its end is missing\n");
}

}  // namespace
}  // namespace nugget::deck
