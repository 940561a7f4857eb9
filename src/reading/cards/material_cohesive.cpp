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
using deck::Row;

constexpr Dimension stiffness{1, -2, -2}, energy_per_area{1, 0, -2};

constexpr Field roflg = integer("roflg", 0, between(0, 1), "density per volume (0), or per area (1)");
constexpr Field intfail =
    real("intfail", dimension::number, 0, between(0, 4),
         "failed points that delete the brick, 1 to 4; 0: none do, and the points are the corners");
constexpr Field density_per_area =
    real("ro", dimension::mass_per_area, required, above_zero(), "density, per area with ROFLG = 1");

Card mixed_card_of(Field ro) {
  return {{
      material_id,
      std::move(ro),
      roflg,
      intfail,
      real("en", stiffness, required, above_zero(), "stiffness normal to the surface, traction over separation"),
      real("et", stiffness, required, above_zero(), "stiffness along the surface"),
      real("gic", energy_per_area, required, above_zero(), "energy per area that parts the faces by tension"),
      real("giic", energy_per_area, required, above_zero(), "the same by shear"),
  }};
}
const Card mixed_card = mixed_card_of(density);
const Card mixed_card_by_area = mixed_card_of(density_per_area);

const Card mixed_limits_card{{
    real("xmu", dimension::number, required, any_value,
         "exponent of mixed modes: above 0, power law; below 0, its size in the law of Benzeggagh and Kenane"),
    real("t", dimension::stress, 0, at_least(0), "highest normal traction; 0: from UND"),
    real("s", dimension::stress, 0, at_least(0), "highest tangential traction; 0: from UTD"),
    real("und", dimension::length, 0, at_least(0), "normal separation at failure, where T is 0"),
    real("utd", dimension::length, 0, at_least(0), "tangential separation at failure, where S is 0"),
    real("gamma", dimension::number, 1, above_zero(), "exponent of the mean stiffness in Benzeggagh and Kenane's law"),
    real("cts", dimension::number, 0, any_value, "tangent stiffness of nonlinear implicit runs, no effect"),
}};

Card elastic_card_of(Field ro) {
  return {{
      material_id,
      std::move(ro),
      roflg,
      intfail,
      real("et", stiffness, required, above_zero(), "stiffness along the surface, traction over separation"),
      real("en", stiffness, required, above_zero(), "stiffness normal to the surface"),
      real("fn_fail", dimension::stress, 0, at_least(0), "normal traction at which a point fails; 0: none"),
      real("ft_fail", dimension::stress, 0, at_least(0), "tangential traction at which a point fails; 0: none"),
  }};
}
const Card elastic_card = elastic_card_of(density);
const Card elastic_card_by_area = elastic_card_of(density_per_area);

Card layer_card_of(Field ro) {
  return {{
      material_id,
      std::move(ro),
      roflg,
      intfail,
      real("emod", dimension::stress, required, above_zero(), "Young's modulus of the layer"),
      real("gmod", dimension::stress, required, above_zero(), "shear modulus of the layer"),
      real("thick", dimension::length, 0, any_value, "thickness of the layer; 0 or less: that of each brick"),
      real("inicrt", dimension::number, 0, only(0), "criterion of yield: 0, an ellipse of the tractions"),
  }};
}
const Card layer_card = layer_card_of(density);
const Card layer_card_by_area = layer_card_of(density_per_area);
constexpr std::array<std::string_view, 8> tension_fields{"g1c_0", "g1c_inf", "edot_g1", "t0",
                                                         "t1",    "edot_t",  "fg1",     "lcg1c"};
constexpr std::array<std::string_view, 8> shear_fields{"g2c_0", "g2c_inf", "edot_g2", "s0",
                                                       "s1",    "edot_s",  "fg2",     "lcg2c"};
Card mode_card(const std::array<std::string_view, 8>& f) {
  return elastoplastic_mode_card(f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]);
}
const Card tension_card = mode_card(tension_fields);
const Card shear_card = mode_card(shear_fields);
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
kernel::CohesiveBond bond_of_row(Builder& b, const Row& row, std::string_view normal = "en",
                                 std::string_view tangential = "et") {
  kernel::CohesiveBond bond;
  bond.stiffness = {row.real(normal), row.real(tangential)};
  bond.density_by_area = row.integer("roflg") == 1;
  const double points = row.real("intfail");
  if (points != std::floor(points)) refuse(b, row, "intfail", "expected a whole number of points", "write 1");
  bond.points_to_delete = static_cast<int>(points);
  return bond;
}

void add_bond(Builder& b, const Row& row, std::string title, std::string_view name, kernel::CohesiveBond bond) {
  kernel::LawComponents law;
  law.flow = kernel::Elastic{};
  law.bond = std::make_shared<const kernel::CohesiveBond>(std::move(bond));
  add_material(b, row, std::move(title), name, kernel::composed_law(std::move(law)));
}

