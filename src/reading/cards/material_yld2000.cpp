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

// *MAT_BARLAT_YLD2000.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Entry;
using deck::RowOf;
using kernel::SheetFormula;
using kernel::Yld2000Sheet;

/// All cards of *MAT_BARLAT_YLD2000.
struct YldCards : MaterialCard, AxesCards {
  double e = 0, pr = 0, fit = 0, iscale = 0;
  double k = 0, e0 = 0, n = 0, hard = 1, a = 0, p4 = 0, offang = 0;
  std::array<double, 8> alpha{};
  double sig00 = 0, sig45 = 0, sig90 = 0, r00 = 0, r45 = 0, r90 = 0;
  double sigxx = 0, sigyy = 0, sigxy = 0, dxx = 0, dyy = 0, dxy = 0;
};

const CardOf<YldCards> yld_elastic_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&YldCards::e, young},
    {&YldCards::pr, poisson},
    {&YldCards::fit, real("fit", dimension::number, 0, between(0, 1), "surface by 0: ALPHA1 to 8, 1: tests")},
    real("beta", dimension::number, 0, only(0), "share of kinematic hardening"),
    real("iter", dimension::number, 0, between(0, 1), "iterations of the return; here always to the end"),
    {&YldCards::iscale,
     real("iscale", dimension::number, 0, between(0, 1),
          "yield stress of the hardening: 0, that of tension along a; 1, effective stress as it is")},
};

const CardOf<YldCards> yld_hardening_card{
    {&YldCards::k, real("k", dimension::stress, 0, at_least(0), "1, 4: k; 2, 5: a")},
    {&YldCards::e0, real("e0", dimension::number, 0, at_least(0), "1, 4: e0; 2, 5: b, a stress")},
    {&YldCards::n, real("n", dimension::number, 0, at_least(0), "1, 4: n; 2, 5: c")},
    real("c", dimension::rate, 0, only(0), "power of the rate: its reference"),
    real("p", dimension::number, 0, any_value, "its exponent, no effect without C"),
    {&YldCards::hard,
     or_negative(real("hard", dimension::number, 1, any_value,
                      "hardening: 1 Swift k (e0 + ep)^n, 2 Voce a - b exp(-c ep), 4 Gosh k (e0 + ep)^n - P4, 5 "
                      "Hockett-Sherby a - b exp(-c ep^P4); below 0: curve, or table over the rate"),
                 IdSpace::function)},
    {&YldCards::a,
     real("a", dimension::number, required, any_value,
          "exponent, 2 or more: about 6 of bcc, 8 of fcc metals; below 0: kinematic hardening, not built")},
};

/// Read so that the cards behind it are read as what they are: the hardening itself is refused at A.
const CardOf<YldCards> yld_kinematic_card{
    real("crc1", dimension::number, 0, any_value, "kinematic hardening, first term"),
    real("cra1", dimension::number, 0, any_value, "the same"),
    real("crc2", dimension::number, 0, any_value, "second term"),
    real("cra2", dimension::number, 0, any_value, "the same"),
    real("crc3", dimension::number, 0, any_value, "third term"),
    real("cra3", dimension::number, 0, any_value, "the same"),
    real("crc4", dimension::number, 0, any_value, "fourth term"),
    real("cra4", dimension::number, 0, any_value, "the same"),
};

constexpr RealField yld_alpha(std::string_view name) {
  return real(name, dimension::number, required, any_value, "of the surface; 1: isotropic");
}
const CardOf<YldCards> yld_alpha_card{
    {at(&YldCards::alpha, 0), yld_alpha("alpha1")}, {at(&YldCards::alpha, 1), yld_alpha("alpha2")},
    {at(&YldCards::alpha, 2), yld_alpha("alpha3")}, {at(&YldCards::alpha, 3), yld_alpha("alpha4")},
    {at(&YldCards::alpha, 4), yld_alpha("alpha5")}, {at(&YldCards::alpha, 5), yld_alpha("alpha6")},
    {at(&YldCards::alpha, 6), yld_alpha("alpha7")}, {at(&YldCards::alpha, 7), yld_alpha("alpha8")},
};

constexpr RealField yld_stress(std::string_view name, std::string_view meaning) {
  return real(name, dimension::stress, required, above_zero(), meaning);
}
constexpr RealField yld_ratio(std::string_view name, std::string_view meaning) {
  return real(name, dimension::number, required, above_zero(), meaning);
}
const CardOf<YldCards> yld_tension_card{
    {&YldCards::sig00, yld_stress("sig00", "yield stress of tension along a")},
    {&YldCards::sig45, yld_stress("sig45", "at 45 degrees to a")},
    {&YldCards::sig90, yld_stress("sig90", "across a")},
    {&YldCards::r00, yld_ratio("r00", "Lankford ratio of tension along a")},
    {&YldCards::r45, yld_ratio("r45", "at 45 degrees to a")},
    {&YldCards::r90, yld_ratio("r90", "across a")},
};

