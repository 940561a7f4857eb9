// SPDX-License-Identifier: Apache-2.0
// *RIGIDWALL_...: planes, cylinders and spheres that nodes cannot enter.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using Shape = RigidWall::Shape;

struct WallIdCard {
  int id = 0;
  std::string title;
};
const CardOf<WallIdCard> wall_id_card{
    {&WallIdCard::id,
     id("id", IdSpace::other, 0, "number of the wall in rwforc; 0: place in the deck, or the next free")},
    {&WallIdCard::title, text("title", 70, "its name")},
};

struct WallCard {
  int nsid = 0, nsidex = 0, boxid = 0;
  double offset = 0, birth = 0, death = 0;
};
const CardOf<WallCard> planar_card1{
    {&WallCard::nsid, id("nsid", IdSpace::set, 0, "nodes that the wall stops; 0: all")},
    {&WallCard::nsidex, id("nsidex", IdSpace::set, 0, "nodes left out")},
    {&WallCard::boxid, id("boxid", IdSpace::define, 0, "only nodes inside this box")},
    {&WallCard::offset, real("offset", dimension::length, 0, at_least(0),
                             "only nodes within this distance of the wall; 0: at any distance")},
    {&WallCard::birth, real("birth", dimension::time, 0, at_least(0), "the wall acts, and moves, from this time on")},
    {&WallCard::death, real("death", dimension::time, forever, at_least(0), "until this time")},
    real("rwksf", dimension::number, 1, any_value, "stiffness in implicit runs"),
};
struct NormalCard {
  double xt = 0, yt = 0, zt = 0, xh = 0, yh = 0, zh = 0, fric = 0, wvel = 0;
};
const CardOf<NormalCard> planar_card2{
    {&NormalCard::xt,
     real("xt", dimension::length, 0, any_value, "tail of the outward normal, a point on the wall: x")},
    {&NormalCard::yt, real("yt", dimension::length, 0, any_value, "y")},
    {&NormalCard::zt, real("zt", dimension::length, 0, any_value, "z")},
    {&NormalCard::xh, real("xh", dimension::length, 0, any_value, "head of the normal: x")},
    {&NormalCard::yh, real("yh", dimension::length, 0, any_value, "y")},
    {&NormalCard::zh, real("zh", dimension::length, 0, any_value, "z")},
    {&NormalCard::fric, real("fric", dimension::number, 0, between(0, 3),
                             "0 none, below 1 Coulomb, 1 no sliding, 2 and 3 fixed above wvel")},
    {&NormalCard::wvel,
     real("wvel", dimension::velocity, 0, at_least(0), "normal velocity above which a node stays fixed (fric 2, 3)")},
};
struct WallEdgeCard {
  double xhev = 0, yhev = 0, zhev = 0, lenl = 0, lenm = 0, lenp = 0;
};
const CardOf<WallEdgeCard> finite_card{
    {&WallEdgeCard::xhev, real("xhev", dimension::length, 0, any_value, "head of the first edge from the tail: x")},
    {&WallEdgeCard::yhev, real("yhev", dimension::length, 0, any_value, "y")},
    {&WallEdgeCard::zhev, real("zhev", dimension::length, 0, any_value, "z")},
    {&WallEdgeCard::lenl, real("lenl", dimension::length, 0, at_least(0), "length of that edge; 0 infinite")},
    {&WallEdgeCard::lenm, real("lenm", dimension::length, 0, at_least(0), "length of the other edge; 0 infinite")},
};
struct MovingCard {
  double mass = 0, v0 = 0;
};
const CardOf<MovingCard> moving_card{
    {&MovingCard::mass, real("mass", dimension::mass, required, above_zero(), "mass of the moving wall")},
    {&MovingCard::v0, real("v0", dimension::velocity, 0, any_value, "its initial velocity along the normal")},
};
struct ForcesCard {
  int soft = 0, ssid = 0;
};
const CardOf<ForcesCard> forces_card{
    {&ForcesCard::soft, integer("soft", 0, at_least(0), "cycles in which the relative velocity goes to zero")},
    {&ForcesCard::ssid, id("ssid", IdSpace::set, 0, "segment sets whose forces are listed apart")},
    id("n1", IdSpace::node, 0, "node of a picture of the wall"),
    id("n2", IdSpace::node, 0, "second"),
    id("n3", IdSpace::node, 0, "third"),
    id("n4", IdSpace::node, 0, "fourth"),
};
struct DisplayCard {
  int pid = 0;
};
const CardOf<DisplayCard> display_card{
    {&DisplayCard::pid, id("pid", IdSpace::part, 0, "part of a picture of the wall in d3plot")},
    real("ro", dimension::density, 0, any_value, "its density"),
    real("e", dimension::stress, 0, any_value, "its modulus"),
    real("pr", dimension::number, 0, any_value, "its Poisson's ratio"),
    id("vid", IdSpace::define, 0, "vector of its orientation"),
};

