// SPDX-License-Identifier: Apache-2.0
// *LOAD_...: forces and moments on nodes and bodies, base accelerations, pressures.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "model/segments.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/turning_nodes.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

// ---- forces and moments

struct ForceCard {
  int target = 0, dof = 0, lcid = 0;
  double sf = 0;
  int cid = 0;
  std::array<int, 3> m{};
};
CardOf<ForceCard> force_card(const FieldOf<ForceCard>& target) {
  return {
      target,
      {&ForceCard::dof,
       integer("dof", required, between(1, 8),
               "1, 2, 3 force along x, y, z; 4 along the normal of m1, m2, m3; 5, 6, 7 moment about x, y, z; 8 about "
               "that normal")},
      {&ForceCard::lcid, within_range(id("lcid", IdSpace::function, required,
                                         "curve of the load over time; below 0, over the displacement: not built"),
                                      at_least(1))},
      {&ForceCard::sf, real("sf", dimension::number, 1, any_value, "scale of the curve")},
      {&ForceCard::cid, id("cid", IdSpace::define, 0, "coordinate system of the direction; 0: global axes")},
      {at(&ForceCard::m, 0), id("m1", IdSpace::node, 0, "first of the nodes whose normal the load follows")},
      {at(&ForceCard::m, 1), id("m2", IdSpace::node, 0, "second")},
      {at(&ForceCard::m, 2), id("m3", IdSpace::node, 0, "third")},
  };
}
const CardOf<ForceCard> force_node_card = force_card({&ForceCard::target, id("nid", IdSpace::node, required, "node")});
const CardOf<ForceCard> force_set_card = force_card(
    {&ForceCard::target, id("nsid", IdSpace::set, required, "node set; the load acts on each of its nodes")});
const CardOf<ForceCard> force_body_card =
    force_card({&ForceCard::target, id("pid", IdSpace::part, required, "part of *MAT_RIGID, or nodal rigid body")});

void resolve_follower(Builder& builder, const RowOf<ForceCard>& row, NodalLoad& load) {
  for (std::size_t i = 0; i < row->m.size(); ++i) {
    const deck::Entry field = row[at(&ForceCard::m, i)];
    if (row->m[i] == 0)
      refuse(builder, field, "a load with dof 4 or 8 follows the normal of three nodes; this one is missing");
    load.follower_nodes[i] = builder.node(field);
  }
  if (std::find(load.follower_nodes.begin(), load.follower_nodes.end(), none) != load.follower_nodes.end()) return;
  const auto place = [&](std::size_t i) { return builder.model.nodes.x[load.follower_nodes[i]]; };
  const Vec3d first = place(1) - place(0), second = place(2) - place(0);
  if (norm(cross(first, second)) <= 1e-6 * norm(first) * norm(second))
    refuse(builder, row[at(&ForceCard::m, 0)], "the three nodes are on a line at the start: they have no normal",
           "name three nodes that span a plane");
}

void resolve_fixed_direction(Builder& builder, const RowOf<ForceCard>& row, NodalLoad& load) {
  const int axis = (row->dof - 1) % 4;
  load.direction = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
  if (const Index system = builder.system_of_directions(row[&ForceCard::cid]); system != none)
    load.direction = builder.model.systems[system].axes.global(load.direction);
}

enum class On { node, set, body };

template <On on>
void resolve_target(Builder& builder, const RowOf<ForceCard>& row, NodalLoad& load) {
  if constexpr (on == On::body) {
    load.rigid_body = find_body(builder, row[&ForceCard::target]);
  } else if constexpr (on == On::set) {
    if (const auto* nodes = builder.node_set(row[&ForceCard::target])) load.nodes = nodes->members;
  } else if (const Index node = builder.node(row[&ForceCard::target]); node != none) {
    load.nodes = {node};
  }
}