/// T or S, given or by the separation at failure: their triangle has the energy G.
double peak(Builder& b, const Row& limits, std::string_view field, std::string_view ultimate, double energy) {
  const double given = limits.real(field), u = limits.real(ultimate);
  if (given == 0.0 && u == 0.0) {
    refuse(b, limits, field, "either the highest traction or the separation at failure must be given",
           "give the traction; the separation at failure follows from the energy");
    return 0.0;
  }
  if (given == 0.0) return 2.0 * energy / u;
  if (u > 0.0 && std::abs(u - 2.0 * energy / given) > 0.01 * u)
    limits.report(b.findings, Severity::warning, ultimate,
                  fmt::format("is not looked at where the traction is given: with the energy it makes {:.4g}",
                              2.0 * energy / given),
                  "leave it 0");
  return given;
}

/// The peak must come before the failure: 2 G > T^2/EN (the check of the manual's remarks).
void check_energy(Builder& b, const Row& row, std::string_view field, double energy, double strength,
                  double stiffness_of_mode) {
  const double least = strength * strength / (2.0 * stiffness_of_mode);
  if (!(strength > 0.0 && energy > 0.0 && stiffness_of_mode > 0.0) || energy > least) return;
  refuse(b, row, field,
         fmt::format("{:.4g} is too small: up to its highest traction {:.4g} at the stiffness {:.4g} the bond takes "
                     "{:.4g} of energy per area already",
                     energy, strength, stiffness_of_mode, least),
         "raise the stiffness, lower the traction, or correct the energy");
}

void read_mixed_mode(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(by_area(cursor) ? mixed_card_by_area : mixed_card);
  const Row limits = cursor.read(mixed_limits_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  kernel::Cohesion& glue = bond.glue;
  glue.softening = kernel::Cohesion::Softening::by_energy;
  glue.normal_energy = row.real("gic");
  glue.shear_energy = row.real("giic");
  glue.exponent = limits.real("xmu");
  bond.stiffness_exponent = limits.real("gamma");
  glue.normal_strength = peak(b, limits, "t", "und", glue.normal_energy);
  glue.shear_strength = peak(b, limits, "s", "utd", glue.shear_energy);
  check_energy(b, row, "gic", glue.normal_energy, glue.normal_strength, bond.stiffness.tension);
  check_energy(b, row, "giic", glue.shear_energy, glue.shear_strength, bond.stiffness.shear);
  if (limits.real("cts") >= 2.0)
    limits.report(b.findings, Severity::warning, "cts",
                  "the law of Ortiz and Pandolfi is not built; the bilinear one "
                  "is computed",
                  "leave it 0");
  add_bond(b, row, std::move(title), "MAT_COHESIVE_MIXED_MODE", std::move(bond));
}

void read_elastic_bond(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(by_area(cursor) ? elastic_card_by_area : elastic_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row);
  bond.glue.normal_strength = row.real("fn_fail");
  bond.glue.shear_strength = row.real("ft_fail");
  add_bond(b, row, std::move(title), "MAT_COHESIVE_ELASTIC", std::move(bond));
}

void read_layer(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(by_area(cursor) ? layer_card_by_area : layer_card);
  const Row tension = cursor.read(tension_card), shear = cursor.read(shear_card);
  if (!at_end(cursor)) cursor.read(layer_options_card);
  expect_end(b, cursor);
  kernel::CohesiveBond bond = bond_of_row(b, row, "emod", "gmod");
  kernel::Cohesion& glue = bond.glue;
  glue.softening = kernel::Cohesion::Softening::elastoplastic;
  glue.thickness = std::max(0.0, row.real("thick"));
  glue.tension = elastoplastic_mode(b, tension, tension_fields);
  glue.shear = elastoplastic_mode(b, shear, shear_fields);
  if (glue.thickness > 0.0) {
    const kernel::CohesiveStiffness k = bond.stiffness_in(0.0);
    const auto beyond_plateau = [](const kernel::ElastoplasticMode& m) {
      return m.energy * (1.0 - std::max(0.0, m.plateau));
    };
    check_energy(b, tension, "g1c_0", beyond_plateau(glue.tension), glue.tension.yield, k.tension);
    check_energy(b, shear, "g2c_0", beyond_plateau(glue.shear), glue.shear.yield, k.shear);
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
           .layout = {{"", &elastic_card}},
           .read = read_elastic_bond},
          {.name = "MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE",
           .aliases = {"MAT_240"},
           .options = {"TITLE"},
           .layout = {{"", &layer_card}, {"", &tension_card}, {"", &shear_card}, {"", &layer_options_card}},
           .read = read_layer}};
}

}  // namespace nugget::reading
