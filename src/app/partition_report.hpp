// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "impact/simulation/simulation.hpp"

namespace nugget::app {

/// How so many ranks would share out the elements: a table, and partition.vtu with the rank of each element (-1: every
/// rank computes it). Throws WriteError.
std::string report_partition(const std::filesystem::path& directory, impact::Simulation& run, int ranks);

}  // namespace nugget::app
