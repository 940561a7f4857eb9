// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kernel/law/law_components.hpp"
#include "kernel/law/saturating_fit.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"
#include "reading/cards/yield_curves.hpp"

// *MAT_ANISOTROPIC_VISCOPLASTIC.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Entry;
using deck::RowOf;
using kernel::HillAnisotropy;
using kernel::Viscoplastic;

/// All cards of *MAT_ANISOTROPIC_VISCOPLASTIC, those of the yield stress in the law itself.
struct ViscoplasticCards : MaterialCard, Viscoplastic, AxesCards {
  int flag = 0, lcss = 0, macf = 1;
  double alpha = 0, fail = 0, numint = 0, beta = 0;
  std::array<double, 6> shape{};  // R00 R45 R90 of shells; F G H L M N of bricks
  std::array<double, 2> back_stress{}, back_exponent{};
};

FieldOf<ViscoplasticCards> back_field(std::array<double, 2> ViscoplasticCards::*pair, std::size_t i,
                                      std::string_view name, Dimension dimension, std::string_view meaning) {
  return {at(pair, i), real(name, dimension, 0, at_least(0), meaning)};
}

const CardOf<ViscoplasticCards> viscoplastic_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&Viscoplastic::E, young},
    {&Viscoplastic::nu, poisson},
    {&Viscoplastic::yield, real("sigy", dimension::stress, 0, at_least(0),
                                "yield stress at first, at rest, of FLAG 0 and 1; 0 with FLAG 1: "
                                "that of the curve")},
    {&ViscoplasticCards::flag,
     integer("flag", 0, between(0, 4),
             "hardening: 0 as on the next card, 1 fitted to LCSS, 2 by the curve LCSS, 4 by the table LCSS (bricks)")},
    {&ViscoplasticCards::lcss,
     id("lcss", IdSpace::function, 0, "of FLAG 1, 2 and 4: yield stress over plastic strain; 4: a table over rates")},
    {&ViscoplasticCards::alpha,
     real("alpha", dimension::number, 0, between(0, 1), "FLAG 1: share of the hardening that is isotropic")},
};

const CardOf<ViscoplasticCards> viscoplastic_hardening_card{
    {&Viscoplastic::hardening_1, real("qr1", dimension::stress, 0, any_value, "isotropic hardening: what it adds")},
    {&Viscoplastic::exponent_1, real("cr1", dimension::number, 0, at_least(0), "and how soon")},
    {&Viscoplastic::hardening_2, real("qr2", dimension::stress, 0, any_value, "the same, a second term")},
    {&Viscoplastic::exponent_2, real("cr2", dimension::number, 0, at_least(0), "and how soon")},
    back_field(&ViscoplasticCards::back_stress, 0, "qx1", dimension::stress, "back stress: what it comes to"),
    back_field(&ViscoplasticCards::back_exponent, 0, "cx1", dimension::number, "and how soon"),
    back_field(&ViscoplasticCards::back_stress, 1, "qx2", dimension::stress, "the same, a second term"),
    back_field(&ViscoplasticCards::back_exponent, 1, "cx2", dimension::number, "and how soon"),
};

FieldOf<ViscoplasticCards> shape_field(std::size_t i, std::string_view name, std::string_view meaning) {
  return {at(&ViscoplasticCards::shape, i), real(name, dimension::number, 0, any_value, meaning)};
}
const CardOf<ViscoplasticCards> viscoplastic_rate_card{
    {&Viscoplastic::viscosity,
     real("vk", dimension::stress, 0, at_least(0), "viscous stress at a rate of 1 of the plastic strain")},
    {&Viscoplastic::rate_exponent, real("vm", dimension::number, 0, at_least(0), "its exponent of the rate")},
    shape_field(0, "r00_f", "Lankford ratio along a, of shells; F of bricks; 0: as isotropic, 1 and 1/2"),
    shape_field(1, "r45_g", "Lankford ratio at 45 degrees; G"),
    shape_field(2, "r90_h", "Lankford ratio along b; H"),
    shape_field(3, "l", "L of bricks; 0: 3/2"),
    shape_field(4, "m", "M of bricks"),
    shape_field(5, "n", "N of bricks"),
};

