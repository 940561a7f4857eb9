// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "model/axes.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"
#include "reading/cards/rigid_constraint.hpp"
#include "reading/cards/yield_curves.hpp"

// *MAT_... Each law: its cards, and how they become the parameters of its kernel.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using deck::RowOf;

struct ElasticCard : MaterialCard, kernel::Elastic {};
const CardOf<ElasticCard> elastic_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&kernel::Elastic::E, young},
    {&kernel::Elastic::nu, poisson},
    real("da", dimension::number, 0, any_value, "axial damping of Belytschko-Schwer beams, no effect here"),
    real("db", dimension::number, 0, any_value, "bending damping of Belytschko-Schwer beams, no effect here"),
    unused(),
    unused(),
};

/// Both cards of *MAT_PLASTIC_KINEMATIC.
struct KinematicCards : MaterialCard, kernel::PlasticKinematic {
  double src = 0, srp = 0;
};
const CardOf<KinematicCards> kinematic_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&kernel::PlasticKinematic::E, young},
    {&kernel::PlasticKinematic::nu, poisson},
    {&kernel::PlasticKinematic::yield, real("sigy", dimension::stress, required, above_zero(), "yield stress")},
    {&kernel::PlasticKinematic::tangent_modulus,
     real("etan", dimension::stress, 0, at_least(0), "tangent modulus, below E")},
    {&kernel::PlasticKinematic::beta,
     real("beta", dimension::number, 0, between(0, 1), "hardening: 0 kinematic, 1 isotropic")},
    unused(),
};

const CardOf<KinematicCards> kinematic_rate_card{
    {&KinematicCards::src, real("src", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect")},
    {&KinematicCards::srp, real("srp", dimension::number, 0, at_least(0), "Cowper-Symonds P")},
    {&kernel::PlasticKinematic::failure_strain,
     real("fs", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none")},
    vp,
};

struct NullCard : MaterialCard {
  double pc = 0, mu = 0, terod = 0, cerod = 0, ym = 0, pr = 0;
};
const CardOf<NullCard> null_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&NullCard::pc,
     real("pc", dimension::stress, 0, any_value, "solids: the pressure falls no further; below 0, or 0: no limit")},
    {&NullCard::mu,
     real("mu", {1, -1, -1}, 0, at_least(0), "solids: viscosity; deviators are 2 MU times those of the strain rate")},
    {&NullCard::terod, real("terod", dimension::number, 0, at_least(0),
                            "solids: relative volume at which they erode in tension, above 1; 0: none")},
    {&NullCard::cerod, real("cerod", dimension::number, 0, between(0, 1), "the same in compression, below 1; 0: none")},
    {&NullCard::ym, real("ym", dimension::stress, 0, at_least(0), "shells, beams: Young's modulus, for contact only")},
    {&NullCard::pr,
     real("pr", dimension::number, 0, between(0, 0.5), "shells, beams: Poisson's ratio, for contact only")},
};

struct RigidMaterialCard : MaterialCard, kernel::Rigid {};
const CardOf<RigidMaterialCard> rigid_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&kernel::Rigid::E, real("e", dimension::stress, 0, at_least(0), "Young's modulus, for contact only")},
    {&kernel::Rigid::nu, real("pr", dimension::number, 0, between(0, 0.5), "Poisson's ratio, for contact only")},
    real("n", dimension::number, 0, only(0), "coupling with MADYMO or CAL3D"),
    real("couple", dimension::number, 0, only(0), "coupling with MADYMO or CAL3D"),
    real("m", dimension::number, 0, only(0), "coupling with MADYMO or CAL3D"),
    text("alias", 10, "name for MADYMO, no effect"),
};

