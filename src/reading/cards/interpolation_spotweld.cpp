// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/sheet_joins.hpp"
#include "reading/cards/weld_function.hpp"

// *CONSTRAINED_INTERPOLATION_SPOTWELD (SPR3). Layout: public keyword tables (PyDYNA).
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

constexpr Dimension per_length{0, -1, 0};

constexpr IntegerField sheet_field(std::string_view name, std::string_view meaning) {
  return or_negative(id(name, IdSpace::part, required, meaning), IdSpace::set);
}
/// A field of what is not built, which must be blank.
constexpr RealField left_blank(std::string_view name, std::string_view meaning) {
  return real(name, dimension::number, 0, only(0), meaning);
}

struct SpotweldJoinCard {
  int pid1 = 0, pid2 = 0, nsid = 0;
  double thick = 0, r = 0, stiff = 0, alpha1 = 0;
  int model = 1;
};
const CardOf<SpotweldJoinCard> spotweld_join_card{
    {&SpotweldJoinCard::pid1,
     sheet_field("pid1", "part of the first sheet; below 0: set of the parts that make it up")},
    {&SpotweldJoinCard::pid2,
     sheet_field("pid2", "part of the second sheet; below 0: set of parts. One part as both: not built")},
    {&SpotweldJoinCard::nsid, id("nsid", IdSpace::set, required, "nodes where the welds are, between the sheets")},
    {&SpotweldJoinCard::thick,
     real("thick", dimension::length, required, above_zero(),
          "thickness of both sheets together; a location node reaches so far for each sheet")},
    {&SpotweldJoinCard::r, real("r", dimension::length, required, above_zero(), "radius of the weld")},
    {&SpotweldJoinCard::stiff, real("stiff", dimension::force_per_length, required, above_zero(),
                                    "elastic stiffness, and what STIFF2 to STIFF4 are where they are blank")},
    {&SpotweldJoinCard::alpha1,
     real("alpha1", per_length, 0, at_least(0), "share of the bending moment in the normal force of yield, alpha 1")},
    {&SpotweldJoinCard::model,
     integer("model", 1, any_value,
             "1 (SPR3) and 3, the same law; 11: STIFF, ALPHA1, RN, RS and BETA are functions of both sheets; 2, 12, 22 "
             "(SPR4) and others are not built")},
};
struct SpotweldYieldCard {
  double rn = 0, rs = 0, beta = 0;
  int lcf = 0, lcupf = 0, lcupr = 0;
  double dens = 0;
};
const CardOf<SpotweldYieldCard> spotweld_yield_card{
    {&SpotweldYieldCard::rn,
     or_negative(real("rn", dimension::number, required, any_value,
                      "factor on LCF in tension; below 0, a curve over the peel ratio: not built"),
                 IdSpace::function)},
    {&SpotweldYieldCard::rs, real("rs", dimension::number, required, above_zero(), "factor on LCF in shear")},
    {&SpotweldYieldCard::beta,
     real("beta", dimension::number, required, at_least(1), "exponent of the yield surface, beta 1")},
    {&SpotweldYieldCard::lcf, id("lcf", IdSpace::function, required, "curve: force over plastic displacement")},
    {&SpotweldYieldCard::lcupf,
     id("lcupf", IdSpace::function, 0,
        "curve: plastic displacement at which damage begins, over the mode mixity from 0 (shear) to 1 (tension)")},
    {&SpotweldYieldCard::lcupr,
     id("lcupr", IdSpace::function, 0, "curve: that at which the weld breaks, over the same")},
    {&SpotweldYieldCard::dens,
     real("dens", dimension::density, required, above_zero(), "density: the weld has the mass DENS pi R^2 THICK")},
    integer("intp", 0, only(0), "weights of the sheets' nodes: 0, here by the area of the weld; others are not built"),
};
struct SpotweldStiffnessCard {
  double stiff2 = 0, stiff3 = 0, stiff4 = 0;
  int lcdexp = 0;
  double gamma = 0;
  int pidvb = 0;
};
const CardOf<SpotweldStiffnessCard> spotweld_stiffness_card{
    {&SpotweldStiffnessCard::stiff2,
     or_negative(real("stiff2", dimension::force_per_length, 0, any_value,
                      "stiffness in shear; blank: STIFF; below 0, a curve over the angle of the load: not built"),
                 IdSpace::function)},
    {&SpotweldStiffnessCard::stiff3, real("stiff3", dimension::moment, 0, at_least(0),
                                          "stiffness in bending, moment per radian; blank: the number STIFF")},
    {&SpotweldStiffnessCard::stiff4,
     real("stiff4", dimension::moment, 0, at_least(0), "stiffness in torsion; blank: the number STIFF")},
    {&SpotweldStiffnessCard::lcdexp, id("lcdexp", IdSpace::function, 0, "exponent of damage: not built")},
    {&SpotweldStiffnessCard::gamma,
     real("gamma", per_length, 0, at_least(0), "share of the torsion in the shear force of yield, gamma 1")},
    integer("sropt", 0, only(0), "1: pure shear makes a normal component; not built"),
    {&SpotweldStiffnessCard::pidvb,
     integer("pidvb", 0, any_value,
             "id of the part of the beams that show the welds; 0: the next free one. Below 0, its "
             "size counts: broken ones always go")},
};
const Card spotweld_scale_card{{
    real("scarn", dimension::number, 1, only(1), "factor on RN and displacements: not built"),
    real("scars", dimension::number, 1, only(1), "factor on RS and displacements: not built"),
    left_blank("damp", "viscous coefficient: its formula is not documented"),
    left_blank("sproff", "place of the weld between the sheets: amid them"),
    unused(),
    left_blank("failbm", "erosion of shells where the weld breaks: not built"),
}};
const Card spotweld_force_failure{{
    left_blank("ffn", "normal force at failure: not built"),
    left_blank("ffb", "bending force at failure: not built"),
    left_blank("ffs", "shear force at failure: not built"),
    left_blank("exfc", "exponent of these: not built"),
    left_blank("stifp", "linear hardening in place of LCF: not built"),
    left_blank("mfsfc", "not built"),
    left_blank("defc", "not built"),
    left_blank("npfc", "not built"),
}};