const CardOf<WallCard> geometric_card1{
    {&WallCard::nsid, id("nsid", IdSpace::set, 0, "nodes that the wall stops; 0: all")},
    {&WallCard::nsidex, id("nsidex", IdSpace::set, 0, "nodes left out")},
    {&WallCard::boxid, id("boxid", IdSpace::define, 0, "only nodes inside this box")},
    {&WallCard::birth, real("birth", dimension::time, 0, at_least(0), "the wall acts, and moves, from this time on")},
    {&WallCard::death, real("death", dimension::time, forever, at_least(0), "until this time")},
};
const CardOf<NormalCard> geometric_card2{
    {&NormalCard::xt, real("xt", dimension::length, 0, any_value,
                           "tail: a point on the plane, the foot of the cylinder, the centre of the sphere: x")},
    {&NormalCard::yt, real("yt", dimension::length, 0, any_value, "y")},
    {&NormalCard::zt, real("zt", dimension::length, 0, any_value, "z")},
    {&NormalCard::xh, real("xh", dimension::length, 0, any_value,
                           "head of the outward normal of the plane, or of the cylinder's axis: x")},
    {&NormalCard::yh, real("yh", dimension::length, 0, any_value, "y")},
    {&NormalCard::zh, real("zh", dimension::length, 0, any_value, "z")},
    {&NormalCard::fric, real("fric", dimension::number, 0, between(0, 1), "0 none, below 1 Coulomb, 1 no sliding")},
};
struct CylinderCard {
  double radcyl = 0, lencyl = 0;
  int nsegs = 0;
};
const CardOf<CylinderCard> cylinder_card{
    {&CylinderCard::radcyl, real("radcyl", dimension::length, required, above_zero(), "radius")},
    {&CylinderCard::lencyl, real("lencyl", dimension::length, 0, at_least(0), "length; 0 infinite")},
    {&CylinderCard::nsegs,
     integer("nsegs", 0, at_least(0), "sections whose forces are listed apart; as many cards follow")},
};
const Card wall_section_card{{
    real("vl", dimension::length, 0, any_value, "distance of a section from the cylinder's foot, no effect"),
    real("height", dimension::length, 0, any_value, "its height, no effect"),
}};
struct SphereCard {
  double radsph = 0;
};
const CardOf<SphereCard> sphere_card{
    {&SphereCard::radsph, real("radsph", dimension::length, required, above_zero(), "radius")},
};
const CardOf<WallEdgeCard> flat_card{
    {&WallEdgeCard::xhev, real("xhev", dimension::length, 0, any_value, "head of the first edge from the tail: x")},
    {&WallEdgeCard::yhev, real("yhev", dimension::length, 0, any_value, "y")},
    {&WallEdgeCard::zhev, real("zhev", dimension::length, 0, any_value, "z")},
    {&WallEdgeCard::lenl, real("lenl", dimension::length, 0, at_least(0), "length of that edge; 0 infinite")},
    {&WallEdgeCard::lenm, real("lenm", dimension::length, 0, at_least(0), "length of the other edge; 0 infinite")},
};
const CardOf<WallEdgeCard> prism_card{
    {&WallEdgeCard::xhev,
     real("xhev", dimension::length, 0, any_value, "head of the first edge of its front face from the tail: x")},
    {&WallEdgeCard::yhev, real("yhev", dimension::length, 0, any_value, "y")},
    {&WallEdgeCard::zhev, real("zhev", dimension::length, 0, any_value, "z")},
    {&WallEdgeCard::lenl, real("lenl", dimension::length, 0, at_least(0), "length of that edge; 0 infinite")},
    {&WallEdgeCard::lenm, real("lenm", dimension::length, 0, at_least(0), "length of the other edge; 0 infinite")},
    {&WallEdgeCard::lenp, real("lenp", dimension::length, 0, at_least(0), "depth behind the face; 0 infinite")},
};
struct WallMotionCard {
  int lcid = 0, opt = 0;
  double vx = 0, vy = 0, vz = 0;
};
const CardOf<WallMotionCard> wall_motion_card{
    {&WallMotionCard::lcid,
     id("lcid", IdSpace::function, required, "curve of the wall's motion over the time since its birth")},
    {&WallMotionCard::opt, integer("opt", 0, between(0, 1), "0 the curve is a velocity, 1 a displacement")},
    {&WallMotionCard::vx, real("vx", dimension::number, 0, any_value, "direction of the motion: x")},
    {&WallMotionCard::vy, real("vy", dimension::number, 0, any_value, "y")},
    {&WallMotionCard::vz, real("vz", dimension::number, 0, any_value, "z")},
};

