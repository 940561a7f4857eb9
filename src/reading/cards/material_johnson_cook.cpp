// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/equation_of_state.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_... of Johnson and Cook.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using kernel::JohnsonCook;
using kernel::JohnsonCookFracture;

// ---- 098, 099

/// All cards of *MAT_SIMPLIFIED_JOHNSON_COOK..., those of the yield stress in the law itself.
struct SimplifiedCards : MaterialCard, JohnsonCook {
  double psfail = 0, eppfr = 0, numint = 0;
  int lcdm = 0;
};

const CardOf<SimplifiedCards> simplified_johnson_cook_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&JohnsonCook::E, young},
    {&JohnsonCook::nu, poisson},
    vp,
};

const CardOf<SimplifiedCards> simplified_johnson_cook_yield_card{
    {&JohnsonCook::yield, real("a", dimension::stress, required, above_zero(), "yield stress at rest")},
    {&JohnsonCook::hardening,
     real("b", dimension::stress, 0, at_least(0), "hardening: factor of the power of the plastic strain")},
    {&JohnsonCook::exponent, real("n", dimension::number, 0, at_least(0), "hardening: exponent of the plastic strain")},
    {&JohnsonCook::rate_factor,
     real("c", dimension::number, 0, at_least(0), "factor of the logarithm of the rate; 0: no rate effect")},
    {&SimplifiedCards::psfail,
     real("psfail", dimension::number, 1e17, at_least(0), "plastic strain at failure; 0: none")},
    {&JohnsonCook::static_stress_limit,
     real("sigmax", dimension::stress, 1e28, at_least(0), "greatest yield stress before rate effects; 0: none")},
    {&JohnsonCook::saturation,
     real("sigsat", dimension::stress, 1e28, at_least(0), "greatest yield stress with rate effects; 0: none")},
    {&JohnsonCook::reference_rate,
     real("epso", dimension::rate, 1, above_zero(), "rate up to which there is no rate effect")},
};

const CardOf<SimplifiedCards> orthotropic_johnson_cook_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&JohnsonCook::E, young},
    {&JohnsonCook::nu, poisson},
    vp,
    {&SimplifiedCards::eppfr,
     real("eppfr", dimension::number, 1e16, at_least(0), "principal plastic strain at rupture")},
    {&SimplifiedCards::lcdm,
     id("lcdm", IdSpace::function, 0, "curve: damage over principal plastic strain beyond PSFAIL")},
    {&SimplifiedCards::numint, numint},
};

/// All cards of *MAT_JOHNSON_COOK.
struct JohnsonCookCards : MaterialCard, JohnsonCook, JohnsonCookFracture {
  double g = 0, dtf = 0, vp = 0;         // of the first card
  double m = 0, tm = 0, tr = 0, cp = 0;  // of heating by plastic work
  double pc = 0, spall = 0, numint = 0;  // of failure
};
const CardOf<JohnsonCookCards> johnson_cook_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&JohnsonCookCards::g, real("g", dimension::stress, 0, at_least(0),
                                "shear modulus, of solids with an equation of state; 0: of E and PR")},
    {&JohnsonCook::E,
     real("e", dimension::stress, 0, at_least(0), "Young's modulus; solids with an equation of state need none")},
    {&JohnsonCook::nu, poisson},
    {&JohnsonCookCards::dtf,
     real("dtf", dimension::time, 0, at_least(0), "smallest time step of a shell before it is deleted; 0: none")},
    {&JohnsonCookCards::vp, vp},
    real("rateop", dimension::number, 0, only(0), "form of the rate effect: 0, the logarithm"),
};

const CardOf<JohnsonCookCards> johnson_cook_yield_card{
    {&JohnsonCook::yield, real("a", dimension::stress, required, above_zero(), "yield stress at rest and cold")},
    {&JohnsonCook::hardening,
     real("b", dimension::stress, 0, at_least(0), "hardening: factor of the power of the plastic strain")},
    {&JohnsonCook::exponent, real("n", dimension::number, 0, at_least(0), "hardening: exponent of the plastic strain")},
    {&JohnsonCook::rate_factor,
     real("c", dimension::number, 0, at_least(0), "factor of the logarithm of the rate; 0: no rate effect")},
    {&JohnsonCookCards::m,
     real("m", dimension::number, 0, at_least(0), "softening: exponent of the relative temperature")},
    {&JohnsonCookCards::tm, real("tm", dimension::number, 0, any_value, "temperature of melting")},
    {&JohnsonCookCards::tr, real("tr", dimension::number, 0, any_value, "temperature at the start")},
    {&JohnsonCook::reference_rate,
     real("epso", dimension::rate, 1, above_zero(), "rate up to which there is no rate effect")},
};