struct RigidOutputCard {
  double a1 = 0, a2 = 0, a3 = 0, v1 = 0, v2 = 0, v3 = 0;
};
const CardOf<RigidOutputCard> rigid_output_card{
    {&RigidOutputCard::a1, real("lco_or_a1", dimension::number, 0, any_value,
                                "LCO, coordinate system of local motions; else first of two vectors")},
    {&RigidOutputCard::a2, real("a2", dimension::number, 0, any_value, "first vector a: first of the body's own axes")},
    {&RigidOutputCard::a3, real("a3", dimension::number, 0, any_value, "first vector a: first of the body's own axes")},
    {&RigidOutputCard::v1,
     real("v1", dimension::number, 0, any_value, "second vector v: third axis c = a x v, second c x a")},
    {&RigidOutputCard::v2,
     real("v2", dimension::number, 0, any_value, "second vector v: third axis c = a x v, second c x a")},
    {&RigidOutputCard::v3,
     real("v3", dimension::number, 0, any_value, "second vector v: third axis c = a x v, second c x a")},
    integer("bndlco", 0, any_value, "axes of bndout, no effect"),
};

const CardOf<YieldCards> plastic_card = yield_card({
    {&YieldCards::fail, real("fail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none")},
    {&YieldCards::tdel, tdel},
});

const CardOf<YieldCards> plastic_rate_card = yield_rate_card({
    {&YieldCards::vp, vp_of_curves},
    unused(),
    real("rfiltf", dimension::number, 0, any_value, "filter of the plastic rate of vp 4: not needed, no effect"),
    unused(),
});

void read_elastic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(elastic_card);
  expect_end(b, cursor);
  add_material(b, row, std::move(title), "MAT_ELASTIC", static_cast<const kernel::Elastic&>(*row));
}

void read_kinematic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  KinematicCards cards;
  const auto row = cursor.read(kinematic_card, cards);
  const auto rate = cursor.read(kinematic_rate_card, cards);
  expect_end(b, cursor);
  check_tangent(b, cards.E, row[&kernel::PlasticKinematic::tangent_modulus]);
  warn_of_half_a_rate(b, rate[&KinematicCards::src], rate[&KinematicCards::srp]);
  kernel::PlasticKinematic law = cards;
  if (cards.src > 0.0 && cards.srp > 0.0) {
    law.rate_c = cards.src;
    law.rate_p = cards.srp;
  }
  law.failure_strain = failure_value(law.failure_strain);
  add_material(b, row, std::move(title), "MAT_PLASTIC_KINEMATIC", law);
}

void read_null(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(null_card);
  expect_end(b, cursor);
  if (row->pc > 0.0)
    row[&NullCard::pc].report(b.findings, Severity::warning, "a limit of the pressure is below 0; taken as none",
                              "write a negative pressure");
  if (row->terod > 0.0 && row->terod <= 1.0)
    refuse(b, row[&NullCard::terod], "a solid has this volume at the start already", "give a volume above 1, or 0");
  if (row->cerod == 1.0)
    refuse(b, row[&NullCard::cerod], "a solid has this volume at the start already", "give a volume below 1, or 0");
  add_material(b, row, std::move(title), "MAT_NULL",
               kernel::Null{row->ym, row->pr, row->mu, std::max(-row->pc, 0.0), row->terod, row->cerod});
}

/// The third card: LCO, the coordinate system of local motions and output, or two vectors a and v that give the
/// axes of output a, c = a x v and b = c x a.
void take_local_axes(Builder& b, const Block& block, const RowOf<RigidOutputCard>& row, RigidCard& card) {
  const Vec3d v = direction(block, {row->v1, row->v2, row->v3});
  if (row->a2 == 0.0 && row->a3 == 0.0 && norm(v) == 0.0) {
    card.lco = system_id(block, row->a1);
    return;
  }
  Frame3d axes;
  if (!frame_from(direction(block, {row->a1, row->a2, row->a3}), v, axes))
    return refuse(b, row[&RigidOutputCard::v1], "the two vectors are parallel, or one is missing",
                  "give two vectors that span a plane");
  card.output_axes = axes;
}

void read_rigid(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(rigid_card);
  RigidCard card;
  card.constraint = read_rigid_constraint(b, cursor);
  take_local_axes(b, block, cursor.read(rigid_output_card), card);
  expect_end(b, cursor);
  const Index material = add_material(b, row, std::move(title), "MAT_RIGID", static_cast<const kernel::Rigid&>(*row));
  b.rigid_cards[material] = std::move(card);
}

