// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/units.hpp"
#include "nvh/eigen/weld_drop.hpp"
#include "output/summary.hpp"

// `nugget modes --drop-weld`: what each weld is worth to each mode.
namespace nugget::app {

/// Which welds are taken out: each on its own (`all`), or some together.
struct DropRequest {
  bool each = false;
  std::vector<nvh::WeldGroup> groups;
};

/// From the command's word: `all`, or ids separated by commas, which go together. A word that cannot be obeyed gives
/// none and a complaint.
std::optional<DropRequest> drop_request(const std::string& word, const system::System& system, std::string& error_text);

/// Estimates for all groups; solves anew without the welds for one group, or for the three that matter most. Writes
/// weld_drop.csv, adds to the summary, returns the tables for the terminal and run.log.
std::string weld_study(const std::filesystem::path& directory, const nvh::Matrices& matrices, const nvh::Modes& modes,
                       const DropRequest& request, const std::optional<model::Units>& units, output::Summary& summary,
                       const nvh::ProgressCallback& progress);

}  // namespace nugget::app
