// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_MODIFIED_JOHNSON_COOK.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using kernel::DuctileFracture;
using kernel::ModifiedJohnsonCook;

constexpr RealField modified_number(std::string_view name, std::string_view meaning) {
  return real(name, dimension::number, 0, any_value, meaning);
}

/// All cards of *MAT_MODIFIED_JOHNSON_COOK.
struct ModifiedCards : ModifiedJohnsonCook, DuctileFracture, MaterialCard {
  double beta = 0, xs1 = 0, cp = 0, tr = 0, tm = 0, t0 = 0, flag1 = 0, flag2 = 0, dc = 0, tc = 0, tauc = 0;
  double rate = 0;
};

const CardOf<ModifiedCards> modified_elastic_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&ModifiedJohnsonCook::E, young},
    {&ModifiedJohnsonCook::nu, poisson},
    {&ModifiedCards::beta, real("beta", dimension::number, 0, only(0), "1: damage weakens the stress")},
    {&ModifiedCards::xs1,
     real("xs1", dimension::number, 0, between(0, 1), "share of the plastic work that becomes heat")},
    {&ModifiedCards::cp,
     real("cp", {0, 2, -2}, 0, at_least(0), "heat capacity a mass and degree; 0: plastic work does not heat")},
    real("alpha", dimension::number, 0, only(0), "thermal expansion"),
};

const CardOf<ModifiedCards> modified_temperature_card{
    {&ModifiedCards::rate, real("e0dot", dimension::rate, required, above_zero(), "rate that the others are over")},
    {&ModifiedCards::tr, modified_number("tr", "room temperature")},
    {&ModifiedCards::tm, modified_number("tm", "melting temperature")},
    {&ModifiedCards::t0, modified_number("t0", "temperature at the start; 0: TR")},
    {&ModifiedCards::flag1, real("flag1", dimension::number, 0, only(0), "1: yield stress of Zerilli and Armstrong")},
    {&ModifiedCards::flag2,
     real("flag2", dimension::number, 0, between(0, 1), "fracture: 0 Johnson and Cook, 1 Cockcroft and Latham")},
};

const CardOf<ModifiedCards> modified_hardening_card{
    {&ModifiedJohnsonCook::yield, real("a", dimension::stress, required, above_zero(), "yield stress at rest")},
    {&ModifiedJohnsonCook::hardening,
     real("b", dimension::stress, 0, at_least(0), "hardening: factor of the power of the plastic strain")},
    {&ModifiedJohnsonCook::exponent, real("n", dimension::number, 1, above_zero(), "its exponent")},
    {&ModifiedJohnsonCook::rate_exponent,
     real("c", dimension::number, 0, at_least(0), "exponent of the rate; 0: no rate effect")},
    {&ModifiedJohnsonCook::softening, real("m", dimension::number, 1, above_zero(), "exponent of the temperature")},
};

const CardOf<ModifiedCards> modified_voce_card{
    {&ModifiedJohnsonCook::saturating_1, real("q1", dimension::stress, 0, any_value, "first term that saturates")},
    {&ModifiedJohnsonCook::saturation_1, real("c1", dimension::number, 0, at_least(0), "how soon it does")},
    {&ModifiedJohnsonCook::saturating_2, real("q2", dimension::stress, 0, any_value, "second term")},
    {&ModifiedJohnsonCook::saturation_2, real("c2", dimension::number, 0, at_least(0), "how soon it does")},
};

const CardOf<ModifiedCards> modified_fracture_card{
    {&ModifiedCards::dc, real("dc", dimension::number, 0, at_least(0), "damage at which a point fails")},
    {&DuctileFracture::threshold, real("pd", dimension::number, 0, at_least(0), "plastic strain at which it begins")},
    {&DuctileFracture::d1, modified_number("d1", "strain at fracture")},
    {&DuctileFracture::d2, modified_number("d2", "what triaxiality adds to it")},
    {&DuctileFracture::d3, modified_number("d3", "how soon, below 0")},
    {&DuctileFracture::d4, modified_number("d4", "exponent of the rate")},
    {&DuctileFracture::d5, modified_number("d5", "factor of the temperature")},
};