template <On on>
void read_force(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto turns = std::make_shared<std::vector<char>>();  // found for the first moment of the block
  while (!at_end(cursor)) {
    const auto row = cursor.read(on == On::node ? force_node_card : on == On::set ? force_set_card : force_body_card);
    if (row->dof % 4 != 0 && row->cid == 0) warn_of_global_axis(builder, block, row[&ForceCard::dof]);
    if (row->dof % 4 == 0 || (row->dof > 4 && row->cid != 0))
      refuse_in_mirror(builder, block, row[&ForceCard::dof], turning_in_mirror);
    builder.defer(Phase::conditions, [row, turns](Builder& b) {
      NodalLoad load;
      const int dof = row->dof;
      load.moment = dof >= 5;
      load.scale = row->sf;
      load.curve = b.curve(row[&ForceCard::lcid]);
      load.place = row.place();
      if (dof == 4 || dof == 8)
        resolve_follower(b, row, load);
      else
        resolve_fixed_direction(b, row, load);
      resolve_target<on>(b, row, load);
      if (load.moment)
        b.defer(Phase::checks, [row, turns, nodes = load.nodes](Builder& all) {
          if (turns->empty()) *turns = nodes_that_turn(all);
          warn_of_no_rotation(
              all, row[&ForceCard::dof], nodes, *turns, "the moment has no effect there",
              "give the moment as forces, or put it on a *CONSTRAINED_NODAL_RIGID_BODY of nodes around");
        });
      b.model.nodal_loads.push_back(std::move(load));
    });
  }
}

// ---- base acceleration

struct BodyLoadCard {
  int lcid = 0;
  double sf = 0;
  int lciddr = 0;
  double xc = 0, yc = 0, zc = 0;
  int cid = 0;
};
const CardOf<BodyLoadCard> body_load_card{
    {&BodyLoadCard::lcid, within_range(id("lcid", IdSpace::function, required,
                                          "curve over time of the base acceleration (positive in z pulls down), or of "
                                          "the angular velocity (RX, RY, RZ)"),
                                       at_least(1))},
    {&BodyLoadCard::sf, real("sf", dimension::number, 1, any_value, "scale of the curve")},
    {&BodyLoadCard::lciddr,
     id("lciddr", IdSpace::function, 0, "curve in dynamic relaxation; 0: lcid, if its SIDR is 1 or 2")},
    {&BodyLoadCard::xc, real("xc", dimension::length, 0, any_value, "centre of rotation, for the rotational forms")},
    {&BodyLoadCard::yc, real("yc", dimension::length, 0, any_value, "the same")},
    {&BodyLoadCard::zc, real("zc", dimension::length, 0, any_value, "the same")},
    {&BodyLoadCard::cid, id("cid", IdSpace::define, 0, "coordinate system of the direction; 0: global axes")},
};
struct BodyVectorCard {
  double v1 = 0, v2 = 0, v3 = 0;
};
const CardOf<BodyVectorCard> body_vector_card{
    {&BodyVectorCard::v1, real("v1", dimension::number, 0, any_value, "direction of the acceleration, x component")},
    {&BodyVectorCard::v2, real("v2", dimension::number, 0, any_value, "y component")},
    {&BodyVectorCard::v3, real("v3", dimension::number, 0, any_value, "z component")},
};
struct BodyPartsCard {
  int psid = 0;
};
const CardOf<BodyPartsCard> body_parts_card{
    {&BodyPartsCard::psid, id("psid", IdSpace::set, required, "part set that all *LOAD_BODY_... are restricted to")},
};

// ---- centrifugal force

template <int axis>
void read_body_rotation(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto row = cursor.read(body_load_card);
  expect_end(builder, cursor);
  const Vec3d center = position(block, {row->xc, row->yc, row->zc});
  builder.defer(Phase::conditions, [row, center](Builder& b) {
    BodyLoad load;
    load.direction = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    load.scale = row->sf;
    load.curve = b.curve(row[&BodyLoadCard::lcid]);
    load.relaxation_curve = b.curve(row[&BodyLoadCard::lciddr]);
    load.centrifugal = true;
    load.center = center;
    if (const Index system = b.system(row[&BodyLoadCard::cid]); system != none)
      load.direction = b.model.systems[system].axes.global(load.direction);
    b.model.body_loads.push_back(std::move(load));
  });
}

// ---- gravity of parts

