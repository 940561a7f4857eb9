// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/fabric_leakage.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_FABRIC.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using kernel::Fabric;
using kernel::WovenFabric;

constexpr auto leakage_flc =
    or_negative(real("flc", dimension::number, 0, any_value,
                     "share of the area that leaks, times FAC; below 0: -FLC is a curve of it over time. With X0: X2"),
                IdSpace::function);
constexpr auto leakage_fac =
    or_negative(real("fac", dimension::number, 0, any_value,
                     "the same; below 0: -FAC is a curve of it, with FVOPT 7 and 8 of the velocity of the gas "
                     "[length/time], over the absolute pressure. With X0: X3"),
                IdSpace::function);
constexpr auto leakage_ela =
    or_negative(real("ela", dimension::number, 0, any_value,
                     "with FVOPT 2, 4, 8: share of what contact covers that leaks all the same; below 0: -ELA is a "
                     "curve of it over time"),
                IdSpace::function);
constexpr auto leakage_option =
    real("fvopt", dimension::number, 0, any_value,
         "how gas leaks: 0 by OPT of the gas; 1, 2 as through a vent, 3, 4 by the pressure, 7, 8 with a velocity; even "
         "ones: less where contact covers the fabric");
constexpr auto leakage_x0 =
    real("x0", dimension::number, 0, any_value, "above 0: the leaking area is A0 (X0 + X1 A/A0 + (X2 + X3 A/A0) PE/p)");
constexpr auto leakage_x1 = real("x1", dimension::number, 0, any_value, "see X0");

/// All cards of *MAT_FABRIC.
struct FabricCards : MaterialCard, Fabric, AxesCards {
  double prab = 0, cse = 0, flc = 0, fac = 0, ela = 0, lnrc = 0, form = 0, fvopt = 0, x0 = 0, x1 = 0, beta = 0;
  int a0ref = 0;
  int lca = 0, lcb = 0, lcab = 0, lcua = 0, lcub = 0, lcuab = 0;
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
    {&FabricCards::flc, leakage_flc},
    {&FabricCards::fac, leakage_fac},
    {&FabricCards::ela, leakage_ela},
    {&FabricCards::lnrc, real("lnrc", dimension::number, 0, only(0), "liner until the reference geometry is reached")},
    {&FabricCards::form, real("form", dimension::number, 0, any_value,
                              "0 and 1: linear, axes that turn with the element; 12 (2, 3, 13): linear in Green's "
                              "strain along the threads; 14 (4, -14): by curves of it; 24 is not built")},
    {&FabricCards::fvopt, leakage_option},
    real("tsrfac", dimension::number, 0, only(0), "stresses of a reference geometry"),
};

const CardOf<FabricCards> fabric_axes_card{
    unused(),
    real("rgbrth", dimension::time, 0, only(0), "birth of a reference geometry"),
    {&FabricCards::a0ref, integer("a0ref", 0, any_value, "with X0: 0, the area A0 is that at the start")},
    {&AxesCards::a1, aopt::a1},
    {&AxesCards::a2, aopt::a2},
    {&AxesCards::a3, aopt::a3},
    {&FabricCards::x0, leakage_x0},
    {&FabricCards::x1, leakage_x1},
};

const CardOf<FabricCards> fabric_angle_card = axes_vectors_card<FabricCards>({
    {&FabricCards::beta, real("beta", dimension::number, 0, any_value, "angle of AOPT 0 and 3 [degrees]")},
    integer("isrefg", 0, only(0), "stresses of a reference geometry"),
});

const CardOf<FabricCards> thread_curves_card{
    {&FabricCards::lca,
     id("lca", IdSpace::function, 0, "curve: second Piola-Kirchhoff stress over Green's strain along a; 0: EA")},
    {&FabricCards::lcb, id("lcb", IdSpace::function, 0, "the same along b; 0: EB")},
    {&FabricCards::lcab,
     id("lcab", IdSpace::function, 0, "the same of the shear, over twice Green's strain ab, for both signs; 0: GAB")},
    {&FabricCards::lcua,
     id("lcua", IdSpace::function, 0, "curve of unloading and reloading along a; 0: that of loading")},
    {&FabricCards::lcub, id("lcub", IdSpace::function, 0, "the same along b")},
    {&FabricCards::lcuab, id("lcuab", IdSpace::function, 0, "the same of the shear")},
    real("rl", dimension::number, 0, only(0), "0: reloading by the curve of unloading"),
};
const Card coating_card{{
    integer("lcaa", 0, only(0), "curve of a under strain in both directions"),
    integer("lcbb", 0, only(0), "curve of b under strain in both directions"),
    real("h", dimension::number, 0, only(0), "hysteresis"),
    real("dt", dimension::time, 0, only(0), "averaging of strain rates"),
    unused(),
    real("ecoat", dimension::stress, 0, only(0), "Young's modulus of a coating"),
    real("scoat", dimension::stress, 0, only(0), "yield stress of a coating"),
    real("tcoat", dimension::length, 0, only(0), "thickness of a coating"),
}};

