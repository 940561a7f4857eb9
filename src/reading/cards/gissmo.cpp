// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/added_law.hpp"
#include "reading/cards/families.hpp"

// *MAT_ADD_DAMAGE_GISSMO: damage of ductile metals added to a law.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card main_card{{
    id("mid", IdSpace::material, required, "material to which the damage is added"),
    unused(),
    real("dtyp", dimension::number, 0, any_value,
         "1: what is damaged loses stress and fails; 0: damage is only summed"),
    gissmo_field::refsz,
    real("numfip", dimension::number, 1, any_value,
         "failed points that delete the element; below 0: percentage of a shell's layers, below -100: points + 100"),
    real("volfrac", dimension::number, 0.5, any_value, "for elements of higher order only"),
    real("tetsf", dimension::number, 0, any_value, "factor on the size of tetrahedra in LCREGD"),
}};

const Card law_card{{
    gissmo_field::lcsdg,
    gissmo_field::ecrit,
    gissmo_field::dmgexp,
    gissmo_field::dcrit,
    gissmo_field::fadexp,
    gissmo_field::lcregd,
    integer("instf", 0, only(0), "how instability grows: 0, step by step"),
    integer("lcsoft", 0, only(0), "softening in front of a crack"),
}};

const Card scale_card{{
    gissmo_field::lcsrs,
    gissmo_field::shrf,
    gissmo_field::biaxf,
    gissmo_field::lcdlim,
    gissmo_field::midfail,
    real("hisvn", dimension::number, 0, only(0), "further variable of LCSDG"),
    real("soft", dimension::number, 0, only(0), "softening in front of a crack"),
    real("lp2bi", dimension::number, 0, only(0), "bending in place of the Lode parameter"),
}};

const Card tub_card{{
    real("rgtr1", dimension::number, 1.0 / 3.0, between(0, 1.0 / 3.0), "triaxiality up to which SHRF has an effect"),
    real("rgtr2", dimension::number, 1.0 / 3.0, between(1.0 / 3.0, 2.0 / 3.0),
         "triaxiality from which on BIAXF has an effect"),
}};

/// The curve, or the table where one may stand, of this id; not given and a finding where there is none.
CurveTable curves_of(Builder& b, const Row& row, std::string_view field, int id, bool may_be_table) {
  CurveTable found;
  if (const Index t = b.tables.find(id); t != none && may_be_table) found = b.table_with_curves(t);
  if (const Index c = b.curves.find(id); c != none && !found.given())
    found = {id, {0.0}, {b.model.curves[static_cast<std::size_t>(c)]}};
  if (!found.given()) {
    refuse(b, row, field,
           b.tables.find(id) != none ? "a table is not built here" : fmt::format("curve {} is not defined", id),
           b.tables.find(id) != none ? "give a curve" : "define it");
    return {};
  }
  for (const Curve& curve : found.curve)
    if (std::any_of(curve.y.begin(), curve.y.end(), [](double y) { return !(y > 0.0); })) {
      refuse(b, row, field, fmt::format("curve {} has values of 0 or below", curve.id), "give values above 0");
      return {};
    }
  return found;
}

/// Strains at fracture of which none is one that sheet steel reaches. Single ones are: in compression decks write any
/// large number.
bool looks_like_percent(const CurveTable& fracture) {
  return fracture.given() && std::all_of(fracture.curve.begin(), fracture.curve.end(), [](const Curve& curve) {
           return std::all_of(curve.y.begin(), curve.y.end(), [](double strain) { return strain >= 3.0; });
         });
}

/// The curves of a field whose value stands for itself from 0 on, and for an id below.
CurveTable number_or_curves(Builder& b, const Row& row, std::string_view field) {
  const double value = row.real(field);
  return value < 0.0 ? curves_of(b, row, field, curve_below_zero(row, field), true)
                     : CurveTable{0, {0.0}, {Curve{0, {0.0}, {value}}}};
}

double share(Builder& b, const Row& row, std::string_view field) {
  const double value = row.real(field);
  if (value < 0.0 || value > 1.0)
    refuse(b, row, field, "a share below 0 or above 1 is not built", "give a value from 0 to 1");
  return value;
}

