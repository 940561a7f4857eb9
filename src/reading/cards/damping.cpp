// SPDX-License-Identifier: Apache-2.0
// *DAMPING_...
#include <fmt/format.h>

#include <cmath>

#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct Scales {
  Vec3d translations, rotations;
};
struct GlobalCard : Scales {
  int lcid = 0;
  double valdmp = 0;
};
const CardOf<GlobalCard> global_card{
    {&GlobalCard::lcid,
     or_negative(id("lcid", IdSpace::function, 0, "curve of the damping constant over time, instead of valdmp"),
                 IdSpace::function)},
    {&GlobalCard::valdmp,
     real("valdmp", dimension::rate, 0, at_least(0), "damping constant D of the force -D m v; critical: 2 w")},
    {within(&GlobalCard::translations, &Vec3d::x),
     real("stx", dimension::number, 0, any_value, "scale of the force along x; all six 0: all 1")},
    {within(&GlobalCard::translations, &Vec3d::y), real("sty", dimension::number, 0, any_value, "along y")},
    {within(&GlobalCard::translations, &Vec3d::z), real("stz", dimension::number, 0, any_value, "along z")},
    {within(&GlobalCard::rotations, &Vec3d::x),
     real("srx", dimension::number, 0, any_value, "scale of the moment about x")},
    {within(&GlobalCard::rotations, &Vec3d::y), real("sry", dimension::number, 0, any_value, "about y")},
    {within(&GlobalCard::rotations, &Vec3d::z), real("srz", dimension::number, 0, any_value, "about z")},
};

struct MassDampingCard {
  int target = 0;
  int lcid = 0;
  double sf = 0;
  int flag = 0;
};
CardOf<MassDampingCard> mass_damping_card(const FieldOf<MassDampingCard>& target) {
  return {
      target,
      {&MassDampingCard::lcid, id("lcid", IdSpace::function, required, "curve of the damping constant over time")},
      {&MassDampingCard::sf, real("sf", dimension::number, 1, any_value, "scale of the curve")},
      {&MassDampingCard::flag, integer("flag", 0, between(0, 1), "1: a card with scales follows")},
      integer("struc", 0, only(0), "structural damping of frequency analyses"),
  };
}
const CardOf<MassDampingCard> part_mass =
    mass_damping_card({&MassDampingCard::target, id("pid", IdSpace::part, required, "part")});
const CardOf<MassDampingCard> part_mass_set =
    mass_damping_card({&MassDampingCard::target, id("psid", IdSpace::set, required, "part set")});
const CardOf<Scales> scales_card{
    {within(&Scales::translations, &Vec3d::x),
     real("stx", dimension::number, 0, any_value, "scale of the force along x")},
    {within(&Scales::translations, &Vec3d::y), real("sty", dimension::number, 0, any_value, "along y")},
    {within(&Scales::translations, &Vec3d::z), real("stz", dimension::number, 0, any_value, "along z")},
    {within(&Scales::rotations, &Vec3d::x),
     real("srx", dimension::number, 0, any_value, "scale of the moment about x")},
    {within(&Scales::rotations, &Vec3d::y), real("sry", dimension::number, 0, any_value, "about y")},
    {within(&Scales::rotations, &Vec3d::z), real("srz", dimension::number, 0, any_value, "about z")},
};

struct StiffnessCard {
  int target = 0;
  double coef = 0;
};
CardOf<StiffnessCard> stiffness_card(const FieldOf<StiffnessCard>& target) {
  return {
      target,
      {&StiffnessCard::coef,
       real("coef", dimension::number, 0, any_value,
            "> 0: share of critical damping at the highest frequency, 0.01 to 0.25; < 0: Rayleigh's beta, a time")},
  };
}
const CardOf<StiffnessCard> part_stiffness =
    stiffness_card({&StiffnessCard::target, id("pid", IdSpace::part, required, "part")});
const CardOf<StiffnessCard> part_stiffness_set =
    stiffness_card({&StiffnessCard::target, id("psid", IdSpace::set, required, "part set")});

struct RangeCard {
  double cdamp = 0, flow = 0, fhigh = 0;
  int psid = 0, pidrel = 0;
};
const CardOf<RangeCard> range_card{
    {&RangeCard::cdamp,
     real("cdamp", dimension::number, required, between(0, 0.2), "share of critical damping, 0.01 as an example")},
    {&RangeCard::flow, real("flow", dimension::rate, required, above_zero(), "lowest frequency, cycles per time")},
    {&RangeCard::fhigh, real("fhigh", dimension::rate, required, above_zero(), "highest frequency, cycles per time")},
    {&RangeCard::psid, id("psid", IdSpace::set, 0, "part set; 0: all parts")},
    unused(),
    {&RangeCard::pidrel, id("pidrel", IdSpace::part, 0, "rigid body relative to whose motion is damped")},
    integer("iflg", 0, only(0), "method of LS-DYNA's releases"),
    integer("icard2", 0, only(0), "1: a second card follows"),
};

