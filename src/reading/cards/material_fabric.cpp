// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_FABRIC.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using kernel::Fabric;

/// All cards of *MAT_FABRIC.
struct FabricCards : MaterialCard, Fabric, AxesCards {
  double prab = 0, cse = 0, flc = 0, fac = 0, lnrc = 0, form = 0, fvopt = 0, beta = 0;
};
const CardOf<FabricCards> moduli_of_fabric_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&Fabric::young_a, real("ea", dimension::stress, required, above_zero(), "Young's modulus along a")},
    {&Fabric::young_b,
     real("eb", dimension::stress, 0, at_least(0), "Young's modulus along b; 0: isotropic by EA and PRBA")},
    real("ec", dimension::stress, 0, any_value, "of older decks: not of the plane, no effect"),
    {&Fabric::poisson_ba,
     real("prba", dimension::number, 0, any_value, "strain along a over that along b, negative, under stress along b")},
    {&FabricCards::prab,
     real("prab", dimension::number, 0, any_value, "the same the other way round: PRBA EA/EB, whatever is written")},
    real("prcb", dimension::number, 0, any_value, "of older decks: not of the plane, no effect"),
};

const CardOf<FabricCards> shear_and_liner_card{
    {&Fabric::shear_ab, real("gab", dimension::stress, 0, at_least(0), "shear modulus ab; isotropic: 0")},
    real("gbc", dimension::stress, 0, any_value, "of older decks: not of the plane, no effect"),
    real("gca", dimension::stress, 0, any_value, "of older decks: not of the plane, no effect"),
    {&FabricCards::cse, real("cse", dimension::number, 0, between(0, 1), "1: no compressive stress in the fabric")},
    {&Fabric::liner_young, real("el", dimension::stress, 0, at_least(0), "Young's modulus of the liner")},
    {&Fabric::liner_poisson, real("prl", dimension::number, 0, between(0, 0.5), "Poisson's ratio of the liner")},
    {&Fabric::liner_share, real("lratio", dimension::number, 0, between(0, 1), "its share of the thickness; 0: none")},
    {&Fabric::damping, real("damp", dimension::number, 0, at_least(0), "share of critical damping, e.g. 0.05")},
};

const CardOf<FabricCards> form_card{
    {&AxesCards::aopt, aopt::option},
    {&FabricCards::flc, real("flc", dimension::number, 0, any_value,
                             "leakage, for gases that ask for it by OPT: none of those that are built")},
    {&FabricCards::fac, real("fac", dimension::number, 0, any_value, "the same")},
    real("ela", dimension::number, 0, any_value, "the same, of fabric that touches something"),
    {&FabricCards::lnrc, real("lnrc", dimension::number, 0, only(0), "liner until the reference geometry is reached")},
    {&FabricCards::form, real("form", dimension::number, 0, any_value,
                              "0 and 1: linear, axes that turn with the element; 2, 3, 4, 12, 13, 14, -14, 24 are not "
                              "built")},
    {&FabricCards::fvopt, real("fvopt", dimension::number, 0, any_value,
                               "venting through the fabric; not built where FLC and FAC are given")},
    real("tsrfac", dimension::number, 0, only(0), "stresses of a reference geometry"),
};

const CardOf<FabricCards> fabric_axes_card{
    unused(),
    real("rgbrth", dimension::time, 0, only(0), "birth of a reference geometry"),
    integer("a0ref", 0, any_value, "area by which fabric leaks; no effect without leakage"),
    {&AxesCards::a1, aopt::a1},
    {&AxesCards::a2, aopt::a2},
    {&AxesCards::a3, aopt::a3},
    real("x0", dimension::number, 0, any_value, "coefficient of leakage; no effect without it"),
    real("x1", dimension::number, 0, any_value, "the same"),
};

const CardOf<FabricCards> fabric_angle_card{
    {&AxesCards::v1, aopt::v1},
    {&AxesCards::v2, aopt::v2},
    {&AxesCards::v3, aopt::v3},
    {&AxesCards::d1, aopt::d1},
    {&AxesCards::d2, aopt::d2},
    {&AxesCards::d3, aopt::d3},
    {&FabricCards::beta, real("beta", dimension::number, 0, any_value, "angle of AOPT 0 and 3 [degrees]")},
    integer("isrefg", 0, only(0), "stresses of a reference geometry"),
};

/// *MAT_ADD_AIRBAG_POROSITY_LEAKAGE: these fields for any law.
struct LeakageCard {
  double flc = 0, fac = 0, fvopt = 0;
};
const CardOf<LeakageCard> leakage_card{
    material_id,
    {&LeakageCard::flc, real("flc", dimension::number, 0, any_value, "share that leaks, with FAC; 0: nothing leaks")},
    {&LeakageCard::fac, real("fac", dimension::number, 0, any_value, "the same")},
    real("ela", dimension::number, 0, any_value, "the same, of fabric that touches something"),
    {&LeakageCard::fvopt, real("fvopt", dimension::number, 0, any_value,
                               "venting through the fabric; not built where FLC and FAC are given")},
    real("x0", dimension::number, 0, any_value, "coefficient of leakage; no effect without it"),
    real("x1", dimension::number, 0, any_value, "the same"),
};

