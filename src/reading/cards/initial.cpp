// SPDX-License-Identifier: Apache-2.0
// *INITIAL_VELOCITY...: a velocity and a spin for each node. Definitions act in the order of the deck, the last one
// wins; then *INITIAL_VELOCITY_NODE (manual vol. I, *INITIAL_VELOCITY, remark 2), then *INITIAL_VELOCITY_RIGID_BODY.
// The velocity of a body with *PART_INERTIA or _INERTIA is its own unless IRIGID says otherwise.
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "base/index.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct VelocityCard1 {
  int nsid = 0, nsidex = 0, boxid = 0, irigid = 0, icid = 0;
};
const CardOf<VelocityCard1> velocity_card1{
    {&VelocityCard1::nsid, id("nsid", IdSpace::set, 0, "node set; 0: all nodes")},
    {&VelocityCard1::nsidex,
     id("nsidex", IdSpace::set, 0, "node set whose nodes get the velocities of the third card")},
    {&VelocityCard1::boxid, id("boxid", IdSpace::define, 0, "box: only nodes inside")},
    {&VelocityCard1::irigid, within_range(id("irigid", IdSpace::set, 0,
                                             "part set of bodies with given inertia that get this velocity too, "
                                             "whatever nsid; -1: all of them, with a box "
                                             "those whose centre is in it (so of a set); -2: all, whatever the box"),
                                          at_least(-2))},
    {&VelocityCard1::icid, id("icid", IdSpace::define, 0, "coordinate system of the velocities; 0: global axes")},
};
struct VelocityCard {
  double vx = 0, vy = 0, vz = 0, vxr = 0, vyr = 0, vzr = 0;
  int icid = 0, target = 0;
};
const CardOf<VelocityCard> velocity_card2{
    {&VelocityCard::vx, real("vx", dimension::velocity, 0, any_value, "velocity along x")},
    {&VelocityCard::vy, real("vy", dimension::velocity, 0, any_value, "velocity along y")},
    {&VelocityCard::vz, real("vz", dimension::velocity, 0, any_value, "velocity along z")},
    {&VelocityCard::vxr, real("vxr", dimension::rate, 0, any_value, "spin about x")},
    {&VelocityCard::vyr, real("vyr", dimension::rate, 0, any_value, "spin about y")},
    {&VelocityCard::vzr, real("vzr", dimension::rate, 0, any_value, "spin about z")},
};
struct VelocityCard3 {
  double vxe = 0, vye = 0, vze = 0, vxre = 0, vyre = 0, vzre = 0;
};
const CardOf<VelocityCard3> velocity_card3{
    {&VelocityCard3::vxe, real("vxe", dimension::velocity, 0, any_value, "velocity along x of the nodes of nsidex")},
    {&VelocityCard3::vye, real("vye", dimension::velocity, 0, any_value, "velocity along y of these nodes")},
    {&VelocityCard3::vze, real("vze", dimension::velocity, 0, any_value, "velocity along z of these nodes")},
    {&VelocityCard3::vxre, real("vxre", dimension::rate, 0, any_value, "spin about x of these nodes")},
    {&VelocityCard3::vyre, real("vyre", dimension::rate, 0, any_value, "spin about y of these nodes")},
    {&VelocityCard3::vzre, real("vzre", dimension::rate, 0, any_value, "spin about z of these nodes")},
};

CardOf<VelocityCard> one_velocity(const FieldOf<VelocityCard>& target) {
  return {
      target,
      {&VelocityCard::vx, real("vx", dimension::velocity, 0, any_value, "velocity along x")},
      {&VelocityCard::vy, real("vy", dimension::velocity, 0, any_value, "velocity along y")},
      {&VelocityCard::vz, real("vz", dimension::velocity, 0, any_value, "velocity along z")},
      {&VelocityCard::vxr, real("vxr", dimension::rate, 0, any_value, "spin about x")},
      {&VelocityCard::vyr, real("vyr", dimension::rate, 0, any_value, "spin about y")},
      {&VelocityCard::vzr, real("vzr", dimension::rate, 0, any_value, "spin about z")},
      {&VelocityCard::icid, id("icid", IdSpace::define, 0, "coordinate system of the velocities; 0: global axes")},
  };
}
const CardOf<VelocityCard> node_card =
    one_velocity({&VelocityCard::target, id("nid", IdSpace::node, required, "node")});
