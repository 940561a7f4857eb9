// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "kernel/law/law_components.hpp"
#include "model/lumped_mass.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/passes.hpp"

namespace nugget::reading {
namespace {

constexpr unsigned translations = 7u, rotations = 56u;  // bits of SinglePointConstraint::fixed

bool cannot_turn(const RigidBody& body) {
  return (body.fixed & rotations) == rotations;
}

/// Where a body's centre is, and how far a node may be off it; kept for the body that was asked for last.
class Center {
 public:
  explicit Center(Builder& builder) : b_(builder) {}
  bool is_at(const RigidBody& body, Index node) {
    if (&body != body_) find(body);
    return norm(place(node) - center_) <= 1e-6 * size_;
  }

 private:
  void find(const RigidBody& body) {
    body_ = &body;
    center_ = center_of_mass(b_, body);
    size_ = 0.0;
    for (const Index n : body.nodes) size_ = std::max(size_, norm(place(n) - center_));
  }
  const Vec3d& place(Index node) const { return b_.model.nodes.x[node]; }

  Builder& b_;
  const RigidBody* body_ = nullptr;
  Vec3d center_;
  double size_ = 0.0;
};

/// Whether an SPC in global axes may be added to what holds the body: not to codes in local ones (CMO = -1), and not to
/// a rigid weld, which may come apart.
bool takes_global_codes(const RigidBody& body) {
  const Frame3d& a = body.fixed_axes;
  return body.origin != RigidBody::Origin::weld && a.e1.x == 1.0 && a.e2.y == 1.0 && a.e3.z == 1.0;
}

RigidBody& body_of(Builder& b, Index node) {
  return b.model.rigid_bodies[b.body_of_node[node]];
}

/// One finding about some nodes of an SPC, which names the first.
void report_nodes(Builder& b, const deck::Entry& field, Severity severity, const std::vector<Index>& nodes,
                  std::string_view what, std::string_view remedy) {
  if (nodes.empty()) return;
  field.report(b.findings, severity,
               fmt::format("node {} belongs to rigid body {}, which moves as one: {} ({} such node{})",
                           b.model.nodes.id[nodes.front()], body_of(b, nodes.front()).id, what, nodes.size(),
                           nodes.size() == 1 ? "" : "s"),
               remedy);
}

/// The translations, when all rotations that are held are known: a body that cannot turn has one velocity.
void constrain_translations(Builder& b, const deck::Entry& field, unsigned fixed, const std::vector<Index>& nodes) {
  std::vector<Index> constrained, left;
  Center center(b);
  for (const Index node : nodes) {
    RigidBody& body = body_of(b, node);
    const bool exact = (fixed & translations) == 0 || cannot_turn(body) || center.is_at(body, node);
    if (exact) body.fixed |= fixed & translations;
    (exact ? constrained : left).push_back(node);
  }
  report_nodes(b, field, Severity::note, constrained, "the body is held; spcforc has no such reaction", {});
  report_nodes(b, field, Severity::warning, left, "its translation is not held",
               "hold the body by CMO of *MAT_RIGID, or _SPC of the nodal rigid body");
}

/// Whether every direction has inertia. Where one has none, or less, a moment about it turns the body without bound.
bool is_positive_definite(const std::array<double, 6>& i) {
  const double trace = i[0] + i[3] + i[5], two = i[0] * i[3] - i[1] * i[1];
  const double all =
      i[0] * (i[3] * i[5] - i[4] * i[4]) - i[1] * (i[1] * i[5] - i[2] * i[4]) + i[2] * (i[1] * i[4] - i[2] * i[3]);
  constexpr double least = 1e-9;
  return i[0] > least * trace && two > least * trace * trace && all > least * trace * trace * trace;
}

/// What elements that deform have at the nodes of bodies whose mass is given: these have that and no more.
void report_mass_beside_given(Builder& b) {
  const std::vector<RigidBody>& bodies = b.model.rigid_bodies;
  if (std::none_of(bodies.begin(), bodies.end(), [](const RigidBody& body) { return body.given; })) return;
  struct Beside {
    double mass = 0.0;
    std::vector<int> parts;
  };
  std::vector<Beside> beside(bodies.size());
  const auto by_part = model::lumped_masses(b.model);
  for (std::size_t p = 0; p < by_part.size(); ++p) {
    const Index material = b.model.parts[p].material;
    if (material == none || std::holds_alternative<kernel::Rigid>(b.model.materials[material].law)) continue;
    for (const auto& [node, mass] : by_part[p]) {
      const Index body = b.body_of_node[node];
      if (body == none || !bodies[body].given || !(mass > 0.0)) continue;
      Beside& of = beside[at(body)];
      of.mass += mass;
      if (of.parts.empty() || of.parts.back() != b.model.parts[p].id) of.parts.push_back(b.model.parts[p].id);
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!(beside[i].mass > 0.0)) continue;
    const double own = bodies[i].inertia.mass;
    constexpr double slight = 0.01;
    b.findings.add({beside[i].mass > slight * own ? Severity::warning : Severity::note,
                    bodies[i].place,
                    "",
                    {},
                    {},
                    fmt::format("the mass of {} is given, {:.6g}: the mass {:.6g} of the elements of part{} {} at its "
                                "nodes takes no part",
                                name_of(bodies[i]), own, beside[i].mass, beside[i].parts.size() == 1 ? "" : "s",
                                fmt::join(beside[i].parts, " ")),
                    "add it to TM, and to the tensor of inertia, if it is not in them"});
  }
}

}  // namespace

void constrain_bodies(Builder& builder, const deck::Entry& field, const SinglePointConstraint& spc,
                      std::vector<Index>& nodes) {
  const auto in_body = [&](Index n) { return builder.body_of_node[n] != none; };
  const bool plain = spc.system == none && spc.birth <= 0.0 && spc.death >= forever;
  std::vector<Index> taken, left;
  for (const Index node : nodes)
    if (in_body(node)) (plain && takes_global_codes(body_of(builder, node)) ? taken : left).push_back(node);
  std::erase_if(nodes, in_body);
  report_nodes(builder, field, Severity::warning, left, "nothing is prescribed to it",
               "hold the body by CMO of *MAT_RIGID, or _SPC of the nodal rigid body");
  if (taken.empty()) return;
  for (const Index node : taken) body_of(builder, node).fixed |= spc.fixed & rotations;
  builder.defer(Phase::checks,
                [field, fixed = spc.fixed, taken](Builder& b) { constrain_translations(b, field, fixed, taken); });
}

void check_inertia(Builder& builder) {
  report_mass_beside_given(builder);
  for (const RigidBody& body : builder.model.rigid_bodies) {
    if (!body.given || is_positive_definite(body.inertia.inertia)) continue;
    const bool harmless = cannot_turn(body);
    builder.findings.add(
        {harmless ? Severity::note : Severity::error,
         body.place,
         body.origin == RigidBody::Origin::part ? "*PART_INERTIA" : "*CONSTRAINED_NODAL_RIGID_BODY_INERTIA",
         {},
         {},
         fmt::format("the tensor of inertia of {} is not that of a body: it is not positive definite{}", name_of(body),
                     harmless ? "; this body cannot turn, so it does not matter" : ""),
         harmless ? ""
                  : "give its moments about the centre, and products that are smaller than these; "
                    "0 for products that are not known"});
  }
}

void release_driven_bodies(Builder& b) {
  for (const PrescribedMotion& motion : b.model.motions) {
    if (motion.rigid_body == none) continue;
    RigidBody& body = b.model.rigid_bodies[motion.rigid_body];
    const Vec3d axes[] = {body.fixed_axes.e1, body.fixed_axes.e2, body.fixed_axes.e3};
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned bit = 1u << (i + (motion.rotation ? 3u : 0u));
      const double share = std::abs(dot(motion.direction, axes[i]));
      if (!(body.fixed & bit) || share < 1e-6) continue;
      const std::string what = fmt::format("rigid body {} is held in the direction in which this drives it", body.id);
      if (share < 1.0 - 1e-6) {
        b.findings.error(motion.place, "*BOUNDARY_PRESCRIBED_MOTION", what + " in part", "free it in CON1 and CON2");
        break;  // once a motion, however many axes hold
      }
      body.fixed &= ~bit;
      b.motions_of_held_bodies.insert(static_cast<Index>(&motion - b.model.motions.data()));
      b.findings.warning(motion.place, "*BOUNDARY_PRESCRIBED_MOTION", what + ": the motion counts, nothing holds it",
                         "free it in CON1 or CON2 of *MAT_RIGID, or in the body's SPC");
    }
  }
}

}  // namespace nugget::reading