void add_damage(Builder& b, const Row& main, const Row& law_row, const Row& scales, const std::optional<Row>& tub) {
  const Index index = b.find(b.materials, "material", main, "mid");
  if (index == none) return;
  Material& material = b.model.materials[static_cast<std::size_t>(index)];
  std::optional<kernel::LawComponents> law = components_of(material.law);
  if (!law)
    return refuse(b, main, "mid", fmt::format("damage cannot be added to *{}", material.keyword),
                  "welds, discrete beams and adhesive have damage of their own");
  if (law->gissmo)
    return refuse(b, main, "mid", fmt::format("material {} has damage of GISSMO already", material.id),
                  "write one card for each material");
  if (main.real("tetsf") != 0.0)
    refuse(b, main, "tetsf", "a factor on the size of tetrahedra is not built", "leave it 0");
  law->gissmo = gissmo(b, {main, law_row, scales, "dtyp"}, law->flow);
  if (!law->gissmo) return;
  if (tub) {
    law->gissmo->shear_end = tub->real("rgtr1");
    law->gissmo->biaxial_start = tub->real("rgtr2");
  }
  take_points_to_delete(b, main, *law, law->erosion.has_value());
  material.law = composed_law(std::move(*law));
}

void read_damage(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const Row main = cursor.read(main_card), law = cursor.read(law_card), scales = cursor.read(scale_card);
  std::optional<Row> tub;
  if (cursor.more()) tub = cursor.read(tub_card);
  expect_end(b, cursor);
  expect(b, main, Severity::note, {{"refsz", 0, "damage for another element size is not written"}});
  // After the laws have their curves.
  b.defer(Phase::systems, [=](Builder& later) { add_damage(later, main, law, scales, tub); });
}

}  // namespace

std::optional<kernel::Gissmo> gissmo(Builder& b, const GissmoRows& rows, const kernel::Flow& flow) {
  const int errors = b.findings.errors();
  const auto& [type, law, scales, type_field] = rows;
  if (!has_plastic_strain(flow)) {
    refuse(b, law, "lcsdg", "damage grows with the plastic strain, which this material does not have",
           "give it to a plastic material");
    return {};
  }
  kernel::Gissmo g;
  if (law.integer("lcsdg") > 0) {
    g.fracture = curves_of(b, law, "lcsdg", law.integer("lcsdg"), true);
    if (looks_like_percent(g.fracture))
      law.report(b.findings, Severity::warning, "lcsdg", "no strain at fracture is below 3 (300 %): nothing will fail",
                 "give strains, not percentages");
  } else {
    refuse(b, law, "lcsdg", "expected a curve or a table; a function is not built",
           "give the plastic strain at fracture over triaxiality");
  }
  if (law.real("ecrit") != 0.0) g.instability = number_or_curves(b, law, "ecrit");
  g.threshold = law.real("dcrit");
  g.growth = law.real("dmgexp");
  g.fading = number_or_curves(b, law, "fadexp");
  if (const int regularization = law.integer("lcregd"); regularization != 0)
    g.mesh = curves_of(b, law, "lcregd", std::abs(regularization), regularization < 0);
  g.shear = share(b, scales, "shrf");
  g.biaxial = share(b, scales, "biaxf");
  if (!g.mesh.given() && (g.shear != 0.0 || g.biaxial != 0.0))
    scales.report(b.findings, Severity::warning, g.shear != 0.0 ? "shrf" : "biaxf", "has no effect without LCREGD",
                  "give LCREGD");
  if (const int rate = scales.integer("lcsrs"); rate != 0) {
    const CurveTable found = curves_of(b, scales, "lcsrs", std::abs(rate), false);
    if (found.given()) g.rate = found.curve.front();
    g.log_rates = !g.rate.empty() && g.rate.x.front() < 0.0;
    g.rate_of_instability = rate > 0;
  }
  const int kind = static_cast<int>(type.real(type_field));
  if (kind != 0 && kind != 1)
    refuse(b, type, type_field,
           fmt::format("{}: damage by another variable than the plastic strain is not built", kind), "give 0 or 1");
  g.weakens = kind == 1;
  if (!g.weakens)
    type.report(b.findings, Severity::warning, type_field, "0: damage is summed, but takes no stress and no element",
                "give 1 if they are to fail");
  if (b.findings.errors() > errors) return {};
  return g;
}

std::vector<Keyword> gissmo_keywords() {
  return {
      {.name = "MAT_ADD_DAMAGE_GISSMO",
       .options = {"TITLE"},
       .layout = {{"", &main_card}, {"", &law_card}, {"", &scale_card}, {"optional", &tub_card}},
       .read = read_damage},
  };
}

}  // namespace nugget::reading
