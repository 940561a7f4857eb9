// SPDX-License-Identifier: Apache-2.0
#include "reading.hpp"

// Cards read by their tables.
namespace nugget::deck {
namespace {

const Card elastic{{id("mid", IdSpace::material, required, "material id"),
                    real("ro", dimension::density, required, above_zero(), "density"),
                    real("e", dimension::stress, required, above_zero(), "Young's modulus"),
                    real("pr", dimension::number, 0.0, between(0.0, 0.5), "Poisson's ratio"), unused(),
                    integer("nip", 2, between(1, 10), "integration points")}};

Reading material(const std::string& line, const std::string& keyword = "*MAT_ELASTIC") {
  return Reading("*KEYWORD\n" + keyword + "\n" + line + "\n");
}

TEST(Cards, FixedColumnsWithoutBlanksBetween) {
  Reading r = material("         11.00000E-7  200000.0       0.3   junk/x         5");
  const Row row = r.row("MAT_ELASTIC", elastic);
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(row.entry("mid").integer(), 1);
  EXPECT_EQ(row.entry("ro").value, 1e-7);
  EXPECT_EQ(row.entry("e").value, 200000.0);
  EXPECT_EQ(row.entry("pr").value, 0.3);
  EXPECT_EQ(row.entry("nip").integer(), 5);
  EXPECT_EQ(row.entry("e").place.column, 23);
  EXPECT_EQ(row.entry("e").place.line, 3);
}

TEST(Cards, CommasMakeALineFree) {
  Reading r = material("1, 7.8e-9 ,2.1+5,,,4");
  const Row row = r.row("MAT_ELASTIC", elastic);
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(row.entry("ro").value, 7.8e-9);
  EXPECT_EQ(row.entry("e").value, 2.1e5);
  EXPECT_TRUE(row.entry("pr").blank);
  EXPECT_EQ(row.entry("nip").integer(), 4);
  EXPECT_EQ(row.entry("ro").place.column, 4);
  EXPECT_EQ(material("1,1,1").row("MAT_ELASTIC", elastic).entry("nip").integer(), 2);
  Reading trailing = material("1,1,1,,,2,,");
  trailing.row("MAT_ELASTIC", elastic);
  EXPECT_CLEAN(trailing.findings);
}

// ---- fields bound to members

enum class Shape : int { plain, waved };
struct Ply {
  double angle = 0.0;
};
struct Material {
  int id = 0;
  double density = 0.0;
  Shape shape = Shape::plain;
  std::string name = "as it was";
};
struct Laminate : Material {
  double nothing_to_do_with_the_card = 7.0;
  bool symmetric = true;
  std::array<double, 3> share{};
  Ply ply;
};
const CardOf<Laminate> laminate_card{
    {&Laminate::id, nugget::id("mid", IdSpace::material, required, "material id")},
    {&Laminate::density, real("ro", dimension::density, 1e-9, above_zero(), "density")},
    {at(&Laminate::share, 0), real("s1", dimension::number, 0.25, any_value, "first share")},
    {at(&Laminate::share, 2), real("s3", dimension::number, 0.75, any_value, "third share")},
    {&Laminate::shape, integer("shape", 0, between(0, 1), "shape")},
    {&Laminate::symmetric, integer("sym", 0, between(0, 1), "symmetric")},
    {within(&Laminate::ply, &Ply::angle), real("beta", dimension::number, 0, any_value, "angle")},
    integer("nodes", 0, only(0), "checked, and no more"),
};

TEST(BoundCards, ValuesComeIntoTheirMembers) {
  Reading r = material("7, 2e-9, 0.5, , 1, 1, 30");
  const auto row = r.cursor("MAT_ELASTIC").read(laminate_card);
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(row->id, 7);
  EXPECT_EQ(row->density, 2e-9);
  EXPECT_EQ(row->share, (std::array<double, 3>{0.5, 0.0, 0.75}));
  EXPECT_EQ(row->shape, Shape::waved);
  EXPECT_TRUE(row->symmetric);
  EXPECT_EQ(row->ply.angle, 30.0);
  EXPECT_EQ(row->nothing_to_do_with_the_card, 7.0);
  EXPECT_EQ(row->name, "as it was");
}

TEST(BoundCards, AFieldIsFoundByItsMember) {
  Reading r = material("7, 2e-9, 0.5, , 1, 1, 30");
  const auto row = r.cursor("MAT_ELASTIC").read(laminate_card);
  const Entry share = row[at(&Laminate::share, 0)];
  EXPECT_EQ(share.field, "s1");
  EXPECT_EQ(share.value, 0.5);
  EXPECT_EQ(share.place.column, 10);
  EXPECT_FALSE(share.blank);
  EXPECT_TRUE(row[at(&Laminate::share, 2)].blank);
  EXPECT_EQ(row[within(&Laminate::ply, &Ply::angle)].text, "30");
  EXPECT_EQ(row[&Laminate::shape].integer(), 1);
  EXPECT_THROW(row[&Laminate::nothing_to_do_with_the_card], std::logic_error);
  row[&Laminate::id].report(r.findings, Severity::error, "material 7 is not defined", "define it");
  EXPECT_ONE_FINDING(r.findings, "(text):3:1: error: *MAT_ELASTIC mid = 7: material 7 is not defined [define it]");
}

TEST(BoundCards, UncheckedMembersKeepWhatTheyHave) {
  Reading r = material("7");
  Laminate there;
  there.name = "given before";
  there.share = {0.1, 0.2, 0.3};
  r.cursor("MAT_ELASTIC").read(laminate_card, there);
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(there.id, 7);
  EXPECT_EQ(there.density, 1e-9);
  EXPECT_EQ(there.share, (std::array<double, 3>{0.25, 0.2, 0.75}));
  EXPECT_EQ(there.name, "given before");
}

TEST(BoundCards, AMissingCardGivesDefaults) {
  Reading r = Reading("*KEYWORD\n*MAT_ELASTIC\n*NODE\n");
  const auto row = r.cursor("MAT_ELASTIC").read(laminate_card);
  EXPECT_EQ(r.findings.errors(), 1) << listed(r.findings);
  EXPECT_EQ(row->density, 1e-9);
  EXPECT_TRUE(row[&Laminate::density].blank);
}

TEST(BoundCards, TextsComeIntoStrings) {
  const CardOf<Material> card{{&Material::name, text("title", 20, "title")},
                              {&Material::id, nugget::id("id", IdSpace::part, 0, "id")}};
  Reading r = material("Zwei W\xf6rter               12");
  const auto row = r.cursor("MAT_ELASTIC").read(card);
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(row->name, row[&Material::name].text);
  EXPECT_EQ(row->id, 12);
}

TEST(Cards, FixedAndFreeLinesAlternate) {
  Reading r = material("         1       1.0       1.0\n2,1,1\n         3       1.0       1.0");
  Cursor c = r.cursor("MAT_ELASTIC");
  for (int i = 1; i <= 3; ++i) EXPECT_EQ(c.read(elastic).entry("mid").integer(), i);
  EXPECT_CLEAN(r.findings);
}

TEST(Cards, LongFormatHasTwentyColumns) {
  const std::string columns_1_to_80 =
      "                   1             1.00E-7             2.0E+05                 0.3";
  Reading r = material(columns_1_to_80 + "              unused                   3", "*MAT_ELASTIC +");
  const Row row = r.row("MAT_ELASTIC", elastic);
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(row.entry("mid").integer(), 1);
  EXPECT_EQ(row.entry("ro").value, 1e-7);
  EXPECT_EQ(row.entry("e").value, 2e5);
  EXPECT_EQ(row.entry("pr").value, 0.3);
  EXPECT_EQ(row.entry("nip").integer(), 3);
}

TEST(Cards, I10WidensNarrowFieldsOnly) {
  const Card mass{{wide(id("eid", IdSpace::element, required, "element"), 8),
                   wide(id("nid", IdSpace::node, required, "node"), 8),
                   wide(real("mass", dimension::mass, 0.0, at_least(0.0), "mass"), 16)}};
  Reading i10("*KEYWORD I10=Y\n*ELEMENT_MASS\n         1         2             0.5\n");
  EXPECT_EQ(i10.row("ELEMENT_MASS", mass).entry("mass").value, 0.5);
  Reading standard("*KEYWORD\n*ELEMENT_MASS\n       1       2             0.5\n");
  EXPECT_EQ(standard.row("ELEMENT_MASS", mass).entry("mass").value, 0.5);
  Reading longer("*KEYWORD LONG=Y\n*ELEMENT_MASS\n                   1                   2                 0.5\n");
  EXPECT_EQ(longer.row("ELEMENT_MASS", mass).entry("mass").value, 0.5);
  EXPECT_CLEAN(i10.findings);
  EXPECT_CLEAN(standard.findings);
  EXPECT_CLEAN(longer.findings);
}

TEST(Cards, BlankAndZeroTakeTheDefault) {
  Reading r = material("         1       1.0       1.0       0.0                   0");
  const Row row = r.row("MAT_ELASTIC", elastic);
  EXPECT_EQ(row.entry("nip").integer(), 2);
  EXPECT_FALSE(row.entry("nip").blank);
  EXPECT_FALSE(row.entry("pr").blank);
  Field counted = integer("n", 7, at_least(0), "n");
  counted.zero_is_default = false;
  const Card card{{counted, integer("m", 9, at_least(0), "m")}};
  Reading zeros("*KEYWORD\n*X\n         0         0\n");
  EXPECT_EQ(zeros.row("X", card).entry("n").integer(), 0);
  EXPECT_EQ(zeros.row("X", card).entry("m").integer(), 9);
}

TEST(Cards, AnIntegerMayBeWrittenAsAReal) {
  Reading r = material("       1.0       1.0       1.0                          3.");
  const Row row = r.row("MAT_ELASTIC", elastic);
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(row.entry("mid").integer(), 1);
  EXPECT_EQ(row.entry("nip").integer(), 3);
}

struct Refused {
  const char* name;
  const char* line;
  const char* printed;
};
void PrintTo(const Refused& r, std::ostream* os) {
  *os << r.name;
}
class RefusedCell : public testing::TestWithParam<Refused> {};

TEST_P(RefusedCell, NamesPlaceFieldExpectationAndRemedy) {
  Reading r = material(GetParam().line);
  const Row row = r.row("MAT_ELASTIC", elastic);
  EXPECT_ONE_FINDING(r.findings, GetParam().printed);
  // What stands for it is not the deck's: nothing more is said about that field.
  for (const char* field : {"mid", "ro", "e", "pr", "nip"})
    row.entry(field).report(r.findings, Severity::error, "must not be 0");
  EXPECT_EQ(r.findings.errors(), 5);
}

INSTANTIATE_TEST_SUITE_P(
    Cards, RefusedCell,
    testing::Values(
        Refused{"NumberCutByItsColumn", "         1       1.0   2.1000e",
                "(text):3:24: error: *MAT_ELASTIC e = 2.1000e: is not a number (Young's modulus) "
                "[keep the number whole inside its columns, or separate the fields by commas]"},
        Refused{"DigitsAndLetters", "       12a       1.0       1.0",
                "(text):3:8: error: *MAT_ELASTIC mid = 12a: an alphanumeric id is not supported, expected "
                "a whole number (material id) [give it a number for an id]"},
        Refused{"OutOfRange", "         1       1.0       1.0       0.7",
                "(text):3:38: error: *MAT_ELASTIC pr = 0.7: expected 0 to 0.5 (Poisson's ratio)"},
        Refused{"NotPositive", "         1      -1.0       1.0",
                "(text):3:17: error: *MAT_ELASTIC ro = -1.0: expected more than 0 (density)"},
        Refused{"RequiredBlank", "         1                 1.0",
                "(text):3:11: error: *MAT_ELASTIC ro = (blank): must be given (density) [write its value there]"},
        Refused{"RequiredZero", "         1         0       1.0",
                "(text):3:20: error: *MAT_ELASTIC ro = 0: must be given, and 0 is not a value here (density) "
                "[write its value there]"},
        Refused{"NotWhole", "         1       1.0       1.0                           2.5",
                "(text):3:58: error: *MAT_ELASTIC nip = 2.5: expected a whole number (integration points)"},
        Refused{"TooLarge", "2147483648       1.0       1.0",
                "(text):3:1: error: *MAT_ELASTIC mid = 2147483648: expected at most 2147483647 (material id)"},
        Refused{"FreeFormat", "1,1.0,12a",
                "(text):3:7: error: *MAT_ELASTIC e = 12a: is not a number (Young's modulus) "
                "[keep the number whole inside its columns, or separate the fields by commas]"},
        Refused{"Word", "         1       1.0     steel",
                "(text):3:26: error: *MAT_ELASTIC e = steel: is not a number (Young's modulus) "
                "[write a number there, or leave the field blank for its default]"},
        Refused{"UnknownParameter", "         1       1.0    &young",
                "(text):3:25: error: *MAT_ELASTIC e = &young: the parameter 'young' is not defined before this line "
                "[define it with "
                "*PARAMETER above this keyword, or correct the name]"}),
    [](const auto& p) { return p.param.name; });

TEST(Cards, AllFaultsOfALineComeAtOnce) {
  Reading r = material("         x        1e                 9.0");
  r.row("MAT_ELASTIC", elastic);
  EXPECT_EQ(r.findings.errors(), 4) << listed(r.findings);
}

TEST(Cards, TheOnlySupportedValue) {
  const Card card{{integer("iopt", 0, only(0), "option")}};
  Reading r("*KEYWORD\n*X\n         3\n");
  r.row("X", card);
  EXPECT_ONE_FINDING(r.findings, "(text):3:10: error: *X iopt = 3: only 0 is supported (option)");
}

TEST(Cards, AMissingCardHasDefaultsAndOneErrorIfAFieldIsRequired) {
  const Card defaults{{real("a", dimension::number, 3.0, any_value, "a"), text("t", 10, "t")}};
  Reading r = material("         1       1.0       1.0");
  Cursor c = r.cursor("MAT_ELASTIC");
  c.read(elastic);
  const Row row = c.read(defaults);
  EXPECT_EQ(row.entry("a").value, 3.0);
  EXPECT_TRUE(row.entry("a").blank);
  EXPECT_EQ(row.entry("t").text, "");
  EXPECT_CLEAN(r.findings);
  EXPECT_EQ(c.read(elastic).entry("mid").integer(), 0);
  EXPECT_ONE_FINDING(r.findings,
                     "(text):2:1: error: *MAT_ELASTIC mid = (blank): must be given, but the keyword ends after 1 data "
                     "line(s) (material id) [add the missing card]");
}

TEST(Cards, TextBehindTheLastFieldWarnsOnceAKeyword) {
  const Card two{{integer("a", 0, any_value, "a"), integer("b", 0, any_value, "b")}};
  Reading r("*KEYWORD\n*X\n         1         2   rest\n         3         4   rest\n");
  Cursor c = r.cursor("X");
  c.read(two);
  c.read(two);
  EXPECT_ONE_FINDING(
      r.findings,
      "(text):3:24: warning: *X: 'rest' stands behind the last field of this card and is not read [remove it; check "
      "that the card has its right form]");
  Reading beyond("*KEYWORD\n*X\n         1         2" + std::string(60, ' ') + "comment\n");
  beyond.row("X", two);
  EXPECT_CLEAN(beyond.findings);
  Reading free("*KEYWORD\n*X\n1,2,3\n");
  free.row("X", two);
  EXPECT_EQ(free.findings.warnings(), 1);
}

TEST(Cards, HeadingsKeepTheirCommas) {
  const Card with_heading{{id("id", IdSpace::set, 0, "id"), text("heading", 70, "heading")}};
  Reading r("*KEYWORD\n*X\n         7welds, left and right\n8,welds, left\n");
  Cursor c = r.cursor("X");
  Row row = c.read(with_heading);
  EXPECT_EQ(row.entry("id").integer(), 7);
  EXPECT_EQ(row.entry("heading").text, "welds, left and right");
  row = c.read(with_heading);
  EXPECT_EQ(row.entry("id").integer(), 8);
  EXPECT_EQ(row.entry("heading").text, "welds, left");
  EXPECT_CLEAN(r.findings);
}

TEST(Cards, PeekSkipAndTexts) {
  Reading r("*KEYWORD\n*X\n  a title, here  \n         5       2.5\n3,4.5\n");
  Cursor c = r.cursor("X");
  EXPECT_EQ(c.place().line, 3);
  EXPECT_EQ(c.peek(), "  a title, here  ");
  EXPECT_EQ(c.read_text(), "a title, here");
  EXPECT_EQ(c.peek_number(0), 5.0);
  EXPECT_EQ(c.peek_number(1), 2.5);
  EXPECT_EQ(c.peek_number(5), 0.0);
  c.skip();
  EXPECT_EQ(c.peek_number(1), 4.5);
  c.skip();
  c.skip();
  EXPECT_FALSE(c.more());
  EXPECT_EQ(c.peek(), "");
  EXPECT_EQ(c.read_text(), "");
}

TEST(Cards, ListsOfIds) {
  Reading r("*KEYWORD\n*SET_NODE_LIST\n         1         2         0         3\n\n4,5,,-6\n        xx         7\n");
  EXPECT_THAT(r.cursor("SET_NODE_LIST").read_ids(IdSpace::node), testing::ElementsAre(1, 2, 3, 4, 5, 7));
  ASSERT_EQ(r.findings.errors(), 2) << listed(r.findings);
  EXPECT_EQ(r.findings.all()[0].place.line, 5);  // a sign before an id
  EXPECT_EQ(r.findings.all()[1].place.line, 6);
  EXPECT_EQ(r.findings.all()[1].place.column, 9);
}

TEST(Cards, ComplainingAboutAField) {
  Reading r = material("         1       1.0       5.0");
  r.row("MAT_ELASTIC", elastic).entry("e").report(r.findings, Severity::warning, "is small", "use MPa");
  EXPECT_ONE_FINDING(r.findings, "(text):3:28: warning: *MAT_ELASTIC e = 5.0: is small [use MPa]");
  EXPECT_THROW(r.row("MAT_ELASTIC", elastic).entry("nonsense").value, std::logic_error);
}

}  // namespace
}  // namespace nugget::deck
