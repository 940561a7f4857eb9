// SPDX-License-Identifier: Apache-2.0
// *LOAD_BLAST_ENHANCED and the segments that it presses on.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/index.hpp"
#include "model/segments.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct BlastCards {
  int bid = 0, unit = 2, blast = 2, nidbo = 0, negphs = 0;
  double m = 0, xbo = 0, ybo = 0, zbo = 0, tbo = 0, cfm = 0, cfl = 0, cft = 0, cfp = 0, death = 0;
};
const CardOf<BlastCards> charge_card{
    {&BlastCards::bid, within_range(id("bid", IdSpace::define, required, "number of the charge"), at_least(1))},
    {&BlastCards::m, real("m", dimension::mass, required, above_zero(), "mass of TNT that is as strong")},
    {&BlastCards::xbo, real("xbo", dimension::length, 0, any_value, "middle of the charge, x")},
    {&BlastCards::ybo, real("ybo", dimension::length, 0, any_value, "y")},
    {&BlastCards::zbo, real("zbo", dimension::length, 0, any_value, "z")},
    {&BlastCards::tbo, real("tbo", dimension::time, 0, any_value, "time of the burst")},
    {&BlastCards::unit,
     integer("unit", 2, between(1, 8),
             "units of the deck: 1 ft lb s psi, 2 m kg s Pa, 3 in, dozens of slugs, s, psi, 4 cm g us Mbar, 5 by the "
             "second card, 6 mm kg ms GPa, 7 mm t s MPa, 8 mm g ms MPa")},
    {&BlastCards::blast, integer("blast", 2, between(1, 4),
                                 "1: half a sphere on the ground; 2: a sphere in free air; 3 and 4 are refused")},
};
const CardOf<BlastCards> units_card{
    {&BlastCards::cfm, real("cfm", dimension::number, 0, at_least(0), "UNIT 5: pounds in a unit of mass")},
    {&BlastCards::cfl, real("cfl", dimension::number, 0, at_least(0), "UNIT 5: feet in a unit of length")},
    {&BlastCards::cft, real("cft", dimension::number, 0, at_least(0), "UNIT 5: milliseconds in a unit of time")},
    {&BlastCards::cfp, real("cfp", dimension::number, 0, at_least(0), "UNIT 5: psi in a unit of stress")},
    {&BlastCards::nidbo,
     id("nidbo", IdSpace::node, 0, "node in whose place at the start the charge is; 0: xbo to zbo")},
    {&BlastCards::death, real("death", dimension::time, forever, any_value, "time after which nothing presses")},
    {&BlastCards::negphs,
     integer("negphs", 0, between(0, 1), "0: suction after the pressure, as Friedlander's curve goes on; 1: none")},
};

struct BlastedCard {
  int bid = 0, target = 0, n2 = 0, n3 = 0, n4 = 0, alepid = 0;
  double sfnrb = 0, scalep = 0;
};
void add_options(CardOf<BlastedCard>& card) {
  card.add({&BlastedCard::alepid, id("alepid", IdSpace::part, 0, "air around it, which is not built")});
  card.add({&BlastedCard::sfnrb, real("sfnrb", dimension::number, 0, only(0), "of ambient air, which is not built")});
  card.add({&BlastedCard::scalep, real("scalep", dimension::number, 1, any_value, "factor on the pressure")});
}
CardOf<BlastedCard> blasted_segment_card() {
  CardOf<BlastedCard> card{
      {&BlastedCard::bid, id("bid", IdSpace::define, required, "charge, by *LOAD_BLAST_ENHANCED")},
      {&BlastedCard::target,
       id("n1", IdSpace::node, required, "corner of the segment, whose right-hand normal looks to the charge")},
      {&BlastedCard::n2, id("n2", IdSpace::node, required, "second corner")},
      {&BlastedCard::n3, id("n3", IdSpace::node, required, "third corner")},
      {&BlastedCard::n4, id("n4", IdSpace::node, 0, "fourth corner; 0 or n3: a triangle")}};
  add_options(card);
  return card;
}
CardOf<BlastedCard> blasted_set_card() {
  CardOf<BlastedCard> card{{&BlastedCard::bid, id("bid", IdSpace::define, required, "charge, by *LOAD_BLAST_ENHANCED")},
                           {&BlastedCard::target, id("ssid", IdSpace::set, required,
                                                     "segment set, whose right-hand normals look to the charge")}};
  add_options(card);
  return card;
}
const CardOf<BlastedCard> segment_card = blasted_segment_card(), set_card = blasted_set_card();

