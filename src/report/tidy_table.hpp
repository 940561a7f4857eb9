// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace nugget::report {

/// Writes the histories of a folder (output::read_histories) as one tidy table: a row for each value, with the columns
/// file, entity, title, quantity, unit, time, value. Units are those of summary.json, empty where they are not known.
/// Gives the number of rows. Throws std::runtime_error where there are no histories, and output::WriteError.
std::size_t write_tidy_table(const std::filesystem::path& directory, const std::filesystem::path& file,
                             const nlohmann::json& summary);

}  // namespace nugget::report