void read_plastic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const YieldRows rows =
      read_yield_cards(cursor, plastic_card, plastic_rate_card, options.contains("LOG_INTERPOLATION"));
  expect_end(b, cursor);
  const YieldCards& cards = rows.cards();
  check_tangent(b, cards.e, rows.main[&YieldCards::etan]);
  kernel::PiecewiseLinear law;
  law.E = cards.e;
  law.nu = cards.pr;
  law.failure_strain = failure_value(cards.fail);
  law.deletion_step = cards.tdel;
  const Index material = add_material(b, rows.main, std::move(title), "MAT_PIECEWISE_LINEAR_PLASTICITY", law);
  // Curves may be defined later in the deck.
  b.defer(Phase::parts, [material, rows](Builder& later) {
    auto& m = later.model.materials[material];
    set_yield_curves(later, rows, std::get<kernel::PiecewiseLinear>(m.law));
  });
}

/// A material of LS-DYNA that is not built.
Keyword not_built(std::string_view name, std::string_view number, std::string_view why) {
  return {.name = name,
          .aliases = number.empty() ? std::vector<std::string_view>{} : std::vector<std::string_view>{number},
          .options = {"TITLE"},
          .status = KeywordStatus::refused,
          .why = why};
}

constexpr std::string_view use_036 = "this law is not built; *MAT_3-PARAMETER_BARLAT comes nearest";

}  // namespace

double failure_value(double written) {
  return written >= 1e20 ? 0.0 : written;
}

double plastic_strain_at_failure(double written) {
  return written >= 1e12 ? 0.0 : written;
}

std::optional<kernel::PlasticDamage> plastic_damage(Builder& b, const deck::Entry& onset_entry,
                                                    const deck::Entry& rupture_entry, const deck::Entry& lcdm) {
  const double onset = plastic_strain_at_failure(onset_entry.value);
  const double rupture = plastic_strain_at_failure(rupture_entry.value);
  if (const Index curve = b.curve(lcdm); curve != none) {
    if (rupture > 0.0)
      refuse(b, lcdm, "a damage curve together with EPPFR is not supported", "give the onset and LCDM only");
    const Curve& growth = b.model.curves[curve];
    if (growth.x.front() < 0.0 || growth.y.front() < 0.0 || !std::is_sorted(growth.y.begin(), growth.y.end()))
      refuse(b, lcdm,
             fmt::format("curve {} is not a damage that grows from 0 over the strain beyond its onset", growth.id),
             "give damage from 0 to 1 over plastic strain, from strain 0 on");
    else if (growth.y.back() < 1.0)
      lcdm.report(b.findings, Severity::warning, fmt::format("the damage ends at {:g}: nothing fails", growth.y.back()),
                  "let it end at 1");
    else if (growth.y.front() > 0.0)
      lcdm.report(b.findings, Severity::warning, fmt::format("the damage leaps to {:g} at its onset", growth.y.front()),
                  "let it begin at 0");
    return kernel::PlasticDamage{onset, 0.0, b.model.curves[curve]};
  }
  if (rupture > 0.0) {
    if (rupture <= onset) refuse(b, rupture_entry, "rupture must come after the onset of damage");
    return kernel::PlasticDamage{onset > 0.0 ? onset : rupture, rupture};
  }
  if (onset > 0.0)
    onset_entry.report(b.findings, Severity::warning, "without EPPFR or LCDM nothing is damaged",
                       "give EPPFR, the plastic strain at rupture");
  return std::nullopt;
}

namespace {
constexpr RealField point_of_constraint(std::string_view name) {
  return real(name, dimension::length, 0, any_value, "for cmo 2 only, which is not built");
}

}  // namespace

