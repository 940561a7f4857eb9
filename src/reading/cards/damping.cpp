// SPDX-License-Identifier: Apache-2.0
// *DAMPING_...
#include <fmt/format.h>

#include <cmath>

#include "base/index.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card global_card{{
    or_negative(id("lcid", IdSpace::function, 0, "curve of the damping constant over time, instead of valdmp"),
                IdSpace::function),
    real("valdmp", dimension::rate, 0, at_least(0), "damping constant D of the force -D m v; critical: 2 w"),
    real("stx", dimension::number, 0, any_value, "scale of the force along x; all six 0: all 1"),
    real("sty", dimension::number, 0, any_value, "along y"),
    real("stz", dimension::number, 0, any_value, "along z"),
    real("srx", dimension::number, 0, any_value, "scale of the moment about x"),
    real("sry", dimension::number, 0, any_value, "about y"),
    real("srz", dimension::number, 0, any_value, "about z"),
}};

Card part_mass_card(Field target) {
  return {{
      target,
      id("lcid", IdSpace::function, required, "curve of the damping constant over time"),
      real("sf", dimension::number, 1, any_value, "scale of the curve"),
      integer("flag", 0, between(0, 1), "1: a card with scales follows"),
      integer("struc", 0, only(0), "structural damping of frequency analyses"),
  }};
}
const Card part_mass = part_mass_card(id("pid", IdSpace::part, required, "part"));
const Card part_mass_set = part_mass_card(id("psid", IdSpace::set, required, "part set"));
const Card scales_card{{
    real("stx", dimension::number, 0, any_value, "scale of the force along x"),
    real("sty", dimension::number, 0, any_value, "along y"),
    real("stz", dimension::number, 0, any_value, "along z"),
    real("srx", dimension::number, 0, any_value, "scale of the moment about x"),
    real("sry", dimension::number, 0, any_value, "about y"),
    real("srz", dimension::number, 0, any_value, "about z"),
}};

Card stiffness_card(Field target) {
  return {{
      target,
      real("coef", dimension::number, 0, any_value,
           "> 0: share of critical damping at the highest frequency, 0.01 to 0.25; < 0: Rayleigh's beta, a time"),
  }};
}
const Card part_stiffness = stiffness_card(id("pid", IdSpace::part, required, "part"));
const Card part_stiffness_set = stiffness_card(id("psid", IdSpace::set, required, "part set"));

const Card range_card{{
    real("cdamp", dimension::number, required, between(0, 0.2), "share of critical damping, 0.01 as an example"),
    real("flow", dimension::rate, required, above_zero(), "lowest frequency, cycles per time"),
    real("fhigh", dimension::rate, required, above_zero(), "highest frequency, cycles per time"),
    id("psid", IdSpace::set, 0, "part set; 0: all parts"),
    unused(),
    id("pidrel", IdSpace::part, 0, "rigid body relative to whose motion is damped"),
    integer("iflg", 0, only(0), "method of LS-DYNA's releases"),
    integer("icard2", 0, only(0), "1: a second card follows"),
}};

const Card relative_card{{
    real("cdamp", dimension::number, 0, at_least(0), "share of critical damping at freq"),
    real("freq", dimension::rate, 0, at_least(0), "frequency at which cdamp holds, cycles per time"),
    id("pidrb", IdSpace::part, required, "rigid body relative to whose motion is damped"),
    id("psid", IdSpace::set, required, "part set that is damped"),
    real("dv2", Dimension{0, -1, 0}, 0, at_least(0), "damping by the square of the velocity"),
    id("lcid", IdSpace::function, 0, "curve of a factor over time"),
}};

// ---- by mass -------------------------------------------------------------------------------------------------------

/// The six scales; where all are 0 they stay 1.
void take_scales(const Row& row, MassDamping& damping) {
  const Vec3d translations = triple(row, "stx", "sty", "stz"), rotations = triple(row, "srx", "sry", "srz");
  if (norm(translations) == 0.0 && norm(rotations) == 0.0) return;
  damping.scale = translations;
  damping.rotary_scale = rotations;
}

void read_global(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const Row row = cursor.read(global_card);
  expect_end(builder, cursor);
  if (row.integer("lcid") < 0)
    return refuse(builder, row, "lcid", "damping constants of single parts by *DEFINE_CURVE pairs are not built",
                  "use *DAMPING_PART_MASS");
  builder.defer(Phase::conditions, [row](Builder& b) {
    MassDamping damping;
    damping.everything = true;
    damping.curve = b.curve(row, "lcid");
    damping.factor = row.integer("lcid") != 0 ? 1.0 : row.real("valdmp");
    take_scales(row, damping);
    b.model.damping.mass.push_back(damping);
  });
}

/// The parts that a card names: one, or those of a set.
template <bool set>
std::vector<Index> parts_of(Builder& builder, const Row& row) {
  if constexpr (set) {
    const auto* parts = builder.part_set(row, "psid");
    return parts ? parts->members : std::vector<Index>{};
  } else {
    const Index part = builder.part(row, "pid");
    return part == none ? std::vector<Index>{} : std::vector<Index>{part};
  }
}

template <bool set>
void read_part_mass(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const Row row = cursor.read(set ? part_mass_set : part_mass);
    MassDamping damping;
    if (row.integer("flag") == 1) take_scales(cursor.read(scales_card), damping);
    builder.defer(Phase::conditions, [row, damping](Builder& b) mutable {
      damping.curve = b.curve(row, "lcid");
      damping.factor = row.real("sf");
      for (const Index part : parts_of<set>(b, row)) {
        damping.part = part;
        b.model.damping.mass.push_back(damping);
      }
    });
  }
}

