// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/orthotropic_fields.hpp"

// *MAT_COMPOSITE_DAMAGE and *MAT_ENHANCED_COMPOSITE_DAMAGE.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using kernel::CompositeLayer;
using kernel::Orthotropic;
using Rule = CompositeLayer::Rule;

/// All cards of both keywords.
struct CompositeCards : MaterialCard, CompositeLayer, AxesCards {
  double beta = 0;  // of 022: MANGLE of 054
  double tfail = 0, dfailc = 0, crit = 54, pel = 0;
  double slimt1 = 0, slimc1 = 0, slimt2 = 0, slimc2 = 0, slims = 0;
};

constexpr Dimension over_stress_cubed{-3, 3, 6};
constexpr RealField strength(std::string_view name, std::string_view meaning) {
  return real(name, dimension::stress, required, above_zero(), meaning);
}
constexpr RealField of_bricks(std::string_view name, std::string_view meaning) {
  return real(name, dimension::stress, 0, any_value, meaning);
}
constexpr RealField along_b =
    real("eb", dimension::stress, required, above_zero(), "Young's modulus across the fibres");

const CardOf<CompositeCards> fibres_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&Orthotropic::young_a,
     real("ea", dimension::stress, required, above_zero(), "Young's modulus along the fibres, a")},
    {&Orthotropic::young_b, along_b},
    {&Orthotropic::young_c, real("ec", dimension::stress, 0, at_least(0), "Young's modulus along c; 0: EB")},
    {&Orthotropic::poisson_ba, orthotropy::ratio_ba},
    {&Orthotropic::poisson_ca, orthotropy::ratio_ca},
    {&Orthotropic::poisson_cb, orthotropy::ratio_cb},
};

const CardOf<CompositeCards> shears_of_022_card{
    {&Orthotropic::shear_ab, orthotropy::shear_ab},
    {&Orthotropic::shear_bc, orthotropy::shear_bc},
    {&Orthotropic::shear_ca, orthotropy::shear_ca},
    of_bricks("kfail", "bulk modulus of failed solids, no effect in shells"),
    {&AxesCards::aopt, aopt::option},
    aopt::macf,
    integer("atrack", 0, only(0), "axes that follow the deformation"),
};

const CardOf<CompositeCards> vector_of_022_card{
    aopt::xp, aopt::yp, aopt::zp, {&AxesCards::a1, aopt::a1}, {&AxesCards::a2, aopt::a2}, {&AxesCards::a3, aopt::a3},
};

const CardOf<CompositeCards> angle_of_022_card = axes_vectors_card<CompositeCards>({
    {&CompositeCards::beta, real("beta", dimension::number, 0, any_value, "angle of AOPT 0 and 3 [degrees]")},
});

constexpr RealField cube_of_shear =
    real("alph", over_stress_cubed, 0, at_least(0), "shear strain ab is tau/GAB + ALPH tau^3");

const CardOf<CompositeCards> strengths_of_022_card{
    {&CompositeLayer::shear_strength, strength("sc", "shear strength ab")},
    {&CompositeLayer::tension_a, strength("xt", "tensile strength along the fibres")},
    {&CompositeLayer::tension_b, strength("yt", "tensile strength across the fibres")},
    {&CompositeLayer::compression_b, strength("yc", "compressive strength across the fibres")},
    {&CompositeLayer::shear_cube, cube_of_shear},
    of_bricks("sn", "tensile strength c of solids, no effect in shells"),
    of_bricks("syz", "shear strength of solids, no effect in shells"),
    of_bricks("szx", "the same"),
};

const CardOf<CompositeCards> shears_of_054_card{
    {&Orthotropic::shear_ab, orthotropy::shear_ab},
    {&Orthotropic::shear_bc, orthotropy::shear_bc},
    {&Orthotropic::shear_ca, orthotropy::shear_ca},
    of_bricks("kf", "bulk modulus of failed material, not used"),
    {&AxesCards::aopt, aopt::option},
    real("2way", dimension::number, 0, only(0), "fibres in both directions"),
    real("ti", dimension::number, 0, only(0), "transversely isotropic solids"),
};

const CardOf<CompositeCards> vector_of_054_card{
    aopt::xp,
    aopt::yp,
    aopt::zp,
    {&AxesCards::a1, aopt::a1},
    {&AxesCards::a2, aopt::a2},
    {&AxesCards::a3, aopt::a3},
    {&CompositeCards::beta, real("mangle", dimension::number, 0, any_value, "angle of AOPT 0 and 3 [degrees]")},
};

const CardOf<CompositeCards> strains_of_054_card = axes_vectors_card<CompositeCards>({
    {&CompositeLayer::failure_strain_m,
     real("dfailm", dimension::number, 0, at_least(0),
          "strain across the fibres, either way, at which the layer fails; 0: none; only with DFAILT")},
    {&CompositeLayer::failure_strain_s,
     real("dfails", dimension::number, 0, at_least(0),
          "tensorial shear strain ab at which the layer fails; 0: none; only with DFAILT")},
});

