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
using deck::RowOf;

using kernel::law_field::compressible;
using kernel::law_field::reference;

// ---- 077_O, 077_H

constexpr RealField friction_shear =
    real("g", dimension::stress, 0, at_least(0), "shear modulus of frictional damping; 0: none");
constexpr RealField friction_limit =
    real("sigf", dimension::stress, 0, at_least(0), "greatest effective stress of frictional damping");

/// The first card: Poisson's ratio, and frictional damping.
struct RubberCard : MaterialCard {
  double pr = 0, g = 0, sigf = 0;
};

/// A line for each stress that relaxes.
using Branch = kernel::Overstress::MaxwellBranch;
const CardOf<Branch> relaxation_card{
    {&Branch::shear, real("gi", dimension::stress, 0, at_least(0), "shear modulus of a stress that relaxes")},
    {&Branch::decay, real("betai", dimension::rate, 0, at_least(0), "its decay")},
    integer("vflag", 0, only(0), "form of the viscous stress: 0, added to that of the energy"),
};

/// Frictional damping of the first card, and the lines of viscous terms up to the end.
kernel::Overstress read_overstress(Builder& b, Cursor& cursor, const RowOf<RubberCard>& first) {
  constexpr std::size_t most_terms = 12;
  kernel::Overstress overstress;
  if (first->g > 0.0 && first->sigf > 0.0) {
    overstress.friction_shear = first->g;
    overstress.friction_limit = first->sigf;
  } else if (first->g > 0.0 || first->sigf > 0.0) {
    first[first->g > 0.0 ? &RubberCard::sigf : &RubberCard::g].report(
        b.findings, Severity::warning, "frictional damping needs both G and SIGF: there is none",
        "give both, or neither");
  }
  while (cursor.more()) {
    const auto term = cursor.read(relaxation_card);
    if (!(term->shear > 0.0)) continue;
    if (overstress.maxwell_branches.size() == most_terms) {
      refuse(b, term[&Branch::shear], "more than twelve viscous terms are not supported");
      break;
    }
    overstress.maxwell_branches.push_back(*term);
  }
  return overstress;
}

const CardOf<RubberCard> ogden_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&RubberCard::pr, compressible},
    integer("n", 0, only(0), "number of terms that would be fitted to a curve"),
    integer("nv", 0, any_value, "viscous terms that would be fitted to a curve"),
    {&RubberCard::g, friction_shear},
    {&RubberCard::sigf, friction_limit},
    reference,
};

struct OgdenTermsCard {
  std::array<double, 8> value{};
};
const CardOf<OgdenTermsCard> ogden_moduli_card{
    {at(&OgdenTermsCard::value, 0), real("mu1", dimension::stress, required, any_value, "modulus of term 1")},
    {at(&OgdenTermsCard::value, 1), real("mu2", dimension::stress, 0, any_value, "term 2")},
    {at(&OgdenTermsCard::value, 2), real("mu3", dimension::stress, 0, any_value, "term 3")},
    {at(&OgdenTermsCard::value, 3), real("mu4", dimension::stress, 0, any_value, "term 4")},
    {at(&OgdenTermsCard::value, 4), real("mu5", dimension::stress, 0, any_value, "term 5")},
    {at(&OgdenTermsCard::value, 5), real("mu6", dimension::stress, 0, any_value, "term 6")},
    {at(&OgdenTermsCard::value, 6), real("mu7", dimension::stress, 0, any_value, "term 7")},
    {at(&OgdenTermsCard::value, 7), real("mu8", dimension::stress, 0, any_value, "term 8")},
};

