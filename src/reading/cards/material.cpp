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

const Card elastic_card{{
    material_id,
    density,
    young,
    poisson,
    real("da", dimension::number, 0, any_value, "axial damping of Belytschko-Schwer beams, no effect here"),
    real("db", dimension::number, 0, any_value, "bending damping of Belytschko-Schwer beams, no effect here"),
    unused(),
    unused(),
}};

const Card kinematic_card{{
    material_id,
    density,
    young,
    poisson,
    real("sigy", dimension::stress, required, above_zero(), "yield stress"),
    real("etan", dimension::stress, 0, at_least(0), "tangent modulus, below E"),
    real("beta", dimension::number, 0, between(0, 1), "hardening: 0 kinematic, 1 isotropic"),
    unused(),
}};

const Card kinematic_rate_card{{
    real("src", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect"),
    real("srp", dimension::number, 0, at_least(0), "Cowper-Symonds P"),
    real("fs", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none"),
    vp,
}};

const Card null_card{{
    material_id,
    density,
    real("pc", dimension::stress, 0, any_value, "solids: the pressure falls no further; below 0, or 0: no limit"),
    real("mu", {1, -1, -1}, 0, at_least(0), "solids: viscosity; deviators are 2 MU times those of the strain rate"),
    real("terod", dimension::number, 0, any_value, "solids: relative volume at which they erode in tension: not built"),
    real("cerod", dimension::number, 0, any_value, "the same in compression: not built"),
    real("ym", dimension::stress, 0, at_least(0), "shells, beams: Young's modulus, for contact only"),
    real("pr", dimension::number, 0, between(0, 0.5), "shells, beams: Poisson's ratio, for contact only"),
}};

const Card rigid_card{{
    material_id,
    density,
    real("e", dimension::stress, 0, at_least(0), "Young's modulus, for contact only"),
    real("pr", dimension::number, 0, between(0, 0.5), "Poisson's ratio, for contact only"),
    real("n", dimension::number, 0, only(0), "coupling with MADYMO or CAL3D"),
    real("couple", dimension::number, 0, only(0), "coupling with MADYMO or CAL3D"),
    real("m", dimension::number, 0, only(0), "coupling with MADYMO or CAL3D"),
    text("alias", 10, "name for MADYMO, no effect"),
}};

const Card rigid_output_card{{
    real("lco_or_a1", dimension::number, 0, any_value,
         "LCO, coordinate system of local motions; else first of two vectors"),
    real("a2", dimension::number, 0, any_value, "first vector a: first of the body's own axes"),
    real("a3", dimension::number, 0, any_value, "first vector a: first of the body's own axes"),
    real("v1", dimension::number, 0, any_value, "second vector v: third axis c = a x v, second c x a"),
    real("v2", dimension::number, 0, any_value, "second vector v: third axis c = a x v, second c x a"),
    real("v3", dimension::number, 0, any_value, "second vector v: third axis c = a x v, second c x a"),
    integer("bndlco", 0, any_value, "axes of bndout, no effect"),
}};

const Card plastic_card{{
    material_id,
    density,
    young,
    poisson,
    real("sigy", dimension::stress, 0, at_least(0), "yield stress, unless LCSS or EPS and ES are given"),
    real("etan", dimension::stress, 0, at_least(0), "tangent modulus, below E"),
    real("fail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none"),
    real("tdel", dimension::time, 0, at_least(0), "smallest time step of an element before it is deleted; 0: none"),
}};

const Card plastic_rate_card{{
    real("c", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect"),
    real("p", dimension::number, 0, at_least(0), "Cowper-Symonds P"),
    id("lcss", IdSpace::function, 0, "yield stress over plastic strain: curve, or table over the strain rate"),
    id("lcsr", IdSpace::function, 0, "curve: factor on the yield stress over the strain rate"),
    vp_of_curves,
    unused(),
    real("rfiltf", dimension::number, 0, any_value, "filter of the plastic rate of vp 4: not needed, no effect"),
    unused(),
}};

void read_elastic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(elastic_card);
  expect_end(b, cursor);
  add_material(b, row, std::move(title), "MAT_ELASTIC", kernel::Elastic{row.real("e"), row.real("pr")});
}

void read_kinematic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(kinematic_card);
  const Row rate = cursor.read(kinematic_rate_card);
  expect_end(b, cursor);
  check_tangent(b, row);
  warn_of_half_a_rate(b, rate.entry("src"), rate.entry("srp"));
  kernel::PlasticKinematic law;
  law.E = row.real("e");
  law.nu = row.real("pr");
  law.yield = row.real("sigy");
  law.tangent_modulus = row.real("etan");
  law.beta = row.real("beta");
  if (rate.real("src") > 0.0 && rate.real("srp") > 0.0) {
    law.rate_c = rate.real("src");
    law.rate_p = rate.real("srp");
  }
  law.failure_strain = failure_value(rate.real("fs"));
  add_material(b, row, std::move(title), "MAT_PLASTIC_KINEMATIC", law);
}

void read_null(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(null_card);
  expect_end(b, cursor);
  if (row.real("pc") > 0.0)
    row.report(b.findings, Severity::warning, "pc", "a limit of the pressure is below 0; taken as none",
               "write a negative pressure");
  add_material(b, row, std::move(title), "MAT_NULL",
               kernel::Null{row.real("ym"), row.real("pr"), row.real("mu"), std::max(-row.real("pc"), 0.0),
                            row.real("terod") > 0.0 || row.real("cerod") > 0.0});
}

/// The third card: LCO, the coordinate system of local motions and output, or two vectors a and v that give the axes of
/// output a, c = a x v and b = c x a.
void take_local_axes(Builder& b, const Block& block, const Row& row, RigidCard& constraint) {
  const Vec3d v = direction(block, row, "v1", "v2", "v3");
  if (row.real("a2") == 0.0 && row.real("a3") == 0.0 && norm(v) == 0.0) {
    constraint.lco = system_id(block, row.real("lco_or_a1"));
    return;
  }
  Frame3d axes;
  if (!frame_from(direction(block, row, "lco_or_a1", "a2", "a3"), v, axes))
    return refuse(b, row, "v1", "the two vectors are parallel, or one is missing",
                  "give two vectors that span a plane");
  constraint.output_axes = axes;
}

void read_rigid(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(rigid_card);
  RigidCard constraint = read_rigid_constraint(b, cursor);
  take_local_axes(b, block, cursor.read(rigid_output_card), constraint);
  expect_end(b, cursor);
  const Index material =
      add_material(b, row, std::move(title), "MAT_RIGID", kernel::Rigid{row.real("e"), row.real("pr")});
  b.rigid_cards[material] = std::move(constraint);
}

void read_plastic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  YieldCards cards{cursor.read(plastic_card), cursor.read(plastic_rate_card), cursor.read(yield_strain_card),
                   cursor.read(yield_stress_card), options.contains("LOG_INTERPOLATION")};
  expect_end(b, cursor);
  check_tangent(b, cards.main);
  kernel::PiecewiseLinear law;
  law.E = cards.main.real("e");
  law.nu = cards.main.real("pr");
  law.failure_strain = failure_value(cards.main.real("fail"));
  law.deletion_step = cards.main.real("tdel");
  const Index material = add_material(b, cards.main, std::move(title), "MAT_PIECEWISE_LINEAR_PLASTICITY", law);
  // Curves may be defined later in the deck.
  b.defer(Phase::parts, [material, cards](Builder& later) {
    auto& m = later.model.materials[static_cast<std::size_t>(material)];
    set_yield_curves(later, cards, std::get<kernel::PiecewiseLinear>(m.law));
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

constexpr std::string_view use_024 = "this law is not built; MAT_024 with a yield curve (LCSS) comes nearest";

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
    const Curve& growth = b.model.curves[static_cast<std::size_t>(curve)];
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
    return kernel::PlasticDamage{onset, 0.0, b.model.curves[static_cast<std::size_t>(curve)]};
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

constexpr Field point_of_constraint(std::string_view name) {
  return real(name, dimension::length, 0, any_value, "for cmo 2 only, which is not built");
}

}  // namespace

const Card rigid_constraint_card{{
    real("cmo", dimension::number, 0, between(-1, 1), "held: 0 nothing, 1 in global axes"),
    real("con1", dimension::number, 0, between(0, 7), "held translations: 1 x, 2 y, 3 z, 4 xy, 5 yz, 6 zx, 7 xyz"),
    real("con2", dimension::number, 0, between(0, 7), "held rotations, by the same codes"),
    integer("spcnid", 0, any_value, "for cmo 2 only, which is not built"),
    point_of_constraint("xspc"),
    point_of_constraint("yspc"),
    point_of_constraint("zspc"),
}};
const Card rigid_constraint_local_card{{
    real("cmo", dimension::number, 0, between(-1, 1), "-1: held in local axes"),
    id("con1", IdSpace::define, 0, "coordinate system"),
    real("con2", dimension::number, 0, between(0, 111111), "six digits, 1: held along x, y, z, about x, y, z"),
    integer("spcnid", 0, any_value, "for cmo 2 only, which is not built"),
    point_of_constraint("xspc"),
    point_of_constraint("yspc"),
    point_of_constraint("zspc"),
}};

RigidCard read_rigid_constraint(Builder& b, Cursor& cursor) {
  const bool local = cursor.more() && cursor.peek_number(0) == -1.0;
  RigidCard constraint;
  constraint.row = cursor.read(local ? rigid_constraint_local_card : rigid_constraint_card);
  constraint.cmo = static_cast<int>(constraint.row.real("cmo"));
  constraint.con2 = static_cast<int>(constraint.row.real("con2"));
  constraint.con1 = local ? constraint.row.integer("con1") : static_cast<int>(constraint.row.real("con1"));
  if (constraint.cmo == 1)
    warn_of_turned_codes(b, cursor.block(), constraint.row, "con1",
                         bits_of_code(constraint.con1) | bits_of_code(constraint.con2) << 3);
  return constraint;
}

int system_id(const Block& block, double written) {
  const int id = static_cast<int>(written);
  if (id == 0 || !block.transform) return id;
  return id + static_cast<int>(block.transform->id_offset[static_cast<std::size_t>(IdSpace::define)]);
}

Index add_material(Builder& b, const Row& row, std::string title, std::string_view name, Law law) {
  return add_material(b, {row.integer("mid"), row.real("ro")}, row, std::move(title), name, std::move(law));
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
      not_built("MAT_3-PARAMETER_BARLAT", "MAT_036", use_024),
  };
}

}  // namespace nugget::reading