const CardOf<ViscoplasticCards> viscoplastic_axes_card{
    {&AxesCards::aopt, aopt::option},
    {&ViscoplasticCards::fail, real("fail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none")},
    {&ViscoplasticCards::numint, numint},
    {&ViscoplasticCards::macf, integer("macf", 1, any_value, "exchange of axes: 1, none")},
};

const CardOf<ViscoplasticCards> viscoplastic_point_card{
    aopt::xp, aopt::yp, aopt::zp, {&AxesCards::a1, aopt::a1}, {&AxesCards::a2, aopt::a2}, {&AxesCards::a3, aopt::a3}};
const CardOf<ViscoplasticCards> viscoplastic_vector_card = axes_vectors_card<ViscoplasticCards>({
    {&ViscoplasticCards::beta,
     real("beta", dimension::number, 0, any_value, "angle of AOPT 0 and 3 in shells [degrees]")},
});

/// Where on the cards stands what is checked later.
struct ViscoplasticRows {
  RowOf<ViscoplasticCards> first, rate, axes;
};

/// Whether the constants are those of an isotropic shell; none at all are those of a brick, too.
bool is_isotropic(const std::array<double, 6>& shape) {
  return std::all_of(shape.begin(), shape.begin() + 3, [](double r) { return r == 0.0 || r == 1.0; }) &&
         std::all_of(shape.begin() + 3, shape.end(), [](double c) { return c == 0.0; });
}

/// What an element of the part makes of the constants.
void check_viscoplastic_part(Builder& b, const Part& part, const ViscoplasticRows& rows) {
  const ViscoplasticCards& cards = *rows.axes;
  const auto* law = std::get_if<kernel::ComposedLaw>(&b.model.materials[part.material].law);
  const bool in_layers = part.kind == ElementKind::shell,
             is_solid = part.kind == ElementKind::solid &&
                        !b.model.has_thick_shells(static_cast<Index>(&part - b.model.parts.data()));
  if (cards.flag == 4 && !is_solid)
    return refuse(b, rows.first[&ViscoplasticCards::flag], "FLAG 4 is made for bricks",
                  "use *MAT_PIECEWISE_LINEAR_PLASTICITY, or *MAT_3-PARAMETER_BARLAT with HR 3");
  const Entry& first_constant = rows.rate[at(&ViscoplasticCards::shape, 0)];
  const auto* flow = law == nullptr ? nullptr : std::get_if<Viscoplastic>(&law->components->flow);
  if (flow != nullptr && flow->anisotropy && !in_layers && !is_solid)
    return refuse(b, first_constant, "anisotropy and back stress are built for shells and bricks",
                  "give the part an isotropic material without QX1 and QX2");
  const auto written = [&](std::size_t i) { return cards.shape[i] != 0.0; };
  if (is_isotropic(cards.shape)) {
    if (is_solid && (written(0) || written(1) || written(2)))
      refuse(b, first_constant, "these are ratios of shells, but the part has bricks, where F, G and H are 1/2",
             "give F to N, or leave them blank where the material is isotropic");
    return;
  }
  if (flow == nullptr || !flow->anisotropy) return;  // refused
  const HillAnisotropy& hill = *flow->anisotropy;
  const auto& ratios = hill.ratios;
  if (in_layers && !(ratios[0] > 0.0 && ratios[1] > 0.0 && ratios[2] > 0.0))
    refuse(b, first_constant, "ratios of Lankford are above 0", "give R00, R45 and R90 of a shell");
  else if (!HillAnisotropy::is_convex(in_layers ? hill.of_layers() : hill.constants))
    refuse(b, first_constant, "with these constants a stress would have no effective stress",
           "F + G, G + H, H + F, F G + G H + H F, L, M and N must be above 0");
}

