// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/run_data.hpp"

// What the page says of runs over frequency: natural modes, responses.
namespace nugget::report {

/// Whether a summary is of modes or of a response over frequency.
bool of_linear_analysis(const nlohmann::json& summary);

/// Share of a part or weld in the strain energy of mode i, counted from 0.
double share_of_mode(const WeldRow& row, std::size_t i);

/// Lines of the first screen: how many modes, the first that is no motion of a rigid body, the weld with the largest
/// share of strain energy. HTML.
void conclude_modes(const RunData& run, std::vector<std::string>& lines);

/// Modes with their shares of the mass and of the strain energy, the welds ranked by the strain energy they hold and,
/// where that was asked for, by what the frequencies lose without them. Empty where there are no modes.
std::string modes_part(const RunData& run);

/// Amplitude and phase over frequency, with the peaks. Empty where there are no responses.
std::string responses_part(const RunData& run);

/// How many of the modes in summary.json, the lowest, are motions of rigid bodies: their frequencies are round-off.
std::size_t rigid_modes(const nlohmann::json& modes);

}  // namespace nugget::report
