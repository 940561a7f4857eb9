// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/axes.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *DEFINE_COORDINATE_..., *DEFINE_VECTOR, *DEFINE_BOX. All are turned and moved with the include they stand in.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using deck::RowOf;

struct PointsCard {
  int cid = 0;
  double xo = 0, yo = 0, zo = 0, xl = 0, yl = 0, zl = 0;
  int cidl = 0;
};
const CardOf<PointsCard> points_card{
    {&PointsCard::cid, id("cid", IdSpace::define, required, "id of the system")},
    {&PointsCard::xo, real("xo", dimension::length, 0, any_value, "origin x")},
    {&PointsCard::yo, real("yo", dimension::length, 0, any_value, "origin y")},
    {&PointsCard::zo, real("zo", dimension::length, 0, any_value, "origin z")},
    {&PointsCard::xl, real("xl", dimension::length, 0, any_value, "point on the local x axis, x")},
    {&PointsCard::yl, real("yl", dimension::length, 0, any_value, "y")},
    {&PointsCard::zl, real("zl", dimension::length, 0, any_value, "z")},
    {&PointsCard::cidl, id("cidl", IdSpace::define, 0, "system of these coordinates: only the global one")},
};

struct PlanePointCard {
  double xp = 0, yp = 0, zp = 0;
  int type = 0;
};
const CardOf<PlanePointCard> plane_point_card{
    {&PlanePointCard::xp, real("xp", dimension::length, 0, any_value, "point in the local xy plane, x")},
    {&PlanePointCard::yp, real("yp", dimension::length, 0, any_value, "y")},
    {&PlanePointCard::zp, real("zp", dimension::length, 0, any_value, "z")},
    {&PlanePointCard::type,
     integer("type", 0, between(0, 2),
             "0 Cartesian; 1 cylindrical, 2 spherical: refused for motions and nodal loads, no effect elsewhere")},
};

struct VectorsCard {
  int cid = 0;
  double xx = 0, yx = 0, zx = 0, xv = 0, yv = 0, zv = 0;
  int nid = 0;
};
const CardOf<VectorsCard> frame_vectors_card{
    {&VectorsCard::cid, id("cid", IdSpace::define, required, "id of the system")},
    {&VectorsCard::xx, real("xx", dimension::number, 0, any_value, "local x axis, x")},
    {&VectorsCard::yx, real("yx", dimension::number, 0, any_value, "y")},
    {&VectorsCard::zx, real("zx", dimension::number, 0, any_value, "z")},
    {&VectorsCard::xv, real("xv", dimension::number, 0, any_value, "vector in the local xy plane, x")},
    {&VectorsCard::yv, real("yv", dimension::number, 0, any_value, "y")},
    {&VectorsCard::zv, real("zv", dimension::number, 0, any_value, "z")},
    {&VectorsCard::nid, id("nid", IdSpace::node, 0, "node that the system turns with: not supported")},
};

struct NodesCard {
  int cid = 0, n1 = 0, n2 = 0, n3 = 0, flag = 0;
  std::string dir;
  int type = 0;
};
const CardOf<NodesCard> nodes_card{
    {&NodesCard::cid, id("cid", IdSpace::define, required, "id of the system")},
    {&NodesCard::n1, id("n1", IdSpace::node, required, "node at the origin")},
    {&NodesCard::n2, id("n2", IdSpace::node, required, "node on the axis DIR")},
    {&NodesCard::n3, id("n3", IdSpace::node, required, "node in the plane of DIR and the next axis")},
    {&NodesCard::flag,
     integer("flag", 0, between(0, 1), "1: the axes turn with the nodes; 0: fixed as they stand at time 0")},
    {&NodesCard::dir, text("dir", 10, "axis through n2: X (default), Y or Z")},
    {&NodesCard::type,
     integer("type", 0, between(0, 2),
             "0 Cartesian; 1 cylindrical, 2 spherical: refused for motions and nodal loads, no effect elsewhere")},
};