const CardOf<RigidConstraintCard> rigid_constraint_card{
    {&RigidConstraintCard::cmo, real("cmo", dimension::number, 0, between(-1, 1), "held: 0 nothing, 1 in global axes")},
    {&RigidConstraintCard::con1,
     real("con1", dimension::number, 0, between(0, 7), "held translations: 1 x, 2 y, 3 z, 4 xy, 5 yz, 6 zx, 7 xyz")},
    {&RigidConstraintCard::con2,
     real("con2", dimension::number, 0, between(0, 7), "held rotations, by the same codes")},
    {&RigidConstraintCard::spcnid, integer("spcnid", 0, any_value, "for cmo 2 only, which is not built")},
    {&RigidConstraintCard::xspc, point_of_constraint("xspc")},
    {&RigidConstraintCard::yspc, point_of_constraint("yspc")},
    {&RigidConstraintCard::zspc, point_of_constraint("zspc")},
};
const CardOf<RigidConstraintCard> rigid_constraint_local_card{
    {&RigidConstraintCard::cmo, real("cmo", dimension::number, 0, between(-1, 1), "-1: held in local axes")},
    {&RigidConstraintCard::system, id("con1", IdSpace::define, 0, "coordinate system")},
    {&RigidConstraintCard::con2,
     real("con2", dimension::number, 0, between(0, 111111), "six digits, 1: held along x, y, z, about x, y, z")},
    {&RigidConstraintCard::spcnid, integer("spcnid", 0, any_value, "for cmo 2 only, which is not built")},
    {&RigidConstraintCard::xspc, point_of_constraint("xspc")},
    {&RigidConstraintCard::yspc, point_of_constraint("yspc")},
    {&RigidConstraintCard::zspc, point_of_constraint("zspc")},
};

deck::RowOf<RigidConstraintCard> read_rigid_constraint(Builder& b, Cursor& cursor) {
  const bool local = cursor.more() && cursor.peek_number(0) == -1.0;
  auto row = cursor.read(local ? rigid_constraint_local_card : rigid_constraint_card);
  if (row->cmo == 1.0) warn_of_turned_codes(b, cursor.block(), row[&RigidConstraintCard::con1], row->fixed_by_codes());
  return row;
}

int system_id(const Block& block, double written) {
  const int id = static_cast<int>(written);
  if (id == 0 || !block.transform) return id;
  return id + static_cast<int>(block.transform->id_offset[static_cast<std::size_t>(IdSpace::define)]);
}

Index add_material(Builder& b, const MaterialCard& card, const Row& row, std::string title, std::string_view name,
                   Law law) {
  const auto index = static_cast<Index>(b.model.materials.size());
  Material m{card.mid, std::move(title), std::string(name), card.ro, std::move(law), row.place()};
  b.materials.add(m.id, index, m.place, row.keyword(), "material", b.findings);
  b.model.materials.push_back(std::move(m));
  return index;
}

std::vector<Keyword> material_keywords() {
  return {
      {.name = "MAT_ELASTIC",
       .aliases = {"MAT_001"},
       .options = {"TITLE"},
       .layout = {{"", &elastic_card}},
       .read = read_elastic},
      {.name = "MAT_PLASTIC_KINEMATIC",
       .aliases = {"MAT_003"},
       .options = {"TITLE"},
       .layout = {{"", &kinematic_card}, {"", &kinematic_rate_card}},
       .read = read_kinematic},
      {.name = "MAT_NULL",
       .aliases = {"MAT_009"},
       .options = {"TITLE"},
       .layout = {{"", &null_card}},
       .read = read_null},
      {.name = "MAT_RIGID",
       .aliases = {"MAT_020"},
       .options = {"TITLE"},
       .layout = {{"", &rigid_card},
                  {"if CMO is 0 or 1", &rigid_constraint_card},
                  {"if CMO is -1", &rigid_constraint_local_card},
                  {"", &rigid_output_card}},
       .read = read_rigid},
      {.name = "MAT_PIECEWISE_LINEAR_PLASTICITY",
       .aliases = {"MAT_024"},
       .options = {"TITLE", "LOG_INTERPOLATION"},
       .layout = {{"", &plastic_card}, {"", &plastic_rate_card}, {"", &yield_strain_card}, {"", &yield_stress_card}},
       .read = read_plastic},
      not_built("MAT_HILL_90", "MAT_243", use_036),
  };
}

}  // namespace nugget::reading
