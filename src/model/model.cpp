// SPDX-License-Identifier: Apache-2.0
#include "model/model.hpp"

#include <algorithm>

#include "kernel/law/law_components.hpp"

namespace nugget::model {

Model::Model() = default;
Model::Model(const Model&) = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(const Model& other) {
  return *this = Model(other);
}
Model& Model::operator=(Model&&) noexcept = default;
Model::~Model() = default;

double Material::young() const {
  return std::visit([](const auto& l) { return l.E; }, law);
}

double Material::poisson() const {
  return std::visit([](const auto& l) { return l.nu; }, law);
}

double Material::contact_young() const {
  const auto* composed = std::get_if<kernel::ComposedLaw>(&law);
  const double own = composed ? composed->components->contact_modulus : 0.0;
  return own > 0.0 ? own : young();
}

std::vector<Index> Solids::corners(std::size_t e) const {
  std::vector<Index> different;
  for (const Index n : node[e])
    if (std::find(different.begin(), different.end(), n) == different.end()) different.push_back(n);
  return different;
}

std::vector<Index> Solids::different_nodes(std::size_t e) const {
  return quadratic(e) ? std::vector<Index>(ten(e).begin(), ten(e).end()) : corners(e);
}

Index Model::node_index(int id) const {
  const auto at = std::lower_bound(nodes.id.begin(), nodes.id.end(), id);
  return at == nodes.id.end() || *at != id ? none : static_cast<Index>(at - nodes.id.begin());
}

Index Model::part_index(int id) const {
  const auto at = std::find_if(parts.begin(), parts.end(), [id](const Part& p) { return p.id == id; });
  return at == parts.end() ? none : static_cast<Index>(at - parts.begin());
}

Index Model::curve_index(int id) const {
  const auto at = std::find_if(curves.begin(), curves.end(), [id](const Curve& c) { return c.id == id; });
  return at == curves.end() ? none : static_cast<Index>(at - curves.begin());
}

bool Model::has_thick_shells(Index part) const {
  const Part& p = parts[part];
  return p.kind == ElementKind::solid && p.section != none && solid_sections[p.section].thickness.has_value();
}

bool Model::has_membranes(Index part) const {
  const Part& p = parts[part];
  if (p.kind != ElementKind::shell || p.section == none || p.material == none) return false;
  const Law& law = materials[p.material].law;
  return is_membrane(shell_sections[p.section].elform) && !std::holds_alternative<kernel::Rigid>(law) &&
         !std::holds_alternative<kernel::Null>(law);
}

}  // namespace nugget::model
