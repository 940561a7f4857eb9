// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "weld/audit/audit.hpp"
#include "weld/tie/ties.hpp"

// The audit of the welds as text: short for 5 welds and for 5,000.
namespace nugget::app {

/// How many welds of which kind, a line per check with the range of its value and its worst welds, what the welds cost.
/// Empty where there are no welds.
std::string audit_table(const model::Model& model, const weld::Ties& ties, const std::vector<weld::Report>& reports);

/// How many welds of which kind: `4 beams, 2 assemblies of bricks`.
std::string weld_kinds(const weld::Ties& ties);

/// A line per weld with its remarks: of all welds if they are few, else of those with the worst remarks.
std::string weld_table(const model::Model& model, const weld::Ties& ties, const std::vector<weld::Report>& reports);

/// What it takes to run the welds with this time step: by mass, or by stiffness.
std::string target_table(const model::Model& model, const weld::Ties& ties, const std::vector<weld::Report>& reports,
                         double step);

}  // namespace nugget::app