// ---- by stiffness --------------------------------------------------------------------------------------------------

template <bool set>
void read_part_stiffness(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const Row row = cursor.read(set ? part_stiffness_set : part_stiffness);
    double coefficient = row.real("coef");
    // A share or, below 0, a time: the table cannot say which.
    if (coefficient < 0.0 && block.transform) coefficient *= block.transform->factor(dimension::time);
    if (coefficient > 1.0)
      refuse(builder, row, "coef", "more than critical damping at the highest frequency",
             "give 0.01 to 0.25, or a negative value for Rayleigh's beta");
    builder.defer(Phase::conditions, [row, coefficient](Builder& b) {
      for (const Index part : parts_of<set>(b, row)) {
        const Part& damped = b.model.parts[at(part)];
        if (coefficient == 0.0 || damped.rigid_body != none) continue;
        const bool is_beam = damped.kind == ElementKind::beam && damped.section != none;
        if (is_beam && b.model.beam_sections[at(damped.section)].elform == 2)
          refuse(b, row, set ? "psid" : "pid", "damping by stiffness of resultant beams (ELFORM 2) is not built",
                 "write ELFORM 1 in their section");
        auto& all = b.model.damping.stiffness;
        std::erase_if(all, [part](const StiffnessDamping& d) { return d.part == part; });  // the last one holds
        all.push_back({part, std::max(coefficient, 0.0), std::max(-coefficient, 0.0)});
      }
    });
  }
}

// ---- over a range of frequencies -----------------------------------------------------------------------------------

bool is_discrete(const Model& m, const Part& part) {
  return part.kind == ElementKind::discrete ||
         (part.kind == ElementKind::beam && part.section != none && m.beam_sections[at(part.section)].elform == 6);
}

/// The parts whose elements _DEFORM damps: all but those of springs, dampers and discrete beams, whose forces are those
/// of cards of their own.
std::vector<Index> deformed_parts(Builder& b, const Row& row, const std::vector<Index>& set) {
  std::vector<Index> parts;
  const bool all = row.integer("psid") == 0;
  for (std::size_t i = 0; i < (all ? b.model.parts.size() : set.size()); ++i) {
    const Index part = all ? static_cast<Index>(i) : set[i];
    const Part& p = b.model.parts[at(part)];
    if (!is_discrete(b.model, p))
      parts.push_back(part);
    else if (!all)
      row.report(b.findings, Severity::warning, "psid",
                 fmt::format("part {} is of discrete elements, which _DEFORM does not damp here", p.id),
                 "give them a damper of their own, as *MAT_S02");
  }
  return parts;
}

void read_range(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  const bool deform = options.contains("DEFORM");
  while (!at_end(cursor)) {
    const Row row = cursor.read(range_card);
    if (row.real("fhigh") < row.real("flow"))
      refuse(builder, row, "fhigh", "the range ends before it begins", "swap flow and fhigh");
    if (deform)
      expect(builder, row, Severity::warning, {{"pidrel", 0, "does not apply to _DEFORM: it does nothing here"}});
    builder.defer(Phase::conditions, [row, deform](Builder& b) {
      FrequencyRangeDamping damping{
          row.real("cdamp"), row.real("flow"), row.real("fhigh"), row.integer("psid") == 0, {}, none, deform};
      if (const auto* parts = b.part_set(row, "psid")) damping.parts = parts->members;
      if (deform) damping.parts = deformed_parts(b, row, damping.parts);
      if (row.integer("pidrel") != 0 && !deform) damping.relative_to = find_body(b, row, "pidrel");
      if (damping.share > 0.0) b.model.damping.range.push_back(std::move(damping));
    });
  }
}

void read_relative(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const Row row = cursor.read(relative_card);
    builder.defer(Phase::conditions, [row](Builder& b) {
      RelativeDamping damping{row.real("cdamp"), row.real("freq"),    find_body(b, row, "pidrb"), {},
                              row.real("dv2"),   b.curve(row, "lcid")};
      if (const auto* parts = b.part_set(row, "psid")) damping.parts = parts->members;
      if (damping.rigid_body != none) b.model.damping.relative.push_back(std::move(damping));
    });
  }
}

}  // namespace

std::vector<Keyword> damping_keywords() {
  const std::vector<LayoutCard> mass{{{}, &part_mass}, {"if FLAG = 1", &scales_card}},
      mass_set{{{}, &part_mass_set}, {"if FLAG = 1", &scales_card}};
  return {
      {"DAMPING_GLOBAL", {}, {}, KeywordStatus::used, {}, {{{}, &global_card}}, read_global},
      {"DAMPING_PART_MASS", {}, {}, KeywordStatus::used, {}, mass, read_part_mass<false>},
      {"DAMPING_PART_MASS_SET", {}, {}, KeywordStatus::used, {}, mass_set, read_part_mass<true>},
      {"DAMPING_PART_STIFFNESS", {}, {}, KeywordStatus::used, {}, {{{}, &part_stiffness}}, read_part_stiffness<false>},
      {"DAMPING_PART_STIFFNESS_SET",
       {},
       {},
       KeywordStatus::used,
       {},
       {{{}, &part_stiffness_set}},
       read_part_stiffness<true>},
      {"DAMPING_FREQUENCY_RANGE", {}, {"DEFORM"}, KeywordStatus::used, {}, {{{}, &range_card}}, read_range},
      {"DAMPING_RELATIVE", {}, {}, KeywordStatus::used, {}, {{{}, &relative_card}}, read_relative},
  };
}

}  // namespace nugget::reading