const CardOf<JohnsonCookCards> johnson_cook_heat_card{
    {&JohnsonCookCards::cp,
     real("cp", {0, 2, -2}, 0, at_least(0), "heat capacity a mass and degree; 0: plastic work does not heat")},
    {&JohnsonCookCards::pc, real("pc", dimension::stress, 0, any_value,
                                 "tension carried by solids with an equation of state, as a pressure below 0; 0: any")},
    {&JohnsonCookCards::spall,
     real(
         "spall", dimension::number, 2, between(0, 3),
         "at PC 1: the pressure falls no further; 2 (and 0): a point breaks by its largest principal stress, 3: by its "
         "mean stress")},
    real("it", dimension::number, 0, any_value, "iteration of plastic strain, for solids only"),
    {&JohnsonCookFracture::d1, real("d1", dimension::number, 0, any_value, "strain at fracture; D1 to D5 0: none")},
    {&JohnsonCookFracture::d2,
     real("d2", dimension::number, 0, any_value, "strain at fracture: factor of exp(D3 mean over effective stress)")},
    {&JohnsonCookFracture::d3,
     real("d3", dimension::number, 0, any_value, "strain at fracture; below 0: less under tension")},
    {&JohnsonCookFracture::d4,
     real("d4", dimension::number, 0, any_value, "strain at fracture: factor of the logarithm of the rate")},
};

const CardOf<JohnsonCookCards> johnson_cook_fracture_card{
    {&JohnsonCookFracture::d5,
     real("d5", dimension::number, 0, any_value, "strain at fracture: factor of the relative temperature")},
    real("c2", dimension::number, 0, any_value, "for RATEOP other than 0 only"),
    real("erod", dimension::number, 0, only(0), "0: an element that fails is deleted"),
    {&JohnsonCookFracture::least, real("efmin", dimension::number, 1e-6, at_least(0), "least strain at fracture")},
    {&JohnsonCookCards::numint, numint},
    real("k", dimension::number, 0, any_value, "for RATEOP 5 only"),
    real("eps1", dimension::rate, 0, any_value, "for RATEOP 5 only"),
    real("dmodel", dimension::number, 0, only(0), "damage model: 0, of Johnson and Cook"),
};

void read_simplified_johnson_cook(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  SimplifiedCards cards;
  const auto row = cursor.read(simplified_johnson_cook_card, cards);
  cursor.read(simplified_johnson_cook_yield_card, cards);
  expect_end(b, cursor);
  kernel::LawComponents law{static_cast<const JohnsonCook&>(cards)};
  law.failure_strain = plastic_strain_at_failure(cards.psfail);
  add_material(b, row, std::move(title), "MAT_SIMPLIFIED_JOHNSON_COOK", composed_law(std::move(law)));
}

void read_orthotropic_johnson_cook(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  SimplifiedCards cards;
  const auto row = cursor.read(orthotropic_johnson_cook_card, cards);
  const auto yield = cursor.read(simplified_johnson_cook_yield_card, cards);
  expect_end(b, cursor);
  const Index material = add_material(b, row, std::move(title), "MAT_SIMPLIFIED_JOHNSON_COOK_ORTHOTROPIC_DAMAGE",
                                      kernel::Elastic{cards.E, cards.nu});
  b.defer(Phase::parts, [=](Builder& later) {
    kernel::LawComponents law{static_cast<const JohnsonCook&>(cards)};
    law.directional_damage = plastic_damage(later, yield[&SimplifiedCards::psfail], row[&SimplifiedCards::eppfr],
                                            row[&SimplifiedCards::lcdm]);
    law.points_to_delete = cards.numint;
    law.for_layers_only = true;
    later.model.materials[material].law = composed_law(std::move(law));
  });
}

// ---- 015

/// Heating by plastic work, where CP is given. `yield`: the second card.
void heat(Builder& b, const RowOf<JohnsonCookCards>& yield, const JohnsonCookCards& cards, JohnsonCook& flow) {
  if (!(cards.cp > 0.0)) return;
  if (!(cards.tm > cards.tr))
    return refuse(b, yield[&JohnsonCookCards::tm], "with CP the temperature of melting must lie above TR",
                  "give TM and TR, or CP 0");
  if (!(cards.m > 0.0))
    return refuse(b, yield[&JohnsonCookCards::m], "with CP the exponent M must be above 0", "give M, or CP 0");
  flow.heating = 1.0 / (cards.ro * cards.cp);
  flow.melting_rise = cards.tm - cards.tr;
  flow.softening = cards.m;
}

