// SPDX-License-Identifier: Apache-2.0
// *DATABASE_CROSS_SECTION_... (secforc) and *DATABASE_NODAL_FORCE_GROUP (nodfor).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

/// ID and ITYPE. The id belongs to the name space that ITYPE says.
IntegerField axes_id(IdSpace space) {
  return id("id", space, 0,
            "rigid body, accelerometer or coordinate system in whose axes the result is written; 0: global axes");
}
const IntegerField axes_kind =
    integer("itype", 0, between(0, 2), "what id is: 0 a rigid body, 1 an accelerometer, 2 a coordinate system");

/// One card for each ITYPE.
template <class Values>
std::array<CardOf<Values>, 3> for_each_kind(CardOf<Values> (*card)(IdSpace)) {
  return {card(IdSpace::part), card(IdSpace::element), card(IdSpace::define)};
}
template <class Values>
const CardOf<Values>& card_for(const std::array<CardOf<Values>, 3>& cards, double kind) {
  return cards[kind == 1.0 ? 1 : kind == 2.0 ? 2 : 0];
}

struct AxesCard {
  int id = 0, itype = 0;
};
struct SetCard : AxesCard {
  int nsid = 0, hsid = 0, bsid = 0, ssid = 0, tsid = 0, dsid = 0;
};
CardOf<SetCard> set_card_of(IdSpace axes) {
  return {
      {&SetCard::nsid, id("nsid", IdSpace::set, required, "node set: the nodes of the section")},
      {&SetCard::hsid, id("hsid", IdSpace::set, 0, "solid set: bricks on one side of these nodes")},
      {&SetCard::bsid, id("bsid", IdSpace::set, 0, "beam set")},
      {&SetCard::ssid, id("ssid", IdSpace::set, 0, "shell set")},
      {&SetCard::tsid, id("tsid", IdSpace::set, 0, "set of thick shells")},
      {&SetCard::dsid, id("dsid", IdSpace::set, 0, "set of discrete elements")},
      {&SetCard::id, axes_id(axes)},
      {&SetCard::itype, axes_kind},
  };
}
const std::array<CardOf<SetCard>, 3> set_cards = for_each_kind(set_card_of);

struct PlaneCard1 {
  int psid = 0;
  double xct = 0, yct = 0, zct = 0, xch = 0, ych = 0, zch = 0, radius = 0;
};
const CardOf<PlaneCard1> plane_card1{
    {&PlaneCard1::psid, id("psid", IdSpace::set, 0, "part set whose elements are cut; 0: all parts")},
    {&PlaneCard1::xct, real("xct", dimension::length, 0, any_value, "point on the plane, x")},
    {&PlaneCard1::yct, real("yct", dimension::length, 0, any_value, "y")},
    {&PlaneCard1::zct, real("zct", dimension::length, 0, any_value, "z")},
    {&PlaneCard1::xch, real("xch", dimension::length, 0, any_value, "head of the plane's normal, x")},
    {&PlaneCard1::ych, real("ych", dimension::length, 0, any_value, "y")},
    {&PlaneCard1::zch, real("zch", dimension::length, 0, any_value, "z")},
    {&PlaneCard1::radius,
     real("radius", dimension::length, 0, at_least(0), "radius of a circle about the point; 0: no circle")},
};
struct EdgeCard : AxesCard {
  double xhev = 0, yhev = 0, zhev = 0, lenl = 0, lenm = 0;
};
CardOf<EdgeCard> plane_card2_of(IdSpace axes) {
  return {
      {&EdgeCard::xhev,
       real("xhev", dimension::length, 0, any_value, "head of the edge L, whose tail is the point, x")},
      {&EdgeCard::yhev, real("yhev", dimension::length, 0, any_value, "y")},
      {&EdgeCard::zhev, real("zhev", dimension::length, 0, any_value, "z")},
      {&EdgeCard::lenl, real("lenl", dimension::length, 0, at_least(0), "length along the edge L; 0: infinite")},
      {&EdgeCard::lenm,
       real("lenm", dimension::length, 0, at_least(0), "length along the edge M = normal x L; 0: infinite")},
      {&EdgeCard::id, axes_id(axes)},
      {&EdgeCard::itype, axes_kind},
  };
}
const std::array<CardOf<EdgeCard>, 3> plane_cards2 = for_each_kind(plane_card2_of);

