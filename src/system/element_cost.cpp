// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <variant>

#include "kernel/law/laws.hpp"
#include "system/partition.hpp"

namespace nugget::system {
namespace {

using model::ElementKind;

/// Cost of a cycle [ns]: of an element whatever its law, and what each of its layers adds, elastic or yielding.
/// Measured by bench/element_costs.py on a Xeon of 2023 with four lanes.
struct Cost {
  ElementKind kind;
  int corners, form;
  double base, elastic_layer, yielding_layer;
};
constexpr std::array costs{
    Cost{ElementKind::shell, 4, 2, 43.0, 1.2, 10.0},    Cost{ElementKind::shell, 4, 16, 62.0, 6.7, 50.0},
    Cost{ElementKind::shell, 4, 5, 38.0, 0.0, 2.0},     Cost{ElementKind::shell, 4, 9, 100.0, 0.0, 50.0},
    Cost{ElementKind::shell, 3, 4, 30.0, 1.0, 13.0},    Cost{ElementKind::shell, 3, 17, 50.0, 1.5, 41.0},
    Cost{ElementKind::solid, 8, 1, 79.0, 0.0, 0.0},     Cost{ElementKind::solid, 8, 2, 170.0, 0.0, 45.0},
    Cost{ElementKind::solid, 8, -1, 217.0, 0.0, 3.0},   Cost{ElementKind::solid, 8, -2, 235.0, 0.0, 129.0},
    Cost{ElementKind::solid, 4, 10, 45.0, 0.0, 10.0},   Cost{ElementKind::solid, 4, 13, 58.0, 0.0, 8.0},
    Cost{ElementKind::solid, 10, 16, 132.0, 0.0, 20.0}, Cost{ElementKind::solid, 4, 4, 132.0, 0.0, 20.0},
    Cost{ElementKind::solid, 8, 105, 92.0, 10.0, 19.0}, Cost{ElementKind::solid, 8, 101, 95.0, 1.5, 10.0},
    Cost{ElementKind::solid, 8, 102, 140.0, 9.0, 38.0}, Cost{ElementKind::solid, 8, 103, 125.0, 28.0, 62.0},
    Cost{ElementKind::beam, 2, 1, 34.0, 0.0, 39.0},     Cost{ElementKind::beam, 2, 3, 14.0, 0.0, 3.0},
};
constexpr int of_thick_shells = 100;  ///< added to their ELFORM
constexpr double of_others = 80.0, of_springs = 20.0, single_precision = 0.7;

int form_of(const model::Model& model, const ElementGroup& group) {
  const model::Part& part = model.parts[group.part];
  if (part.section == model::none) return 0;
  switch (group.kind) {
    case ElementKind::shell: return model.shell_sections[part.section].elform;
    case ElementKind::solid: {
      const model::SectionSolid& section = model.solid_sections[part.section];
      return section.thickness ? of_thick_shells + section.elform : section.elform;
    }
    case ElementKind::beam: return model.beam_sections[part.section].elform;
    default: return 0;
  }
}

}  // namespace

double element_cost(const System& system, const ElementGroup& group) {
  if (group.kind == ElementKind::discrete) return of_springs;
  const int form = form_of(system.model, group);
  const auto same_element = [&](const Cost& c) { return c.kind == group.kind && c.corners == group.nodes_per_element; };
  const auto same = [&](const Cost& c) { return same_element(c) && c.form == form; };
  // A formulation that is not in the table costs what the first of its kind does.
  const Cost* cost = std::find_if(costs.begin(), costs.end(), same);
  if (cost == costs.end()) cost = std::find_if(costs.begin(), costs.end(), same_element);
  if (cost == costs.end()) return of_others;
  const model::Index material = system.model.parts[group.part].material;
  const bool elastic =
      material != model::none && std::holds_alternative<kernel::Elastic>(system.model.materials[material].law);
  // Layers of other solids and of beams are points that their base has already.
  const bool layered = group.kind == ElementKind::shell || system.model.has_thick_shells(group.part);
  const double layers = layered ? std::max(1, group.layers()) : 1;
  const double sum = cost->base + layers * (elastic ? cost->elastic_layer : cost->yielding_layer);
  return group.single_precision() ? single_precision * sum : sum;
}

}  // namespace nugget::system
