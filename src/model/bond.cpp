// SPDX-License-Identifier: Apache-2.0
#include "model/bond.hpp"

#include "kernel/element/cohesive_brick.hpp"
#include "kernel/law/law_components.hpp"

namespace nugget::model {

const kernel::CohesiveBond* bond_of(const Material& material) {
  const auto* law = std::get_if<kernel::ComposedLaw>(&material.law);
  return law == nullptr ? nullptr : law->components->bond.get();
}

const kernel::CohesiveBond* bond_of(const Model& model, const Part& part) {
  if (part.kind != ElementKind::solid || part.material == none) return nullptr;
  return bond_of(model.materials[part.material]);
}

bool bond_between_shells(const Model& model, std::size_t solid) {
  const Part& part = model.parts[model.solids.part[solid]];
  return part.section != none && bond_of(model, part) != nullptr &&
         is_between_shells(model.solid_sections[part.section].elform);
}

std::array<Vec3d, 8> corners_of(const Model& model, std::size_t solid) {
  std::array<Vec3d, 8> x;
  for (std::size_t a = 0; a < 8; ++a) x[a] = model.nodes.x[model.solids.node[solid][a]];
  return x;
}

double bond_mass(const Model& model, std::size_t solid, const kernel::CohesiveBond& bond) {
  const Part& part = model.parts[model.solids.part[solid]];
  const double density = model.materials[part.material].density;
  return kernel::cohesive_brick_mass({density, false}, bond, corners_of(model, solid));
}

}  // namespace nugget::model
