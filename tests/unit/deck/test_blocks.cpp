// SPDX-License-Identifier: Apache-2.0
#include "reading.hpp"

// How a text is cut into keywords and lines.
namespace nugget::deck {
namespace {

TEST(Blocks, KeywordsInReadingOrderUpperCaseAndClean) {
  const Reading r(
      "$ a comment\n*KEYWORD MEMORY=100m NCPU=4\n*Mat_SpotWeld_Damage-Failure_Title and more text\nweld\n*node\n"
      "*ELEMENT_SOLID (ten nodes format)\n*PART   \n*CONSTRAINED_TIE-BREAK\n*END\n*MAT_ELASTIC\n");
  EXPECT_CLEAN(r.findings);
  std::vector<std::string> keywords;
  for (const Block& b : r.deck.blocks) keywords.push_back(b.keyword);
  EXPECT_THAT(keywords, testing::ElementsAre("MAT_SPOTWELD_DAMAGE-FAILURE_TITLE", "NODE", "ELEMENT_SOLID", "PART",
                                             "CONSTRAINED_TIE-BREAK"));
  EXPECT_EQ(r.deck.blocks[0].place.line, 3);
  ASSERT_EQ(r.deck.consumed.size(), 2u);
  EXPECT_EQ(r.deck.consumed[0].first, "KEYWORD");
  EXPECT_EQ(r.deck.consumed[1].first, "END");
}

TEST(Blocks, CommentsGoBlankLinesStay) {
  Reading r("*KEYWORD\n*MAT_SPOTWELD\n         1\n$ between the cards\n\n$\n       7.0\n");
  const Block& b = r.block("MAT_SPOTWELD");
  ASSERT_EQ(b.lines.size(), 3u);
  EXPECT_EQ(b.lines[1].text, "");
  EXPECT_EQ(b.lines[1].number, 5);
  EXPECT_EQ(b.lines[2].number, 7);
  EXPECT_EQ(r.cursor("MAT_SPOTWELD").left(), 3u);
}

TEST(Blocks, BlankLinesAtTheEndAreNotData) {
  Reading r("*KEYWORD\n*PART\nname\n         1\n\n   \n*END\n");
  Cursor c = r.cursor("PART");
  EXPECT_EQ(c.left(), 2u);
  c.skip();
  EXPECT_TRUE(c.more());
  c.skip();
  EXPECT_FALSE(c.more());
}

TEST(Blocks, CarriageReturnsAndAFileWithoutEnd) {
  Reading r("*KEYWORD\r\n*TITLE\r\nmy model\r\n*NODE\r\n       1             1.0             2.0             3.0\r\n");
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(r.cursor("TITLE").read_text(), "my model");
  NodeTable nodes;
  read_nodes(r.deck, r.block("NODE"), nodes, r.findings);
  EXPECT_CLEAN(r.findings);
  ASSERT_EQ(nodes.id.size(), 1u);
  EXPECT_EQ(nodes.x[0].z, 3.0);
}

TEST(Blocks, ByteOrderMarkIsNoText) {
  const Reading r("\xEF\xBB\xBF*KEYWORD\n*PART\n");
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(r.deck.blocks.size(), 1u);
}

TEST(Blocks, TabsAreBlanksWithOneWarningAFile) {
  Reading r("*KEYWORD\n$\tcomment\n*TITLE\na\tb\n*PART\n\tx\n");
  EXPECT_ONE_FINDING(
      r.findings,
      "(text):4:2: warning: the file has tabs; each is read as one blank [replace tabs by blanks, or separate "
      "fields by commas]");
  EXPECT_EQ(r.cursor("TITLE").read_text(), "a b");
}

TEST(Blocks, Latin1IsReadAsText) {
  Reading r("*KEYWORD\n$ gr\xFC\xDF\n*TITLE\nT\xFCr \xC3\xBC\n");
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(r.cursor("TITLE").read_text(), "T\xC3\xBCr \xC3\xBC");
}

TEST(Blocks, FormatsOfKeywordsAndSuffixes) {
  const Reading r("*KEYWORD LONG = Y\n*PART\n*SECTION_SHELL -\n*MAT_ELASTIC%\n*SET_NODE_LIST %\n*MAT_RIGID-\n");
  EXPECT_CLEAN(r.findings);
  const Format expected[] = {Format::long_format, Format::standard, Format::i10, Format::i10, Format::standard};
  ASSERT_EQ(r.deck.blocks.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(r.deck.blocks[i].format, expected[i]) << i;
  EXPECT_EQ(r.deck.blocks[2].keyword, "MAT_ELASTIC");
  EXPECT_EQ(Reading("*KEYWORD i10=y\n*PART +\n*PART + text\n").deck.blocks[0].format, Format::long_format);
  EXPECT_EQ(Reading("*KEYWORD i10=y\n*PART +\n*PART + text\n").deck.blocks[1].format, Format::i10);
  EXPECT_EQ(Reading("*KEYWORD LONG=S\n*PART\n").deck.blocks[0].format, Format::standard);
}

TEST(Blocks, TextThatBelongsToNoKeyword) {
  EXPECT_ONE_FINDING(
      Reading("\nhello\n*KEYWORD\n").findings,
      "(text):2:1: warning: text before the first keyword is not read [start it with $ if it is a comment]");
  EXPECT_ONE_FINDING(
      Reading("*KEYWORD\n*\n").findings,
      "(text):2:1: error: a star without the name of a keyword [start the line with $ if it is a comment]");
  EXPECT_EQ(Reading("").findings.errors(), 1);
  EXPECT_EQ(Reading("$ only a comment\n").findings.errors(), 1);
  EXPECT_CLEAN(Reading("*KEYWORD_ID 650000000\njob name\n").findings);
  EXPECT_EQ(Reading("*KEYWORD\nstray\n").findings.warnings(), 1);
}

TEST(Blocks, ABinaryFileIsRefused) {
  const Reading r(std::string("\x1f\x8b\x08\0\0", 5));
  EXPECT_ONE_FINDING(
      r.findings,
      "(text): error: this is not a text file [give the keyword deck as plain text (unpacked, not encrypted)]");
}

TEST(Blocks, AMissingMasterFileIsAFinding) {
  Findings findings;
  const Deck deck = read("no/such/deck.k", findings);
  EXPECT_ONE_FINDING(
      findings, "no/such/deck.k: error: cannot read the deck: No such file or directory [check the name of the file]");
  EXPECT_TRUE(deck.blocks.empty());
}

TEST(Blocks, ADeckMayBeMoved) {
  Reading r("*KEYWORD\n*PARAMETER\nRa,2.5\n*TITLE\nx&a\n");
  const Deck moved = std::move(r.deck);
  Findings findings;
  EXPECT_EQ(Cursor(moved, moved.blocks[0], findings).read_text(), "x2.5");
}

}  // namespace
}  // namespace nugget::deck
