// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_KELVIN-MAXWELL_VISCOELASTIC, *MAT_GENERAL_VISCOELASTIC. MAT_006 has its cards in kernel/law/viscoelastic.hpp.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using kernel::Viscoelastic;

struct KelvinMaxwellCard : MaterialCard, Viscoelastic {
  double dc = 0, fo = 0, so = 0;
};
const CardOf<KelvinMaxwellCard> kelvin_maxwell_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&Viscoelastic::bulk, real("bulk", dimension::stress, required, above_zero(), "bulk modulus")},
    {&Viscoelastic::instantaneous_shear,
     real("g0", dimension::stress, required, above_zero(), "shear modulus at once")},
    {&Viscoelastic::long_term_shear, real("gi", dimension::stress, 0, at_least(0), "shear modulus in the end")},
    {&KelvinMaxwellCard::dc, real("dc", dimension::number, 0, at_least(0),
                                  "decay of FO 0 [1/time], exp(-DC t); of FO 1 relaxation time [time], exp(-t/DC)")},
    {&KelvinMaxwellCard::fo, real("fo", dimension::number, 0, between(0, 1), "0: Maxwell, 1: Kelvin")},
    {&KelvinMaxwellCard::so,
     real("so", dimension::number, 0, any_value, "which strain d3plot has as plastic strain; here it has none")},
};

void read_kelvin_maxwell(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  KelvinMaxwellCard card;
  const auto row = cursor.read(kelvin_maxwell_card, card);
  expect_end(b, cursor);
  Viscoelastic law = card;
  const bool kelvin = card.fo == 1.0;
  if (card.fo != 0.0 && !kelvin)
    refuse(b, row[&KelvinMaxwellCard::fo], "the formulation is 0 or 1", "write 0 for Maxwell, 1 for Kelvin");
  if (kelvin && !(card.dc > 0.0))
    refuse(b, row[&KelvinMaxwellCard::dc], "Kelvin's formulation needs a relaxation time above 0", "give DC");
  const double time = block.transform == nullptr ? 1.0 : block.transform->factor(dimension::time);
  if (kelvin)
    law.decay = card.dc > 0.0 ? 1.0 / (card.dc * time) : 0.0;
  else
    law.decay = card.dc / time;
  law.complete();
  if (law.nu < 0.0)
    refuse(b, row[&Viscoelastic::bulk], "G0 and BULK make a negative Poisson's ratio", "3 BULK must be above 2 G0");
  if (card.so != 0.0)
    row[&KelvinMaxwellCard::so].report(b.findings, Severity::note,
                                       "d3plot has no strain in the place of the plastic strain, which is 0");
  add_material(b, row, std::move(title), "MAT_KELVIN-MAXWELL_VISCOELASTIC", kernel::composed_law({law}));
}

// ---- 076

struct GeneralCard : MaterialCard {
  double bulk = 0;
};
const CardOf<GeneralCard> general_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&GeneralCard::bulk, real("bulk", dimension::stress, required, above_zero(), "bulk modulus")},
    real("pcf", dimension::number, 0, only(0), "1: no tensile pressure: not built"),
    real("ef", dimension::number, 0, only(0), "1: the layer is elastic: not built"),
    real("tref", dimension::number, 0, only(0), "temperature of the constants: decay that shifts with it is not built"),
    real("a", dimension::number, 0, any_value, "of that shift"),
    real("b", dimension::number, 0, any_value, "of that shift"),
};
const CardOf<GeneralCard> fit_card{
    id("lcid", IdSpace::function, 0, "relaxation curve that a series would be fitted to"),
    integer("nt", 0, any_value, "of that fit"),
    real("bstart", dimension::number, 0, any_value, "of that fit"),
    real("tramp", dimension::number, 0, any_value, "of that fit"),
    id("lcidk", IdSpace::function, 0, "the same of the volume"),
    integer("ntk", 0, any_value, "of that fit"),
    real("bstartk", dimension::number, 0, any_value, "of that fit"),
    real("trampk", dimension::number, 0, any_value, "of that fit"),
};
using Branch = kernel::Overstress::MaxwellBranch;
const CardOf<Branch> term_card{
    {&Branch::shear, real("gi", dimension::stress, 0, at_least(0), "shear modulus of a term")},
    {&Branch::decay, real("betai", dimension::rate, 0, at_least(0), "its decay; 0: the term stays")},
    real("ki", dimension::stress, 0, only(0), "bulk modulus of a term: relaxation of the volume is not built"),
    real("betaki", dimension::rate, 0, any_value, "its decay"),
};

void read_general(Builder& b, const Block& block, const Options& options) {
  constexpr std::size_t most_terms = 18;
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(general_card);
  const auto fit = cursor.read(fit_card);
  for (const char* curve : {"lcid", "lcidk"})
    refuse_nonzero(b, fit.entry(curve), "a series is not fitted to a relaxation curve",
                   "leave the card blank, and give GI and BETAI of each term");
  kernel::GeneralViscoelastic law;
  law.bulk = row->bulk;
  double shear = 0.0;
  while (cursor.more()) {
    const auto term = cursor.read(term_card);
    if (!(term->shear > 0.0)) continue;
    if (law.overstress.maxwell_branches.size() == most_terms) {
      refuse(b, term[&Branch::shear], "more than eighteen terms are not supported");
      break;
    }
    law.overstress.maxwell_branches.push_back(*term);
    shear += term->shear;
  }
  if (!(shear > 0.0)) {
    refuse(b, row[&GeneralCard::bulk], "there is no shear modulus", "give GI and BETAI of at least one term");
    shear = row->bulk;
  }
  law.E = 9.0 * law.bulk * shear / (3.0 * law.bulk + shear);
  law.nu = (3.0 * law.bulk - 2.0 * shear) / (6.0 * law.bulk + 2.0 * shear);
  if (law.nu < 0.0)
    refuse(b, row[&GeneralCard::bulk], "BULK and the sum of GI make a negative Poisson's ratio",
           "3 BULK must be above twice the sum of GI");
  add_material(b, row, std::move(title), "MAT_GENERAL_VISCOELASTIC", kernel::composed_law({law}));
}

}  // namespace

std::vector<Keyword> viscoelastic_keywords() {
  return {{.name = "MAT_KELVIN-MAXWELL_VISCOELASTIC",
           .aliases = {"MAT_061"},
           .options = {"TITLE"},
           .layout = {{"", &kelvin_maxwell_card}},
           .read = read_kelvin_maxwell},
          {.name = "MAT_GENERAL_VISCOELASTIC",
           .aliases = {"MAT_076"},
           .options = {"TITLE"},
           .layout = {{"", &general_card}, {"blank", &fit_card}, {"one a term", &term_card}},
           .read = read_general}};
}

}  // namespace nugget::reading
