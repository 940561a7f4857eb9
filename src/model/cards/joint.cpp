// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "model/cards/families.hpp"
#include "model/cards/reading.hpp"
#include "model/rigid_bodies.hpp"

// *CONSTRAINED_JOINT_..., *CONTROL_RIGID. Layouts: keywords.md section 9.
namespace nugget::model {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card joint_card{{
    id("n1", IdSpace::node, required, "node of body A at the joint"),
    id("n2", IdSpace::node, required, "node of body B at the same place"),
    id("n3", IdSpace::node, 0, "node of body A: n1 to n3 is the joint's axis"),
    id("n4", IdSpace::node, 0, "node of body B at the place of n3; universal: n2 to n4 is the other axis"),
    id("n5", IdSpace::node, 0, "node of body A off the axis (translational, locking)"),
    id("n6", IdSpace::node, 0, "node of body B at the place of n5"),
    real("rps", dimension::number, 1, above_zero(), "factor on the penalty stiffness; 2 is the most that is stable"),
    real("damp", dimension::number, 1, between(0, 5), "factor on the damping; up to 0.01: none"),
}};

const Card rigid_card{{
    integer("lmf", 0, between(0, 1), "joints: 0 penalty, 1 Lagrange multipliers (not built)"),
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
    unused(),
}};

using Kind = Joint::Kind;

/// How many pairs of nodes a joint has.
std::size_t pairs(Kind kind) {
  switch (kind) {
    case Kind::spherical: return 1;
    case Kind::translational:
    case Kind::locking: return 3;
    default: return 2;
  }
}

constexpr std::array<std::string_view, 6> node_fields{"n1", "n2", "n3", "n4", "n5", "n6"};

/// The nodes and the two rigid bodies that they belong to; false and a finding where that fails.
bool find_bodies(Builder& b, const Row& row, Joint& joint) {
  const std::size_t count = 2 * pairs(joint.kind);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view field = node_fields[i];
    joint.node[i] = b.node(row, field);
    if (joint.node[i] == none) {
      if (row.integer(field) == 0)
        refuse(b, row, field, fmt::format("this joint has {} pairs of nodes", count / 2), "give the node");
      return false;
    }
    const Index body = b.body_of_node[static_cast<std::size_t>(joint.node[i])];
    if (body == none) {
      refuse(b, row, field, "a joint joins rigid bodies, but this node is on none",
             "make it a node of a *MAT_RIGID part (*CONSTRAINED_EXTRA_NODES) or of a *CONSTRAINED_NODAL_RIGID_BODY");
      return false;
    }
    Index& side = joint.body[i % 2];
    if (side == none) side = body;
    if (side != body) {
      refuse(b, row, field, fmt::format("this node is not on the body of {}", node_fields[i % 2]),
             "odd nodes belong to body A, even ones to body B");
      return false;
    }
  }
  if (joint.body[0] != joint.body[1]) return true;
  refuse(b, row, "n2", "both nodes belong to the same rigid body", "take the second node from the other body");
  return false;
}