struct GroupCard {
  int nsid = 0, cid = 0;
};
const CardOf<GroupCard> group_card{
    {&GroupCard::nsid, id("nsid", IdSpace::set, required, "node set")},
    {&GroupCard::cid, id("cid", IdSpace::define, 0, "coordinate system in which the sum is written as well")},
};

// ---- axes

void resolve_axes(Builder& builder, const deck::Entry& id, int kind, CrossSection& section) {
  if (id.integer() == 0) return;
  switch (kind) {
    case 0:
      section.rigid_body = find_body(builder, id);
      if (section.rigid_body == none) return;
      if (const Frame3d* axes = body_axes(builder, id.integer()))
        section.axes = *axes;
      else
        refuse(builder, id, "local axes of this body are not known: its principal axes are not used",
               "name a coordinate system in LCO of *MAT_RIGID, or use itype 2");
      return;
    case 1: {
      const auto& all = builder.model.accelerometers;
      const auto found =
          std::find_if(all.begin(), all.end(), [&](const Accelerometer& a) { return a.id == id.integer(); });
      if (found == all.end())
        return refuse(builder, id, fmt::format("accelerometer {} is not defined", id.integer()),
                      "name an *ELEMENT_SEATBELT_ACCELEROMETER");
      section.accelerometer = static_cast<Index>(found - all.begin());
      return;
    }
    default: section.system = builder.turning_or_fixed_system(id);
  }
}

int section_id(const Builder& builder, int given) {
  return given > 0 ? given : static_cast<int>(builder.model.requests.cross_sections.size()) + 1;
}

void add_cross_section(Builder& builder, const deck::Entry& field, CrossSection section) {
  // It stays: sections without an id are numbered by their place in the deck. What a plane cuts is known once welds
  // stand on their sheets (weld::cut_sections).
  if (section.facets.empty() && !section.plane)
    field.report(builder.findings, Severity::warning,
                 fmt::format("cross section {} has no elements: its forces are 0", section.id), "check the sets");
  builder.model.requests.cross_sections.push_back(std::move(section));
}

// ---- by sets

/// Without the elements of rigid parts, which have no internal forces.
std::vector<Index> deformable(const Model& model, const std::vector<Index>& elements,
                              const std::vector<Index>& part_of) {
  std::vector<Index> kept;
  for (const Index e : elements)
    if (model.parts[part_of[e]].rigid_body == none) kept.push_back(e);
  return kept;
}

void resolve_set(Builder& builder, const RowOf<SetCard>& row, CrossSection section) {
  const Model& model = builder.model;
  const auto* nodes = builder.node_set(row[&SetCard::nsid]);
  if (!nodes) return;
  section.id = section_id(builder, section.id);
  section.nodes = nodes->members;
  make_unique(section.nodes);
  std::vector<char> marked(model.nodes.size(), 0);
  for (const Index n : section.nodes) marked[n] = 1;
  const auto take = [&](ElementKind kind, const Set<Index>* set, const std::vector<Index>& part_of) {
    if (!set) return;
    for (auto& facet : facets_between(model, kind, deformable(model, set->members, part_of), marked))
      section.facets.push_back(std::move(facet));
  };
  take(ElementKind::shell, builder.shell_set(row[&SetCard::ssid]), model.shells.part);
  take(ElementKind::solid, builder.solid_set(row[&SetCard::hsid]), model.solids.part);
  take(ElementKind::beam, builder.beam_set(row[&SetCard::bsid]), model.beams.part);
  resolve_axes(builder, row[&AxesCard::id], row->itype, section);
  add_cross_section(builder, row[&SetCard::nsid], std::move(section));
}

CrossSection headed_section(Cursor& cursor, const Options& options) {
  CrossSection section;
  const Heading heading = read_heading(cursor, options.contains("ID"));
  section.id = heading.id;
  section.title = heading.text;
  section.place = cursor.place();
  return section;
}

