// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace nugget::output {

/// Removes from `directory` the files that this program writes, by their exact names (run.log, summary.json, d3plot,
/// d3plot01, binout0000, swforc, ...), and nothing else, so that results of two runs are never mixed. A directory that
/// is not there is none. Returns what was removed, in alphabetical order; throws WriteError where a file resists.
std::vector<std::filesystem::path> remove_old_results(const std::filesystem::path& directory);

}  // namespace nugget::output
