// SPDX-License-Identifier: Apache-2.0
// *INITIAL_VELOCITY...: a velocity and a spin for each node. Definitions act in the order of the deck, the last one
// wins; then *INITIAL_VELOCITY_NODE (manual vol. I, *INITIAL_VELOCITY, remark 2), then *INITIAL_VELOCITY_RIGID_BODY.
// The velocity of a body with *PART_INERTIA or _INERTIA is its own unless IRIGID says otherwise.
#include <fmt/format.h>

#include <algorithm>

#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card velocity_card1{{
    id("nsid", IdSpace::set, 0, "node set; 0: all nodes"),
    id("nsidex", IdSpace::set, 0, "node set whose nodes get the velocities of the third card"),
    id("boxid", IdSpace::define, 0, "box: only nodes inside"),
    {"irigid",
     Kind::integer,
     {},
     0,
     at_least(-2),
     "part set of bodies with given inertia that get this velocity too, whatever nsid; -1: all of them, with a box "
     "those whose centre is in it (so of a set); -2: all, whatever the box",
     IdSpace::set},
    id("icid", IdSpace::define, 0, "coordinate system of the velocities; 0: global axes"),
}};
const Card velocity_card2{{
    real("vx", dimension::velocity, 0, any_value, "velocity along x"),
    real("vy", dimension::velocity, 0, any_value, "velocity along y"),
    real("vz", dimension::velocity, 0, any_value, "velocity along z"),
    real("vxr", dimension::rate, 0, any_value, "spin about x"),
    real("vyr", dimension::rate, 0, any_value, "spin about y"),
    real("vzr", dimension::rate, 0, any_value, "spin about z"),
}};
const Card velocity_card3{{
    real("vxe", dimension::velocity, 0, any_value, "velocity along x of the nodes of nsidex"),
    real("vye", dimension::velocity, 0, any_value, "velocity along y of these nodes"),
    real("vze", dimension::velocity, 0, any_value, "velocity along z of these nodes"),
    real("vxre", dimension::rate, 0, any_value, "spin about x of these nodes"),
    real("vyre", dimension::rate, 0, any_value, "spin about y of these nodes"),
    real("vzre", dimension::rate, 0, any_value, "spin about z of these nodes"),
}};

Card one_velocity(Field target) {
  Card card{{target}};
  card.fields.insert(card.fields.end(), velocity_card2.fields.begin(), velocity_card2.fields.end());
  card.fields.push_back(id("icid", IdSpace::define, 0, "coordinate system of the velocities; 0: global axes"));
  return card;
}
const Card node_card = one_velocity(id("nid", IdSpace::node, required, "node"));
const Card body_card = one_velocity(id("pid", IdSpace::part, required, "part of *MAT_RIGID, or nodal rigid body"));

Card generation_card(IdSpace space) {
  return {{
      id("id", space, 0, "part set, part or node set, by styp; 0: all nodes"),
      integer("styp", 1, between(1, 3), "1 part set, 2 part, 3 node set"),
      real("omega", dimension::rate, 0, any_value, "angular velocity about the axis"),
      real("vx", dimension::velocity, 0, any_value, "velocity along x"),
      real("vy", dimension::velocity, 0, any_value, "velocity along y"),
      real("vz", dimension::velocity, 0, any_value, "velocity along z"),
      integer("ivatn", 0, between(0, 1),
              "1: also all nodes of rigid bodies of which the parts have nodes; with 0 such a body starts with the "
              "momentum of its nodes, a rigid part moves as one with either"),
      id("icid", IdSpace::define, 0, "coordinate system of velocity and axis; 0: global axes"),
  }};
}
// Which offset of *INCLUDE_TRANSFORM holds for the id depends on what it is the id of.
const Card generation_of_set = generation_card(IdSpace::set);
const Card generation_of_part = generation_card(IdSpace::part);
/// `y`, `z`: NY and NZ, components of the axis or, with NX -999, nodes on it.
Card axis_card(Field y, Field z) {
  return {{
      real("xc", dimension::length, 0, any_value,
           "point on the axis of rotation, x; with nx -999 the node ny takes its place"),
      real("yc", dimension::length, 0, any_value, "y"),
      real("zc", dimension::length, 0, any_value, "z"),
      real("nx", dimension::number, 0, any_value,
           "direction of the axis, x; -999: ny and nz are two nodes on the axis"),
      y,
      z,
      integer("phase", 0, between(0, 1), "0, 1: at the start of the run, after dynamic relaxation where there is one"),
      integer("irigid", 0, between(0, 1), "1: bodies with given inertia get this velocity too"),
  }};
}
const Card generation_card2 =
    axis_card(real("ny", dimension::number, 0, any_value, "y"), real("nz", dimension::number, 0, any_value, "z"));
