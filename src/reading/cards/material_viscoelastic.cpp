// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_KELVIN-MAXWELL_VISCOELASTIC.
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

}  // namespace

std::vector<Keyword> kelvin_maxwell_keywords() {
  return {{.name = "MAT_KELVIN-MAXWELL_VISCOELASTIC",
           .aliases = {"MAT_061"},
           .options = {"TITLE"},
           .layout = {{"", &kelvin_maxwell_card}},
           .read = read_kelvin_maxwell}};
}

}  // namespace nugget::reading