struct VectorCard {
  int vid = 0;
  double xt = 0, yt = 0, zt = 0, xh = 0, yh = 0, zh = 0;
  int cid = 0;
};
const CardOf<VectorCard> vector_card{
    {&VectorCard::vid, id("vid", IdSpace::define, required, "id of the vector")},
    {&VectorCard::xt, real("xt", dimension::length, 0, any_value, "tail x")},
    {&VectorCard::yt, real("yt", dimension::length, 0, any_value, "tail y")},
    {&VectorCard::zt, real("zt", dimension::length, 0, any_value, "tail z")},
    {&VectorCard::xh, real("xh", dimension::length, 0, any_value, "head x")},
    {&VectorCard::yh, real("yh", dimension::length, 0, any_value, "head y")},
    {&VectorCard::zh, real("zh", dimension::length, 0, any_value, "head z")},
    {&VectorCard::cid, id("cid", IdSpace::define, 0, "coordinate system of tail and head; 0: global")},
};

struct BoxCard {
  int boxid = 0;
  double xmn = 0, xmx = 0, ymn = 0, ymx = 0, zmn = 0, zmx = 0;
};
const CardOf<BoxCard> box_card{
    {&BoxCard::boxid, id("boxid", IdSpace::define, required, "id of the box")},
    {&BoxCard::xmn, real("xmn", dimension::length, 0, any_value, "smallest x")},
    {&BoxCard::xmx, real("xmx", dimension::length, 0, any_value, "largest x")},
    {&BoxCard::ymn, real("ymn", dimension::length, 0, any_value, "smallest y")},
    {&BoxCard::ymx, real("ymx", dimension::length, 0, any_value, "largest y")},
    {&BoxCard::zmn, real("zmn", dimension::length, 0, any_value, "smallest z")},
    {&BoxCard::zmx, real("zmx", dimension::length, 0, any_value, "largest z")},
};

void add_system(Builder& b, const Row& row, const CoordinateSystem& system) {
  b.systems.add(system.id, static_cast<Index>(b.model.systems.size()), row.place(), row.keyword(), "coordinate system",
                b.findings);
  b.model.systems.push_back(system);
}

void add_system(Builder& b, const Row& row, int id, const Vec3d& origin, const Vec3d& x, const Vec3d& in_plane,
                const deck::Entry& field, int type = 0) {
  CoordinateSystem s{id, origin, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (type != 0) b.curved_systems[s.id] = type;
  if (!frame_from(x, in_plane, s.axes))
    refuse(b, field, "the axis and the vector in the plane must differ in direction and from zero",
           "choose three points that do not lie on a line");
  add_system(b, row, s);
}

/// The axes of a mirrored file: x and y are mirror images, and z = x x y is not.
void note_mirrored(Builder& b, const Block& block, const deck::Entry& id) {
  if (!is_mirrored(block)) return;
  b.mirrored_systems.insert(id.integer());
  id.report(b.findings, Severity::note,
            "of a file that is mirrored: local x and y are mirrored with it, and z, normal to them, then points to "
            "the other side than its image");
}

void read_frame_points(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(points_card);
    const auto plane = cursor.read(plane_point_card);
    note_mirrored(b, block, row[&PointsCard::cid]);
    refuse_nonzero(b, row[&PointsCard::cidl], "points in another coordinate system are not supported",
                   "give them in global axes");
    const Vec3d origin = position(block, {row->xo, row->yo, row->zo});
    add_system(b, row, row->cid, origin, position(block, {row->xl, row->yl, row->zl}) - origin,
               position(block, {plane->xp, plane->yp, plane->zp}) - origin, row[&PointsCard::xl], plane->type);
  }
}

void read_vectors(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(frame_vectors_card);
    note_mirrored(b, block, row[&VectorsCard::cid]);
    refuse_nonzero(b, row[&VectorsCard::nid], "axes that turn with a node are not supported",
                   "leave it 0 for fixed axes");
    b.systems_without_origin.insert(row->cid);
    add_system(b, row, row->cid, {}, direction(block, {row->xx, row->yx, row->zx}),
               direction(block, {row->xv, row->yv, row->zv}), row[&VectorsCard::xx]);
  }
}