struct RelativeCard {
  double cdamp = 0, freq = 0;
  int pidrb = 0, psid = 0;
  double dv2 = 0;
  int lcid = 0;
};
const CardOf<RelativeCard> relative_card{
    {&RelativeCard::cdamp, real("cdamp", dimension::number, 0, at_least(0), "share of critical damping at freq")},
    {&RelativeCard::freq,
     real("freq", dimension::rate, 0, at_least(0), "frequency at which cdamp holds, cycles per time")},
    {&RelativeCard::pidrb, id("pidrb", IdSpace::part, required, "rigid body relative to whose motion is damped")},
    {&RelativeCard::psid, id("psid", IdSpace::set, required, "part set that is damped")},
    {&RelativeCard::dv2, real("dv2", Dimension{0, -1, 0}, 0, at_least(0), "damping by the square of the velocity")},
    {&RelativeCard::lcid, id("lcid", IdSpace::function, 0, "curve of a factor over time")},
};

// ---- by mass

/// The six scales; where all are 0 they stay 1.
void take_scales(const Scales& scales, MassDamping& damping) {
  const auto& [translations, rotations] = scales;
  if (norm(translations) == 0.0 && norm(rotations) == 0.0) return;
  damping.scale = translations;
  damping.rotary_scale = rotations;
}

void read_global(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto row = cursor.read(global_card);
  expect_end(builder, cursor);
  if (row->lcid < 0)
    return refuse(builder, row[&GlobalCard::lcid],
                  "damping constants of single parts by *DEFINE_CURVE pairs are not built", "use *DAMPING_PART_MASS");
  builder.defer(Phase::conditions, [row](Builder& b) {
    MassDamping damping;
    damping.everything = true;
    damping.curve = b.curve(row[&GlobalCard::lcid]);
    damping.factor = row->lcid != 0 ? 1.0 : row->valdmp;
    take_scales(*row, damping);
    b.model.damping.mass.push_back(damping);
  });
}

/// The parts that a card names: one, or those of a set.
template <bool set>
std::vector<Index> parts_of(Builder& builder, const deck::Entry& field) {
  if constexpr (set) {
    const auto* parts = builder.part_set(field);
    return parts ? parts->members : std::vector<Index>{};
  } else {
    const Index part = builder.part(field);
    return part == none ? std::vector<Index>{} : std::vector<Index>{part};
  }
}

/// Damping by mass takes the mass of elements: springs and dampers have none.
void warn_of_no_mass(Builder& b, const deck::Entry& field, const std::vector<Index>& parts) {
  for (const Index part : parts)
    if (const Part& p = b.model.parts[part]; p.kind == ElementKind::discrete)
      field.report(b.findings, Severity::warning,
                   fmt::format("part {} is of springs or dampers, which have no mass: this does not damp it", p.id),
                   "give them a damper of their own, as *MAT_S02");
}

template <bool set>
void read_part_mass(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(set ? part_mass_set : part_mass);
    MassDamping damping;
    if (row->flag == 1) take_scales(*cursor.read(scales_card), damping);
    builder.defer(Phase::conditions, [row, damping](Builder& b) mutable {
      damping.curve = b.curve(row[&MassDampingCard::lcid]);
      damping.factor = row->sf;
      const std::vector<Index> parts = parts_of<set>(b, row[&MassDampingCard::target]);
      warn_of_no_mass(b, row[&MassDampingCard::target], parts);
      for (const Index part : parts) {
        damping.part = part;
        b.model.damping.mass.push_back(damping);
      }
    });
  }
}

// ---- by stiffness

template <bool set>
void read_part_stiffness(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(set ? part_stiffness_set : part_stiffness);
    double coefficient = row->coef;
    // A share or, below 0, a time: the table cannot say which.
    if (coefficient < 0.0 && block.transform) coefficient *= block.transform->factor(dimension::time);
    if (coefficient > 1.0)
      refuse(builder, row[&StiffnessCard::coef], "more than critical damping at the highest frequency",
             "give 0.01 to 0.25, or a negative value for Rayleigh's beta");
    builder.defer(Phase::conditions, [row, coefficient](Builder& b) {
      for (const Index part : parts_of<set>(b, row[&StiffnessCard::target])) {
        const Part& damped = b.model.parts[part];
        if (coefficient == 0.0 || damped.rigid_body != none) continue;
        const bool is_beam = damped.kind == ElementKind::beam && damped.section != none;
        if (is_beam && b.model.beam_sections[damped.section].elform == 2)
          refuse(b, row[&StiffnessCard::target], "damping by stiffness of resultant beams (ELFORM 2) is not built",
                 "write ELFORM 1 in their section");
        auto& all = b.model.damping.stiffness;
        std::erase_if(all, [part](const StiffnessDamping& d) { return d.part == part; });  // the last one holds
        all.push_back({part, std::max(coefficient, 0.0), std::max(-coefficient, 0.0)});
      }
    });
  }
}

