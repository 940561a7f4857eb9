// SPDX-License-Identifier: Apache-2.0
#include "weld/audit/mass_scaling_cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "kernel/element/hexahedron.hpp"
#include "model/discrete_beam_section.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

MassScalingCost beam_cost(const model::Model& model, const Weld& weld, const model::Material& material) {
  const model::SectionBeam& section = model.beam_sections[model.parts[weld.part].section];
  double area = 0.0;
  for (int end = 0; end < 2; ++end)
    area +=
        0.125 * std::numbers::pi * (section.outer[end] * section.outer[end] - section.inner[end] * section.inner[end]);
  MassScalingCost cost;
  cost.young = std::abs(material.young());
  cost.time_step = weld.length / std::sqrt(cost.young / material.density);
  cost.mass = (material.density * area + section.extra_mass) * weld.length;
  return cost;
}

/// The step of a brick at rest contains the linear bulk viscosity: L / c / (Q2 + sqrt(1 + Q2^2)).
double viscous_share(const model::Model& model, const model::Part& part) {
  const model::Hourglass& h = part.hourglass == none ? model.control.hourglass : model.hourglass[part.hourglass];
  return 1.0 / (h.bulk_linear + std::sqrt(1.0 + h.bulk_linear * h.bulk_linear));
}

MassScalingCost brick_cost(const model::Model& model, const std::vector<Vec3d>& x, const Weld& weld,
                           const model::Material& material) {
  MassScalingCost cost;
  cost.young = std::abs(material.young());
  const double share = viscous_share(model, model.parts[weld.part]);
  for (Index e : weld.elements) {
    std::array<Vec3d, 8> corner;
    for (std::size_t i = 0; i < 8; ++i) corner[i] = x[model.solids.node[e][i]];
    const double step = kernel::hexahedron_stable_step(corner, cost.young, material.poisson(), material.density);
    cost.time_step = std::min(cost.time_step, share * step);
    cost.mass += 8.0 * kernel::hexahedron_nodal_mass(corner, material.density);
  }
  return cost;
}

MassScalingCost connector_cost(const model::Model& model, const Weld& weld) {
  const model::Part& part = model.parts[weld.part];
  const model::SectionBeam& section = model.beam_sections[part.section];
  const model::Material& material = model.materials[part.material];
  const auto& law = std::get<kernel::DiscreteBeam>(material.law);
  const kernel::DiscreteBeamProperties beam = model::discrete_beam_properties(section, material, law);
  MassScalingCost cost;
  cost.time_step = kernel::discrete_beam_stable_step(beam, law, weld.length);
  cost.mass = beam.mass;
  return cost;
}

/// Whether the deck says what the weld is made of; always, unless it has errors.
bool has_cost(const model::Model& model, const Weld& weld) {
  const model::Part& part = model.parts[weld.part];
  return part.material != none && (part.section != none || weld.of_bricks());
}

/// Mass times the factor that lifts a time step to `wanted`, less the mass; the step goes with sqrt(density).
double mass_to_add(double wanted, double step, double mass) {
  return step > 0.0 && step < wanted ? mass * ((wanted / step) * (wanted / step) - 1.0) : 0.0;
}

/// Of a weld without DT: with DT2MS > 0 an element gets exactly its step, and may lose mass.
double mass_by_dt2ms(const model::Model& model, double target, double step, double mass) {
  if (!(model.control.mass_step > 0.0)) return mass_to_add(target, step, mass);
  return step > 0.0 ? mass * ((target / step) * (target / step) - 1.0) : 0.0;
}

}  // namespace

MassScalingCost mass_scaling_cost(const model::Model& model, const std::vector<Vec3d>& x, const Weld& weld) {
  if (weld.kind == Weld::Kind::rigid || !has_cost(model, weld)) return {};
  if (weld.kind == Weld::Kind::connector) {
    MassScalingCost cost = connector_cost(model, weld);
    cost.mass_by_dt2ms = mass_by_dt2ms(model, std::abs(model.control.mass_step), cost.time_step, cost.mass);
    return cost;
  }
  const model::Material& material = model.materials[model.parts[weld.part].material];
  MassScalingCost cost =
      weld.kind == Weld::Kind::beam ? beam_cost(model, weld, material) : brick_cost(model, x, weld, material);
  const double dt = std::get<kernel::Spotweld>(material.law).mass_step;
  cost.mass_by_dt = mass_to_add(dt, cost.time_step, cost.mass);
  const double target =
      std::abs(model.control.mass_step) * (scaled_to_the_step_of_the_run(model, weld) ? model.control.step_scale : 1.0);
  cost.mass_by_dt2ms = dt > 0.0 ? mass_to_add(target, std::max(cost.time_step, dt), cost.mass + cost.mass_by_dt)
                                : mass_by_dt2ms(model, target, cost.time_step, cost.mass);
  return cost;
}

StepCost cost_of_step(const MassScalingCost& cost, double step) {
  const double share = cost.time_step < step ? cost.time_step / step : 1.0;
  return {mass_to_add(step, cost.time_step, cost.mass), cost.young * share * share};
}

}  // namespace nugget::weld