/// Solids of *MAT_JOHNSON_COOK have an equation of state, or an elastic bulk modulus; shells have the latter.
void check_equation_of_state(Builder& b, const Part& part, const deck::RowOf<PartCard>& row) {
  const auto& law = std::get<kernel::ComposedLaw>(b.model.materials[part.material].law);
  const bool is_solid = part.kind == ElementKind::solid;
  if (is_solid && law.components->state) return;
  if (is_solid && row->eosid != 0)
    refuse_unknown_state(b, row);
  else if (!(law.E > 0.0))
    refuse(b, row[&PartCard::mid], "*MAT_JOHNSON_COOK without an equation of state needs E and PR", "give them");
  else if (!is_solid && law.components->spall)
    row[&PartCard::mid].report(
        b.findings, Severity::warning,
        "PC and SPALL of *MAT_JOHNSON_COOK are not obeyed in shells: no element is deleted by tension",
        "use *MAT_ADD_EROSION with SIGP1, or leave PC 0");
  else if (is_solid)
    row[&PartCard::eosid].report(
        b.findings, Severity::warning,
        "*MAT_JOHNSON_COOK in solids without an equation of state, which LS-DYNA demands: pressure and shear "
        "are those of E and PR",
        "write *EOS_LINEAR_POLYNOMIAL with C1 = E/(3 (1 - 2 PR))");
}

void read_johnson_cook(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  JohnsonCookCards cards;
  const auto row = cursor.read(johnson_cook_card, cards);
  const auto yield = cursor.read(johnson_cook_yield_card, cards);
  const auto third = cursor.read(johnson_cook_heat_card, cards);
  cursor.read(johnson_cook_fracture_card, cards);
  expect_end(b, cursor);
  JohnsonCook flow = cards;
  heat(b, yield, cards, flow);
  kernel::LawComponents law{flow};
  JohnsonCookFracture fracture = cards;
  fracture.reference_rate = flow.reference_rate;
  fracture.melting_rise = flow.heating > 0.0 ? flow.melting_rise : 0.0;
  fracture.by_plastic_rate = cards.vp == 1.0;
  if (fracture.d1 != 0.0 || fracture.d2 != 0.0 || fracture.d3 != 0.0 || fracture.d4 != 0.0 || fracture.d5 != 0.0)
    law.rules = {fracture};
  if (fracture.d2 > 0.0 && fracture.d3 > 0.0)
    third[&JohnsonCookFracture::d3].report(
        b.findings, Severity::warning,
        "tension is positive here: with D3 above 0 the strain at fracture grows with tension",
        "published constants have a D3 below 0");
  law.points_to_delete = cards.numint;
  law.deletion_step = cards.dtf;
  law.solid_shear = cards.g;
  if (cards.pc < 0.0) {
    const int form = static_cast<int>(cards.spall);
    law.spall = kernel::Spall{static_cast<kernel::Spall::Form>(form == 0 ? 2 : form), -cards.pc};
  }
  const Index material = add_material(b, row, std::move(title), "MAT_JOHNSON_COOK", composed_law(std::move(law)));
  b.part_checks[material] = check_equation_of_state;
}

}  // namespace

std::vector<Keyword> johnson_cook_keywords() {
  return {
      {.name = "MAT_JOHNSON_COOK",
       .aliases = {"MAT_015"},
       .options = {"TITLE"},
       .layout = {{"", &johnson_cook_card},
                  {"", &johnson_cook_yield_card},
                  {"", &johnson_cook_heat_card},
                  {"", &johnson_cook_fracture_card}},
       .read = read_johnson_cook},
      {.name = "MAT_SIMPLIFIED_JOHNSON_COOK",
       .aliases = {"MAT_098"},
       .options = {"TITLE"},
       .layout = {{"", &simplified_johnson_cook_card}, {"", &simplified_johnson_cook_yield_card}},
       .read = read_simplified_johnson_cook},
      {.name = "MAT_SIMPLIFIED_JOHNSON_COOK_ORTHOTROPIC_DAMAGE",
       .aliases = {"MAT_099"},
       .options = {"TITLE"},
       .layout = {{"", &orthotropic_johnson_cook_card}, {"", &simplified_johnson_cook_yield_card}},
       .read = read_orthotropic_johnson_cook},
  };
}

}  // namespace nugget::reading
