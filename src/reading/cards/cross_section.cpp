// SPDX-License-Identifier: Apache-2.0
// *DATABASE_CROSS_SECTION_... (secforc) and *DATABASE_NODAL_FORCE_GROUP (nodfor).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/index.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

/// ID and ITYPE. The id belongs to the name space that ITYPE says.
Field axes_id(IdSpace space) {
  return id("id", space, 0,
            "rigid body, accelerometer or coordinate system in whose axes the result is written; 0: global axes");
}
const Field axes_kind =
    integer("itype", 0, between(0, 2), "what id is: 0 a rigid body, 1 an accelerometer, 2 a coordinate system");

/// One card for each ITYPE.
std::array<Card, 3> for_each_kind(Card (*card)(IdSpace)) {
  return {card(IdSpace::part), card(IdSpace::element), card(IdSpace::define)};
}
const Card& card_for(const std::array<Card, 3>& cards, double kind) {
  return cards[kind == 1.0 ? 1 : kind == 2.0 ? 2 : 0];
}

Card set_card_of(IdSpace axes) {
  return {{
      id("nsid", IdSpace::set, required, "node set: the nodes of the section"),
      id("hsid", IdSpace::set, 0, "solid set: bricks on one side of these nodes"),
      id("bsid", IdSpace::set, 0, "beam set"),
      id("ssid", IdSpace::set, 0, "shell set"),
      id("tsid", IdSpace::set, 0, "set of thick shells"),
      id("dsid", IdSpace::set, 0, "set of discrete elements"),
      axes_id(axes),
      axes_kind,
  }};
}
const std::array<Card, 3> set_cards = for_each_kind(set_card_of);

const Card plane_card1{{
    id("psid", IdSpace::set, 0, "part set whose elements are cut; 0: all parts"),
    real("xct", dimension::length, 0, any_value, "point on the plane, x"),
    real("yct", dimension::length, 0, any_value, "y"),
    real("zct", dimension::length, 0, any_value, "z"),
    real("xch", dimension::length, 0, any_value, "head of the plane's normal, x"),
    real("ych", dimension::length, 0, any_value, "y"),
    real("zch", dimension::length, 0, any_value, "z"),
    real("radius", dimension::length, 0, at_least(0), "radius of a circle about the point; 0: no circle"),
}};
Card plane_card2_of(IdSpace axes) {
  return {{
      real("xhev", dimension::length, 0, any_value, "head of the edge L, whose tail is the point, x"),
      real("yhev", dimension::length, 0, any_value, "y"),
      real("zhev", dimension::length, 0, any_value, "z"),
      real("lenl", dimension::length, 0, at_least(0), "length along the edge L; 0: infinite"),
      real("lenm", dimension::length, 0, at_least(0), "length along the edge M = normal x L; 0: infinite"),
      axes_id(axes),
      axes_kind,
  }};
}
const std::array<Card, 3> plane_cards2 = for_each_kind(plane_card2_of);

const Card group_card{{
    id("nsid", IdSpace::set, required, "node set"),
    id("cid", IdSpace::define, 0, "coordinate system in which the sum is written as well"),
}};

// ---- axes ----------------------------------------------------------------------------------------------------------

void resolve_axes(Builder& builder, const Row& row, CrossSection& section) {
  if (row.integer("id") == 0) return;
  switch (row.integer("itype")) {
    case 0:
      section.rigid_body = find_body(builder, row, "id");
      if (section.rigid_body == none) return;
      if (const Frame3d* axes = body_axes(builder, row.integer("id")))
        section.axes = *axes;
      else
        refuse(builder, row, "id", "local axes of this body are not known: its principal axes are not used",
               "name a coordinate system in LCO of *MAT_RIGID, or use itype 2");
      return;
    case 1: {
      const auto& all = builder.model.accelerometers;
      const auto found =
          std::find_if(all.begin(), all.end(), [&](const Accelerometer& a) { return a.id == row.integer("id"); });
      if (found == all.end())
        return refuse(builder, row, "id", fmt::format("accelerometer {} is not defined", row.integer("id")),
                      "name an *ELEMENT_SEATBELT_ACCELEROMETER");
      section.accelerometer = static_cast<Index>(found - all.begin());
      return;
    }
    default: section.system = builder.turning_or_fixed_system(row, "id");
  }
}

int section_id(const Builder& builder, int given) {
  return given > 0 ? given : static_cast<int>(builder.model.requests.cross_sections.size()) + 1;
}

void add_section(Builder& builder, const Row& row, std::string_view field, CrossSection section) {
  // It stays: sections without an id are numbered by their place in the deck.
  if (section.facets.empty())
    row.report(builder.findings, Severity::warning, field,
               fmt::format("cross section {} has no elements: its forces are 0", section.id),
               "check the sets, or where the plane lies");
  builder.model.requests.cross_sections.push_back(std::move(section));
}

// ---- by sets -------------------------------------------------------------------------------------------------------

/// Without the elements of rigid parts, which have no internal forces.
std::vector<Index> deformable(const Model& model, const std::vector<Index>& elements,
                              const std::vector<Index>& part_of) {
  std::vector<Index> kept;
  for (const Index e : elements)
    if (model.parts[at(part_of[at(e)])].rigid_body == none) kept.push_back(e);
  return kept;
}

