// SPDX-License-Identifier: Apache-2.0
#include "base/formula.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace nugget {
namespace {

using testing::HasSubstr;

double value(const std::string& text, std::initializer_list<double> arguments) {
  Formula::Fault fault;
  const Formula formula = Formula::read(text, fault);
  EXPECT_EQ(fault.text, "") << text << " at " << fault.at;
  if (fault.any()) return std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(formula.arguments(), static_cast<int>(arguments.size()));
  return formula(std::vector<double>(arguments));
}

std::string fault_of(const std::string& text) {
  Formula::Fault fault;
  Formula::read(text, fault);
  return fault.text;
}

TEST(Formula, OfOneLine) {
  EXPECT_EQ(value("f(x,y)=2.0*x+y", {3, 4}), 10.0);
  EXPECT_EQ(value("  g ( x ) = - x * -x ; ", {3}), 9.0);
  EXPECT_EQ(value("f()=1.5e1", {}), 15.0);
  EXPECT_EQ(value("f(x)=8.0-4.0-2.0*x/4.0", {3}), 2.5);
  EXPECT_EQ(value("f(x)=2.0*(x+1.0)*.5f", {3}), 4.0);
  EXPECT_DOUBLE_EQ(value("f(x,y)=pow(x,2)+atan2(y,x)+fmod(7.0,4.0)", {1, 1}), 1.0 + std::atan2(1.0, 1.0) + 3.0);
  EXPECT_DOUBLE_EQ(value("f(x)=sqrt(exp(log(x)))+max(x,min(9,x))+abs(-x)+floor(1.9)+ceil(.1)", {4}), 2 + 4 + 4 + 1 + 1);
}

// Comparisons and logic give 1 or 0; what need not be worked out is not.
TEST(Formula, Logic) {
  EXPECT_EQ(value("f(x)=x>1.0", {2}), 1.0);
  EXPECT_EQ(value("f(x)=x>=2.0 && x<=2.0 && !(x<2.0) && x==2 && x!=3", {2}), 1.0);
  EXPECT_EQ(value("f(x,y)=x>1.0||y>1.0", {0, 2}), 1.0);
  EXPECT_EQ(value("f(x,y)=x>1.0||y>1.0", {0, 0}), 0.0);
  EXPECT_EQ(value("f(x,y)=x>1.0&&y>1.0", {2, 0}), 0.0);
  EXPECT_EQ(value("f(x)=x>0.0?10.0:x<0.0?-10.0:5.0", {-1}), -10.0);
  EXPECT_EQ(value("f(x)=x>0.0?10.0:x<0.0?-10.0:5.0", {0}), 5.0);
  EXPECT_EQ(value("f(x)=2.0+(x>0.0||x<-5.0)*3.0+(x>0.0&&x<5.0)*4.0", {1}), 9.0);
}

TEST(Formula, InTheMannerOfC) {
  const std::string text =
      "float limit(float force, double rate, int n) {\n"
      "  float s = force / 2.0, t; // halved\n"
      "  int k = 2.9;\n"
      "  /* the rest */\n"
      "  t = s;\n"
      "  if (rate > 1.0 && n == 3) { t += k; } else if (n > 3) t *= 10.0; else { t -= 1.0; }\n"
      "  if (t < 0.0) return 0.0;\n"
      "  return t;\n"
      "}\n";
  EXPECT_EQ(value(text, {10, 2, 3}), 7.0);
  EXPECT_EQ(value(text, {10, 0, 4}), 50.0);
  EXPECT_EQ(value(text, {10, 0, 1}), 4.0);
  EXPECT_EQ(value(text, {1, 0, 1}), 0.0);
  EXPECT_EQ(value("float f(float a) { if (a > 0.0) return 1.0; else return 2.0; }", {-1}), 2.0);
  EXPECT_EQ(value("float f(float a) { a /= 4.0; return a; }", {2}), 0.5);
}

TEST(Formula, FaultsSayWhatAndWhere) {
  EXPECT_THAT(fault_of("f(x)=y"), HasSubstr("'y' is no argument and no variable"));
  EXPECT_THAT(fault_of("f(x)=x+"), HasSubstr("ends too early"));
  EXPECT_THAT(fault_of("f(x)=x)"), HasSubstr("the end of the function"));
  EXPECT_THAT(fault_of("f(x)=sine(x)"), HasSubstr("'sine' is no function"));
  EXPECT_THAT(fault_of("f(x)=pow(x)"), HasSubstr("does not take 1 numbers"));
  EXPECT_THAT(fault_of("f(x)=x**2"), HasSubstr("pow(a, b)"));
  EXPECT_THAT(fault_of("f(x)=1/2*x"), HasSubstr("whole numbers are divided"));
  EXPECT_THAT(fault_of("f(int n)=1/n"), HasSubstr("whole numbers are divided"));
  EXPECT_THAT(fault_of("f(x,x)=x"), HasSubstr("'x' is there already"));
  EXPECT_THAT(fault_of("float f(float x) { float y = x; }"), HasSubstr("not every way"));
  EXPECT_THAT(fault_of("float f(float x) { if (x > 0.0) return x; }"), HasSubstr("not every way"));
  EXPECT_THAT(fault_of("float f(float x) { z = x; return x; }"), HasSubstr("'z' is no variable"));
  EXPECT_THAT(fault_of("float f(float x) { for (;;) x = 1.0; }"), HasSubstr("'for' is no variable"));
  EXPECT_THAT(fault_of(""), HasSubstr("the name of the function"));
  EXPECT_THAT(fault_of("f(x)=" + std::string(500, '(') + "x"), HasSubstr("nested too deeply"));
  std::string wide = "f(x)=x";
  for (int i = 0; i < 200; ++i) wide = "f(x)=x*(x+" + wide.substr(5) + ")";
  EXPECT_NE(fault_of(wide), "");
  Formula::Fault fault;
  Formula::read("f(x)=x+yy", fault);
  EXPECT_EQ(fault.at, 7u);
}

}  // namespace
}  // namespace nugget
