// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"
#include "reading/cards/yield_curves.hpp"

// *MAT_... of rolled sheets, whose strength and flow depend on the direction: 036, 037, 122.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Entry;
using deck::RowOf;
using kernel::AnisotropicSheet;
using kernel::SheetFormula;

/// All cards of the three keywords.
struct SheetCards : MaterialCard, AxesCards {
  double e = 0, pr = 0;
  double hr = 1, p1 = 0, p2 = 0, p3 = 0, e0 = 0, spi = 0, c = 0, p = 0;  // hardening and rate
  double m = 2, r00 = 0, r45 = 0, r90 = 0, pb = 0;                       // surface
  double sigy = 0, etan = 0;                                             // of 037
  int lcid = 0;
  double beta = 0;
};

constexpr RealField hardening_rule =
    real("hr", dimension::number, 1, between(1, 6),
         "hardening: 1 linear, 2 Swift k (e0 + ep)^n, 3 curve, 4 Voce a - b exp(-c ep), 5 Gosh k (e0 + ep)^n - p, 6 "
         "Hockett-Sherby a - b exp(-c ep^n)");
constexpr RealField hardening_p1 = real("p1", dimension::stress, 1, any_value, "1: tangent modulus; 2, 5: k; 4, 6: a");
constexpr RealField hardening_p2 = real("p2", dimension::number, 1, any_value, "1: yield stress; 2, 5: n; 4, 6: c");
constexpr RealField hardening_e0 =
    real("e0", dimension::number, 0, at_least(0), "2, 5: e0, 0 of HR 2: by SPI; 4, 6: b, a stress");

const CardOf<SheetCards> barlat_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&SheetCards::e, young},
    {&SheetCards::pr, poisson},
    {&SheetCards::hr, hardening_rule},
    {&SheetCards::p1, hardening_p1},
    {&SheetCards::p2, hardening_p2},
    real("iter", dimension::number, 0, between(0, 1), "iterations of the return; here always to the end"),
};

const CardOf<SheetCards> barlat_surface_card{
    {&SheetCards::m,
     real("m", dimension::number, required, any_value,
          "exponent, 2 or more: about 6 of bcc, 8 of fcc metals; below 0: kinematic hardening, not built")},
    {&SheetCards::r00, real("r00", dimension::number, required, above_zero(), "Lankford ratio along a; A with PB")},
    {&SheetCards::r45, real("r45", dimension::number, required, above_zero(), "at 45 degrees to a; C with PB")},
    {&SheetCards::r90, real("r90", dimension::number, required, above_zero(), "across a; H with PB")},
    {&SheetCards::lcid,
     id("lcid", IdSpace::function, 0, "of HR 3: yield stress along a over plastic strain: curve, or table over rates")},
    {&SheetCards::e0, hardening_e0},
    {&SheetCards::spi, real("spi", dimension::number, 0, at_least(0),
                            "of HR 2 with E0 0: 0: e0 = (E/k)^(1/(n-1)); to 0.02: e0; above: first yield stress")},
    {&SheetCards::p3, real("p3", dimension::number, 0, any_value, "of HR 5: p, a stress; of HR 6: n")},
};

/// Read so that the cards behind it are read as what they are: the hardening itself is refused at M.
const CardOf<SheetCards> barlat_kinematic_card{
    real("crc1", dimension::number, 0, any_value, "kinematic hardening, first term"),
    real("cra1", dimension::number, 0, any_value, "the same"),
    real("crc2", dimension::number, 0, any_value, "second term"),
    real("cra2", dimension::number, 0, any_value, "the same"),
    real("crc3", dimension::number, 0, any_value, "third term"),
    real("cra3", dimension::number, 0, any_value, "the same"),
    real("crc4", dimension::number, 0, any_value, "fourth term"),
    real("cra4", dimension::number, 0, any_value, "the same"),
};