/// Refuses what would make another material of it.
void check_moduli(Builder& b, const RowOf<FabricCards>& moduli, const RowOf<FabricCards>& shear, const Fabric& law) {
  if (law.poisson_ba * law.poisson_ba * law.young_a >= law.young_b)
    refuse(b, moduli[&Fabric::poisson_ba], "with these moduli and this Poisson's ratio the material would give energy",
           "PRBA is the ratio under stress along b: PRBA/EB = PRAB/EA");
  const double symmetric = law.poisson_ba * law.young_a / law.young_b;
  if (moduli->prab != 0.0 && std::abs(moduli->prab - symmetric) > 0.01 * std::abs(symmetric))
    moduli[&FabricCards::prab].report(
        b.findings, Severity::warning,
        fmt::format(
            "not obeyed: PRBA EA/EB is {:.4g}; with another ratio the stiffness would not be symmetric, and the "
            "fabric would give energy in closed cycles",
            symmetric),
        "leave it 0, or give PRBA EB/EA times this ratio");
  if (!(law.shear_ab > 0.0))
    refuse(b, shear[&Fabric::shear_ab], "fabric of two directions needs its shear modulus",
           "give GAB, or no EB for an isotropic one");
  if (law.liner_share > 0.0 && !(law.liner_young > 0.0))
    refuse(b, shear[&Fabric::liner_young], "the liner has no stiffness", "give EL, or LRATIO 0");
}

/// The share of a fabric that leaks is FLC times FAC, so nothing leaks where one of them is 0.
template <class Row, class Option, class Share>
void check_leakage(Builder& b, const Row& row, Option option, Share flc, Share fac) {
  const bool leaks = row[flc].value != 0.0 && row[fac].value != 0.0;
  const double fvopt = row[option].value;
  if (fvopt < 0.0 || (leaks && fvopt != 0.0))
    refuse(b, row[option], "gas that leaks through the fabric is not built",
           "leave it 0, and let the gas out by a vent of its *AIRBAG_ card");
  else if (fvopt != 0.0)
    row[option].report(b.findings, Severity::note, "nothing leaks through this fabric: FLC or FAC is 0");
  if (leaks && b.leaking_fabric.keyword.empty()) b.leaking_fabric = row[flc];
}

void read_leakage(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(leakage_card);
  expect_end(b, cursor);
  check_leakage(b, row, &LeakageCard::fvopt, &LeakageCard::flc, &LeakageCard::fac);
}

void read_fabric(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  FabricCards cards;
  const auto moduli = cursor.read(moduli_of_fabric_card, cards);
  const auto shear = cursor.read(shear_and_liner_card, cards);
  const auto form = cursor.read(form_card, cards);
  const bool linear = cards.form == 0.0 || cards.form == 1.0;
  if (!linear)
    refuse(b, form[&FabricCards::form],
           fmt::format("formulation {:g} of the fabric ({}) is not built", cards.form,
                       cards.form == 4.0 || std::abs(cards.form) == 14.0 || cards.form == 24.0
                           ? "stress by curves over strain along threads that shear"
                           : "strains of Green and Lagrange, or threads that shear"),
           "write FORM 0 with EA, EB, PRBA and GAB");
  check_leakage(b, form, &FabricCards::fvopt, &FabricCards::flc, &FabricCards::fac);
  Fabric law = cards;
  law.no_compression = cards.cse == 1.0;
  if (cards.cse != 0.0 && !law.no_compression)
    refuse(b, shear[&FabricCards::cse], "compression is either carried or not", "write 0 or 1");
  const bool isotropic = law.young_b == 0.0 && law.shear_ab == 0.0;
  if (isotropic) {
    law.young_b = law.young_a;
    law.shear_ab = law.young_a / (2.0 * (1.0 + law.poisson_ba));
  } else if (law.young_b == 0.0) {
    refuse(b, moduli[&Fabric::young_b], "fabric with a shear modulus of its own needs both Young's moduli",
           "give EB, or no GAB for an isotropic one");
    law.young_b = law.young_a;
  }
  check_moduli(b, moduli, shear, law);
  if (linear && cards.fvopt >= 0.0) {  // else more cards follow
    const auto first = cursor.read(fabric_axes_card, cards);
    const auto second = cursor.read(fabric_angle_card, cards);
    expect_end(b, cursor);
    law.axes = material_axes(b, block, cards, form[&AxesCards::aopt], first[&AxesCards::a1], second[&AxesCards::v1]);
    law.axes.angle = hand(block) * cards.beta * (std::numbers::pi / 180.0);
  }
  law.nu = std::clamp(law.poisson_ba, 0.0, 0.45);
  law.E = law.wave_modulus() * (1.0 - law.nu * law.nu);
  const Index material = add_material(b, moduli, std::move(title), "MAT_FABRIC", kernel::composed_law({law}));
  take_axes_of_system(b, form[&AxesCards::aopt], material);
  b.part_checks[material] = [](Builder& later, const Part& part, const RowOf<PartCard>& row) {
    if (part.kind != ElementKind::shell || part.section == none) return;
    const int written = later.model.shell_sections[part.section].elform;
    const int elform = written == 0 ? later.model.control.default_shell : written;
    if (!is_membrane(elform))
      refuse(later, row[&PartCard::mid],
             fmt::format("*MAT_FABRIC is a law of membranes, but the shells have ELFORM {}", elform),
             "write ELFORM 9 or 5 in their section");
  };
}

}  // namespace

std::vector<Keyword> fabric_material_keywords() {
  return {{.name = "MAT_FABRIC",
           .aliases = {"MAT_034"},
           .options = {"TITLE"},
           .layout = {{"", &moduli_of_fabric_card},
                      {"", &shear_and_liner_card},
                      {"", &form_card},
                      {"", &fabric_axes_card},
                      {"", &fabric_angle_card}},
           .read = read_fabric},
          {.name = "MAT_ADD_AIRBAG_POROSITY_LEAKAGE",
           .options = {"TITLE"},
           .layout = {{"", &leakage_card}},
           .read = read_leakage}};
}

}  // namespace nugget::reading
