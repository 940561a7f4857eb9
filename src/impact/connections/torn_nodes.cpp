// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/torn_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "kernel/law/law_components.hpp"
#include "system/share.hpp"

namespace nugget::impact {
namespace {

constexpr double deleted = -1.0;

/// Whether D of GISSMO counts, in place of the plastic strain.
bool tears_by_damage(const model::Model& model, model::Index part) {
  const auto* law = std::get_if<kernel::ComposedLaw>(&model.materials[model.parts[part].material].law);
  return law != nullptr && law->components->gissmo.has_value();
}

}  // namespace

TornNodes::TornNodes(system::System& system) : system_(system) {
  const std::vector<model::TiedNodes>& all = system.model.tied_nodes;
  if (all.empty()) return;
  std::map<int, std::pair<std::size_t, std::size_t>> at_node;  // place, and which of its nodes
  for (std::size_t p = 0; p < all.size(); ++p) {
    Place& place = places_.emplace_back();
    for (const model::Index n : all[p].nodes) {
      at_node[system.node_of[n]] = {p, place.nodes.size()};
      place.nodes.push_back(system.node_of[n]);
    }
    place.around.resize(place.nodes.size());
  }
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const system::ElementGroup& group = *system.groups[g];
    if (group.kind != model::ElementKind::shell && group.kind != model::ElementKind::solid) continue;
    const double density = system.model.materials[system.model.parts[group.part].material].density;
    const bool by_damage = tears_by_damage(system.model, group.part);
    for (std::size_t e = 0; e < group.size(); ++e) {
      const system::ElementNodes nodes = group.nodes(e);
      const std::size_t number = elements_.size();
      for (int a = 0; a < group.nodes_per_element; ++a) {
        const auto found = at_node.find(nodes[a]);
        if (found == at_node.end() || all[found->second.first].kind != group.kind) continue;
        if (elements_.size() == number)
          elements_.push_back({{static_cast<int>(g), static_cast<int>(e)},
                               density > 0.0 ? group.mass(e) / density : group.mass(e),
                               by_damage});
        std::vector<std::size_t>& around = places_[found->second.first].around[found->second.second];
        if (around.empty() || around.back() != number) around.push_back(number);
      }
    }
  }
  value_.assign(elements_.size(), deleted);
}

/// Of an element that this process computes.
double TornNodes::value_of(const Element& element, const system::State& state) const {
  const system::ElementGroup& group = *system_.groups[element.location.group];
  const std::size_t e = at(element.location.element);
  if (!group.alive(e)) return deleted;
  // In axes of any kind, since strain and damage have none: those of each element would take the most time.
  static thread_local std::vector<system::ElementGroup::Layer> layers;
  layers.resize(at(group.layers()));
  group.through(e, state, Frame3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, layers);
  double sum = 0.0;
  for (const system::ElementGroup::Layer& layer : layers)
    sum += element.by_damage ? layer.damage[1] : layer.plastic_strain;
  return group.layers() > 0 ? sum / group.layers() : 0.0;
}

void TornNodes::find_values(const system::State& state) {
  parallel_for(elements_.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      value_[i] = system_.computes(elements_[i].location) ? value_of(elements_[i], state) : deleted;
  });
}

/// Places with an element that has reached EPPF: only there can the mean have. Over several ranks on all of them.
std::vector<std::size_t> TornNodes::places_beyond() const {
  std::vector<std::size_t> beyond;
  for (std::size_t p = 0; p < places_.size(); ++p) {
    const double failure = system_.model.tied_nodes[p].failure;
    const auto is_beyond = [&](std::size_t e) { return value_[e] >= failure; };
    if (std::ranges::any_of(places_[p].around,
                            [&](const auto& elements) { return std::ranges::any_of(elements, is_beyond); }))
      beyond.push_back(p);
  }
  if (system_.share() == nullptr) return beyond;
  beyond = gather_lists(system_.share()->ranks(), beyond);
  std::ranges::sort(beyond);
  beyond.erase(std::unique(beyond.begin(), beyond.end()), beyond.end());
  return beyond;
}

/// Of the elements around these places, which other ranks know.
void TornNodes::gather_values(const std::vector<std::size_t>& places) {
  const system::Share* share = system_.share();
  if (share == nullptr || places.empty()) return;
  struct Known {
    std::size_t element;
    double value;
  };
  std::set<std::size_t> wanted;
  for (const std::size_t p : places)
    for (const std::vector<std::size_t>& elements : places_[p].around) wanted.insert(elements.begin(), elements.end());
  std::vector<Known> known;
  for (const std::size_t e : wanted) {
    const system::System::ElementLocation& location = elements_[e].location;
    if (share->answers_for(location.group, at(location.element))) known.push_back({e, value_[e]});
  }
  for (const Known& k : gather_lists(share->ranks(), known)) value_[k.element] = k.value;
}

bool TornNodes::update(const system::State& state) {
  if (places_.empty()) return false;
  find_values(state);
  const std::vector<std::size_t> beyond = places_beyond();
  gather_values(beyond);
  bool any = false;
  for (const std::size_t p : beyond) any = tear(p, state) || any;
  if (any) system_.transfer_dependent_mass();
  return any;
}

bool TornNodes::tear(std::size_t p, const system::State& state) {
  Place& place = places_[p];
  const model::TiedNodes& tied = system_.model.tied_nodes[p];
  std::set<std::size_t> elements;
  for (const std::vector<std::size_t>& at_node : place.around) elements.insert(at_node.begin(), at_node.end());
  double sum = 0.0, volume = 0.0;
  for (const std::size_t e : elements) {
    if (value_[e] < 0.0) continue;
    sum += elements_[e].volume * value_[e];
    volume += elements_[e].volume;
  }
  if (!(volume > 0.0) || sum < tied.failure * volume) return false;
  std::vector<int> staying, leaving;
  std::vector<std::vector<std::size_t>> around;
  for (std::size_t i = 0; i < place.nodes.size(); ++i) {
    const auto has_failed = [&](std::size_t e) { return value_[e] >= tied.failure; };
    if (std::ranges::any_of(place.around[i], has_failed)) {
      leaving.push_back(place.nodes[i]);
    } else {
      staying.push_back(place.nodes[i]);
      around.push_back(std::move(place.around[i]));
    }
  }
  system_.part_tied_nodes(staying, leaving);
  if (staying.size() == 1) {
    leaving.push_back(staying.front());
    staying.clear();
    around.clear();
  }
  std::string free;
  for (const int node : leaving) free += fmt::format(" {}", system_.node_id(node));
  events_.push_back(fmt::format(
      "tied nodes torn  set={} time={:12.5E} cycle={} free:{}{}, mean {:.4g}", tied.set, state.time, state.cycle, free,
      staying.empty() ? std::string() : fmt::format(", {} stay tied", staying.size()), sum / volume));
  place.nodes = std::move(staying);
  place.around = std::move(around);
  return true;
}

void TornNodes::Place::archive(Archive& a) {
  a(nodes, around);
}

void TornNodes::archive(Archive& a) {
  a(places_, events_);
  a.built(system_, elements_, value_);
}

}  // namespace nugget::impact
