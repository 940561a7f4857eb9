// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "model/units.hpp"
#include "nvh/eigen/mode_comparison.hpp"

namespace nugget::app {

/// `nugget modes --compare`: a line for each mode with its partner in the other run, for the terminal and run.log.
std::string pair_table(const nvh::Modes& modes, const nvh::ModeComparison& comparison, const std::string& other,
                       const std::optional<model::Units>& units);

}  // namespace nugget::app
