// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "reading/builder/passes.hpp"

namespace nugget::reading {
namespace {

/// Nodes that the deck leaves free: no body, support or motion says how they start.
std::vector<char> free_nodes(const Builder& b) {
  std::vector<char> free(b.model.nodes.size(), 1);
  for (std::size_t n = 0; n < free.size(); ++n)
    if (b.body_of_node[n] != none) free[n] = 0;
  for (const SinglePointConstraint& spc : b.model.spcs)
    if (spc.node != none) free[spc.node] = 0;
  for (const PrescribedMotion& motion : b.model.motions)
    for (const Index node : motion.nodes) free[node] = 0;
  return free;
}

/// Elements of one kind that join free nodes that start moving with free nodes that start at rest.
class PartlyMovingElements {
 public:
  explicit PartlyMovingElements(const Builder& b)
      : m_(b.model), free_(free_nodes(b)), in_partly_moving_part_(m_.parts.size(), 0) {}

  template <class Elements>
  void check(const Elements& elements, const char* kind) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      bool moves = false, stands = false;
      for (const Index n : elements.nodes(e)) {
        if (n == none || free_[n] == 0) continue;
        (norm(m_.initial_velocity[n]) > 0.0 ? moves : stands) = true;
      }
      if (!moves || !stands) continue;
      if (count_++ == 0) first_ = fmt::format("{} {}", kind, elements.id[e]);
      if (elements.part[e] != none) in_partly_moving_part_[elements.part[e]] = 1;
    }
  }

  int count() const { return count_; }
  const std::string& first() const { return first_; }
  std::string parts() const {
    std::string ids;
    int written = 0;
    for (std::size_t p = 0; p < in_partly_moving_part_.size(); ++p) {
      if (in_partly_moving_part_[p] == 0) continue;
      if (++written > 10) return ids + ", ...";
      ids += fmt::format("{}{}", ids.empty() ? "" : ", ", m_.parts[p].id);
    }
    return ids;
  }

 private:
  const Model& m_;
  std::vector<char> free_, in_partly_moving_part_;
  int count_ = 0;
  std::string first_;
};

}  // namespace

void check_initial_velocities(Builder& b) {
  const Model& m = b.model;
  const auto moving =
      std::count_if(m.initial_velocity.begin(), m.initial_velocity.end(), [](const Vec3d& v) { return norm(v) > 0.0; });
  if (moving == 0) return;
  PartlyMovingElements partly_moving(b);
  partly_moving.check(m.shells, "shell");
  partly_moving.check(m.solids, "solid");
  if (partly_moving.count() == 0) return;
  const auto block = std::find_if(b.deck.blocks.begin(), b.deck.blocks.end(),
                                  [](const auto& k) { return k.keyword.starts_with("INITIAL_VELOCITY"); });
  b.findings.warning(
      block == b.deck.blocks.end() ? Place{m.deck, 0, 0} : block->place, "*INITIAL_VELOCITY",
      fmt::format(
          "{} elements (the first is {}) of parts {} join nodes that start moving with nodes that start at rest; "
          "{} of the {} nodes have an initial velocity",
          partly_moving.count(), partly_moving.first(), partly_moving.parts(), moving, m.nodes.size()),
      "the difference is a shock at time 0; if the parts are to move as wholes, give the velocity by parts with "
      "*INITIAL_VELOCITY_GENERATION");
}

}  // namespace nugget::reading