const Card generation_by_nodes =
    axis_card(id("ny", IdSpace::node, required, "first node"), id("nz", IdSpace::node, required, "second node"));

/// A rigid field of motion: v = velocity + spin x (x - center) when `turns`, else the same velocity everywhere.
struct Motion {
  Vec3d velocity, spin, center;
  bool turns = false;
  Vec3d at(const Vec3d& x) const { return turns ? velocity + cross(spin, x - center) : velocity; }
};

/// Puts a motion on nodes, and keeps away from bodies that have their own.
class Starter {
 public:
  Starter(Builder& builder, const Row& row, std::string_view field) : b_(builder), row_(row), field_(field) {
    b_.model.initial_velocity.resize(b_.model.nodes.size());
    b_.model.initial_spin.resize(b_.model.nodes.size());
  }

  /// `overwrites(body)` says whether a body with given inertia takes the motion as well.
  template <class Overwrites>
  void start(const std::vector<Index>& nodes, const Motion& motion, Overwrites overwrites) {
    std::vector<Index> own, overwritten;
    for (const Index node : nodes) {
      const Index body = b_.body_of_node[static_cast<std::size_t>(node)];
      const bool given = body != none && b_.model.rigid_bodies[static_cast<std::size_t>(body)].given;
      if (!given) {
        b_.model.initial_velocity[static_cast<std::size_t>(node)] =
            motion.at(b_.model.nodes.x[static_cast<std::size_t>(node)]);
        b_.model.initial_spin[static_cast<std::size_t>(node)] = motion.spin;
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
    RigidBody& body = b_.model.rigid_bodies[static_cast<std::size_t>(index)];
    body.inertia.velocity = motion.at(body.inertia.center);
    body.inertia.spin = motion.spin;
    set_motion(b_.model, body, body.inertia.center, body.inertia.velocity, body.inertia.spin);
  }

 private:
  /// LS-DYNA keeps the body's own velocity without a word; decks that forget this start with a part at rest.
  void report(Index index, const Motion& motion) {
    const RigidBody& body = b_.model.rigid_bodies[static_cast<std::size_t>(index)];
    if (norm(motion.at(body.inertia.center) - body.inertia.velocity) == 0.0 &&
        norm(motion.spin - body.inertia.spin) == 0.0)
      return;
    row_.report(b_.findings, Severity::warning, field_,
                fmt::format("rigid body {} keeps the initial velocity of its inertia cards ({} {} {})", body.id,
                            body.inertia.velocity.x, body.inertia.velocity.y, body.inertia.velocity.z),
                "set IRIGID, use *INITIAL_VELOCITY_RIGID_BODY, or give the velocity on the inertia cards");
  }

  Builder& b_;
  const Row& row_;
  std::string_view field_;
};

Vec3d in_global(Builder& builder, const Row& row, const Vec3d& local) {
  const Index system = builder.system(row, "icid");
  return system == none ? local : builder.model.systems[static_cast<std::size_t>(system)].axes.global(local);
}

/// In local axes the components are as written; else *INCLUDE_TRANSFORM turns them.
Vec3d velocity_of(const Block& block, const Row& row, bool local, std::string_view x, std::string_view y,
                  std::string_view z) {
  return local ? triple(row, x, y, z) : direction(block, row, x, y, z);
}

std::vector<Index> all_nodes(const Model& model) {
  std::vector<Index> nodes(model.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = static_cast<Index>(i);
  return nodes;
}

// ---- *INITIAL_VELOCITY
// ---------------------------------------------------------------------------------------------------

/// The bodies of given inertia that IRIGID names: by a part set or all of them, of which the box, except with -2, takes
/// those whose centre it holds (manual vol. I, *INITIAL_VELOCITY).
std::vector<Index> named_by_irigid(Builder& builder, const Row& row, const Box* box) {
  const int irigid = row.integer("irigid");
  const auto& bodies = builder.model.rigid_bodies;
  std::vector<Index> named;
  if (irigid < 0)
    for (std::size_t i = 0; i < bodies.size(); ++i) named.push_back(static_cast<Index>(i));
  else if (const auto* parts = builder.part_set(row, "irigid"))
    for (const Index p : parts->members) named.push_back(builder.model.parts[static_cast<std::size_t>(p)].rigid_body);
  make_unique(named);
  const auto left_out = [&](Index i) {
    if (i == none || !bodies[static_cast<std::size_t>(i)].given) return true;
    return irigid != -2 && box && !box->holds(bodies[static_cast<std::size_t>(i)].inertia.center);
  };
  named.erase(std::remove_if(named.begin(), named.end(), left_out), named.end());
  return named;
}

void start_set(Builder& builder, const Row& row, const Motion& motion, const Motion& exempt) {
  std::vector<Index> nodes, exempted;
  if (row.integer("nsid") == 0)
    nodes = all_nodes(builder.model);
  else if (const auto* set = builder.node_set(row, "nsid"))
    nodes = set->members;
  if (const auto* set = builder.node_set(row, "nsidex")) exempted = set->members;
  make_unique(exempted);
  const Box* box = builder.box(row, "boxid");
  const auto left_out = [&](Index node) {
    return std::binary_search(exempted.begin(), exempted.end(), node) ||
           (box && !box->holds(builder.model.nodes.x[static_cast<std::size_t>(node)]));
  };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), left_out), nodes.end());

