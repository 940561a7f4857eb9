// SPDX-License-Identifier: Apache-2.0
// *INITIAL_STRESS_SHELL, _SOLID, _SECTION, *INITIAL_STRAIN_SHELL, *INITIAL_AXIAL_FORCE_BEAM.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

// ---- stresses of an earlier run

struct StressPointsCard {
  int eid = 0, nplane = 0, nthick = 0, nhisv = 0, large = 0, nint = 0;
};
const CardOf<StressPointsCard> initial_shell_card{
    {&StressPointsCard::eid, id("eid", IdSpace::element, required, "shell")},
    {&StressPointsCard::nplane,
     integer("nplane", 1, at_least(1), "number of in-plane points; the mean of those at one height is taken")},
    {&StressPointsCard::nthick, integer("nthick", 1, at_least(1), "number of points through the thickness")},
    {&StressPointsCard::nhisv,
     integer("nhisv", 0, at_least(0), "number of history variables of a point; they are read past")},
    integer("ntensr", 0, only(0), "number of tensors of a point"),
    {&StressPointsCard::large, integer("large", 0, between(0, 1), "1: fields of 16 columns, five a line")},
    integer("nthint", 0, only(0), "thermal points"),
    integer("nthhsv", 0, only(0), "thermal history variables"),
};
const CardOf<StressPointsCard> initial_solid_card{
    {&StressPointsCard::eid, id("eid", IdSpace::element, required, "brick")},
    {&StressPointsCard::nint, integer("nint", 1, at_least(1), "number of points; their mean is taken")},
    {&StressPointsCard::nhisv,
     integer("nhisv", 0, at_least(0), "number of history variables of a point; they are read past")},
    {&StressPointsCard::large, integer("large", 0, between(0, 1), "1: fields of 16 columns, five a line")},
    integer("iveflg", 0, only(0), "initial volume or energy"),
    integer("ialegp", 0, any_value, "ALE group"),
    integer("nthint", 0, only(0), "thermal points"),
    integer("nthhsv", 0, only(0), "thermal history variables"),
};
const CardOf<StressPointsCard> strain_card{
    {&StressPointsCard::eid, id("eid", IdSpace::element, required, "shell")},
    {&StressPointsCard::nplane, integer("nplane", 1, at_least(1), "number of in-plane points")},
    {&StressPointsCard::nthick,
     integer("nthick", 2, at_least(1), "number of points through the thickness; blank: the lower and the upper")},
    {&StressPointsCard::large, integer("large", 0, between(0, 1), "1: fields of 16 columns, five a line")},
    unused(),
    unused(),
    unused(),
    integer("ilocal", 0, only(0), "strains in the axes of the element"),
};

/// The numbers of one point.
struct Point {
  double t = 0, eps = 0;
  std::array<double, 6> tensor{};  ///< xx yy zz xy yz zx
};
using StressPointFields = std::vector<FieldOf<Point>>;

const FieldOf<Point> place_field{&Point::t,
                                 real("t", dimension::number, 0, between(-1, 1), "place through the thickness")};
const FieldOf<Point> plastic_field{&Point::eps,
                                   real("eps", dimension::number, 0, at_least(0), "effective plastic strain")};
StressPointFields tensor_fields(std::string_view meaning, Dimension d) {
  constexpr std::array<std::string_view, 6> names{"xx", "yy", "zz", "xy", "yz", "zx"};
  StressPointFields fields;
  for (std::size_t i = 0; i < names.size(); ++i)
    fields.push_back({at(&Point::tensor, i), real(names[i], d, 0, any_value, meaning)});
  return fields;
}

StressPointFields joined(StressPointFields a, const StressPointFields& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
const StressPointFields stress_fields = tensor_fields("stress, global axes", dimension::stress);
const StressPointFields shell_point = joined(joined({place_field}, stress_fields), {plastic_field});
const StressPointFields solid_point = joined(stress_fields, {plastic_field});
const StressPointFields strain_point = joined(tensor_fields("strain, global axes", dimension::number), {place_field});

/// The fields of a point as cards: one of 10 columns each, or lines of five fields of 16.
std::vector<CardOf<Point>> cards_of(const StressPointFields& fields, bool large) {
  std::vector<CardOf<Point>> cards;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (large ? i % 5 == 0 : i == 0) cards.emplace_back();
    cards.back().add(large ? wide(fields[i], 16) : fields[i]);
  }
  return cards;
}
struct PointCards {
  std::vector<CardOf<Point>> normal, large;
  explicit PointCards(const StressPointFields& fields)
      : normal(cards_of(fields, false)), large(cards_of(fields, true)) {}
};
const PointCards shell_point_cards(shell_point), strain_point_cards(strain_point);
const PointCards solid_point_cards = [] {
  PointCards cards(solid_point);
  for (int history = 0; history < 3; ++history) cards.large.back().add(wide(unused(), 16));
  return cards;
}();

Point read_point(Cursor& cursor, const PointCards& cards, bool large) {
  Point point;
  for (const CardOf<Point>& card : large ? cards.large : cards.normal) cursor.read(card, point);
  return point;
}