bool check_places(Builder& b, const Row& row, const Joint& joint) {
  const auto place = [&](std::size_t i) { return b.model.nodes.x[static_cast<std::size_t>(joint.node[i])]; };
  const std::size_t count = pairs(joint.kind);
  const Vec3d axis = count > 1 ? place(2) - place(0) : Vec3d{};
  if (count > 1 && !(norm(axis) > 0.0)) {
    refuse(b, row, "n3", "n1 and n3 are at one place, so the joint has no axis", "take nodes far apart");
    return false;
  }
  // Decks write coordinates with a few digits.
  const double near = 1e-3 * (count > 1 ? norm(axis) : 1.0);
  const std::size_t coincident = joint.kind == Kind::universal ? 1 : count;
  for (std::size_t p = 0; p < coincident; ++p) {
    if (norm(place(2 * p + 1) - place(2 * p)) <= near) continue;
    refuse(b, row, node_fields[2 * p + 1],
           fmt::format("{} and {} are to be at one place, but they are {:g} apart", node_fields[2 * p],
                       node_fields[2 * p + 1], norm(place(2 * p + 1) - place(2 * p))),
           "give both the same coordinates");
    return false;
  }
  if (joint.kind == Kind::universal) {
    const Vec3d other = place(3) - place(1);
    if (!(norm(other) > 0.0) || std::abs(dot(axis, other)) > 0.02 * norm(axis) * norm(other)) {
      refuse(b, row, "n4", "the axes n1 to n3 and n2 to n4 must be perpendicular", "see the nodes' coordinates");
      return false;
    }
  }
  if (count == 3 && !(norm(cross(axis, place(4) - place(0))) > 1e-6 * dot(axis, axis))) {
    refuse(b, row, "n5", "n5 lies on the axis n1 to n3, so it holds no rotation", "take a node off the axis");
    return false;
  }
  return true;
}

void add_joint(Builder& b, const Row& row, Joint joint) {
  joint.stiffness_scale = row.real("rps");
  joint.damping = row.real("damp") > 0.01 ? row.real("damp") : 0.0;
  if (joint.id == 0) joint.id = static_cast<int>(b.model.joints.size()) + 1;
  if (joint.stiffness_scale > 2.0)
    row.complain(b.findings, Severity::warning, "rps", "computed with 2, the most that is stable", "write 2 or less");
  if (find_bodies(b, row, joint) && check_places(b, row, joint)) b.model.joints.push_back(std::move(joint));
}

template <Kind kind>
void read_joint(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    Joint joint;
    joint.kind = kind;
    const Heading heading = read_heading(cursor, options.contains("ID") || options.contains("TITLE"));
    joint.id = heading.id;
    joint.title = heading.text;
    const Row row = cursor.read(joint_card);
    joint.place = row.place();
    b.later(Phase::conditions, [row, joint](Builder& later) { add_joint(later, row, joint); });
  }
}

void read_control(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const Row row = cursor.read(rigid_card);
  b.later(Phase::checks, [row](Builder& later) {
    if (row.integer("lmf") == 1 && !later.model.joints.empty())
      refuse(later, row, "lmf", "joints by Lagrange multipliers are not built", "write 0: joints by penalty");
  });
}

template <Kind kind>
Keyword joint(std::string_view name) {
  return {.name = name,
          .options = {"ID", "TITLE"},
          .layout = {{"with _ID", &heading_card}, {"", &joint_card}},
          .read = read_joint<kind>};
}

}  // namespace

std::vector<Keyword> joint_keywords() {
  const auto refused = [](std::string_view name, std::string_view why) {
    return Keyword{.name = name, .verdict = Verdict::refused, .why = why};
  };
  return {
      joint<Kind::spherical>("CONSTRAINED_JOINT_SPHERICAL"),
      joint<Kind::revolute>("CONSTRAINED_JOINT_REVOLUTE"),
      joint<Kind::cylindrical>("CONSTRAINED_JOINT_CYLINDRICAL"),
      joint<Kind::planar>("CONSTRAINED_JOINT_PLANAR"),
      joint<Kind::universal>("CONSTRAINED_JOINT_UNIVERSAL"),
      joint<Kind::translational>("CONSTRAINED_JOINT_TRANSLATIONAL"),
      joint<Kind::locking>("CONSTRAINED_JOINT_LOCKING"),
      refused("CONSTRAINED_JOINT_*",
              "this joint is not built; SPHERICAL, REVOLUTE, CYLINDRICAL, PLANAR, UNIVERSAL, TRANSLATIONAL and LOCKING "
              "are, without further options"),
      {.name = "CONTROL_RIGID", .layout = {{"", &rigid_card}}, .read = read_control},
  };
}

}  // namespace nugget::model