  Starter starter(builder, row, "nsid");
  const std::vector<Index> named = named_by_irigid(builder, row, box);
  const auto overwrites = [&](Index body) { return std::binary_search(named.begin(), named.end(), body); };
  starter.start(nodes, motion, overwrites);
  for (const Index body : named) starter.restart(body, motion);
  starter.start(exempted, exempt, overwrites);
}

void read_velocity(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const Row row = cursor.read(velocity_card1);
    const Row values = cursor.read(velocity_card2);
    const bool local = row.integer("icid") != 0;
    Motion motion, exempt;
    motion.velocity = velocity_of(block, values, local, "vx", "vy", "vz");
    motion.spin = velocity_of(block, values, local, "vxr", "vyr", "vzr");
    if (row.integer("nsidex") != 0) {
      const Row others = cursor.read(velocity_card3);
      exempt.velocity = velocity_of(block, others, local, "vxe", "vye", "vze");
      exempt.spin = velocity_of(block, others, local, "vxre", "vyre", "vzre");
    }
    builder.defer(Phase::conditions, [row, motion, exempt](Builder& b) mutable {
      for (Vec3d* v : {&motion.velocity, &motion.spin, &exempt.velocity, &exempt.spin}) *v = in_global(b, row, *v);
      start_set(b, row, motion, exempt);
    });
  }
}

// ---- *INITIAL_VELOCITY_NODE and _RIGID_BODY
// --------------------------------------------------------------------------------

Motion motion_of(const Block& block, const Row& row) {
  const bool local = row.integer("icid") != 0;
  return {
      velocity_of(block, row, local, "vx", "vy", "vz"), velocity_of(block, row, local, "vxr", "vyr", "vzr"), {}, false};
}

void start_node(Builder& builder, const Row& row, Motion motion) {
  const Index node = builder.node(row, "nid");
  if (node == none) return;
  motion.velocity = in_global(builder, row, motion.velocity);
  motion.spin = in_global(builder, row, motion.spin);
  Starter(builder, row, "nid").start({node}, motion, [](Index) { return false; });
}

void read_node_velocity(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const Row row = cursor.read(node_card);
    // Left behind once more, so that it comes after all sets of nodes.
    builder.defer(Phase::conditions, [row, motion = motion_of(block, row)](Builder& b) {
      b.defer(Phase::conditions, [row, motion](Builder& last) { start_node(last, row, motion); });
    });
  }
}

void start_body(Builder& builder, const Row& row, const Motion& motion) {
  const Index index = find_body(builder, row, "pid");
  if (index == none) return;
  RigidBody& body = builder.model.rigid_bodies[static_cast<std::size_t>(index)];
  body.inertia.velocity = in_global(builder, row, motion.velocity);
  body.inertia.spin = in_global(builder, row, motion.spin);
  const Vec3d center = norm(body.inertia.spin) > 0.0 ? center_of_mass(builder, body) : Vec3d{};
  set_motion(builder.model, body, center, body.inertia.velocity, body.inertia.spin);
}

void read_body_velocity(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const Row row = cursor.read(body_card);
    // Left behind twice more, so that it comes after those of nodes too.
    builder.defer(Phase::conditions, [row, motion = motion_of(block, row)](Builder& b) {
      b.defer(Phase::conditions, [row, motion](Builder& nodes) {
        nodes.defer(Phase::conditions, [row, motion](Builder& last) { start_body(last, row, motion); });
      });
    });
  }
}

// ---- *INITIAL_VELOCITY_GENERATION
// ------------------------------------------------------------------------------------------