/// A stress of a deck that *INCLUDE_TRANSFORM turns would have to be turned too.
bool turned(Builder& builder, const Block& block) {
  if (!block.transform || block.transform->matrix == deck::Transform{}.matrix) return false;
  builder.findings.error(block.place, block.starred(), "initial stresses and strains are not turned with their include",
                         "give them in the deck of the assembled model");
  return true;
}

/// Points that the row announces. Nothing and a finding where they are more than the lines of the block, of which a
/// point takes one or more.
std::optional<int> points_of(Builder& builder, const Cursor& cursor, const RowOf<StressPointsCard>& row,
                             bool in_layers) {
  const std::int64_t announced = in_layers ? std::int64_t{row->nplane} * row->nthick : std::int64_t{row->nint};
  const std::size_t lines = cursor.block().lines.size();
  if (announced <= static_cast<std::int64_t>(lines)) return static_cast<int>(announced);
  refuse(builder, row[in_layers ? &StressPointsCard::nthick : &StressPointsCard::nint],
         fmt::format("{} points are announced, but the keyword has only {} lines", announced, lines),
         "see the number of points, or whether lines are missing");
  return std::nullopt;
}

void refuse_short(Builder& builder, const RowOf<StressPointsCard>& row, bool in_layers, int announced, int found) {
  refuse(builder, row[in_layers ? &StressPointsCard::nthick : &StressPointsCard::nint],
         fmt::format("{} points are announced, but the keyword ends after {}", announced, found),
         "see the number of points, or whether lines are missing");
}

/// Points of one place are averaged: where places are missing, the bending is lost.
void expect_places(Builder& builder, const RowOf<StressPointsCard>& row, const std::vector<InitialPoint>& points) {
  std::vector<double> places;
  for (const InitialPoint& p : points) places.push_back(p.zeta);
  std::sort(places.begin(), places.end());
  const auto different = std::unique(places.begin(), places.end()) - places.begin();
  if (different != row->nthick)
    row[&StressPointsCard::nthick].report(
        builder.findings, Severity::warning,
        fmt::format("the points are at {} different place{} T through the thickness, and those of one place "
                    "are averaged",
                    different, different == 1 ? "" : "s"),
        "give each of the NTHICK places its T, from -1 at the bottom to 1");
}

template <bool shell>
void read_stress(Builder& builder, const Block& block, const Options&) {
  if (turned(builder, block)) return;
  Cursor cursor(builder.deck, block, builder.findings);
  bool reported = false;
  while (!at_end(cursor)) {
    const auto row = cursor.read(shell ? initial_shell_card : initial_solid_card);
    const bool large = row->large == 1;
    const std::optional<int> points = points_of(builder, cursor, row, shell);
    if (!points) return;
    // With LARGE the history of bricks begins on the line on which their tensor ends, in its last three fields.
    const int per_line = large ? 5 : 8, history = std::max(0, row->nhisv - (!shell && large ? 3 : 0));
    const int history_lines = history / per_line + (history % per_line > 0 ? 1 : 0);
    InitialStress stress;
    stress.place = row.place();
    for (int i = 0; i < *points; ++i) {
      if (!cursor.more()) return refuse_short(builder, row, shell, *points, i);
      const Point point = read_point(cursor, shell ? shell_point_cards : solid_point_cards, large);
      for (int line = 0; line < history_lines && cursor.more(); ++line) cursor.skip();
      stress.points.push_back({point.t, point.tensor, point.eps});
    }
    if (shell) expect_places(builder, row, stress.points);
    if (row->nhisv > 0 && !reported) {
      reported = true;
      row[&StressPointsCard::nhisv].report(
          builder.findings, Severity::warning,
          "history variables of another program's laws are not taken over; stress and plastic strain are");
    }
    builder.defer(Phase::conditions, [row, stress](Builder& b) mutable {
      stress.element = shell ? b.shell(row[&StressPointsCard::eid]) : b.solid(row[&StressPointsCard::eid]);
      if (stress.element == none) return;
      InitialState& state = b.model.initial_state;
      (shell ? state.shells : state.solids).push_back(std::move(stress));
    });
  }
}

void read_strain(Builder& builder, const Block& block, const Options&) {
  if (turned(builder, block)) return;
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(strain_card);
    const std::optional<int> points = points_of(builder, cursor, row, true);
    if (!points) return;
    InitialStrain strain;
    double lowest = 2.0, highest = -2.0;
    for (int i = 0; i < *points; ++i) {
      if (!cursor.more()) return refuse_short(builder, row, true, *points, i);
      const Point point = read_point(cursor, strain_point_cards, row->large == 1);
      if (point.t < lowest) lowest = point.t, strain.lower = point.tensor;
      if (point.t > highest) highest = point.t, strain.upper = point.tensor;
      // Without places the last point is the upper one.
      if (i + 1 == *points && lowest == highest) strain.upper = point.tensor;
    }
    builder.defer(Phase::conditions, [row, strain](Builder& b) mutable {
      strain.shell = b.shell(row[&StressPointsCard::eid]);
      if (strain.shell != none) b.model.initial_state.shell_strains.push_back(strain);
    });
  }
}

