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
using deck::RowOf;

struct MainCard {
  int mid = 0;
  double dtyp = 0, refsz = 0, numfip = 0, tetsf = 0;
};
const CardOf<MainCard> main_card{
    {&MainCard::mid, id("mid", IdSpace::material, required, "material to which the damage is added")},
    unused(),
    {&MainCard::dtyp, real("dtyp", dimension::number, 0, any_value,
                           "1: what is damaged loses stress and fails; 0: damage is only summed")},
    {&MainCard::refsz, gissmo_field::refsz},
    {&MainCard::numfip,
     real("numfip", dimension::number, 1, any_value,
          "failed points that delete the element; below 0: percentage of a shell's layers, below -100: points + 100")},
    real("volfrac", dimension::number, 0.5, any_value, "for elements of higher order only"),
    {&MainCard::tetsf, real("tetsf", dimension::number, 0, any_value, "factor on the size of tetrahedra in LCREGD")},
};

const CardOf<GissmoLawCard> law_card{
    {&GissmoLawCard::lcsdg, gissmo_field::lcsdg},
    {&GissmoLawCard::ecrit, gissmo_field::ecrit},
    {&GissmoLawCard::dmgexp, gissmo_field::dmgexp},
    {&GissmoLawCard::dcrit, gissmo_field::dcrit},
    {&GissmoLawCard::fadexp, gissmo_field::fadexp},
    {&GissmoLawCard::lcregd, gissmo_field::lcregd},
    integer("instf", 0, only(0), "how instability grows: 0, step by step"),
    integer("lcsoft", 0, only(0), "softening in front of a crack"),
};

const CardOf<GissmoScaleCard> gissmo_scale_card{
    {&GissmoScaleCard::lcsrs, gissmo_field::lcsrs},
    {&GissmoScaleCard::shrf, gissmo_field::shrf},
    {&GissmoScaleCard::biaxf, gissmo_field::biaxf},
    gissmo_field::lcdlim,
    gissmo_field::midfail,
    real("hisvn", dimension::number, 0, only(0), "further variable of LCSDG"),
    real("soft", dimension::number, 0, only(0), "softening in front of a crack"),
    real("lp2bi", dimension::number, 0, only(0), "bending in place of the Lode parameter"),
};

struct TubCard {
  double rgtr1 = 0, rgtr2 = 0;
};
const CardOf<TubCard> tub_card{
    {&TubCard::rgtr1,
     real("rgtr1", dimension::number, 1.0 / 3.0, between(0, 1.0 / 3.0), "triaxiality up to which SHRF has an effect")},
    {&TubCard::rgtr2, real("rgtr2", dimension::number, 1.0 / 3.0, between(1.0 / 3.0, 2.0 / 3.0),
                           "triaxiality from which on BIAXF has an effect")},
};

/// Strains at fracture of which none is one that sheet steel reaches. Single ones are: in compression decks write any
/// large number.
bool looks_like_percent(const CurveTable& fracture) {
  return fracture.given() && std::all_of(fracture.curve.begin(), fracture.curve.end(), [](const Curve& curve) {
           return std::all_of(curve.y.begin(), curve.y.end(), [](double strain) { return strain >= 3.0; });
         });
}

/// The curves of a field whose value stands for itself from 0 on, and for an id below.
CurveTable number_or_curves(Builder& b, const deck::Entry& field) {
  const double value = field.value;
  return value < 0.0 ? positive_curves(b, field, curve_below_zero(field.value), true)
                     : CurveTable{0, {0.0}, {Curve{0, {0.0}, {value}}}};
}

double share(Builder& b, const deck::Entry& field) {
  const double value = field.value;
  if (value < 0.0 || value > 1.0)
    refuse(b, field, "a share below 0 or above 1 is not built", "give a value from 0 to 1");
  return value;
}

void add_gissmo(Builder& b, const RowOf<MainCard>& main, const GissmoEntries& damage,
                const std::optional<RowOf<TubCard>>& tub) {
  const Index index = b.find(b.materials, "material", main[&MainCard::mid]);
  if (index == none) return;
  Material& material = b.model.materials[index];
  std::optional<kernel::LawComponents> law = components_of(material.law);
  if (!law)
    return refuse(b, main[&MainCard::mid], fmt::format("damage cannot be added to *{}", material.keyword),
                  "welds, discrete beams and adhesive have damage of their own");
  if (law->gissmo)
    return refuse(b, main[&MainCard::mid], fmt::format("material {} has damage of GISSMO already", material.id),
                  "write one card for each material");
  if (main->tetsf != 0.0)
    refuse(b, main[&MainCard::tetsf], "a factor on the size of tetrahedra is not built", "leave it 0");
  law->gissmo = gissmo(b, damage, law->flow);
  if (!law->gissmo) return;
  if (tub) {
    law->gissmo->shear_end = (*tub)->rgtr1;
    law->gissmo->biaxial_start = (*tub)->rgtr2;
  }
  take_points_to_delete(b, main[&MainCard::numfip], *law, law->erosion.has_value());
  material.law = composed_law(std::move(*law));
}

