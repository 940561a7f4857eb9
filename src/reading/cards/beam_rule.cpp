// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/beam_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/index.hpp"
#include "deck/text.hpp"

namespace nugget::reading {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

namespace {

struct BeamRuleCards : kernel::SectionShape {
  int irid = 0, nip = 0, k = 0;
  double ra = 0.0, sref = 0.0, tref = 0.0;
};
const CardOf<BeamRuleCards> beam_rule_table{
    {&BeamRuleCards::irid,
     id("irid", IdSpace::other, required, "id of the rule, which QR/IRID of *SECTION_BEAM gives with a minus")},
    {&BeamRuleCards::nip, integer("nip", 0, between(0, kernel::most_fibres), "points of the user; 0 with ICST")},
    {&BeamRuleCards::ra, real("ra", dimension::number, 0, at_least(0),
                              "area of the cross-section over TS1 times TT1; for points of the user")},
    {&BeamRuleCards::type, integer("icst", 0, between(0, kernel::section_shapes),
                                   "standard cross-section: 1 W, 2 channel, 3 angle, 4 T, 5 rectangular tube, 6 Z, 7 "
                                   "trapezium, 8 circle, 9 tube, 11 rectangle, others: manual; 0: points of the user")},
    {&BeamRuleCards::k, integer("k", 0, at_least(0), "refinement of a standard cross-section: 1 + K times the points")},
};
CardOf<BeamRuleCards> beam_shape_fields() {
  const auto size = [](std::string_view name) {
    return real(name, dimension::length, 0, at_least(0), "dimension of the cross-section");
  };
  return {
      {at(&BeamRuleCards::d, 0), size("d1")},
      {at(&BeamRuleCards::d, 1), size("d2")},
      {at(&BeamRuleCards::d, 2), size("d3")},
      {at(&BeamRuleCards::d, 3), size("d4")},
      {&BeamRuleCards::sref, real("sref", dimension::number, 0, any_value,
                                  "the nodes stand at s = 1 the upper, 0 the middle, -1 the lower side; not NSLOC")},
      {&BeamRuleCards::tref, real("tref", dimension::number, 0, any_value, "the same along t; not NTLOC")},
      {at(&BeamRuleCards::d, 4), size("d5")},
      {at(&BeamRuleCards::d, 5), size("d6")},
  };
}
const CardOf<BeamRuleCards> beam_shape_table = beam_shape_fields();

struct BeamPointCard {
  double s = 0.0, t = 0.0, wf = 0.0;
};
const CardOf<BeamPointCard> beam_point_table{
    {&BeamPointCard::s,
     real("s", dimension::number, 0, between(-1, 1), "place of the point along s, in halves of TS1")},
    {&BeamPointCard::t,
     real("t", dimension::number, 0, between(-1, 1), "place of the point along t, in halves of TT1")},
    {&BeamPointCard::wf,
     real("wf", dimension::number, required, above_zero(), "its share of the cross-section's area")},
    integer("pid", 0, only(0), "part whose material the point has; only that of the beams' own part is built"),
};

struct NamedShape : kernel::SectionShape {
  std::string stype;
};
CardOf<NamedShape> named_shape_fields() {
  CardOf<NamedShape> card{
      {&NamedShape::stype, text("stype", 10, "SECTION_01 to SECTION_22: a cross-section as ICST 1 to 22")}};
  for (const std::string_view name : {"d1", "d2", "d3", "d4", "d5", "d6"})
    card.add({at(&NamedShape::d, card.fields.size() - 1),
              real(name, dimension::length, 0, at_least(0), "dimension of the cross-section")});
  return card;
}
const CardOf<NamedShape> named_shape_table = named_shape_fields();

/// True where there is such a cross-section; else a finding at the dimension that is wrong.
template <class T>
bool check_beam_shape(Builder& b, const RowOf<T>& row, const kernel::SectionShape& shape) {
  const auto fault = kernel::shape_fault(shape);
  if (!fault) return true;
  refuse(b, row[at(static_cast<std::array<double, 6> T::*>(&T::d), at(fault->dimension))], fault->text,
         "see docs/manual/cross_sections_of_beams.md for what D1 to D6 are");
  return false;
}

/// True where the rule has a standard cross-section that can be used.
bool take_beam_shape(Builder& b, Cursor& cursor, const RowOf<BeamRuleCards>& row, BeamRule& rule) {
  BeamRuleCards card = *row;
  const auto size = cursor.read(beam_shape_table, card);
  if (row->nip != 0)
    refuse(b, row[&BeamRuleCards::nip], "a standard cross-section (ICST) has points of its own", "write 0");
  if (row->ra != 0.0)
    refuse(b, row[&BeamRuleCards::ra], "a standard cross-section (ICST) has an area of its own", "write 0");
  if (row->nip != 0 || !check_beam_shape(b, size, card)) return false;
  if (kernel::shape_fibres(card, card.k).count == 0) {
    int most = card.k;
    while (most > 0 && kernel::shape_fibres(card, most).count == 0) --most;
    refuse(b, row[&BeamRuleCards::k],
           fmt::format("{} refined by {} has more than {} points", kernel::shape_name(card.type), card.k,
                       kernel::most_fibres),
           fmt::format("write {} or less", most));
    return false;
  }
  rule.shape = card;
  rule.refinement = card.k;
  rule.node_s = card.sref;
  rule.node_t = card.tref;
  return true;
}

bool take_beam_points(Builder& b, Cursor& cursor, const RowOf<BeamRuleCards>& row, BeamRule& rule) {
  if (row->nip == 0) {
    refuse(b, row[&BeamRuleCards::nip], "neither a standard cross-section (ICST) nor points of the user", "give one");
    return false;
  }
  if (!(row->ra > 0.0))
    refuse(b, row[&BeamRuleCards::ra], "points of the user need the area of the cross-section over TS1 times TT1",
           "write 1 where the cross-section fills that rectangle");
  rule.relative_area = row->ra;
  double sum = 0.0;
  for (int k = 0; k < row->nip; ++k) {
    const auto point = cursor.read(beam_point_table);
    const auto i = at(rule.points.count++);
    rule.points.s[i] = point->s;
    rule.points.t[i] = point->t;
    rule.points.area[i] = point->wf;
    sum += point->wf;
  }
  if (std::abs(sum - 1.0) > 1e-3)
    row[&BeamRuleCards::irid].report(
        b.findings, Severity::warning,
        fmt::format("the points' shares sum up to {:.4g}, and so much of the area of RA is there", sum),
        "shares that sum up to 1 leave the area to RA");
  return row->ra > 0.0;
}

/// The points of a section, by its rule; nothing (and a finding) where they cannot be.
std::optional<kernel::SectionPoints> points_of_beam(Builder& b, const BeamRule& rule, const SectionBeam& section,
                                                    const deck::Entry& location, const deck::Entry& extent) {
  const bool moved = section.location[0] != 0.0 || section.location[1] != 0.0;
  if (rule.shape) {
    if (moved)
      location.report(b.findings, Severity::warning,
                      "a standard cross-section lies by SREF and TREF of *INTEGRATION_BEAM, not by NSLOC and NTLOC",
                      "write SREF and TREF there, and 0 here");
    return kernel::shape_points(*rule.shape, rule.refinement, rule.node_s, rule.node_t);
  }
  if (section.cross_section == 1) {
    refuse(b, extent, "points of the user lie in a rectangle of TS1 by TT1, and a tube (CST 1) has diameters there",
           "write CST 2");
    return std::nullopt;
  }
  const double along_s = 0.5 * (section.outer[0] + section.outer[1]),
               along_t = 0.5 * (section.inner[0] + section.inner[1]);
  if (!(along_s > 0.0 && along_t > 0.0)) {
    refuse(b, extent, "points of the user need the rectangle in which they lie", "give TS1 and TT1");
    return std::nullopt;
  }
  kernel::FibreRule fibres = rule.points;
  for (std::size_t k = 0; k < at(fibres.count); ++k) {
    fibres.s[k] = 0.5 * along_s * (fibres.s[k] - section.location[0]);
    fibres.t[k] = 0.5 * along_t * (fibres.t[k] - section.location[1]);
    fibres.area[k] *= rule.relative_area * along_s * along_t;
  }
  return kernel::user_points(fibres);
}

}  // namespace

const Card beam_rule_card = beam_rule_table, beam_shape_card = beam_shape_table, beam_point_card = beam_point_table,
           named_shape_card = named_shape_table;

void read_beam_rule(Builder& b, const Block& block, const Options&) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const auto row = cursor.read(beam_rule_table);
    const int shape = row->type;
    if (shape < 0 || shape > kernel::section_shapes || row->nip < 0 || row->nip > kernel::most_fibres || row->k < 0)
      return;  // refused by its range
    BeamRule rule;
    const bool usable = shape > 0 ? take_beam_shape(b, cursor, row, rule) : take_beam_points(b, cursor, row, rule);
    if (shape > 0 && row->nip != 0) return;  // how many cards belong to it is not known
    if (!b.beam_rules.try_emplace(row->irid, usable ? std::optional(rule) : std::nullopt).second)
      refuse(b, row[&BeamRuleCards::irid], fmt::format("rule {} is defined twice", row->irid), "give it another id");
  }
}

