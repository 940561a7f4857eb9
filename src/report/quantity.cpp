// SPDX-License-Identifier: Apache-2.0
#include "report/quantity.hpp"

namespace nugget::report {

std::optional<model::Units> units_of_run(const nlohmann::json& summary) {
  return model::units_named(summary.value("units", ""));
}

std::string unit_of(const nlohmann::json& summary, const Dimension& dimension) {
  return model::unit_of(units_of_run(summary), dimension);
}

std::string in_units(const nlohmann::json& summary, const Dimension& dimension) {
  return model::in_units(units_of_run(summary), dimension);
}

std::string in_frequency(const nlohmann::json& summary) {
  return model::in_frequency(units_of_run(summary));
}

std::string frequency_unit(const nlohmann::json& summary) {
  const auto units = units_of_run(summary);
  return ' ' + (units ? model::frequency_symbol(*units) : std::string("cycles a unit of time"));
}

}  // namespace nugget::report