const CardOf<YldCards> yld_point_card{
    {&YldCards::sigxx, real("sigxx", dimension::stress, 0, any_value, "a further stress at yield, along a")},
    {&YldCards::sigyy, real("sigyy", dimension::stress, 0, any_value, "along b")},
    {&YldCards::sigxy, real("sigxy", dimension::stress, 0, any_value, "shear")},
    {&YldCards::dxx, real("dxx", dimension::number, 0, any_value, "tangent to the surface there, along a")},
    {&YldCards::dyy, real("dyy", dimension::number, 0, any_value, "along b")},
    {&YldCards::dxy, real("dxy", dimension::number, 0, any_value, "shear")},
};

const CardOf<YldCards> yld_option_card{
    {&AxesCards::aopt, aopt::option},
    {&YldCards::offang, real("offang", dimension::number, 0, any_value, "angle of AOPT 0 and 3 [degrees]")},
    {&YldCards::p4, real("p4", dimension::number, 0, any_value, "of HARD 4: p, a stress; of HARD 5: n")},
    integer("htflag", 0, only(0), "heat treatment"),
    integer("hta", 0, only(0), "the same"),
    integer("htb", 0, only(0), "the same"),
    integer("htc", 0, only(0), "the same"),
    integer("htd", 0, only(0), "the same"),
};

const CardOf<YldCards> yld_axes_card{
    unused(), unused(), unused(), {&AxesCards::a1, aopt::a1}, {&AxesCards::a2, aopt::a2}, {&AxesCards::a3, aopt::a3},
};

const CardOf<YldCards> yld_vectors_card = axes_vectors_card<YldCards>({
    integer("usrfail", 0, only(0), "failure by a subroutine of the user"),
});

/// The surface that FIT 1 asks for, of tests over SIG00.
kernel::Yld2000 fitted_surface(Builder& b, const RowOf<YldCards>& tension, const RowOf<YldCards>& point,
                               const YldCards& cards) {
  kernel::Yld2000 surface{.m = cards.a};
  const double over = 1.0 / cards.sig00;
  kernel::SheetTests tests;
  tests.stress = {1.0, over * cards.sig45, over * cards.sig90};
  tests.ratio = {cards.r00, cards.r45, cards.r90};
  tests.point = {over * cards.sigxx, over * cards.sigyy, over * cards.sigxy};
  tests.tangent = {cards.dxx, cards.dyy, cards.dxy};
  if (cards.sigxx == 0.0 && cards.sigyy == 0.0 && cards.sigxy == 0.0) {
    refuse(b, point[&YldCards::sigxx], "FIT 1 needs a further stress at yield",
           "give that of equal biaxial tension as SIGXX and SIGYY");
    return surface;
  }
  if (cards.dxx == 0.0 && cards.dyy == 0.0 && cards.dxy == 0.0) {
    refuse(b, point[&YldCards::dxx], "FIT 1 needs a tangent to the surface there",
           "of equal biaxial tension with equal strains DXX 1 and DYY -1");
    return surface;
  }
  if (const auto found = kernel::Yld2000::from_tests(cards.a, tests)) return *found;
  refuse(b, tension[&YldCards::sig00], "no surface was found that fits these tests",
         "check the stresses, the ratios and the tangent; A must be above 2 for eight tests");
  return surface;
}

/// Hardening by K, E0, N and P4 in the units of the model; refused where it would give no yield stress.
SheetFormula yld_formula(Builder& b, const RowOf<YldCards>& row, const Entry& p4, const YldCards& cards,
                         double stress) {
  SheetFormula f;
  const int rule = static_cast<int>(cards.hard);
  const auto demand = [&](bool holds, const Entry& field, const char* what, const char* remedy) {
    if (!holds) refuse(b, field, what, remedy);
    return holds;
  };
  if (rule == 1 || rule == 4) {
    f.factor = cards.k;
    f.exponent = cards.n;
    f.start_strain = cards.e0;
    if (rule == 4) f.offset = -stress * cards.p4;
    if (demand(cards.k > 0.0, row[&YldCards::k], "k must be above 0", "give it as K") &&
        demand(cards.n > 0.0 && cards.n < 1.0, row[&YldCards::n], "the exponent n must be between 0 and 1",
               "give it as N"))
      demand(cards.e0 > 0.0 && f.offset + f.factor * std::pow(f.start_strain, f.exponent) > 0.0, row[&YldCards::e0],
             "the first yield stress is not above 0", "give e0 as E0, above 0");
  } else {
    f.offset = cards.k;
    f.factor = stress * cards.e0;
    f.decay = cards.n;
    f.exponent = rule == 5 ? cards.p4 : 1.0;
    demand(f.factor < f.offset, row[&YldCards::k], "the first yield stress a - b is not above 0",
           "give a as K above b as E0");
    demand(cards.n > 0.0, row[&YldCards::n], "c must be above 0", "give it as N");
    demand(rule == 2 || cards.p4 > 0.0, p4, "HARD 5 needs the exponent n", "give it as P4");
  }
  return f;
}

