// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/connection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "weld/failure/function.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

const ConnectionRecord& of_sheet(const model::ConnectionProperties& properties, model::Index material) {
  const auto own = std::find_if(properties.records.begin(), properties.records.end(),
                                [&](const ConnectionRecord& r) { return r.material == material; });
  return material == model::none || own == properties.records.end() ? properties.standard : *own;
}

}  // namespace

const ConnectionRecord& connection_record(const model::ConnectionProperties& properties,
                                          std::array<model::Index, 2> sheet_materials) {
  const ConnectionRecord& a = of_sheet(properties, sheet_materials[0]);
  const ConnectionRecord& b = of_sheet(properties, sheet_materials[1]);
  return b.rank < a.rank ? b : a;
}

const ConnectionRecord& connection_record(const model::Model& model, const model::ConnectionProperties& properties,
                                          std::array<model::Index, 2> sheets) {
  return connection_record(properties, {material_of_sheet(model, sheets[0]), material_of_sheet(model, sheets[1])});
}

model::Index material_of_sheet(const model::Model& model, model::Index sheet) {
  if (sheet == model::none || model.parts[sheet].material == model::none) return model::none;
  const int id = model.materials[model.parts[sheet].material].id;
  if (id == 0) return model.parts[sheet].material;  // of *PART_COMPOSITE, which cards cannot name
  const auto first = std::ranges::find(model.materials, id, &model::Material::id);
  return static_cast<model::Index>(first - model.materials.begin());
}

double connection_area(int area_rule, double modelled, double thinner_sheet) {
  if (area_rule == 0 || !(thinner_sheet > 0.0)) return modelled;
  const double mm = area_rule > 0 ? 1.0 : 1000.0;  // in a length unit
  const double diameter = 5.0 * std::sqrt(thinner_sheet * mm) / mm;
  return 0.25 * std::numbers::pi * diameter * diameter;
}

kernel::Spotweld connection_points(const kernel::Spotweld& law, const ConnectionRecord& record, double real_area,
                                   double modelled_area) {
  const double share = real_area / modelled_area;
  kernel::Spotweld own = law;
  own.failure_strain = 0.0;
  own.yield = record.yield > 0.0 ? share * record.yield : std::numeric_limits<double>::max();
  own.hardening = record.yield > 0.0 ? share * law.E * record.tangent_modulus / (law.E - record.tangent_modulus) : 0.0;
  return own;
}

kernel::Spotweld points_of(const model::Model& model, const Weld& weld, const kernel::Spotweld& law) {
  const model::WeldLaw& whole = law_of(model, weld);
  if (!whole.connection || whole.properties == model::none) return law;
  const model::ConnectionProperties& properties = model.connections[whole.properties];
  const failure::Geometry g = failure::geometry_of(model, weld);
  const double area = connection_area(properties.area_rule, g.area, g.thinner());
  return connection_points(law, connection_record(model, properties, weld.sheets), area, g.area);
}

}  // namespace nugget::weld