/// kg, m, ms and kPa in the deck's units, by UNIT.
std::optional<BlastUnits> units_of(Builder& b, const RowOf<BlastCards>& row, const BlastCards& cards) {
  constexpr double pound = 0.45359237, foot = 0.3048, psi = 6.894757293168361;
  switch (cards.unit) {
    case 1: return BlastUnits{pound, foot, 1e3, psi};
    case 2: return BlastUnits{1.0, 1.0, 1e3, 1e-3};
    case 3: return BlastUnits{12.0 * pound * 9.80665 / foot, foot / 12.0, 1e3, psi};
    case 4: return BlastUnits{1e-3, 1e-2, 1e-3, 1e8};
    case 6: return BlastUnits{1.0, 1e-3, 1.0, 1e6};
    case 7: return BlastUnits{1e3, 1e-3, 1e3, 1e3};
    case 8: return BlastUnits{1e-3, 1e-3, 1.0, 1e3};
    default: break;
  }
  if (cards.cfm > 0.0 && cards.cfl > 0.0 && cards.cft > 0.0 && cards.cfp > 0.0)
    return BlastUnits{cards.cfm * pound, cards.cfl * foot, cards.cft, cards.cfp * psi};
  refuse(b, row[&BlastCards::unit], "UNIT 5 needs CFM, CFL, CFT and CFP on the second card",
         "give them, or write the number of the deck's units");
  return {};
}

void read_charge(Builder& builder, const Block& block, const Options&) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    BlastCards cards;
    const auto row = cursor.read(charge_card, cards);
    const auto second = cursor.read(units_card, cards);
    if (cards.blast > 2) {
      refuse(builder, row[&BlastCards::blast],
             cards.blast == 3 ? "moving charges that are no spheres are not built"
                              : "bursts above the ground, with a Mach stem, are not built",
             "write 1 (on the ground) or 2 (free air)");
      builder.blasts.try_emplace(cards.bid);
      continue;
    }
    if (block.transform != nullptr && block.transform->changes_units())
      refuse(builder, row[&BlastCards::unit], "the unit factors of *INCLUDE_TRANSFORM make other units of it",
             "write the charge in the main deck, with the UNIT of that");
    BlastLoad load;
    load.keyword = "LOAD_BLAST_ENHANCED";
    load.place = row.place();
    load.burst = cards.blast == 1 ? kernel::Burst::half_sphere : kernel::Burst::sphere;
    load.mass = cards.m;
    load.time = cards.tbo;
    load.death = cards.death;
    load.negative_phase = cards.negphs == 0;
    load.centre = position(block, {cards.xbo, cards.ybo, cards.zbo});
    const std::optional<BlastUnits> units = units_of(builder, row, cards);
    if (units) load.units = *units;
    if (!builder.blasts.try_emplace(cards.bid, units ? std::optional(load) : std::nullopt).second)
      refuse(builder, row[&BlastCards::bid], fmt::format("charge {} is defined twice", cards.bid),
             "give one of them another number");
    else if (cards.nidbo != 0)
      builder.defer(Phase::sets, [second, bid = cards.bid](Builder& b) {
        const Index node = b.node(second[&BlastCards::nidbo]);
        if (auto& of = b.blasts[bid]; of && node != none) of->centre = b.model.nodes.x[node];
      });
  }
}