const CardOf<ModifiedCards> modified_work_card{
    {&ModifiedCards::dc, real("dc", dimension::number, 0, at_least(0), "damage at which a point fails")},
    {&DuctileFracture::work,
     real("wc", dimension::stress, 0, at_least(0), "work of the largest principal stress at fracture; 0: none")},
};

const CardOf<ModifiedCards> modified_limits_card{
    {&ModifiedCards::tc, real("tc", dimension::number, 0, at_least(0), "temperature at which a point fails; 0: none")},
    {&ModifiedCards::tauc, real("tauc", dimension::stress, 0, at_least(0), "largest shear stress of a point; 0: none")},
};

void read_modified_johnson_cook(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  ModifiedCards cards;
  const auto elastic = cursor.read(modified_elastic_card, cards);
  const auto warmth = cursor.read(modified_temperature_card, cards);
  cursor.read(modified_hardening_card, cards);
  cursor.read(modified_voce_card, cards);
  cards.by_work = cards.flag2 == 1.0;
  const auto fracture = cursor.read(cards.by_work ? modified_work_card : modified_fracture_card, cards);
  cursor.read(modified_limits_card, cards);
  expect_end(b, cursor);
  if (cards.flag2 != 0.0 && !cards.by_work)
    refuse(b, warmth[&ModifiedCards::flag2], "the criterion of fracture is 0 or 1", "write one of them");

  ModifiedJohnsonCook flow = cards;
  flow.reference_rate = cards.rate;
  const double start = cards.t0 != 0.0 ? cards.t0 : cards.tr;
  const bool heats = cards.xs1 > 0.0 && cards.cp > 0.0;
  if (cards.tm > cards.tr) {
    if (start < cards.tr || start >= cards.tm)
      refuse(b, warmth[&ModifiedCards::t0], "the temperature at the start must lie between TR and TM",
             "write 0 for TR");
    flow.warmth = (start - cards.tr) / (cards.tm - cards.tr);
    flow.melting_rise = cards.tm - start;
    if (heats) flow.heating = cards.xs1 / (cards.ro * cards.cp);
  } else if (heats) {
    refuse(b, warmth[&ModifiedCards::tm], "with XS1 and CP the temperature of melting must lie above TR",
           "give TM and TR, or CP 0");
  }
  DuctileFracture rule = cards;
  rule.reference_rate = cards.rate;
  rule.melting_rise = flow.melting_rise;
  rule.warmth = flow.warmth;
  rule.grows = cards.by_work ? rule.work > 0.0 : rule.d1 != 0.0 || rule.d2 != 0.0;
  if (rule.grows && !(cards.dc > 0.0))
    refuse(b, fracture[&ModifiedCards::dc], "fracture needs a critical damage above 0", "give DC, e.g. 1");
  if (cards.tc > 0.0) rule.last_rise = std::max(cards.tc - start, 0.0);
  if (cards.tauc > 0.0) rule.shear_strength = cards.tauc;
  kernel::LawComponents law{flow};
  if (rule.grows || cards.tc > 0.0 || cards.tauc > 0.0) law.rules = {rule};
  add_material(b, elastic, std::move(title), "MAT_MODIFIED_JOHNSON_COOK", kernel::composed_law(std::move(law)));
}

}  // namespace

std::vector<Keyword> modified_johnson_cook_keywords() {
  return {{.name = "MAT_MODIFIED_JOHNSON_COOK",
           .aliases = {"MAT_107"},
           .options = {"TITLE"},
           .layout = {{"", &modified_elastic_card},
                      {"", &modified_temperature_card},
                      {"", &modified_hardening_card},
                      {"", &modified_voce_card},
                      {"if FLAG2 is 0", &modified_fracture_card},
                      {"if FLAG2 is 1", &modified_work_card},
                      {"", &modified_limits_card}},
           .read = read_modified_johnson_cook}};
}

}  // namespace nugget::reading
