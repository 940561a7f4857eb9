// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "model/rigid_bodies.hpp"

namespace nugget::model {
namespace {

constexpr unsigned translations = 7u, rotations = 56u;  // bits of SinglePointConstraint::fixed

/// Turns SPCs on nodes of bodies into constraints of the bodies.
class Holder {
 public:
  explicit Holder(Builder& builder) : b_(builder), model_(builder.model) {
    for (const RigidBody& body : model_.rigid_bodies) center_.push_back(center_of_mass(model_, body));
  }

  void hold() {
    count_.assign(model_.rigid_bodies.size(), 0);
    // Rotations first: a body that cannot turn has one velocity, so translations may then be held at any node.
    for (SinglePointConstraint& spc : model_.spcs)
      if (RigidBody* body = held_body(spc)) take(spc, *body, rotations);
    for (SinglePointConstraint& spc : model_.spcs)
      if (RigidBody* body = held_body(spc); body && (at_center(spc, *body) || (body->fixed & rotations) == rotations))
        take(spc, *body, translations);
    std::erase_if(model_.spcs, [](const SinglePointConstraint& spc) { return spc.fixed == 0; });
    tell();
  }

 private:
  /// The body that the SPC may hold: it must act all the time, in global axes.
  RigidBody* held_body(const SinglePointConstraint& spc) {
    const Index owner = b_.body_of_node[static_cast<std::size_t>(spc.node)];
    if (owner == none || spc.system != none || spc.birth > 0.0 || spc.death < forever) return nullptr;
    RigidBody& body = model_.rigid_bodies[static_cast<std::size_t>(owner)];
    return body.origin == RigidBody::Origin::weld ? nullptr : &body;
  }

  std::size_t index(const RigidBody& body) const {
    return static_cast<std::size_t>(&body - model_.rigid_bodies.data());
  }

  bool at_center(const SinglePointConstraint& spc, const RigidBody& body) const {
    const auto away = [&](Index n) { return norm(model_.nodes.x[static_cast<std::size_t>(n)] - center_[index(body)]); };
    double size = 0.0;
    for (const Index n : body.nodes) size = std::max(size, away(n));
    return away(spc.node) <= 1e-6 * size;
  }

  void take(SinglePointConstraint& spc, RigidBody& body, unsigned which) {
    if ((spc.fixed & which) == 0) return;
    body.fixed |= spc.fixed & which;
    spc.fixed &= ~which;
    ++count_[index(body)];
  }

  void tell() const {
    for (std::size_t i = 0; i < count_.size(); ++i)
      if (count_[i] > 0)
        b_.findings.add({Severity::note,
                         model_.rigid_bodies[i].place,
                         "*BOUNDARY_SPC",
                         {},
                         {},
                         fmt::format("{} is held as a whole by the SPCs on its nodes; spcforc has no reaction of it",
                                     name_of(model_.rigid_bodies[i])),
                         {}});
  }

  Builder& b_;
  Model& model_;
  std::vector<Vec3d> center_;  // by body
  std::vector<int> count_;     // by body: SPCs taken
};

/// Whether every direction has inertia. Where one has none, or less, a moment about it turns the body without bound.
bool is_positive_definite(const std::array<double, 6>& i) {
  const double trace = i[0] + i[3] + i[5], two = i[0] * i[3] - i[1] * i[1];
  const double all =
      i[0] * (i[3] * i[5] - i[4] * i[4]) - i[1] * (i[1] * i[5] - i[2] * i[4]) + i[2] * (i[1] * i[4] - i[2] * i[3]);
  constexpr double least = 1e-9;
  return i[0] > least * trace && two > least * trace * trace && all > least * trace * trace * trace;
}

}  // namespace

void hold_bodies(Builder& builder) {
  Holder(builder).hold();
  for (const RigidBody& body : builder.model.rigid_bodies) {
    if (!body.given || is_positive_definite(body.inertia.inertia)) continue;
    const bool can_turn = (body.fixed & rotations) != rotations;
    builder.findings.add(
        {can_turn ? Severity::error : Severity::note,
         body.place,
         "",
         {},
         {},
         fmt::format("the tensor of inertia of {} is not that of a body: it is not positive definite{}", name_of(body),
                     can_turn ? "" : "; this body cannot turn, so it does not matter"),
         can_turn ? "give its moments about the centre, and products that are smaller than these; "
                    "0 for products that are not known"
                  : ""});
  }
}

}  // namespace nugget::model