/// The axes of *DEFINE_COORDINATE_NODES: N2 lies on the axis DIR, N3 in its plane with the next axis (x y z x).
void add_system_of_nodes(Builder& b, const RowOf<NodesCard>& row) {
  CoordinateSystem::Nodes nodes{b.node(row[&NodesCard::n1]), b.node(row[&NodesCard::n2]), b.node(row[&NodesCard::n3])};
  if (nodes.origin == none || nodes.on_axis == none || nodes.in_plane == none) return;
  const std::string& dir = row->dir;
  if (dir == "Y" || dir == "y")
    nodes.axis = 1;
  else if (dir == "Z" || dir == "z")
    nodes.axis = 2;
  else if (!dir.empty() && dir != "X" && dir != "x")
    refuse(b, row[&NodesCard::dir], "expected X, Y or Z");
  const auto at = [&](Index n) { return b.model.nodes.x[n]; };
  CoordinateSystem s{row->cid, at(nodes.origin), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (!frame_of_points(s.origin, at(nodes.on_axis), at(nodes.in_plane), nodes.axis, s.axes))
    refuse(b, row[&NodesCard::n1], "the three nodes lie on a line, so they define no axes", "choose three that do not");
  s.nodes = nodes;
  s.turning = row->flag == 1;
  if (const int type = row->type; type != 0) b.curved_systems[s.id] = type;
  add_system(b, row, s);
}

void read_nodes(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(nodes_card);
    note_mirrored(b, block, row[&NodesCard::cid]);
    b.defer(Phase::systems, [row](Builder& later) { add_system_of_nodes(later, row); });
  }
}

void read_vector(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(vector_card);
    const auto index = b.vector_list.size();
    b.vectors.add(row->vid, static_cast<Index>(index), row.place(), block.starred(), "vector", b.findings);
    const Vec3d tail = Vec3d{row->xt, row->yt, row->zt}, v = Vec3d{row->xh, row->yh, row->zh} - tail;
    const bool is_local = row->cid != 0, moved = block.transform && !is_local;
    b.vector_list.push_back(moved ? block.transform->direction(v) : v);
    b.vector_tails.push_back(moved ? block.transform->moved(tail) : tail);
    if (!(norm(v) > 0.0)) refuse(b, row[&VectorCard::xh], "head and tail of a vector must differ");
    if (is_local)
      b.defer(Phase::sets, [row, index](Builder& later) {
        const Index s = later.system(row[&VectorCard::cid]);
        if (s == none) return;
        const CoordinateSystem& own = later.model.systems[s];
        later.vector_list[index] = own.axes.global(later.vector_list[index]);
        later.vector_tails[index] = own.origin + own.axes.global(later.vector_tails[index]);
      });
  }
}

void read_box(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(box_card);
    const auto* t = block.transform;
    if (t && (!t->keeps_axes() || t->scales()))
      refuse(b, row[&BoxCard::boxid], "a box cannot be turned or scaled with its include",
             "define it in the main deck");
    const std::pair<double BoxCard::*, double BoxCard::*> extents[] = {
        {&BoxCard::xmn, &BoxCard::xmx}, {&BoxCard::ymn, &BoxCard::ymx}, {&BoxCard::zmn, &BoxCard::zmx}};
    for (const auto& [low, high] : extents)
      if ((*row).*low > (*row).*high) refuse(b, row[low], "the smallest value is larger than the largest", "swap them");
    b.boxes.add(row->boxid, static_cast<Index>(b.box_list.size()), row.place(), block.starred(), "box", b.findings);
    // Mirrored, the largest value of an axis is the smallest.
    const Vec3d one = position(block, {row->xmn, row->ymn, row->zmn}),
                other = position(block, {row->xmx, row->ymx, row->zmx});
    b.box_list.push_back({{std::min(one.x, other.x), std::min(one.y, other.y), std::min(one.z, other.z)},
                          {std::max(one.x, other.x), std::max(one.y, other.y), std::max(one.z, other.z)}});
  }
}

}  // namespace

std::vector<Keyword> frame_keywords() {
  return {
      {.name = "DEFINE_COORDINATE_SYSTEM",
       .options = {"TITLE"},
       .layout = {{"", &points_card}, {"", &plane_point_card}},
       .read = read_frame_points},
      {.name = "DEFINE_COORDINATE_VECTOR",
       .options = {"TITLE"},
       .layout = {{"", &frame_vectors_card}},
       .read = read_vectors},
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
