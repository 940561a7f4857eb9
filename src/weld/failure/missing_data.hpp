// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/finding.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld::failure {

/// What welds lack for the failure that their material asks for (a sheet, a thickness, a strength), as warnings: those
/// that make_function gives at the start of a run, for a deck that has errors and is not run.
void report_missing_data(const model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld::failure