/// Segments nearer than there are data, or further away.
void check_distances(Builder& b, const RowOf<BlastedCard>& row, BlastLoad& load) {
  const double root = std::cbrt(load.mass * load.units.mass), least = kernel::least_scaled_distance(load.burst);
  std::size_t near = 0, far = 0;
  double nearest = 1e300;
  std::vector<Segment> kept;
  for (const Segment& s : load.segments) {
    const double z = model::distance_to(load, s, b.model.nodes.x) * load.units.length / root;
    nearest = std::min(nearest, z);
    if (z < least)
      ++near;
    else if (z > kernel::greatest_scaled_distance)
      ++far;
    else
      kept.push_back(s);
  }
  if (near > 0)
    refuse(
        b, row[&BlastedCard::target],
        fmt::format("{} segments are nearer to the charge than there are data of Kingery and Bulmash: the nearest has "
                    "{:.3g} m/kg^(1/3), they begin at {:g}",
                    near, nearest, least),
        "check UNIT, the mass and the place of the charge, or leave these segments out");
  if (far > 0)
    row[&BlastedCard::target].report(
        b.findings, Severity::warning,
        fmt::format(
            "{} segments are further from the charge than {:g} m/kg^(1/3), where data end: nothing presses there", far,
            kernel::greatest_scaled_distance),
        "check UNIT, the mass and the place of the charge");
  load.segments = std::move(kept);
}

/// Sabotage of many decks: normals that look away from the charge get the passing wave only.
void check_normals(Builder& b, const RowOf<BlastedCard>& row, const BlastLoad& load) {
  const auto& x = b.model.nodes.x;
  const auto away = std::count_if(load.segments.begin(), load.segments.end(), [&](const Segment& s) {
    const Vec3d normal =
        s[3] == s[2] ? cross(x[s[1]] - x[s[0]], x[s[2]] - x[s[0]]) : cross(x[s[2]] - x[s[0]], x[s[3]] - x[s[1]]);
    return dot(normal, load.centre - x[s[0]]) < 0.0;
  });
  if (away > 0)
    row[&BlastedCard::target].report(
        b.findings, Severity::warning,
        fmt::format(
            "{} of {} segments look away from the charge: the wave that passes presses on them from behind, nothing "
            "is thrown back",
            away, load.segments.size()),
        "turn them over, unless they are on the far side of the body");
}

template <class Segments>
void leave_blast(Builder& builder, const RowOf<BlastedCard>& row, Segments segments) {
  refuse_nonzero(builder, row[&BlastedCard::alepid], "a blast on ambient air (ALE) is not built", "leave it 0");
  builder.defer(Phase::conditions, [row, segments](Builder& b) {
    const auto found = b.blasts.find(row->bid);
    if (found == b.blasts.end())
      return refuse(b, row[&BlastedCard::bid], fmt::format("charge {} is not defined", row->bid),
                    "define it by *LOAD_BLAST_ENHANCED");
    if (!found->second) return;  // refused
    BlastLoad load = *found->second;
    load.scale = row->scalep;
    load.segments = segments(b, row);
    check_distances(b, row, load);
    check_normals(b, row, load);
    load.share = share_pressure(b.model, load.segments);
    if (!load.segments.empty()) b.model.blast_loads.push_back(std::move(load));
  });
}

void read_blasted_segment(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor))
    leave_blast(builder, cursor.read(segment_card),
                [mirrored = is_mirrored(block)](Builder& b, const RowOf<BlastedCard>& row) -> std::vector<Segment> {
                  Segment s{b.node(row[&BlastedCard::target]), b.node(row[&BlastedCard::n2]),
                            b.node(row[&BlastedCard::n3]), b.node(row[&BlastedCard::n4])};
                  if (row->n4 == 0) s[3] = s[2];
                  if (std::ranges::find(s, none) != s.end()) return {};
                  return {mirrored ? model::turned_over(s) : s};
                });
}

void read_blasted_set(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor))
    leave_blast(builder, cursor.read(set_card), [](Builder& b, const RowOf<BlastedCard>& row) {
      const auto* set = b.segment_set(row[&BlastedCard::target]);
      return set ? set->members : std::vector<Segment>{};
    });
}

}  // namespace

std::vector<Keyword> blast_keywords() {
  return {
      {.name = "LOAD_BLAST_ENHANCED", .layout = {{{}, &charge_card}, {{}, &units_card}}, .read = read_charge},
      {.name = "LOAD_BLAST_SEGMENT", .layout = {{{}, &segment_card}}, .read = read_blasted_segment},
      {.name = "LOAD_BLAST_SEGMENT_SET", .layout = {{{}, &set_card}}, .read = read_blasted_set},
  };
}

}  // namespace nugget::reading