// ---- what all walls have in common

/// The sum of squares that counts as no length is exactly zero: decks write equal points there, not nearly equal ones.
bool take_normal(Builder& builder, const Block& block, const RowOf<NormalCard>& row, RigidWall& wall) {
  wall.origin = position(block, {row->xt, row->yt, row->zt});
  const Vec3d normal = position(block, {row->xh, row->yh, row->zh}) - wall.origin;
  if (norm(normal) > 0.0) {
    wall.normal = unit(normal);
    return true;
  }
  if (wall.shape == Shape::sphere) return true;
  refuse(builder, row[&NormalCard::xh], "head and tail of the wall's vector are the same point",
         "give the head of the normal or of the axis");
  return false;
}

/// The edges of a bounded plane: l from the tail to the given head, laid into the plane; m = n x l, or its image.
bool take_edges(Builder& builder, const Block& block, const RowOf<WallEdgeCard>& row, RigidWall& wall) {
  const Vec3d edge = position(block, {row->xhev, row->yhev, row->zhev}) - wall.origin;
  const Vec3d in_plane = edge - dot(edge, wall.normal) * wall.normal;
  if (norm(in_plane) <= 1e-10 * norm(edge)) {
    refuse(builder, row[&WallEdgeCard::xhev], "the edge from the tail to this point does not lie in the wall",
           "give a point of the wall other than its tail");
    return false;
  }
  wall.finite = true;
  wall.edge_l = unit(in_plane);
  wall.edge_m = hand(block) * cross(wall.normal, wall.edge_l);
  wall.length_l = row->lenl;
  wall.length_m = row->lenm;
  return true;
}

/// A picture of the wall is not drawn. LS-PrePost leaves its card out where all of it is default, so it may be missing.
void skip_display(Builder& builder, Cursor& cursor, const Options& options) {
  if (!options.contains("DISPLAY") || cursor.left() == 0) return;
  const auto row = cursor.read(display_card);
  row[&DisplayCard::pid].report(builder.findings, Severity::note,
                                "the wall is not drawn in d3plot; its forces are in rwforc");
}