const CardOf<VelocityCard> body_card = one_velocity(
    {&VelocityCard::target, id("pid", IdSpace::part, required, "part of *MAT_RIGID, or nodal rigid body")});

struct GenerationCard {
  int id = 0, styp = 0;
  double omega = 0, vx = 0, vy = 0, vz = 0;
  int ivatn = 0, icid = 0;
};
CardOf<GenerationCard> generation_card(IdSpace space) {
  return {
      {&GenerationCard::id, id("id", space, 0, "part set, part or node set, by styp; 0: all nodes")},
      {&GenerationCard::styp, integer("styp", 1, between(1, 3), "1 part set, 2 part, 3 node set")},
      {&GenerationCard::omega, real("omega", dimension::rate, 0, any_value, "angular velocity about the axis")},
      {&GenerationCard::vx, real("vx", dimension::velocity, 0, any_value, "velocity along x")},
      {&GenerationCard::vy, real("vy", dimension::velocity, 0, any_value, "velocity along y")},
      {&GenerationCard::vz, real("vz", dimension::velocity, 0, any_value, "velocity along z")},
      {&GenerationCard::ivatn,
       integer("ivatn", 0, between(0, 1),
               "1: also all nodes of rigid bodies of which the parts have nodes; with 0 such a body starts with the "
               "momentum of its nodes, a rigid part moves as one with either")},
      {&GenerationCard::icid, id("icid", IdSpace::define, 0, "coordinate system of velocity and axis; 0: global axes")},
  };
}
// Which offset of *INCLUDE_TRANSFORM holds for the id depends on what it is the id of.
const CardOf<GenerationCard> generation_of_set = generation_card(IdSpace::set);
const CardOf<GenerationCard> generation_of_part = generation_card(IdSpace::part);
/// `y`, `z`: NY and NZ, components of the axis or, with NX -999, nodes on it.
struct AxisCard {
  double y = 0, z = 0, xc = 0, yc = 0, zc = 0, nx = 0;
  int first_node = 0, second_node = 0, phase = 0, irigid = 0;
};
CardOf<AxisCard> axis_card(const FieldOf<AxisCard>& y, const FieldOf<AxisCard>& z) {
  return {
      {&AxisCard::xc, real("xc", dimension::length, 0, any_value,
                           "point on the axis of rotation, x; with nx -999 the node ny takes its place")},
      {&AxisCard::yc, real("yc", dimension::length, 0, any_value, "y")},
      {&AxisCard::zc, real("zc", dimension::length, 0, any_value, "z")},
      {&AxisCard::nx, real("nx", dimension::number, 0, any_value,
                           "direction of the axis, x; -999: ny and nz are two nodes on the axis")},
      y,
      z,
      {&AxisCard::phase, integer("phase", 0, between(0, 1),
                                 "0, 1: at the start of the run, after dynamic relaxation where there is one")},
      {&AxisCard::irigid, integer("irigid", 0, between(0, 1), "1: bodies with given inertia get this velocity too")},
  };
}
const CardOf<AxisCard> generation_card2 = axis_card({&AxisCard::y, real("ny", dimension::number, 0, any_value, "y")},
                                                    {&AxisCard::z, real("nz", dimension::number, 0, any_value, "z")});
const CardOf<AxisCard> generation_by_nodes =
    axis_card({&AxisCard::first_node, id("ny", IdSpace::node, required, "first node")},
              {&AxisCard::second_node, id("nz", IdSpace::node, required, "second node")});