struct GravityCard {
  int target = 0, dof = 0, lc = 0;
  double accel = 0;
  int lcdr = 0;
};
CardOf<GravityCard> gravity_card(const FieldOf<GravityCard>& target) {
  return {
      target,
      {&GravityCard::dof, integer("dof", required, between(1, 3), "1, 2, 3: along x, y, z")},
      {&GravityCard::lc,
       within_range(id("lc", IdSpace::function, 0, "curve of a factor over time; 0: 1"), at_least(0))},
      {&GravityCard::accel,
       real("accel", dimension::acceleration, 0, any_value, "base acceleration; positive in z pulls down")},
      {&GravityCard::lcdr,
       id("lcdr", IdSpace::function, 0, "curve in dynamic relaxation; 0: lcid, if its SIDR is 1 or 2")},
      integer("stga", 0, only(0), "construction stage at which the part is added"),
      integer("stgr", 0, only(0), "construction stage at which it is removed"),
  };
}
const CardOf<GravityCard> gravity_part_card =
    gravity_card({&GravityCard::target, id("pid", IdSpace::part, required, "part")});
const CardOf<GravityCard> gravity_part_set_card =
    gravity_card({&GravityCard::target, id("psid", IdSpace::set, required, "part set")});

template <bool set>
void read_gravity(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(set ? gravity_part_set_card : gravity_part_card);
    builder.defer(Phase::conditions, [row](Builder& b) {
      BodyLoad load;
      if constexpr (set) {
        if (const auto* parts = b.part_set(row[&GravityCard::target])) load.parts = parts->members;
      } else if (const Index part = b.part(row[&GravityCard::target]); part != none) {
        load.parts = {part};
      }
      if (load.parts.empty()) return;
      const int axis = row->dof;
      load.direction = {axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0, axis == 3 ? 1.0 : 0.0};
      load.scale = row->accel;
      load.curve = b.curve(row[&GravityCard::lc]);
      load.relaxation_curve = b.curve(row[&GravityCard::lcdr]);
      load.own_parts = true;
      b.model.body_loads.push_back(std::move(load));
    });
  }
}

void leave_body_load(Builder& builder, const RowOf<BodyLoadCard>& row, const Vec3d& local) {
  builder.defer(Phase::conditions, [row, local](Builder& b) {
    BodyLoad load;
    load.direction = local;
    load.scale = row->sf;
    load.curve = b.curve(row[&BodyLoadCard::lcid]);
    load.relaxation_curve = b.curve(row[&BodyLoadCard::lciddr]);
    if (const Index system = b.system(row[&BodyLoadCard::cid]); system != none)
      load.direction = b.model.systems[system].axes.global(local);
    b.model.body_loads.push_back(load);
  });
}

