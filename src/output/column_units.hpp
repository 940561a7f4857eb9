// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "model/units.hpp"

namespace nugget::output {

/// What a column of one of our comma-separated tables holds.
struct ColumnQuantity {
  std::string_view quantity;  ///< `force`, `failure value`, `share of the strain energy`
  Dimension dimension;        ///< of a frequency a rate: cycles a unit of time
  std::string_view unit;      ///< where it does not depend on the deck's: `degree`; else empty
  bool a_frequency = false;
};

/// Of the column `name` of `file` (`welds.csv`); nothing of ids and words, which need no unit, and of what is no column
/// of ours.
std::optional<ColumnQuantity> column_quantity(std::string_view file, std::string_view name);

/// Of the amplitude of a response, as frf.csv, ssd.csv and summary.json name it: of an acceleration for `acceleration`.
/// Of a frequency response it is that to a load of amplitude 1 in the deck's units.
Dimension dimension_of_response(std::string_view response);

/// A column's unit: `N mm`, `Hz`, `degree`; `-` of a number without one; empty where the deck's units are not known.
std::string unit_of_column(const ColumnQuantity& column, const std::optional<model::Units>& units);

/// units.csv: a row for each column with a quantity of each table of ours in the folder, with the columns file, column,
/// quantity, unit; where a column's unit depends on the response, a row for each response. Throws WriteError.
void write_column_units(const std::filesystem::path& directory, const std::optional<model::Units>& units);

}  // namespace nugget::output
