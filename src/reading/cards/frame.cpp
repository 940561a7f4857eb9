// SPDX-License-Identifier: Apache-2.0
#include "model/axes.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *DEFINE_COORDINATE_..., *DEFINE_VECTOR, *DEFINE_BOX. All are turned and moved with the include they stand in.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card points_card{{
    id("cid", IdSpace::define, required, "id of the system"),
    real("xo", dimension::length, 0, any_value, "origin x"),
    real("yo", dimension::length, 0, any_value, "origin y"),
    real("zo", dimension::length, 0, any_value, "origin z"),
    real("xl", dimension::length, 0, any_value, "point on the local x axis, x"),
    real("yl", dimension::length, 0, any_value, "y"),
    real("zl", dimension::length, 0, any_value, "z"),
    id("cidl", IdSpace::define, 0, "system of these coordinates: only the global one"),
}};

const Card plane_point_card{{
    real("xp", dimension::length, 0, any_value, "point in the local xy plane, x"),
    real("yp", dimension::length, 0, any_value, "y"),
    real("zp", dimension::length, 0, any_value, "z"),
    integer("type", 0, between(0, 2),
            "0 Cartesian; 1 cylindrical, 2 spherical: refused for motions and nodal loads, no effect elsewhere"),
}};

const Card vectors_card{{
    id("cid", IdSpace::define, required, "id of the system"),
    real("xx", dimension::number, 0, any_value, "local x axis, x"),
    real("yx", dimension::number, 0, any_value, "y"),
    real("zx", dimension::number, 0, any_value, "z"),
    real("xv", dimension::number, 0, any_value, "vector in the local xy plane, x"),
    real("yv", dimension::number, 0, any_value, "y"),
    real("zv", dimension::number, 0, any_value, "z"),
    id("nid", IdSpace::node, 0, "node that the system turns with: not supported"),
}};

const Card nodes_card{{
    id("cid", IdSpace::define, required, "id of the system"),
    id("n1", IdSpace::node, required, "node at the origin"),
    id("n2", IdSpace::node, required, "node on the axis DIR"),
    id("n3", IdSpace::node, required, "node in the plane of DIR and the next axis"),
    integer("flag", 0, between(0, 1), "1: the axes turn with the nodes; 0: fixed as they stand at time 0"),
    text("dir", 10, "axis through n2: X (default), Y or Z"),
    integer("type", 0, between(0, 2),
            "0 Cartesian; 1 cylindrical, 2 spherical: refused for motions and nodal loads, no effect elsewhere"),
}};

const Card vector_card{{
    id("vid", IdSpace::define, required, "id of the vector"),
    real("xt", dimension::length, 0, any_value, "tail x"),
    real("yt", dimension::length, 0, any_value, "tail y"),
    real("zt", dimension::length, 0, any_value, "tail z"),
    real("xh", dimension::length, 0, any_value, "head x"),
    real("yh", dimension::length, 0, any_value, "head y"),
    real("zh", dimension::length, 0, any_value, "head z"),
    id("cid", IdSpace::define, 0, "coordinate system of tail and head; 0: global"),
}};

const Card box_card{{
    id("boxid", IdSpace::define, required, "id of the box"),
    real("xmn", dimension::length, 0, any_value, "smallest x"),
    real("xmx", dimension::length, 0, any_value, "largest x"),
    real("ymn", dimension::length, 0, any_value, "smallest y"),
    real("ymx", dimension::length, 0, any_value, "largest y"),
    real("zmn", dimension::length, 0, any_value, "smallest z"),
    real("zmx", dimension::length, 0, any_value, "largest z"),
}};

void add_system(Builder& b, const Row& row, const CoordinateSystem& system) {
  b.systems.add(system.id, static_cast<Index>(b.model.systems.size()), row.place(), row.keyword(), "coordinate system",
                b.findings);
  b.model.systems.push_back(system);
}

void add_system(Builder& b, const Row& row, const Vec3d& origin, const Vec3d& x, const Vec3d& in_plane,
                std::string_view field, int type = 0) {
  CoordinateSystem s{row.integer("cid"), origin, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (type != 0) b.curved_systems[s.id] = type;
  if (!frame_from(x, in_plane, s.axes))
    refuse(b, row, field, "the axis and the vector in the plane must differ in direction and from zero",
           "choose three points that do not lie on a line");
  add_system(b, row, s);
}

void read_points(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(points_card);
    const Row plane = cursor.read(plane_point_card);
    refuse_nonzero(b, row, "cidl", "points in another coordinate system are not supported", "give them in global axes");
    const Vec3d origin = position(block, row, "xo", "yo", "zo");
    add_system(b, row, origin, position(block, row, "xl", "yl", "zl") - origin,
               position(block, plane, "xp", "yp", "zp") - origin, "xl", plane.integer("type"));
  }
}

