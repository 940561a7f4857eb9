// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// Cards that move nodes of the mesh before anything is computed.
namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;

struct TransformCard {
  int trsid = 0, nsid = 0;
};
const CardOf<TransformCard> transform_card{
    {&TransformCard::trsid, id("trsid", IdSpace::define, required, "*DEFINE_TRANSFORMATION")},
    {&TransformCard::nsid, id("nsid", IdSpace::set, required, "node set to be moved")},
    integer("immed", 0, between(0, 1), "1: before other cards are looked at; the order makes no difference here"),
};
struct PartMoveCard {
  int pid = 0;
  double xmov = 0, ymov = 0, zmov = 0;
  int cid = 0, ifset = 0;
};
const CardOf<PartMoveCard> part_move_card{
    {&PartMoveCard::pid,
     wide(id("pid", IdSpace::part, required, "part, or part set (ifset 1): the nodes of its elements move"), 8)},
    {&PartMoveCard::xmov, wide(real("xmov", dimension::length, 0, any_value, "by this along x"), 16)},
    {&PartMoveCard::ymov, wide(real("ymov", dimension::length, 0, any_value, "along y"), 16)},
    {&PartMoveCard::zmov, wide(real("zmov", dimension::length, 0, any_value, "along z"), 16)},
    {&PartMoveCard::cid,
     wide(id("cid", IdSpace::define, 0, "coordinate system of these directions; 0: global axes"), 8)},
    {&PartMoveCard::ifset, wide(integer("ifset", 0, between(0, 1), "1: pid is a part set"), 8)},
};

/// Moves nodes to where `moved` says. Axes through nodes are known already by then.
template <class Moved>
void move_nodes(Builder& b, const deck::Entry& field, const std::vector<Index>& nodes, const Moved& moved) {
  for (const Index n : nodes) {
    Vec3d& x = b.model.nodes.x[n];
    x = moved(x);
  }
  for (const CoordinateSystem& system : b.model.systems) {
    if (!system.nodes) continue;
    for (const Index n : {system.nodes->origin, system.nodes->on_axis, system.nodes->in_plane})
      if (std::find(nodes.begin(), nodes.end(), n) != nodes.end()) {
        refuse(b, field,
               fmt::format("moves node {}, which gives coordinate system {} its axes: not supported",
                           b.model.nodes.id[n], system.id),
               "write the node where it shall be, or give the system by *DEFINE_COORDINATE_SYSTEM");
        return;
      }
  }
}

bool mirrors(const deck::Transform& transform) {
  const Vec3d origin = transform.moved({});
  const auto image = [&](const Vec3d& e) { return transform.moved(e) - origin; };
  return dot(cross(image({1, 0, 0}), image({0, 1, 0})), image({0, 0, 1})) < 0.0;
}

void read_node_transform(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(transform_card);
    builder.defer(Phase::sets, [row](Builder& b) {
      const auto* nodes = b.node_set(row[&TransformCard::nsid]);
      const deck::Transform* transform = b.deck.transformation(row->trsid);
      if (transform == nullptr)
        refuse(b, row[&TransformCard::trsid], "no *DEFINE_TRANSFORMATION has this id", "define it");
      else if (nodes != nullptr) {
        if (mirrors(*transform))
          row[&TransformCard::trsid].report(
              b.findings, Severity::warning,
              "mirrors the nodes; elements keep their numbering: shells have their normals on the other side, "
              "and bricks are inside out",
              "renumber the elements of mirrored parts in the pre-processor");
        move_nodes(b, row[&TransformCard::nsid], nodes->members, [&](const Vec3d& x) { return transform->moved(x); });
      }
    });
  }
}

void read_part_move(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(part_move_card);
    const bool local = row->cid != 0;
    const Vec3d by =
        local ? Vec3d{row->xmov, row->ymov, row->zmov} : direction(block, {row->xmov, row->ymov, row->zmov});
    builder.defer(Phase::sets, [row, by](Builder& b) {
      std::vector<Index> parts;
      if (row->ifset == 1) {
        if (const auto* set = b.part_set(row[&PartMoveCard::pid])) parts = set->members;
      } else if (const Index part = b.part(row[&PartMoveCard::pid]); part != none) {
        parts = {part};
      }
      Vec3d shift = by;
      if (const Index system = b.system(row[&PartMoveCard::cid]); system != none)
        shift = b.model.systems[system].axes.global(by);
      move_nodes(b, row[&PartMoveCard::pid], nodes_of_parts(b.model, parts), [&](const Vec3d& x) { return x + shift; });
    });
  }
}

}  // namespace

std::vector<Keyword> move_keywords() {
  return {
      {.name = "NODE_TRANSFORM", .layout = {{"", &transform_card}}, .read = read_node_transform},
      {.name = "PART_MOVE", .layout = {{"", &part_move_card}}, .read = read_part_move},
  };
}

}  // namespace nugget::reading
