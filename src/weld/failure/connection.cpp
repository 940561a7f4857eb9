// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/connection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "model/weld_function.hpp"
#include "weld/failure/function.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

model::WeldFunctionInput function_input(const model::Model& model, int area_rule, const failure::Geometry& weld) {
  model::WeldFunctionInput input{{}, 0.0, connection_area(area_rule, weld.area, weld.thinner())};
  for (std::size_t k = 0; k < 2; ++k)
    if (const Index material = material_of_sheet(model, weld.sheet[k]); material != none)
      input.sheet[k] = model::welded_sheet(model.materials[material], weld.thickness[k]);
  return input;
}

ConnectionRecord record_by_functions(const model::Model& model, const model::ConnectionProperties& properties,
                                     const model::WeldFunctionInput& input) {
  const auto number = [&](Index function, double otherwise) {
    return function == none ? otherwise : model::value_of(model.functions[function].formula, input);
  };
  const auto strength = [&](Index function) {
    model::RateValue of_rate{number(function, 0.0), {}};
    if (function == none || !model.functions[function].formula.uses(model::rate_argument)) return of_rate;
    of_rate.function = [&formula = model.functions[function].formula, input](double rate) {
      model::WeldFunctionInput now = input;
      now.rate = rate;
      return model::value_of(formula, now);
    };
    return of_rate;
  };
  const model::ConnectionProperties::Functions& f = *properties.functions;
  ConnectionRecord record = properties.standard;
  record.yield = number(f.yield, 0.0);
  record.tangent_modulus = number(f.tangent_modulus, 0.0);
  record.normal = strength(f.normal);
  record.bending = strength(f.bending);
  record.shear = strength(f.shear);
  record.normal_exponent = number(f.normal_exponent, 1.0);
  record.bending_exponent = number(f.bending_exponent, 1.0);
  record.shear_exponent = number(f.shear_exponent, 1.0);
  record.fading_energy = number(f.fading_energy, 0.0);
  return record;
}

const ConnectionRecord& of_sheet(const model::ConnectionProperties& properties, model::Index material) {
  const auto own = std::find_if(properties.records.begin(), properties.records.end(),
                                [&](const ConnectionRecord& r) { return r.material == material; });
  return material == model::none || own == properties.records.end() ? properties.standard : *own;
}

/// What decides between the records of two sheets, least first: RANK, then strengths, those that are left out behind
/// all others.
auto precedence(const ConnectionRecord& r) {
  const auto strength = [](const model::RateValue& v) {
    return v.given() ? v.value : std::numeric_limits<double>::infinity();
  };
  return std::tuple{r.rank, strength(r.shear), strength(r.normal), strength(r.bending), r.yield};
}

}  // namespace

const ConnectionRecord& connection_record(const model::ConnectionProperties& properties,
                                          std::array<model::Index, 2> sheet_materials) {
  const ConnectionRecord& a = of_sheet(properties, sheet_materials[0]);
  const ConnectionRecord& b = of_sheet(properties, sheet_materials[1]);
  return precedence(b) < precedence(a) ? b : a;
}

ConnectionRecord connection_record(const model::Model& model, const model::ConnectionProperties& properties,
                                   const failure::Geometry& weld) {
  if (properties.functions)
    return record_by_functions(model, properties, function_input(model, properties.area_rule, weld));
  return connection_record(properties,
                           {material_of_sheet(model, weld.sheet[0]), material_of_sheet(model, weld.sheet[1])});
}

void check_functions(const model::Model& model, const model::ConnectionProperties& properties,
                     const failure::Geometry& weld, const Place& place, Findings& findings) {
  const model::WeldFunctionInput input = function_input(model, properties.area_rule, weld);
  model::WeldFunctionInput turned = input;
  std::swap(turned.sheet[0], turned.sheet[1]);
  const bool yields = std::ranges::all_of(input.sheet, [](const model::WeldedSheet& s) { return s.yield > 0.0; });
  const std::string card = "*DEFINE_CONNECTION_PROPERTIES";
  const auto text = [&](Index function, std::string_view name, const std::string& what) {
    return fmt::format("weld {}: {} by function {}: {}", weld.id, name, model.functions[function].id, what);
  };
  const model::ConnectionProperties::Functions& f = *properties.functions;
  for (const auto& [function, name, above_zero] : {std::tuple{f.yield, "SIGY", false},
                                                   {f.tangent_modulus, "ETAN", false},
                                                   {f.normal, "SN", false},
                                                   {f.bending, "SB", false},
                                                   {f.shear, "SS", false},
                                                   {f.normal_exponent, "EXSN", true},
                                                   {f.bending_exponent, "EXSB", true},
                                                   {f.shear_exponent, "EXSS", true},
                                                   {f.fading_energy, "GFAD", false}}) {
    if (function == none) continue;
    const Formula& formula = model.functions[function].formula;
    const double value = model::value_of(formula, input), other = model::value_of(formula, turned);
    if (model::asks_for_yield(formula) && !yields)
      findings.error(place, card,
                     text(function, name, "it asks for the yield stress of both sheets, one of which has none"),
                     "tie the weld to sheets that yield, or give a function without sy1 to sm2");
    else if (!std::isfinite(value) || value < 0.0 || (above_zero && value == 0.0))
      findings.error(place, card, text(function, name, fmt::format("it gives {:.6g} for these sheets", value)),
                     "correct the function");
    else if (std::abs(value - other) > 1e-9 * std::abs(value))
      findings.warning(
          place, card,
          text(function, name,
               fmt::format("{:.6g} with the sheet of its first end as sheet 1, {:.6g} with the other", value, other)),
          "which sheet LS-DYNA takes first is not known: let it not matter, min and max do");
  }
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
  return connection_points(law, connection_record(model, properties, g), area, g.area);
}

}  // namespace nugget::weld
