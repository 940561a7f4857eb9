// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/held_directions.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::weld {
namespace {

/// What of a direction lies outside others counts as nothing below this share.
constexpr double nothing = 1e-9;

Vec3d outside_of(const std::vector<Vec3d>& held, Vec3d d) {
  for (const Vec3d& h : held) d -= dot(h, d) * h;
  return d;
}

}  // namespace

HeldDirections::HeldDirections(const model::Model& model) {
  for (const model::SinglePointConstraint& spc : model.spcs) {
    if (spc.fixed == 0 || !model.holds_at_start(spc)) continue;
    Node& node = of_[spc.node];
    const Frame3d local =
        spc.system == none ? Frame3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}} : model.systems[spc.system].axes;
    for (int i = 0; i < 6; ++i) {
      if (!(spc.fixed >> i & 1u)) continue;
      std::vector<Vec3d>& held = i < 3 ? node.translation : node.rotation;
      const Vec3d left = outside_of(held, i % 3 == 0 ? local.e1 : i % 3 == 1 ? local.e2 : local.e3);
      if (norm(left) > nothing) held.push_back(unit(left));
    }
  }
}

bool HeldDirections::holds(Index node, bool rotation, const Vec3d& direction) const {
  const auto found = of_.find(node);
  const double size = norm(direction);
  if (found == of_.end()) return size == 0.0;
  return norm(outside_of(rotation ? found->second.rotation : found->second.translation, direction)) <= nothing * size;
}

bool HeldDirections::hold_alike(const Tie& tie, const std::vector<Vec3d>& x) const {
  const auto own = of_.find(tie.node);
  if (own == of_.end()) return true;
  const Vec3d gap = x[tie.node] - tie.point;
  std::vector<Index> nodes = carriers(tie);
  if (tie.couples) nodes.assign(tie.segment.begin(), tie.segment.end());  // all of them turn it
  const auto all = [&](auto&& held) { return std::all_of(nodes.begin(), nodes.end(), held); };
  const auto holds_all_translations = [&](Index n) {
    return holds(n, false, {1, 0, 0}) && holds(n, false, {0, 1, 0}) && holds(n, false, {0, 0, 1});
  };
  if (tie.couples && !all(holds_all_translations)) {
    if (!own->second.rotation.empty() && tie.rotations) return false;
    if (norm(gap) > 0.0) return false;
  }
  const auto turns_nowhere = [&](Index n, const Vec3d& about) { return tie.couples || holds(n, true, about); };
  for (const Vec3d& d : own->second.translation)
    if (!all([&](Index n) {
          const Vec3d arm = arm_from(tie, x[n], gap), about = cross(arm, d);
          const bool turned = norm(about) > nothing * (norm(gap) + norm(x[n] - tie.point));
          return holds(n, false, d) && (!turned || turns_nowhere(n, about));
        }))
      return false;
  if (!tie.rotations) return true;
  for (const Vec3d& d : own->second.rotation)
    if (!all([&](Index n) { return turns_nowhere(n, d); })) return false;
  return true;
}

}  // namespace nugget::weld