// ---- preloads

struct AxialCard {
  int bsid = 0, lcid = 0;
  double scale = 0;
  int kbend = 0;
};
const CardOf<AxialCard> axial_card{
    {&AxialCard::bsid, id("bsid", IdSpace::set, required, "beam set")},
    {&AxialCard::lcid,
     id("lcid", IdSpace::function, required, "curve of the force over time; the preload ends with the curve")},
    {&AxialCard::scale, real("scale", dimension::number, 1, any_value, "scale of the curve")},
    {&AxialCard::kbend,
     integer("kbend", 0, between(0, 1), "0: all points of a section get the same axial stress; 1: the same mean")},
};

void read_axial(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(axial_card);
    builder.defer(Phase::conditions, [row](Builder& b) {
      const auto* beams = b.beam_set(row[&AxialCard::bsid]);
      AxialForce force{{}, b.curve(row[&AxialCard::lcid]), row->scale, row->kbend == 1, row.place()};
      if (!beams || force.curve == none) return;
      force.beams = beams->members;
      b.model.initial_state.axial_forces.push_back(std::move(force));
    });
  }
}

struct SectionStressCard {
  int csid = 0, lcid = 0, psid = 0, vid = 0, izshear = 0;
};
const CardOf<SectionStressCard> section_stress_card{
    id("issid", IdSpace::other, 0, "number of this preload"),
    {&SectionStressCard::csid, id("csid", IdSpace::other, required, "cross section (*DATABASE_CROSS_SECTION_..._ID)")},
    {&SectionStressCard::lcid,
     id("lcid", IdSpace::function, required, "curve of the normal stress over time; the preload ends with the curve")},
    {&SectionStressCard::psid, id("psid", IdSpace::set, 0, "part set; 0: all parts of the section")},
    {&SectionStressCard::vid, id("vid", IdSpace::define, 0, "vector of the normal; 0: that of the plane")},
    {&SectionStressCard::izshear,
     integer("izshear", 0, between(0, 2),
             "0: the other stresses are 0; 1: they grow as the material says; 2: so does bending within a brick")},
    integer("istiff", 0, only(0), "artificial stiffness during the preload"),
};

/// The bricks of a section and, where it is a plane, its normal.
void resolve_section_stress(Builder& builder, const RowOf<SectionStressCard>& row) {
  const auto& sections = builder.model.requests.cross_sections;
  const int id = row->csid;
  const auto found =
      std::find_if(sections.begin(), sections.end(), [id](const CrossSection& section) { return section.id == id; });
  if (found == sections.end())
    return refuse(builder, row[&SectionStressCard::csid], fmt::format("cross section {} is not defined", id),
                  "define it by *DATABASE_CROSS_SECTION_PLANE_ID or _SET_ID");
  SectionStress stress;
  stress.section = static_cast<Index>(found - sections.begin());
  if (found->plane) stress.normal = found->plane->normal;
  stress.curve = builder.curve(row[&SectionStressCard::lcid]);
  stress.keep_shear = row->izshear > 0;
  stress.bends = row->izshear == 2;
  stress.place = row.place();
  if (const Vec3d* vector = builder.vector(row[&SectionStressCard::vid])) stress.normal = unit(*vector);
  if (norm(stress.normal) == 0.0)
    return refuse(builder, row[&SectionStressCard::vid], "a cross section by sets has no normal of its own",
                  "name a *DEFINE_VECTOR");
  if (const auto* parts = builder.part_set(row[&SectionStressCard::psid])) stress.parts = parts->members;
  stress.solids = bricks_of(builder.model, *found, stress.parts);
  if (stress.curve != none) builder.model.initial_state.section_stresses.push_back(std::move(stress));
}

void read_section_stress(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(section_stress_card);
    // In the phase of the checks, when all cross sections are there.
    builder.defer(Phase::checks, [row](Builder& b) { resolve_section_stress(b, row); });
  }
}

}  // namespace

std::vector<Keyword> initial_state_keywords() {
  const auto points = [](const Card& first, const PointCards& cards) {
    return std::vector<LayoutCard>{{{}, &first}, {"for each point", &cards.normal.front()}};
  };
  return {
      {.name = "INITIAL_STRESS_SHELL",
       .layout = points(initial_shell_card, shell_point_cards),
       .read = read_stress<true>},
      {.name = "INITIAL_STRESS_SOLID",
       .layout = points(initial_solid_card, solid_point_cards),
       .read = read_stress<false>},
      {.name = "INITIAL_STRAIN_SHELL", .layout = points(strain_card, strain_point_cards), .read = read_strain},
      {.name = "INITIAL_STRESS_SECTION", .layout = {{{}, &section_stress_card}}, .read = read_section_stress},
      {.name = "INITIAL_AXIAL_FORCE_BEAM", .layout = {{{}, &axial_card}}, .read = read_axial},
  };
}

}  // namespace nugget::reading