template <int axis>
void read_body_load(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  leave_body_load(builder, cursor.read(body_load_card),
                  {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
  expect_end(builder, cursor);
}

void read_body_vector(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto row = cursor.read(body_load_card);
  const auto vector = cursor.read(body_vector_card);
  expect_end(builder, cursor);
  const bool local = row->cid != 0;
  const Vec3d v =
      local ? Vec3d{vector->v1, vector->v2, vector->v3} : direction(block, {vector->v1, vector->v2, vector->v3});
  if (norm(v) == 0.0)
    refuse(builder, vector[&BodyVectorCard::v1], "the direction has no length",
           "give the components of the acceleration's direction");
  else
    leave_body_load(builder, row, unit(v));
}

void read_body_parts(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto row = cursor.read(body_parts_card);
  expect_end(builder, cursor);
  // In the phase of the checks, when every body load is there: the restriction holds for all of them.
  builder.defer(Phase::checks, [row](Builder& b) {
    if (const auto* parts = b.part_set(row[&BodyPartsCard::psid]))
      for (BodyLoad& load : b.model.body_loads)
        if (!load.own_parts) load.parts = parts->members;
  });
}

// ---- pressure

struct PressureCard {
  int lcid = 0;
  double sf = 0, at = 0;
  int n1 = 0, n2 = 0, n3 = 0, n4 = 0, n5 = 0, target = 0;
};
const CardOf<PressureCard> load_segment_card{
    {&PressureCard::lcid,
     or_negative(id("lcid", IdSpace::function, required, "curve of the pressure over time"), IdSpace::function)},
    {&PressureCard::sf, real("sf", dimension::number, 1, any_value, "scale of the curve")},
    {&PressureCard::at, real("at", dimension::time, 0, at_least(0), "arrival time: the curve starts then")},
    {&PressureCard::n1, id("n1", IdSpace::node, required,
                           "corner of the segment; positive pressure pushes against the right-hand normal")},
    {&PressureCard::n2, id("n2", IdSpace::node, required, "second corner")},
    {&PressureCard::n3, id("n3", IdSpace::node, required, "third corner")},
    {&PressureCard::n4, id("n4", IdSpace::node, 0, "fourth corner; 0 or n3: a triangle")},
    {&PressureCard::n5, id("n5", IdSpace::node, 0, "mid-side node")},
};
CardOf<PressureCard> pressure_card(const FieldOf<PressureCard>& target) {
  return {
      target,
      {&PressureCard::lcid,
       or_negative(id("lcid", IdSpace::function, required, "curve of the pressure over time"), IdSpace::function)},
      {&PressureCard::sf, real("sf", dimension::number, 1, any_value, "scale of the curve")},
      {&PressureCard::at, real("at", dimension::time, 0, at_least(0), "arrival time: the curve starts then")},
  };
}
const CardOf<PressureCard> segment_set_card =
    pressure_card({&PressureCard::target, id("ssid", IdSpace::set, required, "segment set")});
const CardOf<PressureCard> load_shell_card =
    pressure_card({&PressureCard::target,
                   id("eid", IdSpace::element, required, "shell; positive pressure pushes against its normal")});
const CardOf<PressureCard> shell_set_card =
    pressure_card({&PressureCard::target,
                   id("esid", IdSpace::set, required, "shell set; positive pressure pushes against the normals")});

/// Nodes in the wrong order, around a segment that crosses itself, span no area.
void warn_of_no_area(Builder& b, const RowOf<PressureCard>& row, const std::vector<Segment>& segments) {
  const auto place = [&](Index n) { return b.model.nodes.x[n]; };
  const auto is_none = [&](const Segment& s) {
    const Vec3d one = place(s[2]) - place(s[0]), other = place(s[3]) - place(s[1]);
    return norm(cross(one, other)) <= 1e-6 * (dot(one, one) + dot(other, other));
  };
  const auto count = std::count_if(segments.begin(), segments.end(), is_none);
  if (count == 0) return;
  const Segment& first = *std::find_if(segments.begin(), segments.end(), is_none);
  row[&PressureCard::lcid].report(
      b.findings, Severity::warning,
      fmt::format("{} of {} segments (the first begins with node {}) have no area: no pressure acts there", count,
                  segments.size(), b.model.nodes.id[first[0]]),
      "give the nodes in their order around the segment");
}

/// Makes a pressure load of what `segments` returns, in its phase.
template <class Segments>
void leave_pressure(Builder& builder, int id, const RowOf<PressureCard>& row, Segments segments) {
  if (row->lcid < 0)
    return refuse(builder, row[&PressureCard::lcid],
                  "blast loads by numbers below 0 (Brode, ConWep) are not built here",
                  "write *LOAD_BLAST_ENHANCED with *LOAD_BLAST_SEGMENT_SET, or give a curve of pressure over time");
  builder.defer(Phase::conditions, [id, row, segments](Builder& b) {
    PressureLoad load;
    load.id = id;
    load.place = row.place();
    load.curve = b.curve(row[&PressureCard::lcid]);
    load.scale = row->sf;
    load.arrival = row->at;
    load.segments = segments(b, row);
    warn_of_no_area(b, row, load.segments);
    load.share = share_pressure(b.model, load.segments);
    if (!load.segments.empty()) b.model.pressure_loads.push_back(std::move(load));
  });
}

/// In a file that is mirrored the nodes go round the other way, so that the pressure acts on the same side.
template <bool mirrored>
std::vector<Segment> one_segment(Builder& builder, const RowOf<PressureCard>& row) {
  Segment segment{builder.node(row[&PressureCard::n1]), builder.node(row[&PressureCard::n2]),
                  builder.node(row[&PressureCard::n3]), builder.node(row[&PressureCard::n4])};
  if (row->n4 == 0) segment[3] = segment[2];
  for (const Index node : segment)
    if (node == none) return {};
  if constexpr (mirrored) segment = model::turned_over(segment);
  return {segment};
}

void read_segment(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const int id = read_heading(cursor, options.contains("ID")).id;
    const auto row = cursor.read(load_segment_card);
    if (row->n5 != 0)
      return refuse(builder, row[&PressureCard::n5], "segments of quadratic elements are not built",
                    "give three or four corners");
    leave_pressure(builder, id, row, is_mirrored(block) ? one_segment<true> : one_segment<false>);
  }
}

// ---- traction

struct TractionCards {
  int lcid = 0, cid = 0;
  double sf = 0, at = 0, dt = 0, v1 = 0, v2 = 0, v3 = 0;
  std::array<int, 8> n{};
  std::array<double, 8> p{};
};
const CardOf<TractionCards> traction_card{
    {&TractionCards::lcid, id("lcid", IdSpace::function, required, "curve of the traction over time")},
    {&TractionCards::sf, real("sf", dimension::number, 1, any_value, "scale of the curve")},
    {&TractionCards::at, real("at", dimension::time, 0, at_least(0), "arrival time: the curve starts then")},
    {&TractionCards::dt, real("dt", dimension::time, 1e28, at_least(0), "death time; 0: none")},
    {&TractionCards::cid, id("cid", IdSpace::define, 0, "coordinate system of the direction; 0: global axes")},
    {&TractionCards::v1,
     real("v1", dimension::number, 0, any_value, "direction of the traction; its length does not count")},
    {&TractionCards::v2, real("v2", dimension::number, 0, any_value, "second component")},
    {&TractionCards::v3, real("v3", dimension::number, 0, any_value, "third component")},
};
/// The fields of eight corners.
template <class Make>
CardOf<TractionCards> card_of_corners(Make field) {
  CardOf<TractionCards> card;
  for (std::size_t i = 0; i < 8; ++i) card.add(field(i));
  return card;
}
constexpr std::array<std::string_view, 8> traction_nodes{"n1", "n2", "n3", "n4", "n5", "n6", "n7", "n8"},
    traction_factors{"p1", "p2", "p3", "p4", "p5", "p6", "p7", "p8"};
const CardOf<TractionCards> traction_nodes_card = card_of_corners([](std::size_t i) -> FieldOf<TractionCards> {
  return {at(&TractionCards::n, i), id(traction_nodes[i], IdSpace::node, i < 3 ? required : 0,
                                       i < 3    ? "corner of the segment"
                                       : i == 3 ? "fourth corner; 0 or n3: a triangle"
                                                : "mid-side node, which is not built")};
});
const CardOf<TractionCards> traction_factors_card = card_of_corners([](std::size_t i) -> FieldOf<TractionCards> {
  return {at(&TractionCards::p, i), real(traction_factors[i], dimension::number, 0, any_value,
                                         i < 4 ? "share of the traction at this corner" : "at a mid-side node")};
});

void read_traction(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    read_heading(cursor, options.contains("ID"));
    TractionCards cards;
    const auto row = cursor.read(traction_card, cards);
    const auto nodes = cursor.read(traction_nodes_card, cards);
    const auto factors = cursor.read(traction_factors_card, cards);
    for (std::size_t i = 4; i < 8; ++i)
      refuse_nonzero(builder, nodes[at(&TractionCards::n, i)], "segments of quadratic elements are not built",
                     "give three or four corners");
    const Vec3d written{cards.v1, cards.v2, cards.v3};
    if (norm(written) == 0.0) {
      refuse(builder, row[&TractionCards::v1], "the direction has no length", "give V1 to V3");
      continue;
    }
    const std::size_t corners = cards.n[3] == 0 || cards.n[3] == cards.n[2] ? 3 : 4;
    for (std::size_t i = 0; i < corners; ++i)
      if (const deck::Entry p = factors[at(&TractionCards::p, i)]; p.blank)
        refuse(builder, p, "must be given for each corner of the segment", "write 0 where no traction acts");
    builder.defer(Phase::conditions, [row, nodes, cards, v = direction(block, written)](Builder& b) {
      TractionLoad load;
      load.keyword = "LOAD_SEGMENT_NONUNIFORM";
      load.place = row.place();
      Segment segment{};
      for (std::size_t i = 0; i < 4; ++i)
        segment[i] = i == 3 && cards.n[3] == 0 ? segment[2] : b.node(nodes[at(&TractionCards::n, i)]);
      load.curve = b.curve(row[&TractionCards::lcid]);
      const Index system = b.system(row[&TractionCards::cid]);
      if (std::ranges::find(segment, none) != segment.end() || (cards.cid != 0 && system == none)) return;
      load.direction = unit(system == none ? v : b.model.systems[system].axes.global({cards.v1, cards.v2, cards.v3}));
      load.segments = {segment};
      load.factor = {{cards.p[0], cards.p[1], cards.p[2], cards.p[3]}};
      load.scale = cards.sf;
      load.birth = cards.at;
      if (cards.dt > 0.0) load.death = cards.dt;
      b.model.traction_loads.push_back(std::move(load));
    });
  }
}

