// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/strains.hpp"

#include <utility>
#include <variant>

#include "base/index.hpp"
#include "impact/conditions/preloads.hpp"
#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/c0_triangle.hpp"
#include "model/axes.hpp"
#include "model/bond.hpp"
#include "system/shell_elements.hpp"
#include "system/thick_shell_element.hpp"

namespace nugget::impact {
namespace {

using Of = system::StrainRule::Of;

Frame3d frame_of(const system::ElementGroup& group, std::size_t e, const system::State& now) {
  const auto nodes = group.nodes(e);
  std::array<Vec3d, 4> x{};
  for (std::size_t a = 0; a < at(group.nodes_per_element); ++a) x[a] = vec(now.x[at(nodes[a])]);
  return group.nodes_per_element == 4 ? kernel::shell_frame(x) : kernel::triangle_frame({x[0], x[1], x[2]});
}

system::StrainRule rule_for(const model::Model& model, const system::ElementGroup& group) {
  const model::Part& part = model.parts[group.part];
  system::StrainRule rule;
  if (group.kind == model::ElementKind::shell) {
    const std::vector<double> places = layer_places(model, group);
    rule.of = Of::shells;
    rule.lower = places.front();
    rule.upper = places.back();
    rule.follows_bubbles = group.nodes_per_element == 3 &&
                           system::triangle_formulation(model.shell_sections[part.section], model.control) == 17;
    for (const model::Index e : group.element) rule.offset.push_back(model.shells.offset(e));
  } else if (group.kind == model::ElementKind::solid && !model::bond_of(model, part)) {  // a bond has separations
    rule.of = Of::solids;
    if (!model.has_thick_shells(group.part)) return rule;
    const kernel::LayerRule layers = system::layer_rule(*model.solid_sections[part.section].thickness, model.control);
    rule.of = Of::thick_shells;
    rule.upper = layers.zeta[at(layers.count - 1)];
    rule.lower = -rule.upper;
  }
  return rule;
}

/// Whose in-plane components xx yy xy yz zx in a shell's frame stand from number `first` on.
Strain global_strain(const system::System& system, const system::ElementGroup& group, std::size_t e, std::size_t first,
                     int layer, const system::State& now) {
  std::array<double, 5> strain;
  for (std::size_t c = 0; c < strain.size(); ++c) strain[c] = group.strain(e, first + c);
  const model::Material& material = system.model.materials[system.model.parts[group.part].material];
  const auto stress = group.layer(e, layer, now).stress;
  const double in_plane = stress[0] + stress[1] + stress[2];
  const auto* layers = std::get_if<kernel::Laminate>(&material.law);
  const double E = layers ? (*layers->layers)[at(layer)].law.E : material.young(),
               nu = layers ? (*layers->layers)[at(layer)].law.nu : material.poisson();
  const double zz = -(strain[0] + strain[1]) + (E > 0.0 ? (1.0 - 2.0 * nu) / E * in_plane : 0.0);
  const auto [g0, g1, g2, g3, g4, g5] =
      model::to_global({strain[0], strain[2], strain[4], strain[1], strain[3], zz}, frame_of(group, e, now));
  return {g0, g3, g5, g1, g4, g2};
}

Strain tensor_from(const system::ElementGroup& group, std::size_t e, std::size_t first) {
  Strain strain;
  for (std::size_t c = 0; c < strain.size(); ++c) strain[c] = group.strain(e, first + c);
  return strain;
}

bool adds_up(const system::ElementGroup& group, Of of) {
  return group.strain_rule() != nullptr && group.strain_rule()->of == of;
}

}  // namespace

void add_up_strains(system::System& system) {
  for (const auto& group : system.groups)
    if (system::StrainRule rule = rule_for(system.model, *group); rule.of != Of::nothing)
      group->add_up_strains(std::move(rule));
}

void start_strains(system::System& system, const system::State& state) {
  for (const model::InitialStrain& initial : system.model.initial_state.shell_strains) {
    const system::System::ElementLocation location = system.shell_location[initial.shell];
    if (location.group < 0) continue;
    system::ElementGroup& group = *system.groups[at(location.group)];
    if (!adds_up(group, Of::shells)) continue;
    const std::size_t e = at(location.element);
    const Frame3d frame = frame_of(group, e, state);
    for (const bool upper : {false, true}) {
      const auto [xx, yy, xy, xz, yz] = system::local_stress(frame, upper ? initial.upper : initial.lower);
      const std::array<double, 5> own{xx, yy, xy, yz, xz};
      for (std::size_t c = 0; c < own.size(); ++c) group.set_strain(e, (upper ? own.size() : 0) + c, own[c]);
    }
  }
}

FaceStrains shell_strains(const system::System& system, const system::ElementGroup& group, std::size_t e,
                          const system::State& now) {
  if (!adds_up(group, Of::shells)) return {};
  return {global_strain(system, group, e, 0, 0, now), global_strain(system, group, e, 5, group.layers() - 1, now)};
}

Strain solid_strain(const system::ElementGroup& group, std::size_t e) {
  return adds_up(group, Of::solids) ? tensor_from(group, e, 0) : Strain{};
}

FaceStrains thick_shell_strains(const system::ElementGroup& group, std::size_t e) {
  if (!adds_up(group, Of::thick_shells)) return {};
  return {tensor_from(group, e, 6), tensor_from(group, e, 12)};
}

}  // namespace nugget::impact
