// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/run_data.hpp"

// What the page says of welds.
namespace nugget::report {

/// A cell of a row; empty where it has none.
std::string cell(const WeldRow& weld, std::string_view column);

/// What became of a weld: `failed at 0.0041 s by axial force`, `not tied`, `near failure`, `holds`, `no failure value`.
/// `summary`: of its run, for the unit of time.
std::string verdict(const WeldRow& weld, const nlohmann::json& summary);
/// Whether two runs came to different ones; failures differ by their mode.
bool verdicts_differ(const WeldRow& a, const WeldRow& b);

/// Failed welds by time, those that are not tied, then by their largest failure value.
std::vector<const WeldRow*> worst_first(const std::vector<WeldRow>& welds);

/// How many welds ended how, and a table of all. HTML.
std::string welds_part(const RunData& run);

/// Lines of the first screen: welds that are not tied; how many failed, the first one; or the one nearest to it. HTML.
void conclude_welds(const RunData& run, std::vector<std::string>& lines);

}  // namespace nugget::report