std::vector<Index> candidates(Builder& builder, const RowOf<WallCard>& row) {
  if (row->nsid != 0) {
    const auto* set = builder.node_set(row[&WallCard::nsid]);
    return set ? set->members : std::vector<Index>{};
  }
  std::vector<Index> nodes(builder.model.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = static_cast<Index>(i);
  return nodes;
}

bool on_rigid_part(const Builder& builder, Index node) {
  const Index body = builder.body_of_node[node];
  return body != none && builder.model.rigid_bodies[body].origin == RigidBody::Origin::part;
}

/// How deep a point is in the body of the wall [length]; negative outside. A bounded plane is only a face.
double depth_in(const RigidWall& wall, const Vec3d& x) {
  const Vec3d r = x - wall.origin;
  const double up = dot(r, wall.normal);
  switch (wall.shape) {
    case Shape::sphere: return wall.radius - norm(r);
    case Shape::cylinder: {
      const double side = wall.radius - norm(r - up * wall.normal);
      return wall.length > 0.0 ? std::min({side, up, wall.length - up}) : side;
    }
    case Shape::plane: return wall.finite && wall.length_l + wall.length_m > 0.0 ? -1.0 : -up;
    case Shape::prism: break;
  }
  double depth = -up;
  const auto between = [&depth](double at, double length) {
    if (length > 0.0) depth = std::min({depth, at, length - at});
  };
  between(-up, wall.depth);
  between(dot(r, wall.edge_l), wall.length_l);
  between(dot(r, wall.edge_m), wall.length_m);
  return depth;
}

/// Nodes that a wall starts behind its face are not pushed out.
void report_nodes_behind(Builder& builder, const RowOf<WallCard>& row, const RigidWall& wall) {
  constexpr double round_off = 1e-6;  // of the node's distance from the wall's reference point
  std::size_t behind = 0;
  Index deepest = none;
  double depth = 0.0;
  for (const Index node : wall.nodes) {
    const Vec3d& x = builder.model.nodes.x[node];
    const double own = depth_in(wall, x);
    if (own <= round_off * (norm(x - wall.origin) + wall.radius)) continue;
    ++behind;
    if (own > depth) depth = own, deepest = node;
  }
  if (behind == 0) return;
  row[&WallCard::nsid].report(
      builder.findings, Severity::warning,
      fmt::format("{} nodes start behind the wall, node {} the deepest, by {:.4g}: they are kept from going "
                  "deeper, not pushed out",
                  behind, builder.model.nodes.id[deepest], depth),
      "shift the wall, turn its normal, or leave them out by nsidex");
}

/// The nodes that the wall stops: NSID or all, in the box, near enough, without NSIDEX and, as in LS-DYNA, without
/// rigid parts where RWPNAL is 0.
void take_nodes(Builder& builder, const RowOf<WallCard>& row, double reach, RigidWall& wall) {
  std::vector<Index> left_out;
  if (const auto* set = builder.node_set(row[&WallCard::nsidex])) left_out = set->members;
  make_unique(left_out);
  const Box* box = builder.box(row[&WallCard::boxid]);
  const bool by_penalty = builder.model.control.wall_penalty > 0.0;
  std::size_t rigid = 0;
  for (const Index node : candidates(builder, row)) {
    const Vec3d& x = builder.model.nodes.x[node];
    if (std::binary_search(left_out.begin(), left_out.end(), node) || (box && !box->holds(x))) continue;
    if (reach > 0.0 && dot(x - wall.origin, wall.normal) > reach) continue;
    const bool on_rigid = on_rigid_part(builder, node);
    rigid += on_rigid;
    if (!on_rigid || by_penalty) wall.nodes.push_back(node);
  }
  make_unique(wall.nodes);
  if (rigid > 0 && !by_penalty)
    row[&WallCard::nsid].report(
        builder.findings, Severity::warning,
        fmt::format("{} nodes of rigid parts pass through the wall: it stops deformable ones (RWPNAL = 0)", rigid),
        "give RWPNAL 1 on *CONTROL_CONTACT to have them stopped by penalty");
  if (wall.nodes.empty()) row[&WallCard::nsid].report(builder.findings, Severity::warning, "the wall stops no node");
  if (wall.birth == 0.0) report_nodes_behind(builder, row, wall);
}

void take_wall_curve(Builder& builder, const deck::Entry& lcid, RigidWall& wall) {
  wall.motion_curve = builder.curve(lcid);
  if (!wall.motion_is_displacement || wall.motion_curve == none) return;
  const Curve& curve = builder.model.curves[wall.motion_curve];
  if (const double first = curve.clamped(0.0); first != 0.0)
    lcid.report(builder.findings, Severity::warning,
                fmt::format("the wall is displaced by {:g} at its start: it starts where its card puts it and moves "
                            "by what the curve adds",
                            first),
                "let the curve begin with 0");
}

void leave_wall(Builder& builder, const RowOf<WallCard>& row, double reach, RigidWall wall,
                const std::optional<deck::Entry>& curve = {}, const std::optional<deck::Entry>& areas = {}) {
  builder.defer(Phase::conditions, [row, reach, wall = std::move(wall), curve, areas](Builder& b) mutable {
    take_nodes(b, row, reach, wall);
    if (const double end = b.model.control.end_time; end > 0.0 && wall.birth >= end)
      row[&WallCard::birth].report(
          b.findings, Severity::warning,
          fmt::format("the wall is activated after the end of the run ({:g}): it stops nothing", end),
          "give 0 if it is to act from the start");
    if (curve) take_wall_curve(b, *curve, wall);
    if (areas)
      if (const Set<Segment>* set = b.segment_set(*areas)) wall.areas = set->members;
    if (wall.id == 0) {
      wall.id = static_cast<int>(b.model.walls.size());
      const auto taken = [&](const RigidWall& other) { return other.id == wall.id; };
      do ++wall.id;
      while (std::any_of(b.model.walls.begin(), b.model.walls.end(), taken));
    }
    b.model.walls.push_back(std::move(wall));
  });
}

RigidWall begin_wall(Cursor& cursor, const Options& options, Shape shape) {
  RigidWall wall;
  wall.shape = shape;
  wall.place = cursor.place();
  if (options.contains("ID")) {
    const auto row = cursor.read(wall_id_card);
    wall.id = row->id;
    wall.title = row->title;
  }
  return wall;
}

// ---- *RIGIDWALL_PLANAR

void take_wall_friction(Builder& builder, const RowOf<NormalCard>& row, RigidWall& wall) {
  wall.friction = row->fric;
  wall.weld_velocity = row->wvel;
  if (wall.friction > 1.0 && wall.friction != 2.0 && wall.friction != 3.0)
    refuse(builder, row[&NormalCard::fric], "expected 0 to 1, 2 or 3");
}

void read_planar(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    RigidWall wall = begin_wall(cursor, options, Shape::plane);
    const auto row1 = cursor.read(planar_card1);
    const auto row2 = cursor.read(planar_card2);
    wall.birth = row1->birth;
    wall.death = death_time(row1->death);
    bool sound = take_normal(builder, block, row2, wall);
    std::optional<deck::Entry> areas;
    take_wall_friction(builder, row2, wall);
    if (options.contains("FINITE")) {
      const auto edge = cursor.read(finite_card);
      sound = sound && take_edges(builder, block, edge, wall);
    }
    if (options.contains("MOVING")) {
      const auto moving = cursor.read(moving_card);
      wall.mass = moving->mass;
      wall.velocity = moving->v0;
    }
    if (options.contains("FORCES")) {
      const auto forces = cursor.read(forces_card);
      wall.soft = forces->soft;
      if (forces->ssid != 0) areas = forces[&ForcesCard::ssid];
      expect(builder, Severity::warning,
             {{forces[&ForcesCard::soft], 0,
               "the wall stops a node in one cycle, not in so many: its first force is that much higher"}});
    }
    skip_display(builder, cursor, options);
    if (sound) leave_wall(builder, row1, row1->offset, std::move(wall), {}, areas);
  }
}

