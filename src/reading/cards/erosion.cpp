// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/added_law.hpp"
#include "reading/cards/families.hpp"

// *MAT_ADD_EROSION: criteria of failure added to a law.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card first_card{{
    id("mid", IdSpace::material, required, "material to which the criteria are added"),
    real("excl", dimension::number, 0, any_value, "criteria of this value do not count"),
    real("mxpres", dimension::stress, 0, any_value, "greatest pressure"),
    real("mneps", dimension::number, 0, any_value, "least principal strain"),
    real("effeps", dimension::number, 0, any_value, "greatest effective strain; below 0: effective plastic strain"),
    real("voleps", dimension::number, 0, any_value, "volumetric strain, above 0 in expansion, below 0 in compression"),
    real("numfip", dimension::number, 1, any_value,
         "failed points that delete the element; below 0: percentage of a shell's layers, below -100: points + 100"),
    real("ncs", dimension::number, 1, at_least(1), "how many criteria must hold at once"),
}};

const Card second_card{{
    real("mnpres", dimension::stress, 0, any_value, "least pressure"),
    real("sigp1", dimension::stress, 0, any_value, "greatest principal stress"),
    or_negative(real("sigvm", dimension::stress, 0, any_value,
                     "greatest effective stress; below 0: curve over the strain rate"),
                IdSpace::function),
    real("mxeps", dimension::number, 0, any_value, "greatest principal strain"),
    real("epssh", dimension::number, 0, any_value, "greatest tensorial shear strain"),
    real("sigth", dimension::stress, 0, any_value, "threshold of the principal stress for IMPULSE"),
    real("impulse", {2, -2, -3}, 0, any_value, "integral of (principal stress - SIGTH)^2 over time"),
    real("failtm", dimension::time, 0, any_value, "time at which the material is taken away"),
}};

const Card third_card{{
    integer("idam", 0, between(0, 1), "1: damage of GISSMO; DIEM (below 0) is not built"),
    real("dmgtyp", dimension::number, 0, any_value,
         "1: what is damaged loses stress and fails; 0: damage is only summed"),
    gissmo_field::lcsdg,
    gissmo_field::ecrit,
    gissmo_field::dmgexp,
    gissmo_field::dcrit,
    gissmo_field::fadexp,
    gissmo_field::lcregd,
}};

const Card damage_card{{
    integer("sizflg", 0, only(0), "size of an element: 0, that of the start"),
    gissmo_field::refsz,
    integer("nahsv", 0, any_value, "history variables of damage; NEIPH and NEIPS count here"),
    gissmo_field::lcsrs,
    gissmo_field::shrf,
    gissmo_field::biaxf,
    gissmo_field::lcdlim,
    gissmo_field::midfail,
}};

const Card fourth_card{{
    integer("lcfld", 0, only(0), "forming limit curve"),
    integer("nsff", 10, any_value, "fade-out, for LCFLD only"),
    real("epsthin", dimension::number, 0, at_least(0), "thinning strain of a layer"),
    real("engcrt", dimension::number, 0, only(0), "critical energy of a neighbourhood"),
    real("radcrt", dimension::length, 0, any_value, "its radius, for ENGCRT only"),
    integer("lceps12", 0, only(0), "in-plane shear strain over element size"),
    integer("lceps13", 0, only(0), "transverse shear strain over element size"),
    integer("lcepsmx", 0, only(0), "major strain over element size"),
}};

const Card fifth_card{{
    real("dteflt", dimension::time, 0, any_value, "filter, for MXEPS below 0 only"),
    real("volfrac", dimension::number, 0, any_value, "for elements of higher order only"),
    real("mxtmp", dimension::number, 0, only(0), "greatest temperature"),
    real("dtmin", dimension::time, 0, only(0), "smallest time step; TSMIN and TDEL are built"),
}};

struct Cards {
  Row first, second, third, fourth;
  std::optional<Row> damage;  ///< with IDAM 1
  int stress_curve;           ///< SIGVM below 0: id of the curve
};