const CardOf<SheetCards> barlat_rate_card{
    {&AxesCards::aopt, aopt::option},
    {&SheetCards::c, real("c", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect")},
    {&SheetCards::p, real("p", dimension::number, 0, at_least(0), "Cowper-Symonds P")},
    integer("vlcid", 0, only(0), "curve: change of volume"),
    unused(),
    {&SheetCards::pb,
     real("pb", dimension::number, 0, at_least(0), "P of the surface, with A, C, H instead of ratios")},
    integer("hta", 0, only(0), "forming and heat treatment"),
    real("htb", dimension::number, 0, only(0), "the same"),
};

const CardOf<SheetCards> sheet_axes_card{
    aopt::xp,
    aopt::yp,
    aopt::zp,
    {&AxesCards::a1, aopt::a1},
    {&AxesCards::a2, aopt::a2},
    {&AxesCards::a3, aopt::a3},
    integer("htc", 0, only(0), "heat treatment"),
    integer("htd", 0, only(0), "the same"),
};

const CardOf<SheetCards> sheet_vectors_card = axes_vectors_card<SheetCards>({
    {&SheetCards::beta, real("beta", dimension::number, 0, any_value, "angle of AOPT 0 and 3 [degrees]")},
    real("htflag", dimension::number, 0, only(0), "heat treatment"),
});

const CardOf<SheetCards> hill_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&SheetCards::e, young},
    {&SheetCards::pr, poisson},
    {&SheetCards::hr, real("hr", dimension::number, 1, between(1, 3), "hardening: 1 linear, 2 Swift, 3 curve")},
    {&SheetCards::p1, hardening_p1},
    {&SheetCards::p2, hardening_p2},
};

const CardOf<SheetCards> hill_surface_card{
    {&SheetCards::r00, real("r00", dimension::number, required, above_zero(), "Lankford ratio along a")},
    {&SheetCards::r45, real("r45", dimension::number, required, above_zero(), "at 45 degrees to a")},
    {&SheetCards::r90, real("r90", dimension::number, required, above_zero(), "across a")},
    {&SheetCards::lcid,
     id("lcid", IdSpace::function, 0, "of HR 3: yield stress along a over plastic strain: curve, or table over rates")},
    {&SheetCards::e0, hardening_e0},
};

const CardOf<SheetCards> hill_axes_option_card{{&AxesCards::aopt, aopt::option}};

const CardOf<SheetCards> transverse_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&SheetCards::e, young},
    {&SheetCards::pr, poisson},
    {&SheetCards::sigy, real("sigy", dimension::stress, 0, at_least(0), "yield stress, unless HLCID is given")},
    {&SheetCards::etan,
     real("etan", dimension::stress, 0, at_least(0), "plastic hardening modulus (of the plastic strain alone)")},
    {&SheetCards::r00, real("r", dimension::number, required, above_zero(), "Lankford ratio, of all directions")},
    {&SheetCards::lcid, id("hlcid", IdSpace::function, 0, "curve: yield stress over plastic strain")},
};

/// The fields that a hardening comes from, wherever they stand.
struct HardeningFields {
  Entry rule, p1, p2, p3, e0, curve, c;
  bool spi_is_stress = false;  ///< as it was written
};

/// SPI is a strain up to here, and a stress above.
constexpr double largest_spi_strain = 0.02;

/// What P2, P3, E0 and SPI are depends on HR: those that are stresses are brought into the units of the model.
void convert_stresses(const Block& block, SheetCards& cards) {
  if (block.transform == nullptr) return;
  const double factor = block.transform->factor(dimension::stress);
  const int rule = static_cast<int>(cards.hr);
  if (rule == 1) cards.p2 *= factor;
  if (rule == 4 || rule == 6) cards.e0 *= factor;
  if (rule == 5) cards.p3 *= factor;
  if (cards.spi > largest_spi_strain) cards.spi *= factor;
}

/// e0 of Swift's hardening (MAT_036, SPI). `spi_is_stress`: as it was written.
double swift_start(const SheetCards& cards, bool spi_is_stress) {
  if (cards.e0 > 0.0) return cards.e0;
  if (spi_is_stress) return std::pow(cards.spi / cards.p1, 1.0 / cards.p2);
  if (cards.spi > 0.0) return cards.spi;
  return std::pow(cards.e / cards.p1, 1.0 / (cards.p2 - 1.0));
}