const CardOf<CompositeCards> failure_of_054_card{
    {&CompositeCards::tfail, real("tfail", dimension::time, 0, any_value,
                                  "smallest time step of an element before it is deleted, up to 0.1; 0: none")},
    {&CompositeLayer::shear_cube, cube_of_shear},
    {&CompositeLayer::soft,
     real("soft", dimension::number, 1, above_zero(), "factor on the strengths beside deleted elements, with TFAIL")},
    {&CompositeLayer::crushed_tension, real("fbrt", dimension::number, 0, between(0, 1),
                                            "factor on XT after compressive failure of the matrix; 0: none")},
    {&CompositeLayer::crushed_compression,
     real("ycfac", dimension::number, 2, above_zero(), "XC is YCFAC YC after it, where that is less")},
    {&CompositeLayer::failure_strain_t,
     real("dfailt", dimension::number, 0, at_least(0),
          "tensile strain along the fibres at which the layer fails; 0: it fails with its fibres in tension")},
    {&CompositeCards::dfailc, real("dfailc", dimension::number, 0, between(-1, 0),
                                   "compressive strain along the fibres at which the layer fails, below 0")},
    {&CompositeLayer::effective_failure_strain,
     real("efs", dimension::number, 0, at_least(0), "effective strain at which the layer fails; 0: none")},
};

const CardOf<CompositeCards> strengths_of_054_card{
    {&CompositeLayer::compression_a, strength("xc", "compressive strength along the fibres, positive")},
    {&CompositeLayer::tension_a, strength("xt", "tensile strength along the fibres")},
    {&CompositeLayer::compression_b, strength("yc", "compressive strength across the fibres, positive")},
    {&CompositeLayer::tension_b, strength("yt", "tensile strength across the fibres")},
    {&CompositeLayer::shear_strength, strength("sc", "shear strength ab")},
    {&CompositeCards::crit,
     real("crit", dimension::number, 54, between(54, 55), "matrix: 54 Chang and Chang, 55 Tsai and Wu")},
    {&CompositeLayer::shear_weight,
     real("beta", dimension::number, 0, between(0, 1), "weight of shear in the index of fibres in tension")},
};

const CardOf<CompositeCards> shear_damage_of_054_card{
    real("pfl", dimension::number, 100, any_value, "share of layers that fail before SOFT begins, no effect without"),
    real("epsf", dimension::number, 0, only(0), "transverse shear strain at which damage begins"),
    real("epsr", dimension::number, 0, any_value, "the same where it ends, no effect without EPSF"),
    real("tsmd", dimension::number, 0.9, any_value, "most of this damage, no effect without EPSF"),
    real("soft2", dimension::number, 1, only(1), "as SOFT, across the direction of crushing"),
};

constexpr RealField rest_of_stress(std::string_view name, std::string_view meaning) {
  return real(name, dimension::number, 0, between(0, 1), meaning);
}
const CardOf<CompositeCards> limits_of_054_card{
    {&CompositeCards::slimt1, rest_of_stress("slimt1", "left of the tension along the fibres after failure; 0: all")},
    {&CompositeCards::slimc1, rest_of_stress("slimc1", "the same of compression along the fibres")},
    {&CompositeCards::slimt2, rest_of_stress("slimt2", "the same of tension across the fibres")},
    {&CompositeCards::slimc2, rest_of_stress("slimc2", "the same of compression across the fibres")},
    {&CompositeCards::slims, rest_of_stress("slims", "the same of shear")},
    {&CompositeLayer::cycles_of_loss,
     real("ncyred", dimension::number, 100, at_least(1), "cycles over which the stress falls to it")},
    real("softg", dimension::number, 1, only(1), "as SOFT, on transverse shear moduli"),
};

constexpr RealField strength_curve(std::string_view name) {
  return real(name, dimension::number, 0, only(0), "strength over the strain rate");
}
const CardOf<CompositeCards> rates_of_054_card{
    strength_curve("lcxc"),
    strength_curve("lcxt"),
    strength_curve("lcyc"),
    strength_curve("lcyt"),
    strength_curve("lcsc"),
    real("dt", dimension::time, 0, any_value, "averaging of the strain rate, no effect without these curves"),
};

/// The elastic part, and the material.
void add_composite(Builder& b, const Block& block, std::string title, std::string_view name,
                   const RowOf<CompositeCards>& fibres, const deck::Entry& option, const deck::Entry& a1,
                   const deck::Entry& v1, const CompositeCards& cards, double deletion_step) {
  CompositeLayer law = cards;
  complete_orthotropic(b, block, law, cards, cards.beta, {fibres[&Orthotropic::poisson_ba], option, a1, v1});
  kernel::LawComponents components = kernel::components_of(law);
  components.for_layers_only = true;
  components.deletion_step = deletion_step;
  const Index material = add_material(b, fibres, std::move(title), name, kernel::composed_law(std::move(components)));
  take_axes_of_system(b, option, material);
}