/// *MAT_ADD_AIRBAG_POROSITY_LEAKAGE: these fields for any law.
struct LeakageCard {
  int mid = 0;
  double flc = 0, fac = 0, ela = 0, fvopt = 0, x0 = 0, x1 = 0;
};
const CardOf<LeakageCard> leakage_card{
    {&LeakageCard::mid, id("mid", IdSpace::material, required, "material whose shells leak")},
    {&LeakageCard::flc, leakage_flc},
    {&LeakageCard::fac, leakage_fac},
    {&LeakageCard::ela, leakage_ela},
    {&LeakageCard::fvopt, leakage_option},
    {&LeakageCard::x0, leakage_x0},
    {&LeakageCard::x1, leakage_x1},
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

bool moves_curve_numbers(const Block& block) {
  return block.transform != nullptr && block.transform->id_offset[static_cast<std::size_t>(IdSpace::function)] != 0;
}

/// How stress follows strain (FORM).
enum class FabricForm {
  sum,     ///< sum of strain increments
  green,   ///< Green's strain
  curves,  ///< the same, with curves
  none     ///< refused
};
FabricForm formulation_of(Builder& b, const deck::Entry& field) {
  const double form = field.value;
  const auto is = [form](std::initializer_list<double> some) { return std::ranges::find(some, form) != some.end(); };
  if (is({0, 1})) return FabricForm::sum;
  if (is({2, 3, 13, 4}))
    field.report(
        b.findings, Severity::note,
        fmt::format("computed as FORM {}: threads that shear are followed there as well", form == 4.0 ? 14 : 12));
  if (is({2, 3, 12, 13})) return FabricForm::green;
  if (is({4, 14, -14})) return FabricForm::curves;
  refuse(b, field,
         form == 24.0
             ? "formulation 24 of the fabric (nominal stress over nominal strain, coupled by Poisson's ratio) is "
               "not built"
             : "there is no such formulation of the fabric",
         form == 24.0 ? "write FORM 14 with curves of the second Piola-Kirchhoff stress over Green's strain"
                      : "write 0, 12 or 14");
  return FabricForm::none;
}

/// What a curve is of: a thread's stress over Green's strain, whose force S sqrt(1 + 2 E) should not fall; the stress
/// of shear, which must not; a way back, which must rise.
enum class ThreadRule { force, stress, rises };

/// A curve of a thread, by the field of its id; nothing where there is none. `whole` is cleared where it cannot be one.
std::optional<Curve> thread_curve(Builder& b, const deck::Entry& field, ThreadRule rule, bool& whole) {
  if (field.value == 0.0) return {};
  const auto refuse_curve = [&](std::string_view text, std::string_view remedy) {
    refuse(b, field, fmt::format("curve {}: {}", field.integer(), text), remedy);
    whole = false;
    return std::optional<Curve>{};
  };
  if (b.tables.find(field.integer()) != none)
    return refuse_curve("tables over the strain rate are not built", "give the curve of one rate");
  const Index found = b.curve(field);
  if (found == none) {
    whole = false;
    return {};
  }
  const Curve& curve = b.model.curves[found];
  if (curve.x.size() < 2) return refuse_curve("one point is no curve", "give at least two");
  if (curve.x.front() > 0.0 || curve.x.back() <= 0.0 || std::abs(curve.clamped(0.0)) > 1e-9 * std::abs(curve.y.back()))
    return refuse_curve("it does not begin at 0, 0", "let the stress be 0 without strain, and rise with it");
  double most = 0.0;  // force of the thread so far
  for (std::size_t i = 0; i < curve.y.size(); ++i) {
    if (rule == ThreadRule::force) {
      const double force = curve.y[i] * std::sqrt(1.0 + 2.0 * std::max(0.0, curve.x[i]));
      if (force < 0.99 * most) {
        field.report(b.findings, Severity::warning,
                     fmt::format("curve {}: the force of a thread, S sqrt(1 + 2 E), falls behind the strain {:g}: what "
                                 "stretches first stretches alone, which depends on the mesh",
                                 field.integer(), curve.x[i - 1]),
                     "give a curve whose force does not fall");
        break;
      }
      most = std::max(most, force);
    } else if (i > 0 &&
               (curve.y[i] < curve.y[i - 1] || (rule == ThreadRule::rises && !(curve.y[i] > curve.y[i - 1])))) {
      return refuse_curve(
          fmt::format("the stress {} after the strain {:g}", curve.y[i] < curve.y[i - 1] ? "falls" : "does not rise",
                      curve.x[i - 1]),
          rule == ThreadRule::rises ? "the way back must rise everywhere" : "give a curve that does not fall");
    }
  }
  return curve;
}

/// Takes the curves over once all are known.
void take_thread_curves(Builder& builder, const WovenFabric& woven, Index material, const deck::Entry& poisson,
                        const RowOf<FabricCards>& row) {
  using F = FabricCards;
  constexpr std::array loading{&F::lca, &F::lcb, &F::lcab}, unloading{&F::lcua, &F::lcub, &F::lcuab};
  const auto given = [&](int F::*field) { return row[field].value != 0.0; };
  if (std::ranges::none_of(loading, given) && std::ranges::none_of(unloading, given)) return;
  if (poisson.value != 0.0)
    poisson.report(builder.findings, Severity::warning,
                   "not obeyed: the threads of FORM 14 follow their curves and are not coupled", "write 0");
  builder.defer(Phase::parts, [=](Builder& b) {
    WovenFabric law = woven;
    law.by_curves = true;
    const std::array moduli{law.young_a, law.young_b, law.shear_ab};
    for (std::size_t k = 0; k < 3; ++k) {
      bool whole = true;
      std::optional<Curve> there =
          thread_curve(b, row[loading[k]], k < 2 ? ThreadRule::force : ThreadRule::stress, whole);
      const std::optional<Curve> back = thread_curve(b, row[unloading[k]], ThreadRule::rises, whole);
      if (!whole) return;
      if (!there && !back) continue;
      if (!there) there = Curve{.id = 0, .x = {0.0, 1.0}, .y = {0.0, moduli[k]}};
      law.curves[k].emplace(*there, back);
      if (const std::optional<double> strain = law.curves[k]->gives_energy())
        return refuse(
            b, row[unloading[k]],
            fmt::format("curve {} gives more energy back than loading to the strain {:.4g} took", back->id, *strain),
            "give a curve that lies below that of loading, or is steeper");
    }
    law.E = law.wave_modulus() * (1.0 - law.nu * law.nu);
    b.model.materials[material].law = kernel::composed_law({law});
  });
}

void read_leakage(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(leakage_card);
  expect_end(b, cursor);
  using L = LeakageCard;
  add_leakage(b,
              {row[&L::flc],
               row[&L::fac],
               row[&L::ela],
               row[&L::fvopt],
               row[&L::x0],
               row[&L::x1],
               {},
               moves_curve_numbers(block)},
              none, row[&L::mid]);
}

void read_fabric(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  FabricCards cards;
  const auto moduli = cursor.read(moduli_of_fabric_card, cards);
  const auto shear = cursor.read(shear_and_liner_card, cards);
  const auto form = cursor.read(form_card, cards);
  const FabricForm formulation = formulation_of(b, form[&FabricCards::form]);
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
  std::optional<RowOf<FabricCards>> axes_row, curves_row;
  if (formulation != FabricForm::none && cards.fvopt >= 0.0) {  // else more cards follow
    const auto first = cursor.read(fabric_axes_card, cards);
    const auto second = cursor.read(fabric_angle_card, cards);
    if (formulation == FabricForm::curves) curves_row = cursor.read(thread_curves_card, cards);
    if (cards.form == -14.0) cursor.read(coating_card);
    expect_end(b, cursor);
    law.axes = material_axes(b, block, cards, form[&AxesCards::aopt], first[&AxesCards::a1], second[&AxesCards::v1]);
    axes_row = first;
    law.axes.angle = hand(block) * cards.beta * (std::numbers::pi / 180.0);
  }
  law.nu = std::clamp(law.poisson_ba, 0.0, 0.45);
  law.E = law.wave_modulus() * (1.0 - law.nu * law.nu);
  const WovenFabric woven{law, false, {}};
  const Index material =
      add_material(b, moduli, std::move(title), "MAT_FABRIC",
                   formulation == FabricForm::sum ? kernel::composed_law({law}) : kernel::composed_law({woven}));
  if (curves_row) take_thread_curves(b, woven, material, moduli[&Fabric::poisson_ba], *curves_row);
  LeakageFields leakage{.flc = form[&FabricCards::flc],
                        .fac = form[&FabricCards::fac],
                        .ela = form[&FabricCards::ela],
                        .fvopt = form[&FabricCards::fvopt],
                        .moves_curve_numbers = moves_curve_numbers(block)};
  if (axes_row) {
    leakage.x0 = (*axes_row)[&FabricCards::x0];
    leakage.x1 = (*axes_row)[&FabricCards::x1];
    leakage.a0ref = (*axes_row)[&FabricCards::a0ref];
  }
  add_leakage(b, leakage, material, moduli[&MaterialCard::mid]);
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
                      {"", &fabric_angle_card},
                      {"if FORM = 4, 14 or -14", &thread_curves_card},
                      {"if FORM = -14", &coating_card}},
           .read = read_fabric},
          {.name = "MAT_ADD_AIRBAG_POROSITY_LEAKAGE",
           .options = {"TITLE"},
           .layout = {{"", &leakage_card}},
           .read = read_leakage}};
}

}  // namespace nugget::reading