/// Hardening by P1 to P3 and E0, as HR says; refused where it would give no yield stress.
SheetFormula sheet_formula(Builder& b, const SheetCards& cards, const HardeningFields& fields) {
  SheetFormula f;
  f.rate_c = cards.c > 0.0 && cards.p > 0.0 ? cards.c : 0.0;
  f.rate_p = cards.p > 0.0 ? cards.p : 1.0;
  const int rule = fields.rule.integer();
  const auto demand = [&](bool holds, const Entry& field, const char* what, const char* remedy) {
    if (!holds) refuse(b, field, what, remedy);
    return holds;
  };
  if (rule == 1) {
    demand(cards.p2 > 0.0, fields.p2, "HR 1 needs a yield stress above 0", "give it as P2");
    if (!demand(cards.p1 >= 0.0 && cards.p1 < cards.e, fields.p1, "HR 1 needs a tangent modulus from 0 to below E",
                "give it as P1"))
      return f;
    f.offset = cards.p2;
    f.factor = cards.e * cards.p1 / (cards.e - cards.p1);
  } else if (rule == 2 || rule == 5) {
    if (!demand(cards.p1 > 0.0, fields.p1, "k must be above 0", "give it as P1") ||
        !demand(cards.p2 > 0.0 && cards.p2 < 1.0, fields.p2, "the exponent n must be between 0 and 1",
                "give it as P2") ||
        !demand(rule == 2 || cards.e0 > 0.0, fields.e0, "HR 5 needs e0, here not found by SPI", "give it as E0"))
      return f;
    f.factor = cards.p1;
    f.exponent = cards.p2;
    f.start_strain = swift_start(cards, fields.spi_is_stress);
    if (rule == 5) f.offset = -cards.p3;
    demand(f.offset + f.factor * std::pow(f.start_strain, f.exponent) > 0.0, fields.p3,
           "the first yield stress k e0^n - p is not above 0", "give a smaller p as P3, or a larger e0 as E0");
  } else {
    if (!demand(cards.e0 < cards.p1, fields.p1, "the first yield stress a - b is not above 0",
                "give a as P1 above b as E0") ||
        !demand(cards.p2 > 0.0, fields.p2, "c must be above 0", "give it as P2") ||
        !demand(rule == 4 || cards.p3 > 0.0, fields.p3, "HR 6 needs the exponent n", "give it as P3"))
      return f;
    f.offset = cards.p1;
    f.factor = cards.e0;
    f.decay = cards.p2;
    f.exponent = rule == 6 ? cards.p3 : 1.0;
  }
  return f;
}

/// Hardening by a curve, or a table over rates.
void set_sheet_curves(Builder& b, Index material, const SheetCards& cards, const HardeningFields& fields) {
  kernel::PiecewiseLinear curves;
  curves.E = cards.e;
  curves.nu = cards.pr;
  YieldTable table = yield_table(b, fields.curve, fields.curve.integer(), false);
  if (table.curves.empty()) return;
  if (cards.c > 0.0 && !table.rates.empty())
    fields.c.report(b.findings, Severity::warning, "not obeyed: the rates are those of the table", "leave it empty");
  else if (cards.c > 0.0 && cards.p > 0.0) {
    curves.rate_c = cards.c;
    curves.rate_p = cards.p;
  }
  curves.yield = std::move(table.curves);
  curves.rates = std::move(table.rates);
  curves.log_rates = table.log_rates;
  auto* composed = std::get_if<kernel::ComposedLaw>(&b.model.materials[material].law);
  if (composed == nullptr) return;  // refused
  kernel::LawComponents made = *composed->components;
  std::get<AnisotropicSheet>(made.flow).hardening = std::move(curves);
  *composed = kernel::composed_law(std::move(made));
}

/// Adds the material, with its curves once these are known.
Index add_sheet(Builder& b, const Block& block, const RowOf<SheetCards>& first, SheetCards cards, std::string title,
                std::string_view name, const kernel::BarlatLian& surface, const kernel::MaterialAxes& axes,
                HardeningFields fields) {
  if (cards.hr != std::floor(cards.hr)) refuse(b, fields.rule, "expected a whole number");
  fields.spi_is_stress = cards.spi > largest_spi_strain;
  convert_stresses(block, cards);
  AnisotropicSheet sheet{.E = cards.e, .nu = cards.pr, .surface = surface, .axes = axes};
  const bool by_curve = fields.rule.integer() == 3;
  if (by_curve && cards.lcid == 0)
    refuse(b, fields.curve, "HR 3 needs a curve", "give the yield stress over plastic strain");
  if (!by_curve) sheet.hardening = sheet_formula(b, cards, fields);
  const Index material = add_material(b, cards, first, std::move(title), name, kernel::composed_law({sheet}));
  if (by_curve && cards.lcid != 0)
    b.defer(Phase::parts, [=](Builder& later) { set_sheet_curves(later, material, cards, fields); });
  return material;
}

/// The two last cards of 036 and 122, and what AOPT makes of them.
kernel::MaterialAxes read_sheet_axes(Builder& b, const Block& block, Cursor& cursor, const Entry& option,
                                     SheetCards& cards) {
  const auto row = cursor.read(sheet_axes_card, cards);
  const auto vectors = cursor.read(sheet_vectors_card, cards);
  kernel::MaterialAxes axes = material_axes(b, block, cards, option, row[&AxesCards::a1], vectors[&AxesCards::v1]);
  axes.angle = hand(block) * cards.beta * (std::numbers::pi / 180.0);
  return axes;
}