struct SpotweldRows {
  std::string title;
  RowOf<SpotweldJoinCard> join;
  RowOf<SpotweldYieldCard> yield;
  RowOf<SpotweldStiffnessCard> stiffness;
};

/// What a weld of a model that is not built would be; empty: it is built.
std::string_view why_no_model(int model) {
  switch (model) {
    case 1:
    case 3:
    case 11: return {};
    case 2:
    case 12:
    case 22: return "SPR4 is not built";
    default: return "what it does other than 11 is not public";
  }
}

/// Ends the reading of a card whose form is another one.
bool refuse_model(Builder& b, const RowOf<SpotweldJoinCard>& join) {
  const std::string_view why = why_no_model(join->model);
  if (why.empty()) return false;
  refuse(b, join[&SpotweldJoinCard::model], fmt::format("{}; expected 1, 3 or 11 (SPR3)", why),
         "fit SPR3: RN, RS, BETA, ALPHA1 with LCF, LCUPF and LCUPR");
  return true;
}

std::vector<Index> parts_of_sheet(Builder& b, deck::Entry field) {
  std::vector<Index> parts;
  if (field.value < 0.0) {
    field.value = -field.value;
    if (const Set<Index>* set = b.part_set(field)) parts = set->members;
  } else if (const Index part = b.part(field); part != none) {
    parts = {part};
  }
  for (const Index part : parts)
    if (b.model.parts[part].kind != ElementKind::shell) {
      refuse(b, field, fmt::format("part {} has no shells, and a weld joins sheets", b.model.parts[part].id),
             "name parts of shells");
      return {};
    }
  return parts;
}