/// The value of a criterion, if it counts. A zero in the first card never does.
std::optional<double> criterion(const Cards& cards, const Row& row, std::string_view field, bool zero_counts = true) {
  const double value = row.real(field);
  if (value == cards.first.real("excl") || (value == 0.0 && !zero_counts)) return std::nullopt;
  return value;
}

kernel::Erosion criteria(Builder& b, const Cards& cards) {
  const auto one = [&](std::string_view field) { return criterion(cards, cards.first, field, false); };
  const auto two = [&](std::string_view field) { return criterion(cards, cards.second, field); };
  kernel::Erosion e;
  e.most_pressure = one("mxpres");
  e.least_strain = one("mneps");
  e.volume_strain = one("voleps");
  if (const auto strain = one("effeps"); strain && *strain > 0.0) e.effective_strain = strain;
  e.needed = static_cast<int>(cards.first.real("ncs"));
  e.least_pressure = two("mnpres");
  e.most_stress = two("sigp1");
  e.most_strain = two("mxeps");
  e.shear_strain = two("epssh");
  if (const auto impulse = two("impulse")) {
    e.impulse = impulse;
    e.threshold = cards.second.real("sigth");
  }
  if (const auto time = two("failtm"); time && *time != 0.0) e.time = std::abs(*time);
  if (cards.fourth.real("epsthin") > 0.0) e.thinning = cards.fourth.real("epsthin");
  if (const auto stress = two("sigvm"); stress && *stress >= 0.0) {
    e.effective_stress = stress;
  } else if (stress) {
    if (const Index curve = b.curves.find(cards.stress_curve); curve != none)
      e.effective_stress_over_rate = b.model.curves[static_cast<std::size_t>(curve)];
    else
      refuse(b, cards.second, "sigvm", fmt::format("curve {} is not defined", cards.stress_curve), "define it");
  }
  if (e.most_strain && *e.most_strain < 0.0)
    refuse(b, cards.second, "mxeps", "a curve over the strain rate is not supported", "give a strain");
  return e;
}

/// How many criteria count.
int number_of(const kernel::Erosion& e) {
  int n = !e.effective_stress_over_rate.empty();
  for (const auto* one :
       {&e.most_pressure, &e.least_pressure, &e.least_strain, &e.most_strain, &e.effective_strain, &e.volume_strain,
        &e.most_stress, &e.effective_stress, &e.shear_strain, &e.impulse, &e.time, &e.thinning})
    n += one->has_value();
  return n;
}

/// Warns of criteria that can never be met, and of those that hold at rest.
void report_idle_fields(Builder& b, const Cards& cards, const kernel::LawComponents& law) {
  const kernel::Erosion& e = *law.erosion;
  const auto warn = [&](const Row& row, std::string_view field, std::string text, const char* remedy) {
    row.report(b.findings, Severity::warning, field, std::move(text), remedy);
  };
  const auto at_rest = [&](const Row& row, std::string_view field, bool met) {
    if (met)
      warn(row, field,
           "the criterion is met where there is no stress and no strain: all elements go in the first cycle",
           "see its sign, and EXCL");
  };
  at_rest(cards.first, "mxpres", e.most_pressure && *e.most_pressure < 0.0);
  at_rest(cards.first, "mneps", e.least_strain && *e.least_strain > 0.0);
  at_rest(cards.second, "mnpres", e.least_pressure && *e.least_pressure > 0.0);
  at_rest(cards.second, "sigp1", e.most_stress && *e.most_stress < 0.0);
  at_rest(cards.second, "epssh", e.shear_strain && *e.shear_strain < 0.0);
  at_rest(cards.second, "impulse", e.impulse && *e.impulse < 0.0);
  if (const double threshold = cards.second.real("sigth");
      threshold != 0.0 && threshold != cards.first.real("excl") && !e.impulse)
    warn(cards.second, "sigth", "a threshold without IMPULSE has no effect", "give IMPULSE");
  const double strain = cards.first.real("effeps");
  const bool by_plastic_strain = strain < 0.0 && strain != cards.first.real("excl");
  if (by_plastic_strain && !has_plastic_strain(law.flow))
    warn(cards.first, "effeps", "below 0 it is a plastic strain, which this material does not have",
         "write it above 0 for the effective strain");
  const int count = number_of(e);
  if (count == 0 && !by_plastic_strain && !law.gissmo)
    warn(cards.first, "mid", "none of the criteria counts: nothing is eroded", "give one, or remove the keyword");
  else if (count > 0 && e.needed > count && !by_plastic_strain)
    warn(cards.first, "ncs",
         fmt::format("{} criteria must hold at once, but {} are given: nothing is eroded", e.needed, count),
         "lower NCS");
  if (e.time && b.model.control.relaxation.on())
    warn(cards.second, "failtm", "the time of dynamic relaxation counts too", "erode in a run without relaxation");
}

