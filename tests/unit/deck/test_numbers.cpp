// SPDX-License-Identifier: Apache-2.0
#include "deck/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace nugget::deck {
namespace {

double real_of(std::string_view text) {
  double v = -999.0;
  EXPECT_TRUE(parse_real(text, v)) << text;
  return v;
}

TEST(Numbers, AllSpellingsOfAReal) {
  EXPECT_EQ(real_of("1"), 1.0);
  EXPECT_EQ(real_of("1."), 1.0);
  EXPECT_EQ(real_of(".5"), 0.5);
  EXPECT_EQ(real_of("-.5"), -0.5);
  EXPECT_EQ(real_of("+1"), 1.0);
  EXPECT_EQ(real_of("1.d-3"), 1e-3);
  EXPECT_EQ(real_of("1D3"), 1e3);
  EXPECT_EQ(real_of("1-3"), 1e-3);
  EXPECT_EQ(real_of("-1.5+2"), -150.0);
  EXPECT_EQ(real_of("+2.-05"), 2e-5);
  EXPECT_EQ(real_of("1.00000E20"), 1e20);
  EXPECT_EQ(real_of("2.100000e+05"), 2.1e5);
  EXPECT_EQ(real_of("0.1"), 0.1);
}

TEST(Numbers, ACellIsConsumedWhole) {
  double v;
  for (const char* text :
       {"1e",   "12a", "1 2", "",     "+",    "-",     ".",   "e5", "1e+", "1--3", "+-1", "1e3-2",
        "1e3e", "inf", "nan", "-inf", "0x10", "1e999", "1,5", "1+", "1d",  "--1",  "++1", "infinity"}) {
    EXPECT_FALSE(parse_real(text, v)) << text;
  }
  EXPECT_FALSE(parse_real(std::string(100, ' ') + "+1", v));
}

TEST(Numbers, AnIntegerMayBeWrittenAsAReal) {
  int v = 0;
  EXPECT_EQ(parse_integer("17", v), WholeNumber::good);
  EXPECT_EQ(v, 17);
  EXPECT_EQ(parse_integer("-1.0", v), WholeNumber::good);
  EXPECT_EQ(v, -1);
  EXPECT_EQ(parse_integer("2147483647", v), WholeNumber::good);
  EXPECT_EQ(v, 2147483647);
  EXPECT_EQ(parse_integer("1.5", v), WholeNumber::not_whole);
  EXPECT_EQ(parse_integer("2147483648", v), WholeNumber::too_large);
  EXPECT_EQ(parse_integer("x", v), WholeNumber::not_a_number);
}

TEST(Numbers, EightColumnsAtOnce) {
  int v = -1;
  EXPECT_TRUE(parse_plain_integer8("       7", v));
  EXPECT_EQ(v, 7);
  EXPECT_TRUE(parse_plain_integer8("50000001", v));
  EXPECT_EQ(v, 50000001);
  EXPECT_TRUE(parse_plain_integer8("        ", v));
  EXPECT_EQ(v, 0);
  for (const char* text : {"7       ", "   1 2  ", "      -7", "     1.0", "   &node", "1234567,", "   12/34",
                           "   12:34", "     \x80\x81\x82", "      \t7", "@@@@@@@@", "       \xB1", "  PP  11"}) {
    EXPECT_FALSE(parse_plain_integer8(text, v)) << text;
  }
}

TEST(Numbers, EightColumnsAtOnceAgreeWithTheCarefulWay) {
  std::mt19937 random(7);
  const std::string alphabet = "0123456789  -.";
  int plain = 0;
  for (int i = 0; i < 300000; ++i) {
    std::string text(8, ' ');
    const std::size_t start = random() % 9;
    for (std::size_t k = start; k < 8; ++k) text[k] = alphabet[random() % (i % 2 ? 10 : alphabet.size())];
    int fast = 0, slow = 0;
    if (!parse_plain_integer8(text.data(), fast)) continue;
    ++plain;
    ASSERT_TRUE(parse_plain_integer(text.data(), 8, slow)) << text;
    ASSERT_EQ(fast, slow) << text;
  }
  EXPECT_GT(plain, 100000);
}

TEST(Numbers, SixteenColumnsAtOnceGiveTheSameBitsAsStrtod) {
  std::mt19937_64 random(11);
  int plain = 0;
  for (int i = 0; i < 300000; ++i) {
    const auto places = 1 + random() % 16;
    std::string text(random() % 2 ? "-" : "");
    const auto point = random() % (places + 2);
    for (std::size_t k = 0; k < places; ++k) {
      if (k == point) text += '.';
      text += static_cast<char>('0' + random() % 10);
    }
    if (text.size() > 16) text.resize(16);
    if (i % 3 == 0) text[random() % text.size()] = "e-. x"[random() % 5];
    text.insert(0, 16 - text.size(), ' ');
    double fast = 0.0;
    if (!parse_fixed_point16(text.data(), fast)) continue;
    ++plain;
    char* end = nullptr;
    const double expected = std::strtod(text.c_str(), &end);
    ASSERT_EQ(end, text.c_str() + 16) << '[' << text << ']';
    ASSERT_EQ(fast, expected) << '[' << text << ']';
    ASSERT_EQ(std::signbit(fast), std::signbit(expected)) << '[' << text << ']';
  }
  EXPECT_GT(plain, 150000);
}

TEST(Numbers, SixteenColumnsAtOnceLeaveTheRestToOthers) {
  double v;
  for (const char* text : {"                ", "               .", "               -", "         1.0e+05",
                           "1.0             ", "         1.0 1.0", "        1.0.0   ", "             1-3",
                           "            &abc", "       1.0,2.0,3", "9999999999999999"}) {
    EXPECT_FALSE(parse_fixed_point16(text, v)) << text;
  }
}

}  // namespace
}  // namespace nugget::deck