// ---- *RIGIDWALL_FORCE_TRANSDUCER

struct TransducerCard {
  int tid = 0, rwid = 0, nsid = 0;
  std::string heading;
};
const CardOf<TransducerCard> transducer_card{
    {&TransducerCard::tid, id("tid", IdSpace::other, required, "number of the transducer in rwforc")},
    {&TransducerCard::rwid, id("rwid", IdSpace::other, required, "wall whose force is listed apart")},
};
const CardOf<TransducerCard> transducer_heading_card{{&TransducerCard::heading, text("heading", 80, "its name")}};
const CardOf<TransducerCard> transducer_nodes_card{
    {&TransducerCard::nsid, id("nsid", IdSpace::set, required, "nodes on which it is")},
};

void read_wall_transducer(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    TransducerCard values;
    const auto row = cursor.read(transducer_card, values);
    cursor.read(transducer_heading_card, values);
    const auto nodes = cursor.read(transducer_nodes_card, values);
    // Behind the walls.
    builder.defer(Phase::conditions, [row, nodes](Builder& now) {
      now.defer(Phase::conditions, [row, nodes](Builder& b) {
        WallTransducer transducer;
        transducer.id = nodes->tid;
        transducer.title = nodes->heading;
        transducer.set = nodes->nsid;
        transducer.place = row.place();
        const auto wall = std::ranges::find(b.model.walls, nodes->rwid, &RigidWall::id);
        if (wall == b.model.walls.end())
          return refuse(b, row[&TransducerCard::rwid], "no wall has this number",
                        "give the one of *RIGIDWALL_..._ID, or the wall's place in the deck");
        transducer.wall = static_cast<Index>(wall - b.model.walls.begin());
        const Set<Index>* set = b.node_set(nodes[&TransducerCard::nsid]);
        if (set == nullptr) return;
        transducer.nodes = set->members;
        std::ranges::sort(transducer.nodes);
        transducer.nodes.erase(std::unique(transducer.nodes.begin(), transducer.nodes.end()), transducer.nodes.end());
        const bool any =
            std::ranges::any_of(transducer.nodes, [&](Index n) { return std::ranges::binary_search(wall->nodes, n); });
        if (!any)
          nodes[&TransducerCard::nsid].report(b.findings, Severity::warning,
                                              "none of these nodes is one that the wall stops: the force stays 0",
                                              "name nodes of the wall");
        const auto same = std::ranges::find(b.model.wall_transducers, transducer.id, &WallTransducer::id);
        if (same != b.model.wall_transducers.end())
          return refuse(b, row[&TransducerCard::tid], "another transducer has this number", "give each its own");
        b.model.wall_transducers.push_back(std::move(transducer));
      });
    });
  }
}

