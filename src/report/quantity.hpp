// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/card.hpp"
#include "model/units.hpp"
#include "output/history.hpp"

namespace nugget::report {

/// The units that summary.json names, if any.
std::optional<model::Units> units_of_run(const nlohmann::json& summary);

/// Unit of a quantity behind a number, ` N mm`, by the units that summary.json names; nothing where they are not known.
std::string unit_of(const nlohmann::json& summary, const Dimension& dimension);
/// The same in a heading: ` [N mm]`.
std::string in_units(const nlohmann::json& summary, const Dimension& dimension);
/// Of frequencies in a heading: ` [Hz]`.
std::string in_frequency(const nlohmann::json& summary);
/// ` Hz` or ` kHz`; ` cycles a unit of time` where the units are not known.
std::string frequency_unit(const nlohmann::json& summary);

}  // namespace nugget::report