void read_segment_set(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const int id = read_heading(cursor, options.contains("ID")).id;
    leave_pressure(builder, id, cursor.read(segment_set_card), [](Builder& b, const RowOf<PressureCard>& row) {
      const auto* set = b.segment_set(row[&PressureCard::target]);
      return set ? set->members : std::vector<Segment>{};
    });
  }
}

template <bool set>
void read_shell_pressure(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const int id = read_heading(cursor, options.contains("ID")).id;
    leave_pressure(builder, id, cursor.read(set ? shell_set_card : load_shell_card),
                   [](Builder& b, const RowOf<PressureCard>& row) {
                     std::vector<Segment> segments;
                     const auto add = [&](Index shell) { segments.push_back(b.model.shells.node[shell]); };
                     if constexpr (set) {
                       if (const auto* shells = b.shell_set(row[&PressureCard::target]))
                         for (const Index shell : shells->members) add(shell);
                     } else if (const Index shell = b.shell(row[&PressureCard::target]); shell != none) {
                       add(shell);
                     }
                     return segments;
                   });
  }
}

Keyword simple(std::string_view name, const Card& card, void (*read)(Builder&, const Block&, const Options&)) {
  return {.name = name, .layout = {{{}, &card}}, .read = read};
}
Keyword with_heading(std::string_view name, const Card& card, void (*read)(Builder&, const Block&, const Options&)) {
  return {.name = name, .options = {"ID"}, .layout = {{"with _ID", &heading_card}, {{}, &card}}, .read = read};
}

}  // namespace

