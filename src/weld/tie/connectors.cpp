// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/connectors.hpp"

#include <variant>

#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

bool discrete(const model::Model& model, Index part) {
  const Index material = model.parts[part].material;
  return material != none && std::holds_alternative<kernel::DiscreteBeam>(model.materials[material].law);
}

/// A cable only pulls: it holds no sheets together.
bool may_connect(const model::Model& model, Index part) {
  return discrete(model, part) &&
         !std::get<kernel::DiscreteBeam>(model.materials[model.parts[part].material].law).cable;
}

}  // namespace

bool joins_sheets(const model::Model& model, Index part) {
  return discrete(model, part) &&
         std::get<kernel::DiscreteBeam>(model.materials[model.parts[part].material].law).joint.has_value();
}

bool has_rivets(const model::Model& model, Index part) {
  if (!joins_sheets(model, part)) return false;
  const auto& law = std::get<kernel::DiscreteBeam>(model.materials[model.parts[part].material].law);
  return std::holds_alternative<kernel::Spr2>(*law.joint);
}

std::vector<Index> find_connectors(const model::Model& model) {
  std::vector<Index> candidates;
  for (Index e = 0; e < static_cast<Index>(model.beams.size()); ++e)
    if (may_connect(model, model.beams.part[e])) candidates.push_back(e);
  if (candidates.empty()) return {};

  std::vector<char> of_mesh(model.nodes.size(), 0), of_body(model.nodes.size(), 0);
  for (Index e = 0; e < static_cast<Index>(model.beams.size()); ++e)
    if (!may_connect(model, model.beams.part[e]) && !of_weld_material(model, model.beams.part[e]))
      for (const Index n : model.beams.node[e]) of_mesh[n] = 1;
  for (const model::Discrete& spring : model.discretes)
    for (const Index n : spring.node)
      if (n != none) of_mesh[n] = 1;
  for (const auto& nodes : model.shells.node)
    for (const Index n : nodes) of_mesh[n] = 1;
  for (const auto& nodes : model.solids.node)
    for (const Index n : nodes) of_mesh[n] = 1;
  for (const model::RigidBody& body : model.rigid_bodies)
    for (const Index n : body.nodes) of_body[n] = 1;
  std::vector<Index> found;
  for (const Index e : candidates) {
    const auto [a, b] = model.beams.node[e];
    if (!of_mesh[a] && !of_mesh[b] && !(of_body[a] && of_body[b])) found.push_back(e);
  }
  return found;
}

}  // namespace nugget::weld