void resolve_set(Builder& builder, const Row& row, CrossSection section) {
  const Model& model = builder.model;
  const auto* nodes = builder.node_set(row, "nsid");
  if (!nodes) return;
  section.id = section_id(builder, section.id);
  section.nodes = nodes->members;
  make_unique(section.nodes);
  std::vector<char> marked(model.nodes.size(), 0);
  for (const Index n : section.nodes) marked[at(n)] = 1;
  const auto take = [&](ElementKind kind, const Set<Index>* set, const std::vector<Index>& part_of) {
    if (!set) return;
    for (auto& facet : facets_between(model, kind, deformable(model, set->members, part_of), marked))
      section.facets.push_back(std::move(facet));
  };
  take(ElementKind::shell, builder.shell_set(row, "ssid"), model.shells.part);
  take(ElementKind::solid, builder.solid_set(row, "hsid"), model.solids.part);
  take(ElementKind::beam, builder.beam_set(row, "bsid"), model.beams.part);
  resolve_axes(builder, row, section);
  add_section(builder, row, "nsid", std::move(section));
}

CrossSection headed(Cursor& cursor, const Options& options) {
  CrossSection section;
  const Heading heading = read_heading(cursor, options.contains("ID"));
  section.id = heading.id;
  section.title = heading.text;
  section.place = cursor.place();
  return section;
}

void read_set(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const CrossSection section = headed(cursor, options);
    const Row row = cursor.read(card_for(set_cards, cursor.peek_number(7)));
    refuse_nonzero(builder, row, "tsid", "thick shells are not built", "leave it 0");
    refuse_nonzero(builder, row, "dsid", "discrete elements carry no section force", "leave it 0; deforc holds theirs");
    builder.defer(Phase::conditions, [row, section](Builder& b) { resolve_set(b, row, section); });
  }
}

// ---- by a plane ----------------------------------------------------------------------------------------------------

/// False (and a finding) where the card describes no plane.
bool plane_of(Builder& builder, const Block& block, const Row& row1, const Row& row2, CuttingPlane& plane) {
  plane.origin = position(block, row1, "xct", "yct", "zct");
  const Vec3d normal = position(block, row1, "xch", "ych", "zch") - plane.origin;
  if (norm(normal) == 0.0) {
    refuse(builder, row1, "xch", "the plane has no normal", "tail and head must differ");
    return false;
  }
  plane.normal = unit(normal);
  plane.radius = row1.real("radius");
  plane.length_l = row2.real("lenl");
  plane.length_m = row2.real("lenm");
  if (plane.length_l == 0.0 && plane.length_m == 0.0) return true;
  const Vec3d edge = position(block, row2, "xhev", "yhev", "zhev") - plane.origin;
  const Vec3d in_plane = edge - dot(edge, plane.normal) * plane.normal;
  if (!(norm(in_plane) > 1e-6 * norm(edge))) {
    refuse(builder, row2, "xhev", "a bounded plane needs the direction of its edge L, which lies in it",
           "give a point in the plane other than its tail");
    return false;
  }
  plane.edge_l = unit(in_plane);
  plane.edge_m = cross(plane.normal, plane.edge_l);
  return true;
}

void resolve_plane(Builder& builder, const Row& row1, const Row& row2, const CuttingPlane& plane,
                   CrossSection section) {
  const Model& model = builder.model;
  section.id = section_id(builder, section.id);
  std::vector<char> parts(model.parts.size(), row1.integer("psid") == 0);
  if (row1.integer("psid") != 0) {
    const auto* set = builder.part_set(row1, "psid");
    if (!set) return;
    for (const Index p : set->members) parts[at(p)] = 1;
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (model.parts[p].rigid_body != none) parts[p] = 0;
  cut(model, plane, parts, section);
  resolve_axes(builder, row2, section);
  add_section(builder, row1, "xct", std::move(section));
}

void read_plane(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const CrossSection section = headed(cursor, options);
    const Row row1 = cursor.read(plane_card1), row2 = cursor.read(card_for(plane_cards2, cursor.peek_number(6)));
    CuttingPlane plane;
    if (!plane_of(builder, block, row1, row2, plane)) continue;
    builder.defer(Phase::conditions,
                  [row1, row2, plane, section](Builder& b) { resolve_plane(b, row1, row2, plane, section); });
  }
}

// ---- groups of nodes -----------------------------------------------------------------------------------------------

void read_group(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const Row row = cursor.read(group_card);
    builder.defer(Phase::conditions, [row](Builder& b) {
      const auto* nodes = b.node_set(row, "nsid");
      if (!nodes) return;
      b.model.requests.nodal_force_groups.push_back(
          {row.integer("nsid"), nodes->members, b.turning_or_fixed_system(row, "cid")});
    });
  }
}

}  // namespace

std::vector<Keyword> cross_section_keywords() {
  return {
      {"DATABASE_CROSS_SECTION_SET",
       {},
       {"ID"},
       KeywordStatus::used,
       {},
       {{"with _ID", &heading_card}, {{}, &set_cards[0]}},
       read_set},
      {"DATABASE_CROSS_SECTION_PLANE",
       {},
       {"ID"},
       KeywordStatus::used,
       {},
       {{"with _ID", &heading_card}, {{}, &plane_card1}, {{}, &plane_cards2[0]}},
       read_plane},
      {"DATABASE_NODAL_FORCE_GROUP", {}, {}, KeywordStatus::used, {}, {{{}, &group_card}}, read_group},
  };
}

}  // namespace nugget::reading