void take_yield_curve(Builder& b, const RowOf<SpotweldYieldCard>& row, kernel::Spr3& law) {
  const Index c = b.curve(row[&SpotweldYieldCard::lcf]);
  if (c == none) return;
  law.yield = kernel::ForceCurve(b.model.curves[c]);
  const auto refuse_curve = [&](std::string_view text, std::string_view remedy) {
    refuse(b, row[&SpotweldYieldCard::lcf], text, remedy);
  };
  if (b.model.curves[c].x.front() < 0.0)
    return refuse_curve("a plastic displacement is never below 0",
                        "begin the curve at 0, with the force of first yield");
  if (law.yield.lowest() < 0.0 || !(law.yield.yield(0.0) > 0.0))
    return refuse_curve("expected a force above 0 at first yield and none below 0 later", "give such a curve");
  const double fall = 2.0 * law.yield.steepest_fall();  // half of what one mode alone bears: both fall together
  if (fall * law.normal_strength >= law.normal || fall * law.shear_strength >= law.shear)
    refuse_curve("the force falls more than half as fast as the elastic force, so it cannot be followed",
                 "let damage soften the weld (LCUPF, LCUPR), or give a curve that falls less steeply");
}

void take_damage_curves(Builder& b, const RowOf<SpotweldYieldCard>& row, kernel::Spr3& law) {
  if ((row->lcupf == 0) != (row->lcupr == 0))
    return refuse(b, row[row->lcupf == 0 ? &SpotweldYieldCard::lcupf : &SpotweldYieldCard::lcupr],
                  "damage needs both LCUPF and LCUPR", "give both, or neither for a weld that never breaks");
  const Index begins = b.curve(row[&SpotweldYieldCard::lcupf]), ends = b.curve(row[&SpotweldYieldCard::lcupr]);
  if (begins == none || ends == none) return;
  law.initiation = b.model.curves[begins];
  law.rupture = b.model.curves[ends];
  constexpr double beyond_round_off = 1.0 + 1e-6;
  for (const auto& [curve, field] :
       {std::pair{&law.initiation, &SpotweldYieldCard::lcupf}, {&law.rupture, &SpotweldYieldCard::lcupr}})
    if (curve->x.front() < 0.0 || curve->x.back() > beyond_round_off)
      return refuse(b, row[field],
                    fmt::format("its abscissae run from {:.4g} to {:.4g}, a mode mixity from 0 to 1", curve->x.front(),
                                curve->x.back()),
                    "0 is shear, 1 tension: kappa = 2/pi atan(f_n / f_s)");
  for (const Curve* curve : {&law.initiation, &law.rupture})
    for (const double kappa : curve->x)
      if (!(law.rupture.clamped(kappa) > law.initiation.clamped(kappa)) || law.initiation.clamped(kappa) < 0.0)
        return refuse(b, row[&SpotweldYieldCard::lcupr],
                      fmt::format("at a mode mixity of {:.4g} it breaks at {:.4g} and damage begins at {:.4g}", kappa,
                                  law.rupture.clamped(kappa), law.initiation.clamped(kappa)),
                      "let LCUPR lie above LCUPF everywhere, and LCUPF not below 0");
}

/// One of the parts of a sheet, which must all be alike.
model::WeldedSheet sheet_of_functions(Builder& b, const std::vector<Index>& parts, const deck::Entry& field) {
  const auto of = [&b](const Part& part) {
    const double thickness = part.section == none ? 0.0 : b.model.shell_sections[part.section].thickness;
    return part.material == none ? model::WeldedSheet{}
                                 : model::welded_sheet(b.model.materials[part.material], thickness);
  };
  const model::WeldedSheet first = of(b.model.parts[parts.front()]);
  for (const Index part : parts)
    if (of(b.model.parts[part]) != first) {
      refuse(b, field, "the parts of the sheet differ in thickness or material, and one card has one set of numbers",
             "write a card for each, with location nodes of its own");
      break;
    }
  return first;
}

