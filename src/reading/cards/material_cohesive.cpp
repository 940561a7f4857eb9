// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/law/cohesive_bond.hpp"
#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/contact_glue.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_COHESIVE_..., the laws of adhesive between two faces.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

constexpr Dimension stiffness{1, -2, -2}, energy_per_area{1, 0, -2};

constexpr IntegerField roflg = integer("roflg", 0, between(0, 1), "density per volume (0), or per area (1)");
constexpr RealField intfail =
    real("intfail", dimension::number, 0, between(0, 4),
         "failed points that delete the brick, 1 to 4; 0: none do, and the points are the corners");
constexpr RealField density_per_area =
    real("ro", dimension::mass_per_area, required, above_zero(), "density, per area with ROFLG = 1");

/// All cards of the three laws but those of the modes of MAT_240.
struct CohesiveCards : MaterialCard {
  int roflg = 0;
  double intfail = 0;
  double en = 0, et = 0;  ///< also EMOD, GMOD
  double gic = 0, giic = 0, xmu = 0, t = 0, s = 0, und = 0, utd = 0, gamma = 0, cts = 0;
  double fn_fail = 0, ft_fail = 0, thick = 0;
};

CardOf<CohesiveCards> mixed_card_of(const RealField& ro) {
  return {
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, ro},
      {&CohesiveCards::roflg, roflg},
      {&CohesiveCards::intfail, intfail},
      {&CohesiveCards::en,
       real("en", stiffness, required, above_zero(), "stiffness normal to the surface, traction over separation")},
      {&CohesiveCards::et, real("et", stiffness, required, above_zero(), "stiffness along the surface")},
      {&CohesiveCards::gic,
       real("gic", energy_per_area, required, above_zero(), "energy per area that parts the faces by tension")},
      {&CohesiveCards::giic, real("giic", energy_per_area, required, above_zero(), "the same by shear")},
  };
}
const CardOf<CohesiveCards> mixed_card = mixed_card_of(density);
const CardOf<CohesiveCards> mixed_card_by_area = mixed_card_of(density_per_area);

const CardOf<CohesiveCards> mixed_limits_card{
    {&CohesiveCards::xmu,
     real("xmu", dimension::number, required, any_value,
          "exponent of mixed modes: above 0, power law; below 0, its size in the law of Benzeggagh and Kenane")},
    {&CohesiveCards::t, real("t", dimension::stress, 0, at_least(0), "highest normal traction; 0: from UND")},
    {&CohesiveCards::s, real("s", dimension::stress, 0, at_least(0), "highest tangential traction; 0: from UTD")},
    {&CohesiveCards::und, real("und", dimension::length, 0, at_least(0), "normal separation at failure, where T is 0")},
    {&CohesiveCards::utd,
     real("utd", dimension::length, 0, at_least(0), "tangential separation at failure, where S is 0")},
    {&CohesiveCards::gamma, real("gamma", dimension::number, 1, above_zero(),
                                 "exponent of the mean stiffness in Benzeggagh and Kenane's law")},
    {&CohesiveCards::cts,
     real("cts", dimension::number, 0, any_value, "tangent stiffness of nonlinear implicit runs, no effect")},
};

CardOf<CohesiveCards> elastic_card_of(const RealField& ro) {
  return {
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, ro},
      {&CohesiveCards::roflg, roflg},
      {&CohesiveCards::intfail, intfail},
      {&CohesiveCards::et,
       real("et", stiffness, required, above_zero(), "stiffness along the surface, traction over separation")},
      {&CohesiveCards::en, real("en", stiffness, required, above_zero(), "stiffness normal to the surface")},
      {&CohesiveCards::fn_fail,
       real("fn_fail", dimension::stress, 0, at_least(0), "normal traction at which a point fails; 0: none")},
      {&CohesiveCards::ft_fail,
       real("ft_fail", dimension::stress, 0, at_least(0), "tangential traction at which a point fails; 0: none")},
  };
}
const CardOf<CohesiveCards> cohesive_elastic_card = elastic_card_of(density);
const CardOf<CohesiveCards> elastic_card_by_area = elastic_card_of(density_per_area);