/// A rigid field of motion: v = velocity + spin x (x - center) when `turns`, else the same velocity everywhere.
struct Motion {
  Vec3d velocity, spin, center;
  bool turns = false;
  Vec3d at(const Vec3d& x) const { return turns ? velocity + cross(spin, x - center) : velocity; }
};

/// Puts a motion on nodes, and keeps away from bodies that have their own.
class Starter {
 public:
  Starter(Builder& builder, deck::Entry field) : b_(builder), field_(std::move(field)) {
    b_.model.initial_velocity.resize(b_.model.nodes.size());
  }

  /// `overwrites(body)` says whether a body with given inertia takes the motion as well.
  template <class Overwrites>
  void start(const std::vector<Index>& nodes, const Motion& motion, Overwrites overwrites) {
    std::vector<Index> own, overwritten;
    std::vector<Vec3d>& spins = b_.model.initial_spin;  // none, most of the time
    if (norm(motion.spin) > 0.0 || !spins.empty()) spins.resize(b_.model.nodes.size());
    for (const Index node : nodes) {
      const Index body = b_.body_of_node[node];
      const bool given = body != none && b_.model.rigid_bodies[body].given;
      if (!given) {
        b_.model.initial_velocity[node] = motion.at(b_.model.nodes.x[node]);
        if (!spins.empty()) spins[at(node)] = motion.spin;
      } else {
        (overwrites(body) ? overwritten : own).push_back(body);
      }
    }
    make_unique(own);
    make_unique(overwritten);
    for (const Index body : overwritten) restart(body, motion);
    for (const Index body : own) report(body, motion);
  }

  /// A body of given inertia.
  void restart(Index index, const Motion& motion) {
    RigidBody& body = b_.model.rigid_bodies[index];
    body.inertia.velocity = motion.at(body.inertia.center);
    body.inertia.spin = motion.spin;
    set_motion(b_.model, body, body.inertia.center, body.inertia.velocity, body.inertia.spin);
  }

 private:
  /// LS-DYNA keeps the body's own velocity without a word; decks that forget this start with a part at rest.
  void report(Index index, const Motion& motion) {
    const RigidBody& body = b_.model.rigid_bodies[index];
    if (norm(motion.at(body.inertia.center) - body.inertia.velocity) == 0.0 &&
        norm(motion.spin - body.inertia.spin) == 0.0)
      return;
    field_.report(b_.findings, Severity::warning,
                  fmt::format("rigid body {} keeps the initial velocity of its inertia cards ({} {} {})", body.id,
                              body.inertia.velocity.x, body.inertia.velocity.y, body.inertia.velocity.z),
                  "set IRIGID, use *INITIAL_VELOCITY_RIGID_BODY, or give the velocity on the inertia cards");
  }

  Builder& b_;
  deck::Entry field_;
};

/// Vectors of one card together: a system that is not there is one finding.
void turn_to_global(Builder& builder, const deck::Entry& icid, std::initializer_list<Vec3d*> vectors) {
  const Index system = builder.system(icid);
  if (system == none) return;
  for (Vec3d* v : vectors) *v = builder.model.systems[system].axes.global(*v);
}

/// In local axes the components are as written; else *INCLUDE_TRANSFORM turns them.
Vec3d velocity_of(const Block& block, bool local, const Vec3d& written) {
  return local ? written : direction(block, written);
}

/// Angular velocities that are not 0 in a file that is mirrored.
template <class Row, class... Fields>
void refuse_spin_in_mirror(Builder& builder, const Block& block, const Row& row, Fields... fields) {
  (refuse_in_mirror(builder, block, row[fields], turning_in_mirror), ...);
}

