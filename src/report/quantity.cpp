// SPDX-License-Identifier: Apache-2.0
#include "report/quantity.hpp"

#include <fmt/format.h>

#include "model/units.hpp"

namespace nugget::report {

std::string unit_of(const nlohmann::json& summary, const Dimension& dimension) {
  const auto units = model::units_named(summary.value("units", ""));
  if (!units || dimension == dimension::number) return {};
  return ' ' + model::symbol(*units, dimension);
}
std::string in_units(const nlohmann::json& summary, const Dimension& dimension) {
  const std::string unit = unit_of(summary, dimension);
  return unit.empty() ? unit : fmt::format(" [{}]", unit.substr(1));
}

std::string frequency_unit(const nlohmann::json& summary) {
  const auto units = model::units_named(summary.value("units", ""));
  return ' ' + (units ? model::frequency_symbol(*units) : std::string("cycles a unit of time"));
}

}  // namespace nugget::report
