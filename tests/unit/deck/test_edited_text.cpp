// SPDX-License-Identifier: Apache-2.0
#include "deck/edited_text.hpp"

#include <stdexcept>

#include "deck/card_text.hpp"
#include "reading.hpp"

namespace nugget::deck {
namespace {

const Card plain_card{{id("mid", IdSpace::material, required, ""), real("ro", dimension::density, required, {}, ""),
                       real("e", dimension::stress, 0.0, {}, ""), text("name", 10, "")}};

TEST(EditedText, PiecesAreReplacedAndTheLastOneCounts) {
  Reading r("*KEYWORD\n*TITLE\nfirst\n*TITLE\nsecond\n");
  EditedText edited(r.deck);
  EXPECT_TRUE(edited.empty());
  const std::string_view first = edited.line(0, 3), second = edited.line(0, 5);
  EXPECT_EQ(first, "first");
  EXPECT_EQ(edited.current(first), nullptr);
  EXPECT_TRUE(edited.replace(first, "other"));
  EXPECT_TRUE(edited.replace(first, "third"));
  EXPECT_EQ(*edited.current(first), "third");
  EXPECT_TRUE(edited.replace(second, ""));
  EXPECT_EQ(edited.files("new.k", "").at(0).text, "*KEYWORD\n*TITLE\nthird\n*TITLE\n\n");
}

TEST(EditedText, WhatLiesInsideGoesAndWhatCrossesIsRefused) {
  Reading r("*KEYWORD\n*TITLE\nfirst second third\n");
  EditedText edited(r.deck);
  const std::string_view line = edited.line(0, 3);
  EXPECT_TRUE(edited.replace(line.substr(6, 6), "2nd"));
  EXPECT_TRUE(edited.replace(line.substr(0, 5), "1st"));
  EXPECT_FALSE(edited.replace(line.substr(3, 5), "x")) << "across both";
  EXPECT_FALSE(edited.replace(line.substr(7, 2), "x")) << "inside the first";
  EXPECT_EQ(edited.files("new.k", "").at(0).text, "*KEYWORD\n*TITLE\n1st 2nd third\n");
  EXPECT_TRUE(edited.replace(line, "all")) << "both are gone";
  EXPECT_EQ(edited.files("new.k", "").at(0).text, "*KEYWORD\n*TITLE\nall\n");
}

TEST(CardText, ACellChangesAndNothingElse) {
  const auto with = [](std::string_view line, std::size_t field, std::string_view text,
                       Format format = Format::standard) { return with_cell(plain_card, format, line, field, text); };
  EXPECT_EQ(with("         1  7.85e-09  210000.0", 2, "70000."), "         1  7.85e-09    70000.");
  EXPECT_EQ(with("         1  7.85e-09  210000.0   steel  and more", 1, "2.7e-9"),
            "         1    2.7e-9  210000.0   steel  and more");
  EXPECT_EQ(with("1", 2, "70000."), "1                       70000.") << "a short line becomes longer";
  EXPECT_EQ(with("1,7.85e-9,210000.0,steel", 1, "2.7e-9"), "1,2.7e-9,210000.0,steel");
  EXPECT_EQ(with("1,7.85e-9", 3, "alu"), "1,7.85e-9,,alu");
  EXPECT_EQ(with("1", 1, "1.0", Format::long_format), "1                                    1.0");
  EXPECT_EQ(with("         1  7.85e-09  210000.0", 3, "alu"), "         1  7.85e-09  210000.0alu       ");
  EXPECT_THROW(with("1", 1, "12345678901"), std::invalid_argument);
  EXPECT_THROW(with("1,2", 1, "1,0"), std::invalid_argument);
}

TEST(CardText, NumbersHaveTheDigitsThatFit) {
  EXPECT_EQ(fitted(9000.0, Kind::real, 10), "9000.0");
  EXPECT_EQ(fitted(1.0 / 3.0, Kind::real, 10), "0.3333333") << "a blank is left";
  EXPECT_EQ(fitted(1.0 / 3.0, Kind::real, 0), "0.3333333333333333");
  EXPECT_EQ(fitted(7.85e-9, Kind::real, 10), "7.85e-9");
  EXPECT_EQ(fitted(1.23456e21, Kind::real, 10), "1.23456e21");
  EXPECT_EQ(fitted(-1.23456e-5, Kind::real, 10), "") << "with less than five digits";
  EXPECT_EQ(fitted(123456789012.0, Kind::real, 8), "");
  EXPECT_EQ(fitted(12.0, Kind::integer, 10), "12");
  EXPECT_EQ(fitted(1.5, Kind::integer, 10), "");
}

}  // namespace
}  // namespace nugget::deck