void read_composite_damage(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  CompositeCards cards;
  const auto fibres = cursor.read(fibres_card, cards);
  const auto shears = cursor.read(shears_of_022_card, cards);
  const auto first = cursor.read(vector_of_022_card, cards);
  const auto second = cursor.read(angle_of_022_card, cards);
  cursor.read(strengths_of_022_card, cards);
  expect_end(b, cursor);
  cards.rule = Rule::stresses_vanish;
  add_composite(b, block, std::move(title), "MAT_COMPOSITE_DAMAGE", fibres, shears[&AxesCards::aopt],
                first[&AxesCards::a1], second[&AxesCards::v1], cards, 0.0);
}

/// What of the failure of *MAT_ENHANCED_COMPOSITE_DAMAGE is not built, or contradicts itself.
void check_failure_of_fibres(Builder& b, const RowOf<CompositeCards>& strains, const RowOf<CompositeCards>& failure,
                             const RowOf<CompositeCards>& strengths, const CompositeCards& cards) {
  if (cards.crit != 54.0 && cards.crit != 55.0)
    refuse(b, strengths[&CompositeCards::crit], "the criterion is 54 or 55", "write 54 for Chang and Chang");
  if (cards.tfail > 0.1)
    refuse(b, failure[&CompositeCards::tfail],
           "above 0.1 it is a share of the element's first time step, which is not built",
           "give the time step itself, or 0");
  if (cards.tfail == 0.0 && cards.soft != 1.0)
    failure[&CompositeLayer::soft].report(b.findings, Severity::warning, "has no effect without TFAIL",
                                          "give TFAIL, a small time step, or write SOFT 1");
  const bool by_strains = cards.failure_strain_t > 0.0;
  if (by_strains && cards.dfailc == 0.0)
    refuse(b, failure[&CompositeCards::dfailc], "with DFAILT the compressive strain at failure is needed too",
           "give DFAILC, below 0");
  const auto without_effect = [&](const deck::Entry& field, double value) {
    if (value == 0.0) return;
    if (cards.crit == 55.0)
      field.report(b.findings, Severity::note, "strains at failure have no effect with CRIT 55");
    else if (!by_strains)
      field.report(b.findings, Severity::note, "has no effect without DFAILT");
  };
  without_effect(strains[&CompositeLayer::failure_strain_m], cards.failure_strain_m);
  without_effect(strains[&CompositeLayer::failure_strain_s], cards.failure_strain_s);
  without_effect(failure[&CompositeCards::dfailc], cards.dfailc);
  if (cards.crit == 55.0) without_effect(failure[&CompositeLayer::failure_strain_t], cards.failure_strain_t);
}

void read_enhanced_composite(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  CompositeCards cards;
  const auto fibres = cursor.read(fibres_card, cards);
  const auto shears = cursor.read(shears_of_054_card, cards);
  const auto first = cursor.read(vector_of_054_card, cards);
  const auto second = cursor.read(strains_of_054_card, cards);
  const auto failure = cursor.read(failure_of_054_card, cards);
  const auto strengths = cursor.read(strengths_of_054_card, cards);
  if (cursor.more()) cursor.read(shear_damage_of_054_card, cards);
  if (cursor.more()) cursor.read(limits_of_054_card, cards);
  if (cursor.more()) cursor.read(rates_of_054_card, cards);
  expect_end(b, cursor);
  check_failure_of_fibres(b, second, failure, strengths, cards);
  cards.rule = cards.crit == 55.0 ? Rule::tsai_wu : Rule::stresses_stay;
  if (cards.rule == Rule::tsai_wu) cards.failure_strain_t = 0.0;
  cards.failure_strain_c = -cards.dfailc;
  if (!(cards.tfail > 0.0)) cards.soft = 1.0;
  const double slim[] = {cards.slimt1, cards.slimc1, cards.slimt2, cards.slimc2, cards.slims};
  for (std::size_t k = 0; k < cards.left.size(); ++k)
    if (slim[k] > 0.0) cards.left[k] = slim[k];
  add_composite(b, block, std::move(title), "MAT_ENHANCED_COMPOSITE_DAMAGE", fibres, shears[&AxesCards::aopt],
                first[&AxesCards::a1], second[&AxesCards::v1], cards, std::max(cards.tfail, 0.0));
}

}  // namespace

std::vector<Keyword> composite_material_keywords() {
  return {{.name = "MAT_COMPOSITE_DAMAGE",
           .aliases = {"MAT_022"},
           .options = {"TITLE"},
           .layout = {{"", &fibres_card},
                      {"", &shears_of_022_card},
                      {"", &vector_of_022_card},
                      {"", &angle_of_022_card},
                      {"", &strengths_of_022_card}},
           .read = read_composite_damage},
          {.name = "MAT_ENHANCED_COMPOSITE_DAMAGE",
           .aliases = {"MAT_054", "MAT_055", "MAT_054-055"},
           .options = {"TITLE"},
           .layout = {{"", &fibres_card},
                      {"", &shears_of_054_card},
                      {"", &vector_of_054_card},
                      {"", &strains_of_054_card},
                      {"", &failure_of_054_card},
                      {"", &strengths_of_054_card},
                      {"optional", &shear_damage_of_054_card},
                      {"optional", &limits_of_054_card},
                      {"optional", &rates_of_054_card}},
           .read = read_enhanced_composite}};
}

}  // namespace nugget::reading
