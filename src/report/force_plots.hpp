// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace nugget::report {

/// Forces of walls (rwforc) and contacts (rcforc, a side each) over time as HTML that stands still: a plot of each file
/// with the largest of them, and what each came to, with its unit. Empty where the folder has neither.
std::string force_plots(const std::filesystem::path& directory, const nlohmann::json& summary);

}  // namespace nugget::report