void read_barlat(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  SheetCards cards;
  const auto first = cursor.read(barlat_card, cards);
  const auto shape = cursor.read(barlat_surface_card, cards);
  if (cards.m < 0.0) cursor.read(barlat_kinematic_card, cards);
  cards.m = yield_exponent(b, shape[&SheetCards::m], cards.m);
  const auto rate = cursor.read(barlat_rate_card, cards);
  const kernel::MaterialAxes axes = read_sheet_axes(b, block, cursor, rate[&AxesCards::aopt], cards);
  expect_end(b, cursor);
  warn_of_half_a_rate(b, rate[&SheetCards::c], rate[&SheetCards::p]);
  kernel::BarlatLian surface{.m = cards.m, .A = cards.r00, .C = cards.r45, .H = cards.r90, .P = cards.pb};
  if (!(cards.pb > 0.0)) surface = kernel::BarlatLian::from_ratios(cards.m, cards.r00, cards.r45, cards.r90);
  HardeningFields fields;
  fields.rule = first[&SheetCards::hr];
  fields.p1 = first[&SheetCards::p1];
  fields.p2 = first[&SheetCards::p2];
  fields.p3 = shape[&SheetCards::p3];
  fields.e0 = shape[&SheetCards::e0];
  fields.curve = shape[&SheetCards::lcid];
  fields.c = rate[&SheetCards::c];
  const Index material =
      add_sheet(b, block, first, cards, std::move(title), "MAT_3-PARAMETER_BARLAT", surface, axes, fields);
  take_axes_of_system(b, rate[&AxesCards::aopt], material);
}

void read_hill(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  SheetCards cards;
  const auto first = cursor.read(hill_card, cards);
  const auto shape = cursor.read(hill_surface_card, cards);
  const auto option = cursor.read(hill_axes_option_card, cards);
  const kernel::MaterialAxes axes = read_sheet_axes(b, block, cursor, option[&AxesCards::aopt], cards);
  expect_end(b, cursor);
  HardeningFields fields;
  fields.rule = first[&SheetCards::hr];
  fields.p1 = first[&SheetCards::p1];
  fields.p2 = first[&SheetCards::p2];
  fields.e0 = shape[&SheetCards::e0];
  fields.curve = shape[&SheetCards::lcid];
  const Index material = add_sheet(b, block, first, cards, std::move(title), "MAT_HILL_3R",
                                   kernel::BarlatLian::from_ratios(2.0, cards.r00, cards.r45, cards.r90), axes, fields);
  take_axes_of_system(b, option[&AxesCards::aopt], material);
}

void read_transverse(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  SheetCards cards;
  const auto first = cursor.read(transverse_card, cards);
  expect_end(b, cursor);
  HardeningFields fields;
  fields.curve = first[&SheetCards::lcid];
  AnisotropicSheet sheet{.E = cards.e, .nu = cards.pr};
  sheet.surface = kernel::BarlatLian::from_ratios(2.0, cards.r00, cards.r00, cards.r00);
  sheet.hardening = SheetFormula{.offset = cards.sigy, .factor = cards.etan};
  if (cards.lcid == 0 && !(cards.sigy > 0.0))
    refuse(b, first[&SheetCards::sigy], "the yield stress must be given", "give SIGY, or HLCID");
  const Index material = add_material(b, cards, first, std::move(title), "MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC",
                                      kernel::composed_law({sheet}));
  if (cards.lcid != 0) b.defer(Phase::parts, [=](Builder& later) { set_sheet_curves(later, material, cards, fields); });
}

}  // namespace

std::vector<Keyword> sheet_material_keywords() {
  return {{.name = "MAT_3-PARAMETER_BARLAT",
           .aliases = {"MAT_036"},
           .options = {"TITLE"},
           .layout = {{"", &barlat_card},
                      {"", &barlat_surface_card},
                      {"if M is below 0", &barlat_kinematic_card},
                      {"", &barlat_rate_card},
                      {"", &sheet_axes_card},
                      {"", &sheet_vectors_card}},
           .read = read_barlat},
          {.name = "MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC",
           .aliases = {"MAT_037"},
           .options = {"TITLE"},
           .layout = {{"", &transverse_card}},
           .read = read_transverse},
          {.name = "MAT_HILL_3R",
           .aliases = {"MAT_122"},
           .options = {"TITLE"},
           .layout = {{"", &hill_card},
                      {"", &hill_surface_card},
                      {"", &hill_axes_option_card},
                      {"", &sheet_axes_card},
                      {"", &sheet_vectors_card}},
           .read = read_hill}};
}

}  // namespace nugget::reading