std::vector<Index> generation_nodes(Builder& builder, const Row& row) {
  if (row.integer("id") == 0) return all_nodes(builder.model);
  if (row.integer("styp") == 3) {
    const auto* set = builder.node_set(row, "id");
    return set ? set->members : std::vector<Index>{};
  }
  std::vector<Index> parts;
  if (row.integer("styp") == 1) {
    if (const auto* set = builder.part_set(row, "id")) parts = set->members;
  } else if (const Index part = builder.part(row, "id"); part != none) {
    parts = {part};
  }
  std::vector<Index> nodes = nodes_of_parts(builder.model, parts);
  // A rigid body moves as one, with its merged parts and extra nodes.
  for (const Index part : parts)
    if (const Index body = builder.model.parts[static_cast<std::size_t>(part)].rigid_body; body != none) {
      const auto& carried = builder.model.rigid_bodies[static_cast<std::size_t>(body)].nodes;
      nodes.insert(nodes.end(), carried.begin(), carried.end());
    }
  make_unique(nodes);
  if (row.integer("ivatn") == 1) {
    std::vector<Index> bodies;
    for (const Index node : nodes) bodies.push_back(builder.body_of_node[static_cast<std::size_t>(node)]);
    make_unique(bodies);
    for (const Index body : bodies)
      if (body != none) {
        const auto& carried = builder.model.rigid_bodies[static_cast<std::size_t>(body)].nodes;
        nodes.insert(nodes.end(), carried.begin(), carried.end());
      }
    make_unique(nodes);
  }
  return nodes;
}

/// Direction of the axis in global axes, not normalized; through two nodes where NX = -999.
Vec3d generation_axis(Builder& builder, const Block& block, const Row& row1, const Row& row2) {
  if (row2.real("nx") != -999.0)
    return in_global(builder, row1, velocity_of(block, row2, row1.integer("icid") != 0, "nx", "ny", "nz"));
  const Index from = builder.node(row2, "ny"), to = builder.node(row2, "nz");
  if (from == none || to == none) return {};
  return builder.model.nodes.x[static_cast<std::size_t>(to)] - builder.model.nodes.x[static_cast<std::size_t>(from)];
}

void generate(Builder& builder, const Block& block, const Row& row1, const Row& row2) {
  Motion motion;
  motion.velocity = in_global(builder, row1, velocity_of(block, row1, row1.integer("icid") != 0, "vx", "vy", "vz"));
  if (const double omega = row1.real("omega"); omega != 0.0) {
    const Vec3d axis = generation_axis(builder, block, row1, row2);
    if (norm(axis) == 0.0)
      return refuse(builder, row2, "nx", "the axis of rotation has no length", "give its direction, or two nodes");
    motion.spin = omega * unit(axis);
    // The axis goes through the first of its two nodes; XC, YC, ZC are for the other form.
    const Index first = row2.real("nx") == -999.0 ? builder.node(row2, "ny") : none;
    motion.center = first == none ? position(block, row2, "xc", "yc", "zc")
                                  : builder.model.nodes.x[static_cast<std::size_t>(first)];
    motion.turns = true;
  }
  const bool overwrites = row2.integer("irigid") == 1;
  Starter(builder, row1, "id").start(generation_nodes(builder, row1), motion, [&](Index) { return overwrites; });
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
    const Row row1 = cursor.read(cursor.peek_number(1) == 2.0 ? generation_of_part : generation_of_set);
    const Row row2 = cursor.read(cursor.peek_number(3) == -999.0 ? generation_by_nodes : generation_card2);
    builder.defer(Phase::conditions, [&block, row1, row2](Builder& b) { generate(b, block, row1, row2); });
    if (row2.integer("phase") == 0)
      builder.defer(Phase::checks, [row2](Builder& b) {
        if (b.model.control.relaxation.on())
          row2.report(b.findings, Severity::note, "phase",
                      "the velocity begins after dynamic relaxation, as with 1; LS-DYNA has it in the relaxation too");
      });
  }
}

}  // namespace

std::vector<Keyword> initial_keywords() {
  return {
      {"INITIAL_VELOCITY",
       {},
       {},
       KeywordStatus::used,
       {},
       {{{}, &velocity_card1}, {{}, &velocity_card2}, {"if NSIDEX > 0", &velocity_card3}},
       read_velocity},
      {"INITIAL_VELOCITY_NODE", {}, {}, KeywordStatus::used, {}, {{{}, &node_card}}, read_node_velocity},
      {"INITIAL_VELOCITY_RIGID_BODY", {}, {}, KeywordStatus::used, {}, {{{}, &body_card}}, read_body_velocity},
      {"INITIAL_VELOCITY_GENERATION",
       {},
       {},
       KeywordStatus::used,
       {},
       {{{}, &generation_of_set}, {{}, &generation_card2}},
       read_generation},
  };
}

}  // namespace nugget::reading