/// The numbers that MODEL 11 makes of both sheets.
struct Spr3Numbers {
  double stiff, alpha1, rn, rs, beta;
};
Spr3Numbers spr3_numbers(Builder& b, const SpotweldRows& rows, const InterpolationSpotweld& weld) {
  if (rows.join->model != 11)
    return {rows.join->stiff, rows.join->alpha1, rows.yield->rn, rows.yield->rs, rows.yield->beta};
  model::WeldFunctionInput input;
  input.sheet = {sheet_of_functions(b, weld.sheet[0], rows.join[&SpotweldJoinCard::pid1]),
                 sheet_of_functions(b, weld.sheet[1], rows.join[&SpotweldJoinCard::pid2])};
  input.area = std::numbers::pi * weld.radius * weld.radius;
  const auto value = [&](const deck::Entry& field, double least, bool that_too) {
    const Index function = weld_function(b, field);
    if (function == none) return 1.0;
    const Formula& formula = b.model.functions[function].formula;
    const bool yields = input.sheet[0].yield > 0.0 && input.sheet[1].yield > 0.0;
    const double result = model::value_of(formula, input);
    if (formula.uses(model::rate_argument))
      refuse(b, field, "it asks for r, which is no number of a weld of this kind", "let it not depend on r");
    else if (model::asks_for_yield(formula) && !yields)
      refuse(b, field, "it asks for the yield stress of both sheets, one of which has none",
             "give a function without sy1 to sm2");
    else if (!std::isfinite(result) || result < least || (result == least && !that_too))
      refuse(b, field,
             fmt::format("it gives {:.6g} for these sheets; expected {} {}", result, that_too ? "at least" : "above",
                         least),
             "correct the function");
    return result;
  };
  return {.stiff = value(rows.join[&SpotweldJoinCard::stiff], 0.0, false),
          .alpha1 = rows.join->alpha1 == 0.0 ? 0.0 : value(rows.join[&SpotweldJoinCard::alpha1], 0.0, true),
          .rn = value(rows.yield[&SpotweldYieldCard::rn], 0.0, false),
          .rs = value(rows.yield[&SpotweldYieldCard::rs], 0.0, false),
          .beta = value(rows.yield[&SpotweldYieldCard::beta], 1.0, true)};
}

kernel::Spr3 spr3_law(Builder& b, const SpotweldRows& rows, const InterpolationSpotweld& weld) {
  kernel::Spr3 law;
  const Spr3Numbers numbers = spr3_numbers(b, rows, weld);
  const auto or_stiff = [&](double own) { return own > 0.0 ? own : numbers.stiff; };
  law.normal = numbers.stiff;
  law.shear = or_stiff(rows.stiffness->stiff2);
  law.bending = or_stiff(rows.stiffness->stiff3);
  law.torsion = or_stiff(rows.stiffness->stiff4);
  law.normal_strength = numbers.rn;
  law.shear_strength = numbers.rs;
  law.exponent = numbers.beta;
  law.bending_share = numbers.alpha1;
  law.torsion_share = rows.stiffness->gamma;
  take_yield_curve(b, rows.yield, law);
  take_damage_curves(b, rows.yield, law);
  return law;
}

/// The number STIFF stands for a moment per radian where STIFF3, STIFF4 are blank: of one unit of length squared.
void note_units_of_bending(Builder& b, const SpotweldRows& rows, double stiffness) {
  if (rows.stiffness->stiff3 > 0.0 && rows.stiffness->stiff4 > 0.0) return;
  rows.join[&SpotweldJoinCard::stiff].report(
      b.findings, Severity::note,
      fmt::format(
          "STIFF3 or STIFF4 is blank: a moment of {:.4g} a radian, the number STIFF, which is another stiffness "
          "in other units of length",
          stiffness),
      "give STIFF3 and STIFF4");
}

