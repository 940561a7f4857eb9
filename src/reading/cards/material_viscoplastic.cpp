// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_ANISOTROPIC_VISCOPLASTIC, as far as it is isotropic.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using kernel::Viscoplastic;

/// All cards of *MAT_ANISOTROPIC_VISCOPLASTIC, those of the yield stress in the law itself.
struct ViscoplasticCards : MaterialCard, Viscoplastic {
  double fail = 0, numint = 0, aopt = 0;
  std::array<double, 6> shape{};  // R00 R45 R90 of shells; F G H L M N of bricks
};

RealField no_kinematic(std::string_view name) {
  return real(name, dimension::number, 0, only(0), "kinematic hardening, which is not built");
}

const CardOf<ViscoplasticCards> viscoplastic_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&Viscoplastic::E, young},
    {&Viscoplastic::nu, poisson},
    {&Viscoplastic::yield, real("sigy", dimension::stress, required, above_zero(), "yield stress at first, at rest")},
    integer("flag", 0, only(0), "0: parameters are given; fits and curves (1, 2, 4) are not built"),
    id("lcss", IdSpace::function, 0, "curve of FLAG 1, 2 and 4, which are not built"),
    real("alpha", dimension::number, 0, any_value, "share of isotropic hardening of FLAG 1"),
};

const CardOf<ViscoplasticCards> viscoplastic_hardening_card{
    {&Viscoplastic::hardening_1, real("qr1", dimension::stress, 0, any_value, "isotropic hardening: what it adds")},
    {&Viscoplastic::exponent_1, real("cr1", dimension::number, 0, at_least(0), "and how soon")},
    {&Viscoplastic::hardening_2, real("qr2", dimension::stress, 0, any_value, "the same, a second term")},
    {&Viscoplastic::exponent_2, real("cr2", dimension::number, 0, at_least(0), "and how soon")},
    no_kinematic("qx1"),
    real("cx1", dimension::number, 0, any_value, "of QX1"),
    no_kinematic("qx2"),
    real("cx2", dimension::number, 0, any_value, "of QX2"),
};

FieldOf<ViscoplasticCards> shape_field(std::size_t i, std::string_view name, std::string_view meaning) {
  return {at(&ViscoplasticCards::shape, i), real(name, dimension::number, 0, any_value, meaning)};
}
const CardOf<ViscoplasticCards> viscoplastic_rate_card{
    {&Viscoplastic::viscosity,
     real("vk", dimension::stress, 0, at_least(0), "viscous stress at a rate of 1 of the plastic strain")},
    {&Viscoplastic::rate_exponent, real("vm", dimension::number, 0, at_least(0), "its exponent of the rate")},
    shape_field(0, "r00_f", "Lankford ratio along a, of shells; F of bricks; 0: isotropic"),
    shape_field(1, "r45_g", "Lankford ratio at 45 degrees; G"),
    shape_field(2, "r90_h", "Lankford ratio along b; H"),
    shape_field(3, "l", "L of bricks"),
    shape_field(4, "m", "M of bricks"),
    shape_field(5, "n", "N of bricks"),
};

const CardOf<ViscoplasticCards> viscoplastic_axes_card{
    {&ViscoplasticCards::aopt, aopt::option},
    {&ViscoplasticCards::fail, real("fail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none")},
    {&ViscoplasticCards::numint, numint},
    integer("macf", 1, any_value, "exchange of axes, of which none counts"),
};

/// Axes, which an isotropic material has not.
const CardOf<ViscoplasticCards> viscoplastic_point_card{aopt::xp, aopt::yp, aopt::zp, aopt::a1, aopt::a2, aopt::a3};
const CardOf<ViscoplasticCards> viscoplastic_vector_card{
    aopt::v1, aopt::v2, aopt::v3, aopt::d1, aopt::d2, aopt::d3, real("beta", dimension::number, 0, any_value, "angle")};

/// What is isotropic is so by other numbers in shells than in bricks.
void check_shape(Builder& b, const Part& part, const RowOf<ViscoplasticCards>& row) {
  const bool is_solid = part.kind == ElementKind::solid;
  constexpr std::array<double, 6> of_bricks{0.5, 0.5, 0.5, 1.5, 1.5, 1.5};
  for (std::size_t i = 0; i < (is_solid ? 6u : 3u); ++i) {
    const auto field = at(&ViscoplasticCards::shape, i);
    const double isotropic = is_solid ? of_bricks[i] : 1.0, written = row->shape[i];
    if (written == 0.0 || written == isotropic) continue;
    return refuse(b, row[field],
                  fmt::format("anisotropy is not built: {:g} is isotropic in {}, as 0 is", isotropic,
                              is_solid ? "bricks" : "shells"),
                  is_solid ? "leave F to N blank, where the material is isotropic"
                           : "use *MAT_3-PARAMETER_BARLAT or *MAT_HILL_3R for a rolled sheet");
  }
}

void read_viscoplastic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  ViscoplasticCards cards;
  const auto first = cursor.read(viscoplastic_card, cards);
  cursor.read(viscoplastic_hardening_card, cards);
  const auto rate = cursor.read(viscoplastic_rate_card, cards);
  cursor.read(viscoplastic_axes_card, cards);
  cursor.read(viscoplastic_point_card, cards);
  cursor.read(viscoplastic_vector_card, cards);
  expect_end(b, cursor);
  if (cards.viscosity > 0.0 && !(cards.rate_exponent > 0.0))
    refuse(b, rate[&Viscoplastic::rate_exponent], "with VK the exponent VM must be above 0", "give VM, or VK 0");
  if (cards.viscosity > 0.0 && block.transform != nullptr && block.transform->time != 1.0)
    refuse(b, rate[&Viscoplastic::viscosity], "FCTTIM of *INCLUDE_TRANSFORM changes the unit of VK by a power VM of it",
           "write VK in the units of the whole model");
  if (cards.yield + std::min(cards.hardening_1, 0.0) + std::min(cards.hardening_2, 0.0) <= 0.0)
    refuse(b, first[&Viscoplastic::yield], "QR1 and QR2 take all of it away", "the yield stress must stay above 0");
  kernel::LawComponents law{static_cast<const Viscoplastic&>(cards)};
  law.failure_strain = plastic_strain_at_failure(cards.fail);
  law.points_to_delete = cards.numint;
  const Index material =
      add_material(b, first, std::move(title), "MAT_ANISOTROPIC_VISCOPLASTIC", composed_law(std::move(law)));
  b.part_checks[material] = [rate](Builder& later, const Part& part, const auto&) { check_shape(later, part, rate); };
}

}  // namespace

std::vector<Keyword> viscoplastic_material_keywords() {
  return {{.name = "MAT_ANISOTROPIC_VISCOPLASTIC",
           .aliases = {"MAT_103"},
           .options = {"TITLE"},
           .layout = {{"", &viscoplastic_card},
                      {"", &viscoplastic_hardening_card},
                      {"", &viscoplastic_rate_card},
                      {"", &viscoplastic_axes_card},
                      {"", &viscoplastic_point_card},
                      {"", &viscoplastic_vector_card}},
           .read = read_viscoplastic}};
}

}  // namespace nugget::reading
