// SPDX-License-Identifier: Apache-2.0
#include "reading.hpp"

#include "deck/expression.hpp"

namespace nugget::deck {
namespace {

const Card pair{
    {real("a", dimension::number, 0.0, any_value, "a"), integer("b", 0, any_value, "b"), text("c", 10, "c")}};

double value(const std::string& parameters, const std::string& cell) {
  Reading r("*KEYWORD\n" + parameters + "*X\n" + cell + "\n");
  const double v = r.row("X", pair).entry("a").value;
  EXPECT_CLEAN(r.findings);
  return v;
}

TEST(Parameters, FixedColumns) {
  const std::string p =
      "*PARAMETER\n$ prmr1\nr  tbumper         3   rtrailb         2   rtrailf         3   ryrailb       400\n"
      "R     tEnd       5.0I        n         7\n";
  EXPECT_EQ(value(p, "  &tbumper"), 3.0);
  EXPECT_EQ(value(p, "&yrailb"), 400.0);
  EXPECT_EQ(value(p, "     &TEND"), 5.0);
  EXPECT_EQ(value(p, "        &n"), 7.0);
}

TEST(Parameters, Commas) {
  const std::string p =
      "*PARAMETER\nrtbumper,2.9785,rtrailb,2.18735,rtrailf,3.38227,ryrailf,317.975\nI n , 3 , R b,1-3,Rlast,9,R5,5\n";
  EXPECT_EQ(value(p, "&trailb"), 2.18735);
  EXPECT_EQ(value(p, "&yrailf,1"), 317.975);
  EXPECT_EQ(value(p, "&b"), 1e-3);
  EXPECT_EQ(value(p, "&5"), 5.0);
}

TEST(Parameters, SignsNeighboursAndFullPrecision) {
  const std::string p = "*PARAMETER\nRx,1.23456789012345678\nIn,4\n";
  EXPECT_EQ(value(p, "-&x"), -1.2345678901234568);
  EXPECT_EQ(value(p, "  - &x"), -1.2345678901234568);
  Reading r("*KEYWORD\n" + p + "*X\n&x        &n        \n");
  const Row row = r.row("X", pair);
  EXPECT_EQ(row.entry("a").value, 1.2345678901234568);
  EXPECT_EQ(row.entry("b").integer(), 4);
  EXPECT_CLEAN(r.findings);
}

TEST(Parameters, InTextsAndTitles) {
  Reading r(
      "*KEYWORD\n*PARAMETER\nCname,hat,Rt,1.5,In,3\n*X\nR&D of the &name, &t mm, &n layers\n                    "
      "&name\n");
  Cursor c = r.cursor("X");
  EXPECT_EQ(c.read_text(), "R&D of the hat, 1.5 mm, 3 layers");
  EXPECT_EQ(c.read(pair).entry("c").text, "hat");
  EXPECT_CLEAN(r.findings);
}

TEST(Parameters, MustBeDefinedBefore) {
  Reading r("*KEYWORD\n*X\n&late\n*PARAMETER\nRlate,1.0\n*Y\n&late\n");
  r.row("X", pair);
  EXPECT_ONE_FINDING(
      r.findings,
      "(text):3:1: error: *X a = &late: the parameter 'late' is not defined before this line [define it with "
      "*PARAMETER above this keyword, or correct the name]");
  EXPECT_EQ(r.row("Y", pair).entry("a").value, 1.0);
}

TEST(Parameters, ARedefinitionDoesNotLeakBack) {
  Reading r("*KEYWORD\n*PARAMETER_MUTABLE\nRa,1.0\n*X\n&a\n*PARAMETER\nRa,2.0\n*Y\n&a\n");
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(r.row("Y", pair).entry("a").value, 2.0);
  EXPECT_EQ(r.row("X", pair).entry("a").value, 1.0);
}

TEST(Parameters, TwiceIsAnErrorUnlessTheDeckSaysOtherwise) {
  const std::string twice = "*PARAMETER\nRa,1.0\n*PARAMETER\nRa,2.0\n*X\n&a\n";
  EXPECT_ONE_FINDING(
      Reading("*KEYWORD\n" + twice).findings,
      "(text):5:1: error: *PARAMETER: the parameter 'a' is defined a second time; first at (text):3 [rename it, or "
      "use *PARAMETER_MUTABLE, *PARAMETER_LOCAL or *PARAMETER_DUPLICATION]");
  const auto with_flag = [&](int flag) {
    return Reading("*KEYWORD\n*PARAMETER_DUPLICATION\n         " + std::to_string(flag) + "\n" + twice);
  };
  const struct {
    int flag, errors, warnings;
    double value;
  } cases[] = {{1, 0, 1, 1.0}, {2, 0, 1, 2.0}, {3, 1, 0, 1.0}, {4, 0, 0, 2.0}, {5, 0, 0, 1.0}};
  for (const auto& c : cases) {
    Reading r = with_flag(c.flag);
    EXPECT_EQ(r.findings.errors(), c.errors) << c.flag;
    EXPECT_EQ(r.findings.warnings(), c.warnings) << c.flag;
    EXPECT_EQ(r.row("X", pair).entry("a").value, c.value) << c.flag;
  }
}

TEST(Parameters, LocalToAFile) {
  Folder folder;
  folder.write("inner.k",
               "*KEYWORD\n*PARAMETER_LOCAL\nRa,2.0,Rb,3.0\n*PARAMETER\nRglobal,4.0\n*INNER\n&a,&b\n*INCLUDE\ndeep.k\n");
  folder.write("deep.k", "*KEYWORD\n*PARAMETER_LOCAL\nRa,9.0\n*DEEP\n&a,&b\n");
  folder.write("sister.k", "*KEYWORD\n*PARAMETER_LOCAL\nRb,7.0\n*SISTER\n&a,&b\n*INCLUDE\ndeep.k\n");
  const Card reals{
      {real("a", dimension::number, 0.0, any_value, "a"), real("b", dimension::number, 0.0, any_value, "b")}};
  Reading r("*KEYWORD\n*PARAMETER\nRa,1.0\n*INCLUDE\ninner.k\nsister.k\n*OUTER\n&a,&global\n*NONE\n&b\n", folder.path);
  EXPECT_EQ(r.row("INNER", reals).entry("a").value, 2.0);
  EXPECT_EQ(r.row("INNER", reals).entry("b").value, 3.0);
  EXPECT_EQ(r.row("DEEP", reals).entry("a").value, 9.0);
  EXPECT_EQ(r.row("DEEP", reals).entry("b").value, 3.0);
  EXPECT_EQ(r.row("SISTER", reals).entry("a").value, 1.0);
  EXPECT_EQ(r.row("OUTER", reals).entry("a").value, 1.0);
  EXPECT_EQ(r.row("OUTER", reals).entry("b").value, 4.0);
  EXPECT_CLEAN(r.findings);
  r.row("NONE", reals);
  EXPECT_EQ(r.findings.errors(), 1);
}

TEST(Parameters, WhatIsRefused) {
  const auto error = [](const std::string& line) {
    const Reading r("*KEYWORD\n*PARAMETER\n" + line + "\n");
    return r.findings.all().size() == 1 ? to_string(r.findings.all()[0]) : listed(r.findings);
  };
  EXPECT_THAT(error("Xa,1.0"),
              testing::StartsWith("(text):3:1: error: *PARAMETER Xa = 1.0: a parameter starts with its type"));
  EXPECT_THAT(error("R TEND 5.0"),
              testing::StartsWith("(text):3:1: error: *PARAMETER R TEND 5.0 = (blank): the name of a parameter"));
  EXPECT_THAT(error("Ra"), testing::HasSubstr("the value is missing"));
  EXPECT_THAT(error("Ra,1.0e"), testing::StartsWith("(text):3:1: error: *PARAMETER Ra = 1.0e: is not a number"));
  EXPECT_THAT(error("Ra,2*3"), testing::HasSubstr("an expression needs *PARAMETER_EXPRESSION"));
  EXPECT_THAT(error("Ia,1.5"), testing::HasSubstr("expected a whole number"));
  EXPECT_THAT(error("Ra,&b"), testing::HasSubstr("the parameter 'b' is not defined before this line"));
  EXPECT_THAT(listed(Reading("*KEYWORD\n*PARAMETER_TYPE\n").findings),
              testing::HasSubstr("the option _TYPE is not supported"));
  Reading expression("*KEYWORD\n*PARAMETER\nRa,1.0\n*X\n2*&a\n");
  expression.row("X", pair);
  EXPECT_THAT(listed(expression.findings), testing::HasSubstr("compute the value with *PARAMETER_EXPRESSION"));
}

TEST(Parameters, ValuesFromEarlierParametersAndLongFormat) {
  EXPECT_EQ(value("*PARAMETER\nRa,1.5\n*PARAMETER\nR        b       -&a\n", "&b"), -1.5);
  EXPECT_EQ(
      value("*PARAMETER+\nR                  a                 2.5I                  b                   4\n", "&a"),
      2.5);
}

double expression(const std::string& text, const std::string& parameters = "") {
  return value("*PARAMETER\nRx,2.0,In,7,Im,2\n" + parameters + "*PARAMETER_EXPRESSION\nR result  " + text + "\n",
               "&result");
}

TEST(Expressions, OperatorsInTheirOrder) {
  EXPECT_EQ(expression("1+2*3"), 7.0);
  EXPECT_EQ(expression("(1+2)*3"), 9.0);
  EXPECT_EQ(expression("2**3**2"), 512.0);
  EXPECT_EQ(expression("-2**2"), -4.0);
  EXPECT_EQ(expression("2**-1."), 0.5);
  EXPECT_EQ(expression("10-4-3"), 3.0);
  EXPECT_EQ(expression("12./4./3."), 1.0);
  EXPECT_EQ(expression("1.5e1-3"), 12.0);
  EXPECT_EQ(expression("1.d0 + .5"), 1.5);
}

TEST(Expressions, ParametersWithAndWithoutAmpersand) {
  EXPECT_EQ(expression("x*&x+N"), 11.0);
  EXPECT_EQ(expression("-&x"), -2.0);
}

TEST(Expressions, AllFunctions) {
  const std::pair<const char*, double> cases[] = {{"abs(-3)", 3},
                                                  {"aint(-2.7)", -2},
                                                  {"anint(2.5)", 3},
                                                  {"nint(-2.5)", -3},
                                                  {"int(2.9)", 2},
                                                  {"float(3)", 3},
                                                  {"atan(1.)", std::atan(1.)},
                                                  {"atan2(1.,-1.)", std::atan2(1., -1.)},
                                                  {"acos(0.5)", std::acos(.5)},
                                                  {"asin(0.5)", std::asin(.5)},
                                                  {"cos(1.)", std::cos(1.)},
                                                  {"sin(1.)", std::sin(1.)},
                                                  {"tan(1.)", std::tan(1.)},
                                                  {"exp(1.)", std::exp(1.)},
                                                  {"log(2.)", std::log(2.)},
                                                  {"log10(1000.)", 3},
                                                  {"max(1,n,x)", 7},
                                                  {"min(4,x,3)", 2},
                                                  {"mod(n,4)", 3},
                                                  {"mod(-7.5,2.)", -1.5},
                                                  {"sign(3,-1)", -3},
                                                  {"sqrt(16.)", 4},
                                                  {"sinh(1.)", std::sinh(1.)},
                                                  {"cosh(1.)", std::cosh(1.)},
                                                  {"tanh(1.)", std::tanh(1.)},
                                                  {"MAX(1,2)", 2}};
  for (const auto& [text, expected] : cases) EXPECT_DOUBLE_EQ(expression(text), expected) << text;
}

TEST(Expressions, IntegersDivideToIntegersWithAWarning) {
  Reading r(
      "*KEYWORD\n*PARAMETER\nIn,7,Rx,7\n*PARAMETER_EXPRESSION\nI half    n/2\nR real    x/2\nI cut     "
      "3.9\n*X\n&half\n&real\n&cut\n");
  Cursor c = r.cursor("X");
  EXPECT_EQ(c.read(pair).entry("a").value, 3.0);
  EXPECT_EQ(c.read(pair).entry("a").value, 3.5);
  EXPECT_EQ(c.read(pair).entry("a").value, 3.0);
  ASSERT_EQ(r.findings.all().size(), 1u) << listed(r.findings);
  EXPECT_THAT(listed(r.findings), testing::HasSubstr("half: integers divide to an integer: 7/2 gives 3"));
}

TEST(Expressions, ContinuationLinesAndCommas) {
  EXPECT_EQ(expression("1 +\n          2 +\n$ comment\n          max(3,4)"), 7.0);
  EXPECT_EQ(value("*PARAMETER_EXPRESSION\nRa,max(1,2)*3\nRb,a+1\n", "&b"), 7.0);
}

TEST(Expressions, WhatIsRefused) {
  const auto fault = [](std::string_view text) { return evaluate_expression(text, Parameters{}, 0).fault; };
  EXPECT_EQ(fault("1+"), "the expression ends too early");
  EXPECT_EQ(fault("(1"), "a closing parenthesis is missing");
  EXPECT_EQ(fault("1 2"), "'2' is not expected here");
  EXPECT_EQ(fault("y"), "the parameter 'y' is not defined before this line");
  EXPECT_EQ(fault("foo(1)"), "the function 'foo' is not known");
  EXPECT_EQ(fault("sqrt(1,2)"), "sqrt takes 1 argument(s), not 2");
  EXPECT_EQ(fault("1/0"), "division by zero");
  EXPECT_EQ(fault("sqrt(-1.)"), "sqrt has no value for these arguments");
  EXPECT_EQ(fault("10.**400"), "the result is not a finite number");
  EXPECT_EQ(fault(std::string(10000, '(')), "the expression is nested too deeply");
  EXPECT_EQ(fault(std::string(10000, '-') + "1"), "the expression is nested too deeply");
  EXPECT_EQ(fault("1e+"), "'1e+' is not a number");
  EXPECT_EQ(fault("a=1"), "the parameter 'a' is not defined before this line");
  EXPECT_EQ(fault(""), "the expression ends too early");
}

}  // namespace
}  // namespace nugget::deck