/// The sheets and the location nodes.
void take_sheets(Builder& b, const deck::Entry& first, const deck::Entry& second, const deck::Entry& nsid,
                 InterpolationSpotweld& weld) {
  weld.sheet = {parts_of_sheet(b, first), parts_of_sheet(b, second)};
  for (const Index part : weld.sheet[0])
    if (std::find(weld.sheet[1].begin(), weld.sheet[1].end(), part) != weld.sheet[1].end())
      return refuse(
          b, second,
          fmt::format("part {} stands on both sides; a sheet joined with itself is not built", b.model.parts[part].id),
          "give the two sheets parts of their own");
  if (const Set<Index>* nodes = b.node_set(nsid)) weld.nodes = nodes->members;
}

void make_spotwelds(Builder& b, const SpotweldRows& rows) {
  const int errors = b.findings.errors();
  InterpolationSpotweld weld;
  weld.title = rows.title;
  take_sheets(b, rows.join[&SpotweldJoinCard::pid1], rows.join[&SpotweldJoinCard::pid2],
              rows.join[&SpotweldJoinCard::nsid], weld);
  weld.thickness = rows.join->thick;
  weld.radius = rows.join->r;
  weld.density = rows.yield->dens;
  weld.part = std::abs(rows.stiffness->pidvb);
  if (weld.part != 0 && b.model.part_index(weld.part) != none)
    refuse(b, rows.stiffness[&SpotweldStiffnessCard::pidvb], fmt::format("part {} is in the deck", weld.part),
           "leave it blank, or give an id that is free");
  if (weld.sheet[0].empty() || weld.sheet[1].empty()) return;
  const kernel::Spr3 law = spr3_law(b, rows, weld);
  weld.law = law;
  weld.place = rows.join.place();
  if (b.findings.errors() > errors) return;
  note_units_of_bending(b, rows, law.normal);
  b.model.interpolation_spotwelds.push_back(std::move(weld));
}

void read_interpolation_spotweld(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  std::string title = read_title(cursor, options);
  const auto join = cursor.read(spotweld_join_card);
  if (refuse_model(builder, join)) return;
  if (join->model == 11) refuse_transformed_functions(builder, block, join[&SpotweldJoinCard::model]);
  const auto yield = cursor.read(spotweld_yield_card);
  if (yield->rn <= 0.0)
    refuse(builder, yield[&SpotweldYieldCard::rn],
           yield->rn < 0.0 ? "a curve over the peel ratio is not built" : "expected a factor above 0", "give a number");
  // The cards for MODEL 1 that may follow are read, blank or not.
  const auto stiffness = cursor.read(spotweld_stiffness_card);
  if (stiffness->stiff2 < 0.0)
    refuse(builder, stiffness[&SpotweldStiffnessCard::stiff2], "a curve over the angle of the load is not built",
           "give a number, or leave it blank");
  refuse_nonzero(builder, stiffness[&SpotweldStiffnessCard::lcdexp],
                 "an exponent of damage is not built: damage is linear", "leave it blank");
  if (!at_end(cursor)) cursor.read(spotweld_scale_card);
  if (!at_end(cursor)) cursor.read(spotweld_force_failure);
  expect_end(builder, cursor);
  builder.defer(Phase::conditions, [rows = SpotweldRows{std::move(title), join, yield, stiffness}](Builder& later) {
    make_spotwelds(later, rows);
  });
}

// ---- self-piercing rivets