std::vector<Index> all_nodes(const Model& model) {
  std::vector<Index> nodes(model.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = static_cast<Index>(i);
  return nodes;
}

// ---- *INITIAL_VELOCITY

/// The bodies of given inertia that IRIGID names: by a part set or all of them, of which the box, except with -2, takes
/// those whose centre it holds (manual vol. I, *INITIAL_VELOCITY).
std::vector<Index> named_by_irigid(Builder& builder, const RowOf<VelocityCard1>& row, const Box* box) {
  const int irigid = row->irigid;
  const auto& bodies = builder.model.rigid_bodies;
  std::vector<Index> named;
  if (irigid < 0)
    for (std::size_t i = 0; i < bodies.size(); ++i) named.push_back(static_cast<Index>(i));
  else if (const auto* parts = builder.part_set(row[&VelocityCard1::irigid]))
    for (const Index p : parts->members) named.push_back(builder.model.parts[p].rigid_body);
  make_unique(named);
  const auto left_out = [&](Index i) {
    if (i == none || !bodies[i].given) return true;
    return irigid != -2 && box && !box->holds(bodies[i].inertia.center);
  };
  named.erase(std::remove_if(named.begin(), named.end(), left_out), named.end());
  return named;
}

void start_set(Builder& builder, const RowOf<VelocityCard1>& row, const Motion& motion, const Motion& exempt) {
  std::vector<Index> nodes, exempted;
  if (row->nsid == 0)
    nodes = all_nodes(builder.model);
  else if (const auto* set = builder.node_set(row[&VelocityCard1::nsid]))
    nodes = set->members;
  if (const auto* set = builder.node_set(row[&VelocityCard1::nsidex])) exempted = set->members;
  make_unique(exempted);
  const Box* box = builder.box(row[&VelocityCard1::boxid]);
  const auto left_out = [&](Index node) {
    return std::binary_search(exempted.begin(), exempted.end(), node) ||
           (box && !box->holds(builder.model.nodes.x[node]));
  };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), left_out), nodes.end());

  Starter starter(builder, row[&VelocityCard1::nsid]);
  const std::vector<Index> named = named_by_irigid(builder, row, box);
  const auto overwrites = [&](Index body) { return std::binary_search(named.begin(), named.end(), body); };
  starter.start(nodes, motion, overwrites);
  for (const Index body : named) starter.restart(body, motion);
  starter.start(exempted, exempt, overwrites);
}

void read_velocity(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(velocity_card1);
    const auto values = cursor.read(velocity_card2);
    const bool local = row->icid != 0;
    refuse_spin_in_mirror(builder, block, values, &VelocityCard::vxr, &VelocityCard::vyr, &VelocityCard::vzr);
    Motion motion, exempt;
    motion.velocity = velocity_of(block, local, Vec3d{values->vx, values->vy, values->vz});
    motion.spin = velocity_of(block, local, Vec3d{values->vxr, values->vyr, values->vzr});
    if (row->nsidex != 0) {
      const auto others = cursor.read(velocity_card3);
      refuse_spin_in_mirror(builder, block, others, &VelocityCard3::vxre, &VelocityCard3::vyre, &VelocityCard3::vzre);
      exempt.velocity = velocity_of(block, local, Vec3d{others->vxe, others->vye, others->vze});
      exempt.spin = velocity_of(block, local, Vec3d{others->vxre, others->vyre, others->vzre});
    }
    builder.defer(Phase::conditions, [row, motion, exempt](Builder& b) mutable {
      turn_to_global(b, row[&VelocityCard1::icid], {&motion.velocity, &motion.spin, &exempt.velocity, &exempt.spin});
      start_set(b, row, motion, exempt);
    });
  }
}

// ---- *INITIAL_VELOCITY_NODE and _RIGID_BODY

