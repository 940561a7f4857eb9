// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_... of rubbers with terms that relax. The plain ones have their cards in kernel/law/rubber.hpp.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

using kernel::law_field::compressible;
using kernel::law_field::reference;

Index add_solid_law(Builder& b, const Row& row, std::string title, std::string_view name, kernel::LawComponents law) {
  return add_material(b, row, std::move(title), name, composed_law(std::move(law)));
}

// ---- 077_O, 077_H

constexpr Field friction_shear =
    real("g", dimension::stress, 0, at_least(0), "shear modulus of frictional damping; 0: none");
constexpr Field friction_limit =
    real("sigf", dimension::stress, 0, at_least(0), "greatest effective stress of frictional damping");

/// A line for each stress that relaxes.
const Card relaxation_card{{
    real("gi", dimension::stress, 0, at_least(0), "shear modulus of a stress that relaxes"),
    real("betai", dimension::rate, 0, at_least(0), "its decay"),
    integer("vflag", 0, only(0), "form of the viscous stress: 0, added to that of the energy"),
}};

/// Frictional damping of the first card, and the lines of viscous terms up to the end.
kernel::Overstress read_overstress(Builder& b, Cursor& cursor, const Row& first) {
  constexpr std::size_t most_terms = 12;
  kernel::Overstress overstress;
  if (first.real("g") > 0.0 && first.real("sigf") > 0.0) {
    overstress.friction_shear = first.real("g");
    overstress.friction_limit = first.real("sigf");
  } else if (first.real("g") > 0.0 || first.real("sigf") > 0.0) {
    first.report(b.findings, Severity::warning, first.real("g") > 0.0 ? "sigf" : "g",
                 "frictional damping needs both G and SIGF: there is none", "give both, or neither");
  }
  while (cursor.more()) {
    const Row term = cursor.read(relaxation_card);
    if (!(term.real("gi") > 0.0)) continue;
    if (overstress.maxwell_branches.size() == most_terms) {
      refuse(b, term, "gi", "more than twelve viscous terms are not supported");
      break;
    }
    overstress.maxwell_branches.push_back({term.real("gi"), term.real("betai")});
  }
  return overstress;
}

const Card ogden_card{{
    material_id,
    density,
    compressible,
    integer("n", 0, only(0), "number of terms that would be fitted to a curve"),
    integer("nv", 0, any_value, "viscous terms that would be fitted to a curve"),
    friction_shear,
    friction_limit,
    reference,
}};

const Card ogden_moduli_card{{
    real("mu1", dimension::stress, required, any_value, "modulus of term 1"),
    real("mu2", dimension::stress, 0, any_value, "term 2"),
    real("mu3", dimension::stress, 0, any_value, "term 3"),
    real("mu4", dimension::stress, 0, any_value, "term 4"),
    real("mu5", dimension::stress, 0, any_value, "term 5"),
    real("mu6", dimension::stress, 0, any_value, "term 6"),
    real("mu7", dimension::stress, 0, any_value, "term 7"),
    real("mu8", dimension::stress, 0, any_value, "term 8"),
}};

const Card ogden_exponents_card{{
    real("alpha1", dimension::number, required, any_value, "exponent of term 1"),
    real("alpha2", dimension::number, 0, any_value, "term 2"),
    real("alpha3", dimension::number, 0, any_value, "term 3"),
    real("alpha4", dimension::number, 0, any_value, "term 4"),
    real("alpha5", dimension::number, 0, any_value, "term 5"),
    real("alpha6", dimension::number, 0, any_value, "term 6"),
    real("alpha7", dimension::number, 0, any_value, "term 7"),
    real("alpha8", dimension::number, 0, any_value, "term 8"),
}};

void read_ogden(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(ogden_card);
  const Row moduli = cursor.read(ogden_moduli_card);
  const Row exponents = cursor.read(ogden_exponents_card);
  kernel::Ogden flow;
  flow.overstress = read_overstress(b, cursor, row);
  double shear = 0.0;
  for (int i = 1; i <= 8; ++i) {
    const double mu = moduli.real(fmt::format("mu{}", i)), alpha = exponents.real(fmt::format("alpha{}", i));
    if (mu != 0.0 && alpha != 0.0) flow.terms.push_back({mu, alpha});
    shear += 0.5 * mu * alpha;
  }
  if (!(shear > 0.0)) refuse(b, moduli, "mu1", "the shear modulus, half the sum of MU ALPHA, must be above 0");
  flow.nu = row.real("pr");
  flow.E = 2.0 * shear * (1.0 + flow.nu);
  add_solid_law(b, row, std::move(title), "MAT_OGDEN_RUBBER", {flow});
}

const Card polynomial_card{{
    material_id,
    density,
    compressible,
    integer("n", 0, only(0), "number of constants that would be fitted to a curve"),
    integer("nv", 0, any_value, "viscous terms that would be fitted to a curve"),
    friction_shear,
    friction_limit,
    reference,
}};

const Card polynomial_constants_card{{
    real("c10", dimension::stress, 0, any_value, "constant of J1 - 3"),
    real("c01", dimension::stress, 0, any_value, "constant of J2 - 3"),
    real("c11", dimension::stress, 0, any_value, "constant of (J1 - 3) (J2 - 3)"),
    real("c20", dimension::stress, 0, any_value, "constant of (J1 - 3)^2"),
    real("c02", dimension::stress, 0, any_value, "constant of (J2 - 3)^2"),
    real("c30", dimension::stress, 0, any_value, "constant of (J1 - 3)^3"),
    real("therml", dimension::number, 0, only(0), "constants by curves over temperature"),
}};

void read_polynomial(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(polynomial_card);
  const Row c = cursor.read(polynomial_constants_card);
  kernel::PolynomialRubber flow;
  flow.c10 = c.real("c10");
  flow.c01 = c.real("c01");
  flow.c11 = c.real("c11");
  flow.c20 = c.real("c20");
  flow.c02 = c.real("c02");
  flow.c30 = c.real("c30");
  flow.overstress = read_overstress(b, cursor, row);
  const double shear = 2.0 * (flow.c10 + flow.c01);
  if (!(shear > 0.0)) refuse(b, c, "c10", "the shear modulus, 2 (C10 + C01), must be above 0");
  flow.nu = row.real("pr");
  flow.E = 2.0 * shear * (1.0 + flow.nu);
  add_solid_law(b, row, std::move(title), "MAT_HYPERELASTIC_RUBBER", {flow});
}

}  // namespace

std::vector<Keyword> rubber_material_keywords() {
  return {
      {.name = "MAT_OGDEN_RUBBER",
       .aliases = {"MAT_077_O"},
       .options = {"TITLE"},
       .layout = {{"", &ogden_card},
                  {"", &ogden_moduli_card},
                  {"", &ogden_exponents_card},
                  {"for each viscous term", &relaxation_card}},
       .read = read_ogden},
      {.name = "MAT_HYPERELASTIC_RUBBER",
       .aliases = {"MAT_077_H"},
       .options = {"TITLE"},
       .layout = {{"", &polynomial_card},
                  {"", &polynomial_constants_card},
                  {"for each viscous term", &relaxation_card}},
       .read = read_polynomial},
  };
}

}  // namespace nugget::reading