struct RivetPlaceCard {
  int upid = 0, lpid = 0, nsid = 0;
  double thick = 0, d = 0, fn = 0, ft = 0, dn = 0;
};
const CardOf<RivetPlaceCard> rivet_place_card{
    {&RivetPlaceCard::upid, id("upid", IdSpace::part, required, "part of the upper sheet, that of the rivet's head")},
    {&RivetPlaceCard::lpid, id("lpid", IdSpace::part, required, "part of the lower sheet")},
    {&RivetPlaceCard::nsid, id("nsid", IdSpace::set, required, "nodes where the rivets are, between the sheets")},
    {&RivetPlaceCard::thick, real("thick", dimension::length, required, above_zero(),
                                  "thickness of both sheets together; a location node reaches so far for each sheet")},
    {&RivetPlaceCard::d, real("d", dimension::length, required, above_zero(), "diameter of the rivet")},
    {&RivetPlaceCard::fn,
     or_negative(real("fn", dimension::force, required, any_value,
                      "largest force in tension (pull-out); below 0, a *MAT_CONSTRAINED_SPR2: not built"),
                 IdSpace::material)},
    {&RivetPlaceCard::ft, real("ft", dimension::force, required, above_zero(), "largest force in shear")},
    {&RivetPlaceCard::dn,
     real("dn", dimension::length, required, above_zero(), "opening at which the rivet is pulled out")},
};
constexpr RealField share_of_displacement(std::string_view name, std::string_view meaning) {
  return real(name, dimension::number, required, between(1e-6, 1.0 - 1e-6), meaning);
}
struct RivetShapeCard {
  double dt = 0, xin = 0, xit = 0, alpha1 = 0, alpha2 = 0, alpha3 = 0, dens = 0;
};
const CardOf<RivetShapeCard> rivet_shape_card{
    {&RivetShapeCard::dt, real("dt", dimension::length, required, above_zero(), "sliding at which it is gone")},
    {&RivetShapeCard::xin, share_of_displacement("xin", "share of DN at which the tension is largest")},
    {&RivetShapeCard::xit, share_of_displacement("xit", "share of DT at which the shear is largest")},
    {&RivetShapeCard::alpha1, real("alpha1", dimension::number, required, above_zero(),
                                   "divisor of the effective displacement between tension and shear, undamaged")},
    {&RivetShapeCard::alpha2, real("alpha2", dimension::number, required, above_zero(), "the same at the damage XIT")},
    {&RivetShapeCard::alpha3,
     real("alpha3", dimension::number, required, any_value,
          "the same at rupture; its sign, which chooses how the normal is followed, makes no difference here")},
    {&RivetShapeCard::dens,
     real("dens", dimension::density, required, above_zero(), "density: a rivet has the mass DENS pi D^2/4 THICK")},
    integer("intp", 0, only(0), "weights of the sheets' nodes: 0, here by the area of the rivet; others are not built"),
};
struct RivetExponentCard {
  double expn = 8, expt = 8;
  int pidvb = 0;
};
const CardOf<RivetExponentCard> rivet_exponent_card{
    {&RivetExponentCard::expn,
     real("expn", dimension::number, 8, at_least(1), "exponent of the force before its largest value, in tension")},
    {&RivetExponentCard::expt, real("expt", dimension::number, 8, at_least(1), "the same in shear")},
    {&RivetExponentCard::pidvb,
     integer("pidvb", 0, any_value, "id of the part of the beams that show the rivets; 0: the next free one")},
};
const Card rivet_more_sheets_card{{
    integer("xpid1", 0, only(0), "a third sheet: not built; write a rivet for each two sheets"),
    integer("xpid2", 0, only(0), "likewise"),
    integer("xpid3", 0, only(0), "likewise"),
    integer("xpid4", 0, only(0), "likewise"),
}};

kernel::Spr2 spr2_law(const RowOf<RivetPlaceCard>& place, const RowOf<RivetShapeCard>& shape,
                      const RowOf<RivetExponentCard>& exponents) {
  kernel::Spr2 law;
  law.normal_force = place->fn;
  law.shear_force = place->ft;
  law.normal_failure = place->dn;
  law.shear_failure = shape->dt;
  law.normal_peak = shape->xin;
  law.shear_peak = shape->xit;
  law.alpha = {shape->alpha1, shape->alpha2, std::abs(shape->alpha3)};
  law.normal_exponent = exponents->expn;
  law.shear_exponent = exponents->expt;
  law.arm = 0.5 * place->thick;
  return law;
}

