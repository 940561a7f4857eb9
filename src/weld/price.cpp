// SPDX-License-Identifier: Apache-2.0
#include "weld/price.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "weld/welds.hpp"

namespace nugget::weld {
namespace {

Price beam_price(const model::Model& model, const Weld& weld, const model::Material& material) {
  const model::SectionBeam& section = model.beam_sections[model.parts[weld.part].section];
  double area = 0.0;
  for (int end = 0; end < 2; ++end)
    area +=
        0.125 * std::numbers::pi * (section.outer[end] * section.outer[end] - section.inner[end] * section.inner[end]);
  Price price;
  price.young = std::abs(material.young());
  price.time_step = weld.length / std::sqrt(price.young / material.density);
  price.mass = (material.density * area + section.extra_mass) * weld.length;
  return price;
}

Price brick_price(const model::Model& model, const std::vector<Vec3d>& x, const Weld& weld,
                  const model::Material& material) {
  const double volume = 0.25 * std::numbers::pi * weld.diameter * weld.diameter * weld.length;
  double largest = 0.0;
  for (const auto& pair : opposite_faces(model.solids.node[weld.element]))
    for (const auto& face : pair)
      largest = std::max(largest, 0.5 * norm(cross(x[face[2]] - x[face[0]], x[face[3]] - x[face[1]])));
  Price price;
  price.young = std::abs(material.young());
  const double nu = material.poisson();
  const double speed = std::sqrt(price.young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu) * material.density));
  price.time_step = largest > 0.0 ? volume / largest / speed : 0.0;
  price.mass = material.density * volume;
  return price;
}

/// Mass times the factor that lifts a time step to `wanted`, less the mass; the step goes with sqrt(density).
double mass_to_reach(double wanted, double step, double mass) {
  return step > 0.0 && step < wanted ? mass * ((wanted / step) * (wanted / step) - 1.0) : 0.0;
}

}  // namespace

Price price(const model::Model& model, const std::vector<Vec3d>& x, const Weld& weld) {
  if (weld.kind == Weld::Kind::rigid) return {};
  const model::Material& material = model.materials[model.parts[weld.part].material];
  Price price =
      weld.kind == Weld::Kind::beam ? beam_price(model, weld, material) : brick_price(model, x, weld, material);
  const double dt = std::get<kernel::Spotweld>(material.law).mass_step;
  price.mass_by_dt = mass_to_reach(dt, price.time_step, price.mass);
  const double target = std::abs(model.control.mass_step * model.control.step_scale);
  price.mass_by_dt2ms = mass_to_reach(target, std::max(price.time_step, dt), price.mass + price.mass_by_dt);
  return price;
}

Target reach(const Price& price, double step) {
  const double share = price.time_step < step ? price.time_step / step : 1.0;
  return {mass_to_reach(step, price.time_step, price.mass), price.young * share * share};
}

}  // namespace nugget::weld
