// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *DEFINE_HAZ_PROPERTIES and *DEFINE_HAZ_TAILOR_WELDED_BLANK: sheets softened by the heat of welding.
namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;

struct HeatZoneCard {
  int id_haz = 0, iop = 0, pid = 0, pid_typ = 0;
};
CardOf<HeatZoneCard> heat_zone_card_of(IdSpace parts) {
  return {
      {&HeatZoneCard::id_haz, id("id_haz", IdSpace::define, required, "number of the zone")},
      {&HeatZoneCard::iop, integer("iop", 0, between(0, 1), "1: it acts; 0: it does not")},
      {&HeatZoneCard::pid, id("pid", parts, required, "part or part set of the sheets")},
      {&HeatZoneCard::pid_typ, integer("pid_typ", 0, between(0, 1), "what PID is: 0 a part, 1 a part set")},
  };
}
const CardOf<HeatZoneCard> zone_of_part = heat_zone_card_of(IdSpace::part),
                           zone_of_set = heat_zone_card_of(IdSpace::set);

struct FactorCard {
  std::array<int, 8> curve{};  ///< ISS IFS ISB IFB ISC IFC ISW IFW
};
FieldOf<FactorCard> factor_field(std::size_t i, std::string_view name, std::string_view meaning) {
  return {at(&FactorCard::curve, i), or_negative(id(name, IdSpace::function, 0, meaning), IdSpace::function)};
}
const CardOf<FactorCard> factor_card{
    factor_field(0, "iss",
                 "curve: factor on the yield stress over the distance from a brick weld; negative: in diameters"),
    factor_field(1, "ifs", "on the strain at failure, from a brick weld"),
    factor_field(2, "isb", "on the yield stress, from a beam weld"),
    factor_field(3, "ifb", "on the strain at failure, from a beam weld"),
    factor_field(4, "isc", "on the yield stress, from a constrained weld"),
    factor_field(5, "ifc", "on the strain at failure, from a constrained weld"),
    factor_field(6, "isw", "on the yield stress, from the line of a tailor welded blank"),
    factor_field(7, "ifw", "on the strain at failure, from that line"),
};

struct SeamCard {
  int idtwb = 0, idns = 0, idp = 0, ipflag = 0, imonflag = 0;
};
CardOf<SeamCard> seam_card_of(IdSpace parts) {
  return {
      {&SeamCard::idtwb, id("idtwb", IdSpace::define, required, "number of the line")},
      {&SeamCard::idns, id("idns", IdSpace::set, required, "set of its nodes, in order")},
      {&SeamCard::idp, id("idp", parts, 0, "part or part set that it counts for; 0: all of the zones")},
      {&SeamCard::ipflag, integer("ipflag", 0, between(0, 1), "what IDP is: 0 a part, 1 a part set")},
      {&SeamCard::imonflag,
       integer("imonflag", 0, between(0, 1), "no effect: curves of ISW and IFW need not rise, as with 1")},
  };
}
const CardOf<SeamCard> seam_of_part = seam_card_of(IdSpace::part), seam_of_set = seam_card_of(IdSpace::set);

std::vector<Index> parts_of(Builder& b, const deck::Entry& field, bool set) {
  if (set) {
    const auto* parts = b.part_set(field);
    return parts ? parts->members : std::vector<Index>{};
  }
  const Index part = b.part(field);
  return part == none ? std::vector<Index>{} : std::vector<Index>{part};
}

HeatZone::Factor factor(Builder& b, const deck::Entry& field, bool has_diameter) {
  const int given = field.integer();
  if (given == 0) return {};
  if (given < 0 && !has_diameter)
    refuse(b, field, "these welds have no diameter to count distances in", "write the curve over the distance");
  const Index curve = b.curves.find(std::abs(given));
  if (curve == none) {
    refuse(b, field, fmt::format("curve {} is not defined", std::abs(given)), "define it");
    return {};
  }
  return {b.model.curves[curve], given < 0};
}

/// The softening stands in the laws of the parts.
void check_law(Builder& b, const deck::Entry& pid, Index part) {
  const Index material = b.model.parts[part].material;
  if (material == none) return;
  const Material& m = b.model.materials[material];
  if (std::holds_alternative<kernel::PlasticKinematic>(m.law) || std::holds_alternative<kernel::PiecewiseLinear>(m.law))
    return;
  refuse(b, pid, fmt::format("part {} is of *{}, which no heat can soften here", b.model.parts[part].id, m.keyword),
         "built for MAT_003 and MAT_024");
}

void read_heat_zone(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const bool set = cursor.peek_number(3) == 1.0;
  const auto row = cursor.read(set ? zone_of_set : zone_of_part);
  const auto factors = cursor.read(factor_card);
  expect_end(b, cursor);
  if (row->iop == 0) {
    row[&HeatZoneCard::iop].report(b.findings, Severity::note, "the zone does not act", "write 1 if it is to act");
    return;
  }
  b.defer(Phase::conditions, [row, factors, set](Builder& later) {
    HeatZone zone;
    zone.id = row->id_haz;
    zone.place = row.place();
    zone.parts = parts_of(later, row[&HeatZoneCard::pid], set);
    for (const Index part : zone.parts) check_law(later, row[&HeatZoneCard::pid], part);
    for (std::size_t i = 0; i < 4; ++i) {
      const bool has_diameter = i == HeatZone::bricks || i == HeatZone::beams;
      zone.yield[i] = factor(later, factors[at(&FactorCard::curve, 2 * i)], has_diameter);
      zone.strain[i] = factor(later, factors[at(&FactorCard::curve, 2 * i + 1)], has_diameter);
    }
    later.model.heat_zones.push_back(std::move(zone));
  });
}

void read_seam(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const bool set = cursor.peek_number(3) == 1.0;
  const auto row = cursor.read(set ? seam_of_set : seam_of_part);
  expect_end(b, cursor);
  b.defer(Phase::conditions, [row, set](Builder& later) {
    WeldSeam seam;
    seam.id = row->idtwb;
    if (const auto* nodes = later.node_set(row[&SeamCard::idns])) seam.nodes = nodes->members;
    if (row->idp != 0) seam.parts = parts_of(later, row[&SeamCard::idp], set);
    later.model.weld_seams.push_back(std::move(seam));
  });
}

}  // namespace

std::vector<Keyword> heat_zone_keywords() {
  return {
      {.name = "DEFINE_HAZ_PROPERTIES",
       .options = {"TITLE"},
       .layout = {{"", &zone_of_part}, {"", &factor_card}},
       .read = read_heat_zone},
      {.name = "DEFINE_HAZ_TAILOR_WELDED_BLANK",
       .options = {"TITLE"},
       .layout = {{"", &seam_of_part}},
       .read = read_seam},
  };
}

}  // namespace nugget::reading