/// The law with the hardening of its cards, or of LCSS; nothing where it is refused.
void set_viscoplastic(Builder& b, Index material, const ViscoplasticRows& rows) {
  auto* composed = std::get_if<kernel::ComposedLaw>(&b.model.materials[material].law);
  if (composed == nullptr) return;  // refused
  const ViscoplasticCards& cards = *rows.axes;
  const Entry& lcss = rows.first[&ViscoplasticCards::lcss];
  kernel::LawComponents made = *composed->components;
  auto& flow = std::get<Viscoplastic>(made.flow);
  const YieldTable table = yield_table(b, lcss, lcss.integer(), false);
  if (table.curves.empty()) return;
  if (cards.flag != 4 && !table.rates.empty())
    return refuse(b, lcss, fmt::format("FLAG {} with a table is not built", cards.flag),
                  cards.flag == 1 ? "give one curve, with VK and VM" : "give one curve, or FLAG 4");
  if (cards.flag == 1) {
    const Curve& curve = table.curves.front();
    const double start = cards.yield > 0.0 ? cards.yield : curve.extrapolated(0.0);
    if (curve.x.size() < 3 || !(curve.x.back() > 0.0) || !std::is_sorted(curve.y.begin(), curve.y.end()))
      return refuse(b, lcss, "two terms are fitted to a curve of at least three points that does not fall",
                    "give such a curve, or FLAG 2, which takes it as it is");
    const kernel::SaturatingFit fit = kernel::saturating_fit(curve, start);
    flow.yield = start;
    flow.hardening_1 = cards.alpha * fit.stress[0];
    flow.hardening_2 = cards.alpha * fit.stress[1];
    flow.exponent_1 = fit.exponent[0];
    flow.exponent_2 = fit.exponent[1];
    if (cards.alpha < 1.0) {
      flow.anisotropy->back_stress = {(1.0 - cards.alpha) * fit.stress[0], (1.0 - cards.alpha) * fit.stress[1]};
      flow.anisotropy->back_exponent = fit.exponent;
    }
    lcss.report(b.findings, fit.farthest > 0.05 ? Severity::warning : Severity::note,
                fmt::format("curve {} is fitted by {:.5g} + {:.5g} (1 - exp(-{:.5g} e)) + {:.5g} (1 - exp(-{:.5g} e)), "
                            "which is within {:.2g} % of it",
                            curve.id, start, fit.stress[0], fit.exponent[0], fit.stress[1], fit.exponent[1],
                            100.0 * fit.farthest),
                fit.farthest > 0.05 ? "FLAG 2 takes the curve as it is" : "");
  } else {
    kernel::PiecewiseLinear curves;
    curves.E = flow.E;
    curves.nu = flow.nu;
    curves.yield = table.curves;
    curves.rates = table.rates;
    curves.log_rates = table.log_rates;
    if (cards.flag == 2 && flow.viscosity > 0.0) {
      curves.rate_c = 1.0;
      curves.rate_p = 1.0 / flow.rate_exponent;
      curves.rate_yield = flow.viscosity;
    }
    if (flow.anisotropy)
      flow.anisotropy->curves = std::move(curves);
    else
      made.flow = std::move(curves);
  }
  *composed = kernel::composed_law(std::move(made));
}

/// Findings of the cards of the hardening.
void check_viscoplastic_cards(Builder& b, const Block& block, const ViscoplasticRows& rows) {
  const ViscoplasticCards& cards = *rows.axes;
  const Entry &sigy = rows.first[&Viscoplastic::yield], &vk = rows.rate[&Viscoplastic::viscosity];
  if (cards.flag == 3) refuse(b, rows.first[&ViscoplasticCards::flag], "there is no FLAG 3", "0, 1, 2 or 4");
  if (cards.flag != 0 && cards.lcss == 0)
    refuse(b, rows.first[&ViscoplasticCards::lcss], fmt::format("FLAG {} needs a curve", cards.flag),
           "give the yield stress over plastic strain");
  if (cards.flag == 0 && !(cards.yield > 0.0))
    refuse(b, sigy, "the yield stress must be above 0", "give SIGY, or LCSS with FLAG 2");
  if (cards.viscosity > 0.0 && cards.flag != 4) {
    if (!(cards.rate_exponent > 0.0))
      refuse(b, rows.rate[&Viscoplastic::rate_exponent], "with VK the exponent VM must be above 0", "give VM, or VK 0");
    if (block.transform != nullptr && block.transform->time != 1.0)
      refuse(b, vk, "FCTTIM of *INCLUDE_TRANSFORM changes the unit of VK by a power VM of it",
             "write VK in the units of the whole model");
  }
  if (cards.viscosity > 0.0 && cards.flag == 4)
    vk.report(b.findings, Severity::warning, "not obeyed: the rates are those of the table (FLAG 4)", "leave it empty");
  if (cards.flag == 0 && cards.yield > 0.0 &&
      cards.yield + std::min(cards.hardening_1, 0.0) + std::min(cards.hardening_2, 0.0) <= 0.0)
    refuse(b, sigy, "QR1 and QR2 take all of it away", "the yield stress must stay above 0");
}