// ---- *RIGIDWALL_GEOMETRIC_...

enum class Form { flat, cylinder, sphere, prism };

template <Form form>
bool take_wall_form(Builder& builder, const Block& block, Cursor& cursor, RigidWall& wall) {
  if constexpr (form == Form::cylinder) {
    const auto cylinder = cursor.read(cylinder_card);
    wall.radius = cylinder->radcyl;
    wall.length = cylinder->lencyl;
    const int sections = cylinder->nsegs;
    for (int i = 0; i < sections; ++i) cursor.read(wall_section_card);
    if (sections > 1)
      cylinder[&CylinderCard::nsegs].report(builder.findings, Severity::warning,
                                            "forces by section are not written yet; rwforc holds the wall's sum");
  } else if constexpr (form == Form::sphere) {
    wall.radius = cursor.read(sphere_card)->radsph;
  } else if constexpr (form == Form::prism) {
    const auto prism = cursor.read(prism_card);
    wall.depth = prism->lenp;
    return take_edges(builder, block, prism, wall);
  } else {
    const auto row = cursor.read(flat_card);
    if (row->lenl > 0.0 || row->lenm > 0.0) return take_edges(builder, block, row, wall);
  }
  return true;
}

/// False (and a finding) where the motion has no direction. The curve is looked up later.
bool take_motion(Builder& builder, const Block& block, const RowOf<WallMotionCard>& row, RigidWall& wall) {
  const Vec3d along = direction(block, {row->vx, row->vy, row->vz});
  if (norm(along) == 0.0) {
    refuse(builder, row[&WallMotionCard::vx], "the direction of the wall's motion has no length",
           "give its components");
    return false;
  }
  wall.motion_direction = unit(along);
  wall.motion_is_displacement = row->opt == 1;
  return true;
}