Motion motion_of(Builder& builder, const Block& block, const RowOf<VelocityCard>& row) {
  const bool local = row->icid != 0;
  refuse_spin_in_mirror(builder, block, row, &VelocityCard::vxr, &VelocityCard::vyr, &VelocityCard::vzr);
  return {velocity_of(block, local, Vec3d{row->vx, row->vy, row->vz}),
          velocity_of(block, local, Vec3d{row->vxr, row->vyr, row->vzr}),
          {},
          false};
}

void start_node(Builder& builder, const RowOf<VelocityCard>& row, Motion motion) {
  const Index node = builder.node(row[&VelocityCard::target]);
  if (node == none) return;
  turn_to_global(builder, row[&VelocityCard::icid], {&motion.velocity, &motion.spin});
  Starter(builder, row[&VelocityCard::target]).start({node}, motion, [](Index) { return false; });
}

void read_node_velocity(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(node_card);
    // Left behind once more, so that it comes after all sets of nodes.
    builder.defer(Phase::conditions, [row, motion = motion_of(builder, block, row)](Builder& b) {
      b.defer(Phase::conditions, [row, motion](Builder& last) { start_node(last, row, motion); });
    });
  }
}

void start_body(Builder& builder, const RowOf<VelocityCard>& row, Motion motion) {
  const Index index = find_body(builder, row[&VelocityCard::target]);
  if (index == none) return;
  RigidBody& body = builder.model.rigid_bodies[index];
  turn_to_global(builder, row[&VelocityCard::icid], {&motion.velocity, &motion.spin});
  body.inertia.velocity = motion.velocity;
  body.inertia.spin = motion.spin;
  const Vec3d center = norm(body.inertia.spin) > 0.0 ? center_of_mass(builder, body) : Vec3d{};
  set_motion(builder.model, body, center, body.inertia.velocity, body.inertia.spin);
}

void read_body_velocity(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(body_card);
    // Left behind twice more, so that it comes after those of nodes too.
    builder.defer(Phase::conditions, [row, motion = motion_of(builder, block, row)](Builder& b) {
      b.defer(Phase::conditions, [row, motion](Builder& nodes) {
        nodes.defer(Phase::conditions, [row, motion](Builder& last) { start_body(last, row, motion); });
      });
    });
  }
}

// ---- *INITIAL_VELOCITY_GENERATION

std::vector<Index> generation_nodes(Builder& builder, const RowOf<GenerationCard>& row) {
  if (row->id == 0) return all_nodes(builder.model);
  if (row->styp == 3) {
    const auto* set = builder.node_set(row[&GenerationCard::id]);
    return set ? set->members : std::vector<Index>{};
  }
  std::vector<Index> parts;
  if (row->styp == 1) {
    if (const auto* set = builder.part_set(row[&GenerationCard::id])) parts = set->members;
  } else if (const Index part = builder.part(row[&GenerationCard::id]); part != none) {
    parts = {part};
  }
  std::vector<Index> nodes = nodes_of_parts(builder.model, parts);
  // A rigid body moves as one, with its merged parts and extra nodes.
  for (const Index part : parts)
    if (const Index body = builder.model.parts[part].rigid_body; body != none) {
      const auto& carried = builder.model.rigid_bodies[body].nodes;
      nodes.insert(nodes.end(), carried.begin(), carried.end());
    }
  make_unique(nodes);
  if (row->ivatn == 1) {
    std::vector<Index> bodies;
    for (const Index node : nodes) bodies.push_back(builder.body_of_node[node]);
    make_unique(bodies);
    for (const Index body : bodies)
      if (body != none) {
        const auto& carried = builder.model.rigid_bodies[body].nodes;
        nodes.insert(nodes.end(), carried.begin(), carried.end());
      }
    make_unique(nodes);
  }
  return nodes;
}