bool names_a_shape(const Cursor& cursor) {
  const std::string line = deck::upper(cursor.peek());
  return deck::trimmed(line.substr(0, std::min<std::size_t>(10, line.find(',')))).starts_with("SECTION_");
}

void read_named_shape(Builder& b, Cursor& cursor, SectionBeam& section) {
  const auto row = cursor.read(named_shape_table);
  section.area = std::numeric_limits<double>::quiet_NaN();
  kernel::SectionShape shape = *row;
  const std::string name = deck::upper(row->stype), number = name.substr(std::min<std::size_t>(8, name.size()));
  const bool digits = !number.empty() && number.size() <= 2 &&
                      std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  shape.type = digits ? std::stoi(number) : 0;
  if (shape.type < 1 || shape.type > kernel::section_shapes)
    return refuse(b, row[&NamedShape::stype], "there is no cross-section of this name",
                  fmt::format("write SECTION_01 to SECTION_{}", kernel::section_shapes));
  if (!check_beam_shape(b, row, shape)) return;
  const kernel::ShapeConstants c = kernel::shape_constants(shape);
  if (section.elform == 2 && std::abs(c.product) > 1e-9 * std::max(c.moment_s, c.moment_t))
    return refuse(b, row[&NamedShape::stype],
                  fmt::format("the principal axes of {} are not s and t, which ELFORM 2 takes for such",
                              kernel::shape_name(shape.type)),
                  "compute it with ELFORM 1 and *INTEGRATION_BEAM");
  section.area = c.area;
  section.moment_s = c.moment_s;
  section.moment_t = c.moment_t;
  section.torsion_constant = c.torsion;
}