// ---- over a range of frequencies

bool is_discrete(const Model& m, const Part& part) {
  return part.kind == ElementKind::discrete ||
         (part.kind == ElementKind::beam && part.section != none && m.beam_sections[part.section].elform == 6);
}

/// The parts whose elements _DEFORM damps: all but those of springs, dampers and discrete beams, whose forces are those
/// of cards of their own.
std::vector<Index> deformed_parts(Builder& b, const RowOf<RangeCard>& row, const std::vector<Index>& set) {
  std::vector<Index> parts;
  const bool all = row->psid == 0;
  for (std::size_t i = 0; i < (all ? b.model.parts.size() : set.size()); ++i) {
    const Index part = all ? static_cast<Index>(i) : set[i];
    const Part& p = b.model.parts[part];
    if (!is_discrete(b.model, p))
      parts.push_back(part);
    else if (!all)
      row[&RangeCard::psid].report(
          b.findings, Severity::warning,
          fmt::format("part {} is of discrete elements, which _DEFORM does not damp here", p.id),
          "give them a damper of their own, as *MAT_S02");
  }
  return parts;
}

void read_range(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  const bool deform = options.contains("DEFORM");
  while (!at_end(cursor)) {
    const auto row = cursor.read(range_card);
    if (row->fhigh < row->flow)
      refuse(builder, row[&RangeCard::fhigh], "the range ends before it begins", "swap flow and fhigh");
    if (deform)
      expect(builder, Severity::warning,
             {{row[&RangeCard::pidrel], 0, "does not apply to _DEFORM: it does nothing here"}});
    builder.defer(Phase::conditions, [row, deform](Builder& b) {
      FrequencyRangeDamping damping{row->cdamp, row->flow, row->fhigh, row->psid == 0, {}, none, deform};
      if (const auto* parts = b.part_set(row[&RangeCard::psid])) damping.parts = parts->members;
      if (deform)
        damping.parts = deformed_parts(b, row, damping.parts);
      else
        warn_of_no_mass(b, row[&RangeCard::psid], damping.parts);
      if (row->pidrel != 0 && !deform) damping.relative_to = find_body(b, row[&RangeCard::pidrel]);
      if (damping.share > 0.0) b.model.damping.range.push_back(std::move(damping));
    });
  }
}

void read_relative(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(relative_card);
    builder.defer(Phase::conditions, [row](Builder& b) {
      RelativeDamping damping{row->cdamp, row->freq, find_body(b, row[&RelativeCard::pidrb]),
                              {},         row->dv2,  b.curve(row[&RelativeCard::lcid])};
      if (const auto* parts = b.part_set(row[&RelativeCard::psid])) damping.parts = parts->members;
      warn_of_no_mass(b, row[&RelativeCard::psid], damping.parts);
      if (damping.rigid_body != none) b.model.damping.relative.push_back(std::move(damping));
    });
  }
}

}  // namespace

std::vector<Keyword> damping_keywords() {
  const std::vector<LayoutCard> mass{{{}, &part_mass}, {"if FLAG = 1", &scales_card}},
      mass_set{{{}, &part_mass_set}, {"if FLAG = 1", &scales_card}};
  return {
      {.name = "DAMPING_GLOBAL", .layout = {{{}, &global_card}}, .read = read_global},
      {.name = "DAMPING_PART_MASS", .layout = mass, .read = read_part_mass<false>},
      {.name = "DAMPING_PART_MASS_SET", .layout = mass_set, .read = read_part_mass<true>},
      {.name = "DAMPING_PART_STIFFNESS", .layout = {{{}, &part_stiffness}}, .read = read_part_stiffness<false>},
      {.name = "DAMPING_PART_STIFFNESS_SET", .layout = {{{}, &part_stiffness_set}}, .read = read_part_stiffness<true>},
      {.name = "DAMPING_FREQUENCY_RANGE", .options = {"DEFORM"}, .layout = {{{}, &range_card}}, .read = read_range},
      {.name = "DAMPING_RELATIVE", .layout = {{{}, &relative_card}}, .read = read_relative},
  };
}

}  // namespace nugget::reading
