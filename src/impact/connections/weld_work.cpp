// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/weld_work.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace nugget::impact {

WeldWork::WeldWork(const system::System& system, const weld::Weld& weld) {
  const std::vector<model::Index> only{weld.element};
  for (const model::Index e : weld.elements.empty() ? only : weld.elements) {
    const system::System::ElementLocation location = system.location_of(weld, e);
    if (location.group < 0) continue;
    const system::ElementGroup& group = *system.groups[location.group];
    const system::ElementNodes nodes = group.nodes(at(location.element));
    for (int a = 0; a < group.nodes_per_element; ++a)
      for (int end = 0; end < 2; ++end) {
        const std::vector<model::Index>& face = weld.face[end];
        if (std::find(face.begin(), face.end(), system.model_node[nodes[a]]) != face.end())
          corners_.push_back({location, a, nodes[a], end, {}, {}});
      }
  }
}

void WeldWork::add_step(const system::System& system, const system::State& state) {
  for (Corner& c : corners_) {
    const Vec3d force = system.nodal_force(c.location, c.corner), moment = system.nodal_moment(c.location, c.corner);
    taken_[c.end] +=
        0.5 * state.dt * (dot(c.force + force, vec(state.v[c.node])) + dot(c.moment + moment, vec(state.w[c.node])));
    c.force = force;
    c.moment = moment;
  }
  if (std::abs(passed()) > std::abs(most_)) most_ = passed();
}

void WeldWork::add(const std::array<double, 2>& at_end) {
  for (std::size_t end = 0; end < 2; ++end) taken_[end] += at_end[end];
}

void WeldWork::reset() {
  taken_ = {};
  most_ = 0.0;
}

void WeldWork::archive(Archive& a) {
  a(corners_, taken_, most_);
}

}  // namespace nugget::impact
