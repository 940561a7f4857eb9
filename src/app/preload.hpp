// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/finding.hpp"
#include "impact/simulation/simulation.hpp"
#include "nvh/matrices/matrices.hpp"

namespace nugget::app {

/// What the deck asks of a preload, and does not get; called before the findings are reported. `after`: the explicit
/// run that comes before, if any.
void check_preload(const model::Model& model, const impact::Simulation* after, Findings& findings);

/// Adds geometric stiffness to K where the deck asks for it (IGS 1): of the stresses in which the explicit run `after`
/// has ended; else of those that the deck begins with, and where NEIG is below 0 of its linear static solution. Returns
/// a table for run.log. Throws Factorization::SolverError.
std::string stiffen_by_preload(nvh::Matrices& matrices, const impact::Simulation* after = nullptr);

}  // namespace nugget::app