void read_gissmo(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto main = cursor.read(main_card);
  const auto law = cursor.read(law_card);
  const auto scales = cursor.read(gissmo_scale_card);
  std::optional<RowOf<TubCard>> tub;
  if (cursor.more()) tub = cursor.read(tub_card);
  expect_end(b, cursor);
  expect(b, Severity::note, {{main[&MainCard::refsz], 0, "damage for another element size is not written"}});
  // After the laws have their curves.
  b.defer(Phase::systems, [=, damage = gissmo_entries(main[&MainCard::dtyp], law, scales)](Builder& later) {
    add_gissmo(later, main, damage, tub);
  });
}

}  // namespace

CurveTable positive_curves(Builder& b, const deck::Entry& field, int id, bool may_be_table) {
  CurveTable found;
  if (const Index t = b.tables.find(id); t != none && may_be_table) found = b.table_with_curves(t);
  if (const Index c = b.curves.find(id); c != none && !found.given()) found = {id, {0.0}, {b.model.curves[c]}};
  if (!found.given()) {
    refuse(b, field,
           b.tables.find(id) != none ? "a table is not built here" : fmt::format("curve {} is not defined", id),
           b.tables.find(id) != none ? "give a curve" : "define it");
    return {};
  }
  for (const Curve& curve : found.curve)
    if (std::any_of(curve.y.begin(), curve.y.end(), [](double y) { return !(y > 0.0); })) {
      refuse(b, field, fmt::format("curve {} has values of 0 or below", curve.id), "give values above 0");
      return {};
    }
  return found;
}

std::optional<kernel::Gissmo> gissmo(Builder& b, const GissmoEntries& entries, const kernel::Flow& flow) {
  const int errors = b.findings.errors();
  if (!has_plastic_strain(flow)) {
    refuse(b, entries.lcsdg, "damage grows with the plastic strain, which this material does not have",
           "give it to a plastic material");
    return {};
  }
  kernel::Gissmo g;
  if (entries.lcsdg.integer() > 0) {
    g.fracture = positive_curves(b, entries.lcsdg, entries.lcsdg.integer(), true);
    if (looks_like_percent(g.fracture))
      entries.lcsdg.report(b.findings, Severity::warning, "no strain at fracture is below 3 (300 %): nothing will fail",
                           "give strains, not percentages");
  } else {
    refuse(b, entries.lcsdg, "expected a curve or a table; a function is not built",
           "give the plastic strain at fracture over triaxiality");
  }
  if (entries.ecrit.value != 0.0) g.instability = number_or_curves(b, entries.ecrit);
  g.threshold = entries.dcrit.value;
  g.growth = entries.dmgexp.value;
  g.fading = number_or_curves(b, entries.fadexp);
  if (const int regularization = entries.lcregd.integer(); regularization != 0)
    g.mesh = positive_curves(b, entries.lcregd, std::abs(regularization), regularization < 0);
  g.shear = share(b, entries.shrf);
  g.biaxial = share(b, entries.biaxf);
  if (!g.mesh.given() && (g.shear != 0.0 || g.biaxial != 0.0))
    (g.shear != 0.0 ? entries.shrf : entries.biaxf)
        .report(b.findings, Severity::warning, "has no effect without LCREGD", "give LCREGD");
  if (const int rate = entries.lcsrs.integer(); rate != 0) {
    const CurveTable found = positive_curves(b, entries.lcsrs, std::abs(rate), false);
    if (found.given()) g.rate = found.curve.front();
    g.log_rates = !g.rate.empty() && g.rate.x.front() < 0.0;
    g.rate_of_instability = rate > 0;
  }
  const int kind = static_cast<int>(entries.type.value);
  if (kind != 0 && kind != 1)
    refuse(b, entries.type, fmt::format("{}: damage by another variable than the plastic strain is not built", kind),
           "give 0 or 1");
  g.weakens = kind == 1;
  if (!g.weakens)
    entries.type.report(b.findings, Severity::warning, "0: damage is summed, but takes no stress and no element",
                        "give 1 if they are to fail");
  if (b.findings.errors() > errors) return {};
  return g;
}

std::vector<Keyword> gissmo_keywords() {
  return {
      {.name = "MAT_ADD_DAMAGE_GISSMO",
       .options = {"TITLE"},
       .layout = {{"", &main_card}, {"", &law_card}, {"", &gissmo_scale_card}, {"optional", &tub_card}},
       .read = read_gissmo},
  };
}

}  // namespace nugget::reading