CardOf<CohesiveCards> layer_card_of(const RealField& ro) {
  return {
      {&MaterialCard::mid, material_id},
      {&MaterialCard::ro, ro},
      {&CohesiveCards::roflg, roflg},
      {&CohesiveCards::intfail, intfail},
      {&CohesiveCards::en, real("emod", dimension::stress, required, above_zero(), "Young's modulus of the layer")},
      {&CohesiveCards::et, real("gmod", dimension::stress, required, above_zero(), "shear modulus of the layer")},
      {&CohesiveCards::thick,
       real("thick", dimension::length, 0, any_value, "thickness of the layer; 0 or less: that of each brick")},
      real("inicrt", dimension::number, 0, only(0), "criterion of yield: 0, an ellipse of the tractions"),
  };
}
const CardOf<CohesiveCards> layer_card = layer_card_of(density);
const CardOf<CohesiveCards> layer_card_by_area = layer_card_of(density_per_area);
const CardOf<ElastoplasticModeCard> tension_card =
    elastoplastic_mode_card({"g1c_0", "g1c_inf", "edot_g1", "t0", "t1", "edot_t", "fg1", "lcg1c"});
const CardOf<ElastoplasticModeCard> shear_card =
    elastoplastic_mode_card({"g2c_0", "g2c_inf", "edot_g2", "s0", "s1", "edot_s", "fg2", "lcg2c"});
const Card layer_options_card{{
    real("rfiltf", dimension::number, 0, only(0), "filter of the strain rate"),
    real("compy", dimension::number, 0, only(0), "1: yields under pressure"),
    real("smolim", dimension::number, 0, any_value, "smoother limits of the modes, no effect: they are smooth"),
    real("xmu", dimension::number, 1, only(1), "exponent of the energies at failure"),
    unused(),
    integer("usrfail", 0, only(0), "failure by the user's subroutine"),
}};

bool by_area(const Cursor& cursor) {
  return cursor.peek_number(2) == 1.0;
}

/// What the first card of each law has.
kernel::CohesiveBond bond_of_row(Builder& b, const RowOf<CohesiveCards>& row) {
  kernel::CohesiveBond bond;
  bond.stiffness = {row->en, row->et};
  bond.density_by_area = row->roflg == 1;
  const double points = row->intfail;
  if (points != std::floor(points))
    refuse(b, row[&CohesiveCards::intfail], "expected a whole number of points", "write 1");
  bond.points_to_delete = static_cast<int>(points);
  return bond;
}

void add_bond(Builder& b, const RowOf<CohesiveCards>& row, std::string title, std::string_view name,
              kernel::CohesiveBond bond) {
  kernel::LawComponents law;
  law.flow = kernel::Elastic{};
  law.bond = std::make_shared<const kernel::CohesiveBond>(std::move(bond));
  add_material(b, row, std::move(title), name, kernel::composed_law(std::move(law)));
}

/// T or S, given or by the separation at failure: their triangle has the energy G.
double peak(Builder& b, const deck::Entry& traction, const deck::Entry& ultimate, double energy) {
  const double given = traction.value, u = ultimate.value;
  if (given == 0.0 && u == 0.0) {
    refuse(b, traction, "either the highest traction or the separation at failure must be given",
           "give the traction; the separation at failure follows from the energy");
    return 0.0;
  }
  if (given == 0.0) return 2.0 * energy / u;
  if (u > 0.0 && std::abs(u - 2.0 * energy / given) > 0.01 * u)
    ultimate.report(b.findings, Severity::warning,
                    fmt::format("is not looked at where the traction is given: with the energy it makes {:.4g}",
                                2.0 * energy / given),
                    "leave it 0");
  return given;
}