template <Form form>
void read_geometric(Builder& builder, const Block& block, const Options& options) {
  constexpr Shape shape = form == Form::flat       ? Shape::plane
                          : form == Form::cylinder ? Shape::cylinder
                          : form == Form::prism    ? Shape::prism
                                                   : Shape::sphere;
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    RigidWall wall = begin_wall(cursor, options, shape);
    const auto row1 = cursor.read(geometric_card1);
    const auto row2 = cursor.read(geometric_card2);
    wall.birth = row1->birth;
    wall.death = death_time(row1->death);
    wall.friction = row2->fric;
    bool sound = take_normal(builder, block, row2, wall);
    sound = take_wall_form<form>(builder, block, cursor, wall) && sound;
    std::optional<deck::Entry> curve;
    if (options.contains("MOTION")) {
      const auto motion = cursor.read(wall_motion_card);
      sound = take_motion(builder, block, motion, wall) && sound;
      curve = motion[&WallMotionCard::lcid];
    }
    skip_display(builder, cursor, options);
    if (sound) leave_wall(builder, row1, 0.0, std::move(wall), curve);
  }
}

}  // namespace

std::vector<Keyword> rigidwall_keywords() {
  const auto geometric = [](std::string_view name, const Card& form, auto read) {
    return Keyword{.name = name,
                   .options = {"MOTION", "DISPLAY", "ID"},
                   .layout = {{"with _ID", &wall_id_card},
                              {{}, &geometric_card1},
                              {{}, &geometric_card2},
                              {{}, &form},
                              {"with _MOTION", &wall_motion_card},
                              {"with _DISPLAY; may be missing", &display_card}},
                   .read = read};
  };
  Keyword cylinder = geometric("RIGIDWALL_GEOMETRIC_CYLINDER", cylinder_card, read_geometric<Form::cylinder>);
  cylinder.layout.insert(cylinder.layout.begin() + 4, {"nsegs times", &wall_section_card});
  const auto refused = [](std::string_view name, std::string_view why) {
    return Keyword{.name = name,
                   .options = {"FINITE", "MOVING", "FORCES", "MOTION", "DISPLAY", "ID"},
                   .status = KeywordStatus::refused,
                   .why = why,
                   .read = nullptr};
  };
  return {
      {.name = "RIGIDWALL_PLANAR",
       .options = {"FINITE", "MOVING", "FORCES", "DISPLAY", "ID"},
       .layout = {{"with _ID", &wall_id_card},
                  {{}, &planar_card1},
                  {{}, &planar_card2},
                  {"with _FINITE", &finite_card},
                  {"with _MOVING", &moving_card},
                  {"with _FORCES", &forces_card},
                  {"with _DISPLAY; may be missing", &display_card}},
       .read = read_planar},
      geometric("RIGIDWALL_GEOMETRIC_FLAT", flat_card, read_geometric<Form::flat>),
      geometric("RIGIDWALL_GEOMETRIC_PRISM", prism_card, read_geometric<Form::prism>),
      cylinder,
      geometric("RIGIDWALL_GEOMETRIC_SPHERE", sphere_card, read_geometric<Form::sphere>),
      refused("RIGIDWALL_PLANAR_ORTHO",
              "orthotropic friction is not built; use *RIGIDWALL_PLANAR with one coefficient"),
      {.name = "RIGIDWALL_FORCE_TRANSDUCER",
       .layout = {{{}, &transducer_card}, {{}, &transducer_heading_card}, {{}, &transducer_nodes_card}},
       .read = read_wall_transducer},
  };
}

}  // namespace nugget::reading
