// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "app/frf.hpp"
#include "app/linear_job.hpp"
#include "impact/simulation/simulation.hpp"

namespace nugget::app {

struct LinearChecks {
  Analysis analysis = Analysis::statics;
  bool responses = true;                      ///< those that the deck asks for are computed
  const impact::Simulation* after = nullptr;  ///< the explicit run that comes before, if any
};

/// What a linear analysis refuses and warns of when its equations are set up, and none is solved: the analyses ask
/// here, and so does `nugget check`.
void check_linear(LinearJob& job, const LinearChecks& checks, Findings& findings);

/// Errors of the modes behind an explicit run (IMFLAG 6), before it: they must not show at its end.
void check_modes_after(const std::filesystem::path& directory, const RunArguments& arguments, const PreparedDeck& p,
                       const impact::Simulation& run, Findings& findings);

}  // namespace nugget::app