/// The peak must come before the failure: 2 G > T^2/EN (the check of the manual's remarks).
void check_energy(Builder& b, const deck::Entry& field, double energy, double strength, double stiffness_of_mode) {
  const double least = strength * strength / (2.0 * stiffness_of_mode);
  if (!(strength > 0.0 && energy > 0.0 && stiffness_of_mode > 0.0) || energy > least) return;
  refuse(b, field,
         fmt::format("{:.4g} is too small: up to its highest traction {:.4g} at the stiffness {:.4g} the bond takes "
                     "{:.4g} of energy per area already",
                     energy, strength, stiffness_of_mode, least),
         "raise the stiffness, lower the traction, or correct the energy");
}

void read_mixed_mode(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(by_area(cursor) ? mixed_card_by_area : mixed_card);
  const auto limits = cursor.read(mixed_limits_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  kernel::Cohesion& glue = bond.glue;
  glue.softening = kernel::Cohesion::Softening::by_energy;
  glue.normal_energy = row->gic;
  glue.shear_energy = row->giic;
  glue.exponent = limits->xmu;
  bond.stiffness_exponent = limits->gamma;
  glue.normal_strength = peak(b, limits[&CohesiveCards::t], limits[&CohesiveCards::und], glue.normal_energy);
  glue.shear_strength = peak(b, limits[&CohesiveCards::s], limits[&CohesiveCards::utd], glue.shear_energy);
  check_energy(b, row[&CohesiveCards::gic], glue.normal_energy, glue.normal_strength, bond.stiffness.tension);
  check_energy(b, row[&CohesiveCards::giic], glue.shear_energy, glue.shear_strength, bond.stiffness.shear);
  if (limits->cts >= 2.0)
    limits[&CohesiveCards::cts].report(b.findings, Severity::warning,
                                       "the law of Ortiz and Pandolfi is not built; the bilinear one "
                                       "is computed",
                                       "leave it 0");
  add_bond(b, row, std::move(title), "MAT_COHESIVE_MIXED_MODE", std::move(bond));
}

void read_elastic_bond(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(by_area(cursor) ? elastic_card_by_area : cohesive_elastic_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  bond.glue.normal_strength = row->fn_fail;
  bond.glue.shear_strength = row->ft_fail;
  add_bond(b, row, std::move(title), "MAT_COHESIVE_ELASTIC", std::move(bond));
}

void read_layer(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(by_area(cursor) ? layer_card_by_area : layer_card);
  const auto tension = cursor.read(tension_card), shear = cursor.read(shear_card);
  if (!at_end(cursor)) cursor.read(layer_options_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  kernel::Cohesion& glue = bond.glue;
  glue.softening = kernel::Cohesion::Softening::elastoplastic;
  glue.thickness = std::max(0.0, row->thick);
  glue.tension = elastoplastic_mode(b, tension);
  glue.shear = elastoplastic_mode(b, shear);
  if (glue.thickness > 0.0) {
    const kernel::CohesiveStiffness k = bond.stiffness_in(0.0);
    const auto beyond_plateau = [](const kernel::ElastoplasticMode& m) {
      return m.energy * (1.0 - std::max(0.0, m.plateau));
    };
    check_energy(b, tension[&ElastoplasticModeCard::energy], beyond_plateau(glue.tension), glue.tension.yield,
                 k.tension);
    check_energy(b, shear[&ElastoplasticModeCard::energy], beyond_plateau(glue.shear), glue.shear.yield, k.shear);
  }
  add_bond(b, row, std::move(title), "MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE", std::move(bond));
}

}  // namespace

std::vector<Keyword> cohesive_material_keywords() {
  return {{.name = "MAT_COHESIVE_MIXED_MODE",
           .aliases = {"MAT_138"},
           .options = {"TITLE"},
           .layout = {{"", &mixed_card}, {"", &mixed_limits_card}},
           .read = read_mixed_mode},
          {.name = "MAT_COHESIVE_ELASTIC",
           .aliases = {"MAT_184"},
           .options = {"TITLE"},
           .layout = {{"", &cohesive_elastic_card}},
           .read = read_elastic_bond},
          {.name = "MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE",
           .aliases = {"MAT_240"},
           .options = {"TITLE"},
           .layout = {{"", &layer_card}, {"", &tension_card}, {"", &shear_card}, {"", &layer_options_card}},
           .read = read_layer}};
}

}  // namespace nugget::reading