std::vector<Keyword> load_keywords() {
  return {
      simple("LOAD_NODE_POINT", force_node_card, read_force<On::node>),
      simple("LOAD_NODE_SET", force_set_card, read_force<On::set>),
      simple("LOAD_RIGID_BODY", force_body_card, read_force<On::body>),
      simple("LOAD_BODY_X", body_load_card, read_body_load<0>),
      simple("LOAD_BODY_Y", body_load_card, read_body_load<1>),
      simple("LOAD_BODY_Z", body_load_card, read_body_load<2>),
      simple("LOAD_BODY_RX", body_load_card, read_body_rotation<0>),
      simple("LOAD_BODY_RY", body_load_card, read_body_rotation<1>),
      simple("LOAD_BODY_RZ", body_load_card, read_body_rotation<2>),
      simple("LOAD_GRAVITY_PART", gravity_part_card, read_gravity<false>),
      simple("LOAD_GRAVITY_PART_SET", gravity_part_set_card, read_gravity<true>),
      {.name = "LOAD_BODY_VECTOR",
       .layout = {{{}, &body_load_card}, {{}, &body_vector_card}},
       .read = read_body_vector},
      simple("LOAD_BODY_PARTS", body_parts_card, read_body_parts),
      with_heading("LOAD_SEGMENT", load_segment_card, read_segment),
      {.name = "LOAD_SEGMENT_NONUNIFORM",
       .options = {"ID"},
       .layout = {{"with _ID", &heading_card},
                  {{}, &traction_card},
                  {{}, &traction_nodes_card},
                  {{}, &traction_factors_card}},
       .read = read_traction},
      with_heading("LOAD_SEGMENT_SET", segment_set_card, read_segment_set),
      with_heading("LOAD_SHELL_ELEMENT", load_shell_card, read_shell_pressure<false>),
      with_heading("LOAD_SHELL_SET", shell_set_card, read_shell_pressure<true>),
  };
}

}  // namespace nugget::reading