const CardOf<OgdenTermsCard> ogden_exponents_card{
    {at(&OgdenTermsCard::value, 0), real("alpha1", dimension::number, required, any_value, "exponent of term 1")},
    {at(&OgdenTermsCard::value, 1), real("alpha2", dimension::number, 0, any_value, "term 2")},
    {at(&OgdenTermsCard::value, 2), real("alpha3", dimension::number, 0, any_value, "term 3")},
    {at(&OgdenTermsCard::value, 3), real("alpha4", dimension::number, 0, any_value, "term 4")},
    {at(&OgdenTermsCard::value, 4), real("alpha5", dimension::number, 0, any_value, "term 5")},
    {at(&OgdenTermsCard::value, 5), real("alpha6", dimension::number, 0, any_value, "term 6")},
    {at(&OgdenTermsCard::value, 6), real("alpha7", dimension::number, 0, any_value, "term 7")},
    {at(&OgdenTermsCard::value, 7), real("alpha8", dimension::number, 0, any_value, "term 8")},
};

void read_ogden(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(ogden_card);
  const auto moduli = cursor.read(ogden_moduli_card);
  const auto exponents = cursor.read(ogden_exponents_card);
  kernel::Ogden flow;
  flow.overstress = read_overstress(b, cursor, row);
  double shear = 0.0;
  for (std::size_t i = 0; i < moduli->value.size(); ++i) {
    const double mu = moduli->value[i], alpha = exponents->value[i];
    if (mu != 0.0 && alpha != 0.0) flow.terms.push_back({mu, alpha});
    shear += 0.5 * mu * alpha;
  }
  if (!(shear > 0.0))
    refuse(b, moduli[at(&OgdenTermsCard::value, 0)], "the shear modulus, half the sum of MU ALPHA, must be above 0");
  flow.nu = row->pr;
  flow.E = 2.0 * shear * (1.0 + flow.nu);
  add_material(b, row, std::move(title), "MAT_OGDEN_RUBBER", kernel::composed_law({flow}));
}

const CardOf<RubberCard> rubber_polynomial_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&RubberCard::pr, compressible},
    integer("n", 0, only(0), "number of constants that would be fitted to a curve"),
    integer("nv", 0, any_value, "viscous terms that would be fitted to a curve"),
    {&RubberCard::g, friction_shear},
    {&RubberCard::sigf, friction_limit},
    reference,
};

const CardOf<kernel::PolynomialRubber> polynomial_constants_card{
    {&kernel::PolynomialRubber::c10, real("c10", dimension::stress, 0, any_value, "constant of J1 - 3")},
    {&kernel::PolynomialRubber::c01, real("c01", dimension::stress, 0, any_value, "constant of J2 - 3")},
    {&kernel::PolynomialRubber::c11, real("c11", dimension::stress, 0, any_value, "constant of (J1 - 3) (J2 - 3)")},
    {&kernel::PolynomialRubber::c20, real("c20", dimension::stress, 0, any_value, "constant of (J1 - 3)^2")},
    {&kernel::PolynomialRubber::c02, real("c02", dimension::stress, 0, any_value, "constant of (J2 - 3)^2")},
    {&kernel::PolynomialRubber::c30, real("c30", dimension::stress, 0, any_value, "constant of (J1 - 3)^3")},
    real("therml", dimension::number, 0, only(0), "constants by curves over temperature"),
};

void read_rubber_polynomial(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(rubber_polynomial_card);
  const auto constants = cursor.read(polynomial_constants_card);
  kernel::PolynomialRubber flow = *constants;
  flow.overstress = read_overstress(b, cursor, row);
  const double shear = 2.0 * (flow.c10 + flow.c01);
  if (!(shear > 0.0))
    refuse(b, constants[&kernel::PolynomialRubber::c10], "the shear modulus, 2 (C10 + C01), must be above 0");
  flow.nu = row->pr;
  flow.E = 2.0 * shear * (1.0 + flow.nu);
  add_material(b, row, std::move(title), "MAT_HYPERELASTIC_RUBBER", kernel::composed_law({flow}));
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
       .layout = {{"", &rubber_polynomial_card},
                  {"", &polynomial_constants_card},
                  {"for each viscous term", &relaxation_card}},
       .read = read_rubber_polynomial},
  };
}

}  // namespace nugget::reading