void make_rivets(Builder& b, const RowOf<RivetPlaceCard>& place, const RowOf<RivetShapeCard>& shape,
                 const RowOf<RivetExponentCard>& exponents) {
  const int errors = b.findings.errors();
  InterpolationSpotweld rivet;
  take_sheets(b, place[&RivetPlaceCard::upid], place[&RivetPlaceCard::lpid], place[&RivetPlaceCard::nsid], rivet);
  if (place->fn <= 0.0)
    refuse(b, place[&RivetPlaceCard::fn],
           place->fn < 0.0 ? "data of *MAT_CONSTRAINED_SPR2 are not built" : "expected a force above 0",
           "write FN to EXPT on the cards of the rivet");
  if (shape->alpha3 == 0.0) refuse(b, shape[&RivetShapeCard::alpha3], "expected a divisor", "1 has no effect");
  rivet.thickness = place->thick;
  rivet.radius = 0.5 * place->d;
  rivet.density = shape->dens;
  rivet.part = std::abs(exponents->pidvb);
  if (rivet.part != 0 && b.model.part_index(rivet.part) != none)
    refuse(b, exponents[&RivetExponentCard::pidvb], fmt::format("part {} is in the deck", rivet.part),
           "leave it blank, or give an id that is free");
  rivet.law = spr2_law(place, shape, exponents);
  rivet.place = place.place();
  if (b.findings.errors() == errors) b.model.interpolation_spotwelds.push_back(std::move(rivet));
}

void read_spr2(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto place = cursor.read(rivet_place_card);
  const auto shape = cursor.read(rivet_shape_card);
  const auto exponents = cursor.read(rivet_exponent_card);  // blank where it is missing
  if (!at_end(cursor)) cursor.read(rivet_more_sheets_card);
  expect_end(builder, cursor);
  builder.defer(Phase::conditions, [=](Builder& later) { make_rivets(later, place, shape, exponents); });
}

SheetJoin spotweld_join(const deck::Deck& deck, const Block& block, Findings& findings) {
  Cursor cursor(deck, block, findings);
  if (block.keyword.ends_with("_TITLE")) cursor.skip();
  const auto card = cursor.read(spotweld_join_card);
  return {block.starred(), card->pid1, card->pid2, card->nsid, 2.0 * card->r, card.place()};
}

SheetJoin rivet_join(const deck::Deck& deck, const Block& block, Findings& findings) {
  Cursor cursor(deck, block, findings);
  const auto card = cursor.read(rivet_place_card);
  return {block.starred(), card->upid, card->lpid, card->nsid, card->d, card.place()};
}

}  // namespace

std::vector<SheetJoin> sheet_joins(const deck::Deck& deck) {
  Findings elsewhere;
  std::vector<SheetJoin> joins;
  for (const Block& block : deck.blocks) {
    if (block.keyword.starts_with("CONSTRAINED_INTERPOLATION_SPOTWELD"))
      joins.push_back(spotweld_join(deck, block, elsewhere));
    else if (block.keyword == "CONSTRAINED_SPR2")
      joins.push_back(rivet_join(deck, block, elsewhere));
  }
  return joins;
}

std::vector<Keyword> interpolation_spotweld_keywords() {
  return {{.name = "CONSTRAINED_SPR2",
           .layout = {{{}, &rivet_place_card},
                      {{}, &rivet_shape_card},
                      {"if given", &rivet_exponent_card},
                      {"if given", &rivet_more_sheets_card}},
           .read = read_spr2},
          {.name = "CONSTRAINED_INTERPOLATION_SPOTWELD",
           .options = {"TITLE"},
           .layout = {{"with _TITLE", &title_card},
                      {{}, &spotweld_join_card},
                      {{}, &spotweld_yield_card},
                      {"if given", &spotweld_stiffness_card},
                      {"if given", &spotweld_scale_card},
                      {"if given", &spotweld_force_failure}},
           .read = read_interpolation_spotweld}};
}

}  // namespace nugget::reading
