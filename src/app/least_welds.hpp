// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/units.hpp"
#include "nvh/eigen/weld_drop.hpp"

namespace nugget::app {

/// `nugget modes --least-welds SHARE`: takes out weld after weld, that one first without which the first elastic
/// frequency stays highest, as long as this is at least `share` of what it was. A greedy search: each step goes by
/// estimates (nvh::drop_welds) of the structure as it has become and is then solved; other welds than these may do, or
/// fewer. Writes least_welds.csv, returns a table. Throws Factorization::SolverError.
std::string find_least_welds(const std::filesystem::path& directory, const nvh::Matrices& matrices,
                             const nvh::Modes& modes, double share, const std::optional<model::Units>& units,
                             const nvh::ProgressCallback& progress);

}  // namespace nugget::app
