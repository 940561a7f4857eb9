// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/orthotropic_fields.hpp"

// *MAT_ORTHOTROPIC_ELASTIC.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using kernel::Orthotropic;

/// All cards of *MAT_ORTHOTROPIC_ELASTIC.
struct OrthotropicCards : MaterialCard, Orthotropic, AxesCards {
  double beta = 0;
};
const CardOf<OrthotropicCards> moduli_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&Orthotropic::young_a, real("ea", dimension::stress, required, above_zero(), "Young's modulus along a")},
    {&Orthotropic::young_b, real("eb", dimension::stress, required, above_zero(), "Young's modulus along b")},
    {&Orthotropic::young_c, real("ec", dimension::stress, 0, at_least(0), "Young's modulus along c; 0, of shells: EB")},
    {&Orthotropic::poisson_ba, orthotropy::ratio_ba},
    {&Orthotropic::poisson_ca, orthotropy::ratio_ca},
    {&Orthotropic::poisson_cb, orthotropy::ratio_cb},
};

const CardOf<OrthotropicCards> shears_card{
    {&Orthotropic::shear_ab, orthotropy::shear_ab},
    {&Orthotropic::shear_bc, orthotropy::shear_bc},
    {&Orthotropic::shear_ca, orthotropy::shear_ca},
    {&AxesCards::aopt, aopt::option},
    real("g", dimension::stress, 0, only(0), "shear modulus of frictional damping"),
    real("sigf", dimension::stress, 0, only(0), "limit of frictional damping"),
};

const CardOf<OrthotropicCards> orthotropic_axes_card{
    aopt::xp,
    aopt::yp,
    aopt::zp,
    {&AxesCards::a1, aopt::a1},
    {&AxesCards::a2, aopt::a2},
    {&AxesCards::a3, aopt::a3},
    aopt::macf,
    integer("ihis", 0, only(0), "axes from *INITIAL_STRESS_SOLID"),
};

const CardOf<OrthotropicCards> angle_card = axes_vectors_card<OrthotropicCards>({
    {&OrthotropicCards::beta,
     real("beta", dimension::number, 0, any_value, "angle of AOPT 0 and 3 in shells [degrees]")},
    real("ref", dimension::number, 0, only(0), "stress from a reference geometry"),
});

void read_orthotropic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  OrthotropicCards cards;
  const auto moduli = cursor.read(moduli_card, cards);
  const auto shears = cursor.read(shears_card, cards);
  const auto first = cursor.read(orthotropic_axes_card, cards);
  const auto second = cursor.read(angle_card, cards);
  expect_end(b, cursor);
  Orthotropic law = cards;
  complete_orthotropic(
      b, block, law, cards, cards.beta,
      {moduli[&Orthotropic::poisson_ba], shears[&AxesCards::aopt], first[&AxesCards::a1], second[&AxesCards::v1]});
  const Index material =
      add_material(b, moduli, std::move(title), "MAT_ORTHOTROPIC_ELASTIC", kernel::composed_law({law}));
  take_axes_of_system(b, shears[&AxesCards::aopt], material);
}

}  // namespace

void complete_orthotropic(Builder& b, const Block& block, Orthotropic& law, const AxesCards& cards, double beta,
                          const OrthotropicEntries& entries) {
  if (!(law.young_c > 0.0)) law.young_c = law.young_b;
  law.axes = material_axes(b, block, cards, entries.option, entries.a1, entries.v1);
  law.axes.angle = hand(block) * beta * (std::numbers::pi / 180.0);
  if (!(law.definiteness() > 0.0))
    refuse(b, entries.ratio_ba, "with these moduli and Poisson's ratios the material would give energy",
           "PRBA is the ratio under stress along b: PRBA/EB = PRAB/EA; PRCA and PRCB are those under stress along c");
  law.take_isotropic_constants();
}

std::vector<Keyword> orthotropic_material_keywords() {
  return {{.name = "MAT_ORTHOTROPIC_ELASTIC",
           .aliases = {"MAT_002"},
           .options = {"TITLE"},
           .layout = {{"", &moduli_card}, {"", &shears_card}, {"", &orthotropic_axes_card}, {"", &angle_card}},
           .read = read_orthotropic}};
}

}  // namespace nugget::reading