void read_viscoplastic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  ViscoplasticCards cards;
  ViscoplasticRows rows;
  rows.first = cursor.read(viscoplastic_card, cards);
  const auto second = cursor.read(viscoplastic_hardening_card, cards);
  rows.rate = cursor.read(viscoplastic_rate_card, cards);
  rows.axes = cursor.read(viscoplastic_axes_card, cards);
  const auto point = cursor.read(viscoplastic_point_card, cards);
  const auto vectors = cursor.read(viscoplastic_vector_card, cards);
  expect_end(b, cursor);
  check_viscoplastic_cards(b, block, rows);
  Viscoplastic flow = cards;
  const bool by_card = cards.flag == 0;
  const auto has_term = [&](std::size_t k) { return cards.back_stress[k] > 0.0 && cards.back_exponent[k] > 0.0; };
  if (!by_card) {
    flow.hardening_1 = flow.hardening_2 = 0.0;
    if (cards.hardening_1 != 0.0 || cards.hardening_2 != 0.0 || has_term(0) || has_term(1))
      second[&Viscoplastic::hardening_1].report(b.findings, Severity::warning,
                                                fmt::format("this card is not obeyed with FLAG {}", cards.flag),
                                                "leave it empty, or FLAG 0");
  }
  if (flow.yield == 0.0) flow.yield = cards.E;  // that of LCSS comes later
  const bool isotropic = is_isotropic(cards.shape),
             moves = by_card ? has_term(0) || has_term(1) : cards.flag == 1 && cards.alpha < 1.0;
  if (!isotropic || moves) {
    HillAnisotropy& hill = flow.anisotropy.emplace();
    for (std::size_t i = 0; i < 6; ++i) {
      if (cards.shape[i] == 0.0) continue;
      hill.constants[i] = cards.shape[i];
      if (i < 3) hill.ratios[i] = cards.shape[i];
    }
    if (by_card) {
      hill.back_stress = cards.back_stress;
      hill.back_exponent = cards.back_exponent;
    }
    if (!isotropic) {
      hill.axes =
          material_axes(b, block, cards, rows.axes[&AxesCards::aopt], point[&AxesCards::a1], vectors[&AxesCards::v1]);
      hill.axes.angle = hand(block) * cards.beta * (std::numbers::pi / 180.0);
      if (cards.macf != 0 && cards.macf != 1)
        refuse(b, rows.axes[&ViscoplasticCards::macf], "exchange of axes is not built", "leave it empty");
    }
  }
  kernel::LawComponents law{flow};
  law.failure_strain = plastic_strain_at_failure(cards.fail);
  law.points_to_delete = cards.numint;
  const Index material =
      add_material(b, rows.first, std::move(title), "MAT_ANISOTROPIC_VISCOPLASTIC", composed_law(std::move(law)));
  if (!isotropic) take_axes_of_system(b, rows.axes[&AxesCards::aopt], material);
  if (!by_card && cards.lcss != 0)
    b.defer(Phase::parts, [=](Builder& later) { set_viscoplastic(later, material, rows); });
  b.part_checks[material] = [rows](Builder& later, const Part& part, const auto&) {
    check_viscoplastic_part(later, part, rows);
  };
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
