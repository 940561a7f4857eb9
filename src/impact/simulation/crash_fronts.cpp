// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/crash_fronts.hpp"

#include <span>

#include "base/index.hpp"

namespace nugget::impact {
namespace {

/// Calls `visit` with each node of an element.
template <class Visit>
void for_each_node(const system::ElementGroup& group, std::size_t e, Visit&& visit) {
  const system::ElementNodes nodes = group.nodes(e);
  for (const int node : std::span(nodes).first(at(group.nodes_per_element))) visit(node);
}

}  // namespace

CrashFronts::CrashFronts(const system::System& system) {
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const system::ElementGroup& group = *system.groups[g];
    if (group.crash_front_fields().empty()) continue;
    groups_.push_back(g);
    known_.emplace_back(group.size(), char{0});
    for (std::size_t e = 0; e < group.size(); ++e)
      for_each_node(group, e, [&](int node) { at_node_[node].push_back({g, e}); });
  }
}

void CrashFronts::update(const system::System& system) {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const system::ElementGroup& group = *system.groups[groups_[i]];
    for (std::size_t e = 0; e < group.size(); ++e) {
      if (known_[i][e] != 0 || group.alive(e)) continue;
      known_[i][e] = 1;
      for_each_node(group, e, [&](int node) {
        for (const Element& beside : at_node_.at(node)) {
          system::ElementGroup& other = *system.groups[beside.group];
          for (const int field : other.crash_front_fields()) other.set_number(beside.element, field, 1.0);
        }
      });
    }
  }
}

void CrashFronts::archive(Archive& a) {
  a(known_);
  a.built(groups_, at_node_);
}

}  // namespace nugget::impact
