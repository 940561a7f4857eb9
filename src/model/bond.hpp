// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/law/cohesive_bond.hpp"
#include "model/model.hpp"

// Adhesive: parts of cohesive bricks.
namespace nugget::model {

/// The law of cohesive bricks that a material has; null: it has another.
const kernel::CohesiveBond* bond_of(const Material& material);
/// The same of a part of solids.
const kernel::CohesiveBond* bond_of(const Model& model, const Part& part);

/// Formulations of cohesive bricks, by *SECTION_SOLID.
inline bool is_cohesive(int elform) {
  return elform >= 19 && elform <= 22;
}
inline bool is_between_shells(int elform) {
  return elform == 20 || elform == 22;
}

/// Whether a solid is a cohesive brick whose nodes turn.
bool bond_between_shells(const Model& model, std::size_t solid);

/// Places of the eight corners of a solid at the start [length].
std::array<Vec3d, 8> corners_of(const Model& model, std::size_t solid);

/// Mass of a cohesive brick [mass].
double bond_mass(const Model& model, std::size_t solid, const kernel::CohesiveBond& bond);

}  // namespace nugget::model