void add_erosion(Builder& b, const Cards& cards) {
  const Index index = b.find(b.materials, "material", cards.first, "mid");
  if (index == none) return;
  Material& material = b.model.materials[static_cast<std::size_t>(index)];
  std::optional<kernel::LawComponents> law = components_of(material.law);
  if (!law)
    return refuse(b, cards.first, "mid", fmt::format("erosion cannot be added to *{}", material.keyword),
                  "welds, discrete beams and adhesive have failure criteria of their own");
  if (law->erosion)
    return refuse(b, cards.first, "mid", fmt::format("material {} has criteria of erosion already", material.id),
                  "write all criteria on one *MAT_ADD_EROSION");
  take_points_to_delete(b, cards.first, *law, law->gissmo.has_value());
  if (cards.damage && law->gissmo)
    return refuse(b, cards.third, "idam", fmt::format("material {} has damage of GISSMO already", material.id),
                  "write one card for each material");
  if (cards.damage) {
    law->gissmo = gissmo(b, {cards.third, cards.third, *cards.damage, "dmgtyp"}, law->flow);
    if (!law->gissmo) return;
  }
  law->erosion = criteria(b, cards);
  if (const auto strain = criterion(cards, cards.first, "effeps", false); strain && *strain < 0.0) {
    if (law->erosion->needed > 1)
      return refuse(b, cards.first, "effeps", "a plastic strain together with NCS above 1 is not supported",
                    "write NCS 1");
    law->failure_strain = law->failure_strain > 0.0 ? std::min(law->failure_strain, -*strain) : -*strain;
  }
  report_idle_fields(b, cards, *law);
  if (law->gissmo && number_of(*law->erosion) == 0) law->erosion.reset();
  material.law = composed_law(std::move(*law));
}

void read_erosion(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  Cards cards{cursor.read(first_card), cursor.read(second_card), cursor.read(third_card), {}, {}, 0};
  if (cards.third.integer("idam") == 1) {
    cards.damage = cursor.read(damage_card);
    expect(b, *cards.damage, Severity::note,
           {{"refsz", 0, "damage for another element size is not written"},
            {"nahsv", 0, "NEIPH, NEIPS say how many history variables are written"}});
  }
  cards.fourth = cursor.read(fourth_card);
  cursor.read(fifth_card);
  expect_end(b, cursor);
  cards.stress_curve = curve_below_zero(cards.second, "sigvm");
  // After the laws have their curves.
  b.defer(Phase::systems, [cards](Builder& later) { add_erosion(later, cards); });
}

}  // namespace

std::vector<Keyword> erosion_keywords() {
  return {
      {.name = "MAT_ADD_EROSION",
       .options = {"TITLE"},
       .layout = {{"", &first_card},
                  {"", &second_card},
                  {"", &third_card},
                  {"if IDAM = 1", &damage_card},
                  {"", &fourth_card},
                  {"", &fifth_card}},
       .read = read_erosion},
  };
}

}  // namespace nugget::reading