void set_yld_curves(Builder& b, Index material, const Entry& hard) {
  YieldTable table = yield_table(b, hard, curve_below_zero(hard.value), false);
  auto* composed = std::get_if<kernel::ComposedLaw>(&b.model.materials[material].law);
  if (table.curves.empty() || composed == nullptr) return;
  kernel::LawComponents made = *composed->components;
  auto& sheet = std::get<Yld2000Sheet>(made.flow);
  kernel::PiecewiseLinear curves;
  curves.E = sheet.E;
  curves.nu = sheet.nu;
  curves.yield = std::move(table.curves);
  curves.rates = std::move(table.rates);
  curves.log_rates = table.log_rates;
  sheet.hardening = std::move(curves);
  *composed = kernel::composed_law(std::move(made));
}

void read_yld2000(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  YldCards cards;
  const auto elastic = cursor.read(yld_elastic_card, cards);
  const auto hardening = cursor.read(yld_hardening_card, cards);
  if (cards.a < 0.0) cursor.read(yld_kinematic_card, cards);
  cards.a = yield_exponent(b, hardening[&YldCards::a], cards.a);
  const bool fits = cards.fit == 1.0;
  if (cards.fit != 0.0 && !fits) refuse(b, elastic[&YldCards::fit], "FIT is 0 or 1", "write one of them");
  if (cards.iscale != 0.0 && cards.iscale != 1.0)
    refuse(b, elastic[&YldCards::iscale], "ISCALE is 0 or 1", "write one of them");
  if (fits && cards.iscale != 0.0)
    refuse(b, elastic[&YldCards::iscale], "with FIT 1 the yield stress is that of tension along a", "write 0");
  Yld2000Sheet sheet{.E = cards.e, .nu = cards.pr};
  if (fits) {
    const auto tension = cursor.read(yld_tension_card, cards);
    const auto point = cursor.read(yld_point_card, cards);
    sheet.surface = fitted_surface(b, tension, point, cards);
  } else {
    cursor.read(yld_alpha_card, cards);
    sheet.surface = {.m = cards.a, .alpha = cards.alpha};
    if (const double along = sheet.surface.stress(0.0); cards.iscale == 0.0)
      for (double& alpha : sheet.surface.alpha) alpha *= along;
  }
  const auto option = cursor.read(yld_option_card, cards);
  const auto row = cursor.read(yld_axes_card, cards);
  const auto vectors = cursor.read(yld_vectors_card, cards);
  expect_end(b, cursor);
  sheet.axes = material_axes(b, block, cards, option[&AxesCards::aopt], row[&AxesCards::a1], vectors[&AxesCards::v1]);
  sheet.axes.angle = hand(block) * cards.offang * (std::numbers::pi / 180.0);
  const bool by_curve = cards.hard < 0.0;
  if (!by_curve && cards.hard != 1.0 && cards.hard != 2.0 && cards.hard != 4.0 && cards.hard != 5.0)
    refuse(b, hardening[&YldCards::hard], "built are 1, 2, 4, 5 and curves", "give the curve, as a negative id");
  else if (!by_curve)
    sheet.hardening = yld_formula(b, hardening, option[&YldCards::p4], cards,
                                  block.transform == nullptr ? 1.0 : block.transform->factor(dimension::stress));
  const Index material =
      add_material(b, elastic, std::move(title), "MAT_BARLAT_YLD2000", kernel::composed_law({sheet}));
  if (by_curve)
    b.defer(Phase::parts,
            [=, hard = hardening[&YldCards::hard]](Builder& later) { set_yld_curves(later, material, hard); });
  take_axes_of_system(b, option[&AxesCards::aopt], material);
}

}  // namespace

std::vector<Keyword> yld2000_keywords() {
  return {{.name = "MAT_BARLAT_YLD2000",
           .aliases = {"MAT_133"},
           .options = {"TITLE"},
           .layout = {{"", &yld_elastic_card},
                      {"", &yld_hardening_card},
                      {"if A is below 0", &yld_kinematic_card},
                      {"if FIT is 0", &yld_alpha_card},
                      {"if FIT is 1", &yld_tension_card},
                      {"if FIT is 1", &yld_point_card},
                      {"", &yld_option_card},
                      {"", &yld_axes_card},
                      {"", &yld_vectors_card}},
           .read = read_yld2000}};
}

}  // namespace nugget::reading