void read_vectors(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(vectors_card);
    refuse_nonzero(b, row, "nid", "axes that turn with a node are not supported", "leave it 0 for fixed axes");
    add_system(b, row, {}, direction(block, row, "xx", "yx", "zx"), direction(block, row, "xv", "yv", "zv"), "xx");
  }
}

/// The axes of *DEFINE_COORDINATE_NODES: N2 lies on the axis DIR, N3 in its plane with the next axis (x y z x).
void add_system_of_nodes(Builder& b, const Row& row) {
  CoordinateSystem::Nodes nodes{b.node(row, "n1"), b.node(row, "n2"), b.node(row, "n3")};
  if (nodes.origin == none || nodes.on_axis == none || nodes.in_plane == none) return;
  const std::string& dir = row.text("dir");
  if (dir == "Y" || dir == "y")
    nodes.axis = 1;
  else if (dir == "Z" || dir == "z")
    nodes.axis = 2;
  else if (!dir.empty() && dir != "X" && dir != "x")
    refuse(b, row, "dir", "expected X, Y or Z");
  const auto at = [&](Index n) { return b.model.nodes.x[static_cast<std::size_t>(n)]; };
  CoordinateSystem s{row.integer("cid"), at(nodes.origin), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (!frame_of_points(s.origin, at(nodes.on_axis), at(nodes.in_plane), nodes.axis, s.axes))
    refuse(b, row, "n1", "the three nodes lie on a line, so they do not tell the axes", "choose three that do not");
  s.nodes = nodes;
  s.turning = row.integer("flag") == 1;
  if (const int type = row.integer("type"); type != 0) b.curved_systems[s.id] = type;
  add_system(b, row, s);
}

void read_nodes(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(nodes_card);
    b.defer(Phase::systems, [row](Builder& later) { add_system_of_nodes(later, row); });
  }
}

void read_vector(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(vector_card);
    const auto index = b.vector_list.size();
    b.vectors.add(row.integer("vid"), static_cast<Index>(index), row.place(), block.starred(), "vector", b.findings);
    const Vec3d tail = triple(row, "xt", "yt", "zt"), v = triple(row, "xh", "yh", "zh") - tail;
    const bool is_local = row.integer("cid") != 0, moved = block.transform && !is_local;
    b.vector_list.push_back(moved ? block.transform->direction(v) : v);
    b.vector_tails.push_back(moved ? block.transform->moved(tail) : tail);
    if (!(norm(v) > 0.0)) refuse(b, row, "xh", "head and tail of a vector must differ");
    if (is_local)
      b.defer(Phase::sets, [row, index](Builder& later) {
        const Index s = later.system(row, "cid");
        if (s == none) return;
        const CoordinateSystem& own = later.model.systems[static_cast<std::size_t>(s)];
        later.vector_list[index] = own.axes.global(later.vector_list[index]);
        later.vector_tails[index] = own.origin + own.axes.global(later.vector_tails[index]);
      });
  }
}

void read_box(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(box_card);
    const auto* t = block.transform;
    if (t && (t->turns() || t->scales()))
      refuse(b, row, "boxid", "a box cannot be turned or scaled with its include", "define it in the main deck");
    for (const auto& [low, high] : {std::pair{"xmn", "xmx"}, {"ymn", "ymx"}, {"zmn", "zmx"}})
      if (row.real(low) > row.real(high))
        refuse(b, row, low, "the smallest value is larger than the largest", "swap them");
    b.boxes.add(row.integer("boxid"), static_cast<Index>(b.box_list.size()), row.place(), block.starred(), "box",
                b.findings);
    b.box_list.push_back({position(block, row, "xmn", "ymn", "zmn"), position(block, row, "xmx", "ymx", "zmx")});
  }
}

}  // namespace

std::vector<Keyword> frame_keywords() {
  return {
      {.name = "DEFINE_COORDINATE_SYSTEM",
       .options = {"TITLE"},
       .layout = {{"", &points_card}, {"", &plane_point_card}},
       .read = read_points},
      {.name = "DEFINE_COORDINATE_VECTOR", .options = {"TITLE"}, .layout = {{"", &vectors_card}}, .read = read_vectors},
      {.name = "DEFINE_COORDINATE_NODES",
       .aliases = {"DEFINE_COORDINATE_NODE"},
       .options = {"TITLE"},
       .layout = {{"", &nodes_card}},
       .read = read_nodes},
      {.name = "DEFINE_VECTOR", .options = {"TITLE"}, .layout = {{"", &vector_card}}, .read = read_vector},
      {.name = "DEFINE_BOX", .options = {"TITLE"}, .layout = {{"", &box_card}}, .read = read_box},
  };
}

}  // namespace nugget::reading