void generate(Builder& builder, const Block& block, const RowOf<GenerationCard>& row1, const RowOf<AxisCard>& row2) {
  const bool local = row1->icid != 0, by_nodes = row2->nx == -999.0;
  Motion motion;
  motion.velocity = velocity_of(block, local, Vec3d{row1->vx, row1->vy, row1->vz});
  Vec3d axis = by_nodes ? Vec3d{} : velocity_of(block, local, Vec3d{row2->nx, row2->y, row2->z});  // not normalized
  turn_to_global(builder, row1[&GenerationCard::icid], {&motion.velocity, &axis});
  if (const double omega = row1->omega; omega != 0.0) {
    Index first = none;
    if (by_nodes) {
      for (const deck::Entry& field : {row2[&AxisCard::first_node], row2[&AxisCard::second_node]})
        if (field.integer() == 0) refuse(builder, field, "a node on the axis must be given", "give two nodes");
      first = builder.node(row2[&AxisCard::first_node]);
      const Index second = builder.node(row2[&AxisCard::second_node]);
      if (first == none || second == none) return;
      axis = builder.model.nodes.x[second] - builder.model.nodes.x[first];
    }
    if (norm(axis) == 0.0)
      return refuse(builder, row2[&AxisCard::nx], "the axis of rotation has no length",
                    "give its direction, or two nodes");
    motion.spin = omega * unit(axis);
    // The axis goes through the first of its two nodes; XC, YC, ZC are for the other form.
    motion.center = first == none ? position(block, {row2->xc, row2->yc, row2->zc}) : builder.model.nodes.x[first];
    motion.turns = true;
  }
  const bool overwrites = row2->irigid == 1;
  Starter(builder, row1[&GenerationCard::id]).start(generation_nodes(builder, row1), motion, [&](Index) {
    return overwrites;
  });
}

void warn_of_mixture(Builder& builder, const Block& block) {
  const auto& blocks = builder.deck.blocks;
  const bool mixed = std::any_of(blocks.begin(), blocks.end(), [](const Block& other) {
    return other.keyword == "INITIAL_VELOCITY" || other.keyword == "INITIAL_VELOCITY_NODE";
  });
  if (mixed)
    builder.findings.warning(block.place, block.starred(),
                             "LS-DYNA forbids it together with *INITIAL_VELOCITY and *INITIAL_VELOCITY_NODE; the last "
                             "in the deck holds, and "
                             "*INITIAL_VELOCITY_NODE before all",
                             "use one kind");
}

void read_generation(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  warn_of_mixture(builder, block);
  while (!at_end(cursor)) {
    const auto row1 = cursor.read(cursor.peek_number(1) == 2.0 ? generation_of_part : generation_of_set);
    const auto row2 = cursor.read(cursor.peek_number(3) == -999.0 ? generation_by_nodes : generation_card2);
    refuse_in_mirror(builder, block, row1[&GenerationCard::omega], turning_in_mirror);
    builder.defer(Phase::conditions, [&block, row1, row2](Builder& b) { generate(b, block, row1, row2); });
    if (row2->phase == 0)
      builder.defer(Phase::checks, [row2](Builder& b) {
        if (b.model.control.relaxation.on())
          row2[&AxisCard::phase].report(
              b.findings, Severity::note,
              "the velocity begins after dynamic relaxation, as with 1; LS-DYNA has it in the relaxation too");
      });
  }
}

}  // namespace

std::vector<Keyword> initial_keywords() {
  return {
      {.name = "INITIAL_VELOCITY",
       .layout = {{{}, &velocity_card1}, {{}, &velocity_card2}, {"if NSIDEX > 0", &velocity_card3}},
       .read = read_velocity},
      {.name = "INITIAL_VELOCITY_NODE", .layout = {{{}, &node_card}}, .read = read_node_velocity},
      {.name = "INITIAL_VELOCITY_RIGID_BODY", .layout = {{{}, &body_card}}, .read = read_body_velocity},
      {.name = "INITIAL_VELOCITY_GENERATION",
       .layout = {{{}, &generation_of_set}, {{}, &generation_card2}},
       .read = read_generation},
  };
}

}  // namespace nugget::reading
