// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/nodal_force_groups.hpp"

#include "impact/conditions/axes_now.hpp"

namespace nugget::impact {

NodalForceGroups::NodalForceGroups(const system::System& system) : system_(system) {
  const auto& cards = system.model.requests.nodal_force_groups;
  if (cards.empty()) return;
  std::vector<std::vector<Corner>> at_node(system.all_nodes());
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const system::ElementGroup& group = *system.groups[g];
    for (std::size_t e = 0; e < group.size(); ++e) {
      const auto nodes = group.nodes(e);
      for (int a = 0; a < group.nodes_per_element; ++a)
        at_node[nodes[a]].push_back({{static_cast<int>(g), static_cast<int>(e)}, a});
    }
  }
  for (const model::NodalForceGroup& card : cards) {
    Group group{&card, {}};
    for (const model::Index n : card.nodes) group.nodes.push_back({n, at_node[system.node_of[n]], {}, 0.0});
    groups_.push_back(std::move(group));
  }
}

void NodalForceGroups::update(const system::State& state) {
  for (Group& group : groups_)
    for (Node& node : group.nodes) {
      Vec3d force{};
      for (const Corner& c : node.corners) force += system_.nodal_force(c.location, c.corner);
      node.work += 0.5 * state.dt * dot(node.force + force, vec(state.v[system_.node_of[node.node]]));
      node.force = force;
    }
}

output::NodforState NodalForceGroups::state(const system::State& now) const {
  output::NodforState s;
  s.time = now.time;
  for (const Group& group : groups_) {
    output::NodforGroup out{group.card->set_id, {}, {}};
    for (const Node& node : group.nodes) out.rows.push_back({system_.model.nodes.id[node.node], node.force, node.work});
    if (group.card->system != model::none) out.axes = axes_now(system_, now, group.card->system);
    s.groups.push_back(std::move(out));
  }
  return s;
}

void NodalForceGroups::Node::archive(Archive& a) {
  a(force, work);
  a.built(node, corners);
}

void NodalForceGroups::Group::archive(Archive& a) {
  a(nodes);
  a.built(card);
}

void NodalForceGroups::archive(Archive& a) {
  a(groups_);
  a.built(system_);
}

}  // namespace nugget::impact