void read_section_set(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const CrossSection section = headed_section(cursor, options);
    const auto row = cursor.read(card_for(set_cards, cursor.peek_number(7)));
    refuse_nonzero(builder, row[&SetCard::tsid], "thick shells are not built", "leave it 0");
    refuse_nonzero(builder, row[&SetCard::dsid], "discrete elements carry no section force",
                   "leave it 0; deforc holds theirs");
    builder.defer(Phase::conditions, [row, section](Builder& b) { resolve_set(b, row, section); });
  }
}

// ---- by a plane

/// False (and a finding) where the card describes no plane.
bool plane_of(Builder& builder, const Block& block, const RowOf<PlaneCard1>& row1, const RowOf<EdgeCard>& row2,
              CuttingPlane& plane) {
  plane.origin = position(block, {row1->xct, row1->yct, row1->zct});
  const Vec3d normal = position(block, {row1->xch, row1->ych, row1->zch}) - plane.origin;
  if (norm(normal) == 0.0) {
    refuse(builder, row1[&PlaneCard1::xch], "the plane has no normal", "tail and head must differ");
    return false;
  }
  plane.normal = unit(normal);
  plane.radius = row1->radius;
  plane.length_l = row2->lenl;
  plane.length_m = row2->lenm;
  if (plane.length_l == 0.0 && plane.length_m == 0.0) return true;
  const Vec3d edge = position(block, {row2->xhev, row2->yhev, row2->zhev}) - plane.origin;
  const Vec3d in_plane = edge - dot(edge, plane.normal) * plane.normal;
  if (!(norm(in_plane) > 1e-6 * norm(edge))) {
    refuse(builder, row2[&EdgeCard::xhev], "a bounded plane needs the direction of its edge L, which lies in it",
           "give a point in the plane other than its tail");
    return false;
  }
  plane.edge_l = unit(in_plane);
  plane.edge_m = hand(block) * cross(plane.normal, plane.edge_l);
  return true;
}

void resolve_plane(Builder& builder, const RowOf<PlaneCard1>& row1, const RowOf<EdgeCard>& row2,
                   const CuttingPlane& plane, CrossSection section) {
  const Model& model = builder.model;
  section.id = section_id(builder, section.id);
  std::vector<char> parts(model.parts.size(), row1->psid == 0);
  if (row1->psid != 0) {
    const auto* set = builder.part_set(row1[&PlaneCard1::psid]);
    if (!set) return;
    for (const Index p : set->members) parts[p] = 1;
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (parts[p] != 0 && model.parts[p].rigid_body == none) section.parts.push_back(static_cast<Index>(p));
  section.plane = plane;
  cut(model, model.nodes.x, section);
  resolve_axes(builder, row2[&AxesCard::id], row2->itype, section);
  add_cross_section(builder, row1[&PlaneCard1::xct], std::move(section));
}

void read_plane(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const CrossSection section = headed_section(cursor, options);
    const auto row1 = cursor.read(plane_card1);
    const auto row2 = cursor.read(card_for(plane_cards2, cursor.peek_number(6)));
    CuttingPlane plane;
    if (!plane_of(builder, block, row1, row2, plane)) continue;
    builder.defer(Phase::conditions,
                  [row1, row2, plane, section](Builder& b) { resolve_plane(b, row1, row2, plane, section); });
  }
}

// ---- groups of nodes

void read_group(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(group_card);
    builder.defer(Phase::conditions, [row](Builder& b) {
      const auto* nodes = b.node_set(row[&GroupCard::nsid]);
      if (!nodes) return;
      b.model.requests.nodal_force_groups.push_back(
          {row->nsid, nodes->members, b.turning_or_fixed_system(row[&GroupCard::cid])});
    });
  }
}

}  // namespace

std::vector<Keyword> cross_section_keywords() {
  return {
      {.name = "DATABASE_CROSS_SECTION_SET",
       .options = {"ID"},
       .layout = {{"with _ID", &heading_card}, {{}, &set_cards[0]}},
       .read = read_section_set},
      {.name = "DATABASE_CROSS_SECTION_PLANE",
       .options = {"ID"},
       .layout = {{"with _ID", &heading_card}, {{}, &plane_card1}, {{}, &plane_cards2[0]}},
       .read = read_plane},
      {.name = "DATABASE_NODAL_FORCE_GROUP", .layout = {{{}, &group_card}}, .read = read_group},
  };
}

}  // namespace nugget::reading
