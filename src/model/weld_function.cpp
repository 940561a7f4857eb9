// SPDX-License-Identifier: Apache-2.0
#include "model/weld_function.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>

#include "model/sheet_yield.hpp"

namespace nugget::model {

WeldedSheet welded_sheet(const Material& material, double thickness) {
  const Strength strength = strength_of(material);
  return {thickness, strength.yield, strength.tensile, material.young()};
}

std::string wrong_arguments(const Formula& function) {
  const std::vector<std::string>& names = function.argument_names();
  bool right = !names.empty() && names.size() <= weld_function_names.size();
  for (std::size_t i = 0; right && i < names.size(); ++i) right = names[i] == weld_function_names[i];
  return right ? std::string() : fmt::format("its arguments are ({})", fmt::join(names, ", "));
}

bool asks_for_yield(const Formula& function) {
  return function.uses(2) || function.uses(3) || function.uses(4) || function.uses(5);
}

double value_of(const Formula& function, const WeldFunctionInput& input) {
  const auto& [first, second] = input.sheet;
  const std::array<double, weld_function_names.size()> all{first.thickness, second.thickness, first.yield, second.yield,
                                                           first.strength,  second.strength,  input.rate,  input.area,
                                                           first.young,     second.young};
  return function(std::span(all).first(static_cast<std::size_t>(function.arguments())));
}

}  // namespace nugget::model