void take_beam_rule(Builder& b, int id, const deck::Entry& given, const deck::Entry& location,
                    const deck::Entry& extent) {
  b.defer(Phase::curves, [=, index = b.model.beam_sections.size()](Builder& builder) {
    const auto found = builder.beam_rules.find(id);
    if (found == builder.beam_rules.end())
      return refuse(builder, given, fmt::format("rule {} is not defined", id),
                    "define it with *INTEGRATION_BEAM, or write 1 to 5");
    if (!found->second) return;  // refused where it stands
    SectionBeam& section = builder.model.beam_sections[index];
    section.points = points_of_beam(builder, *found->second, section, location, extent);
    if (!section.points) return;
    const kernel::FibreRule& fibres = section.points->fibres;
    section.area = 0.0;
    for (std::size_t k = 0; k < at(fibres.count); ++k) section.area += fibres.area[k];
    const double away = std::hypot(section.points->offset_s, section.points->offset_t);
    if (away > 1e-3 * std::sqrt(section.area))
      given.report(builder.findings, Severity::note,
                   fmt::format("the cross-section's centroid lies {:.4g} along s and {:.4g} along t off the nodes: a "
                               "pull along them bends the beams",
                               section.points->offset_s, section.points->offset_t),
                   found->second->shape ? "SREF and TREF of *INTEGRATION_BEAM move it" : "NSLOC and NTLOC move it");
  });
}

}  // namespace nugget::reading
