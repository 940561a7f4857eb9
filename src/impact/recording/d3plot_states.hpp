// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "impact/simulation/snapshot.hpp"
#include "output/d3plot.hpp"

namespace nugget::impact {

/// The model at one moment. Rigid and null shells have no stresses; deleted elements keep their last values.
output::D3plotState d3plot_state(const Snapshot& now);

}  // namespace nugget::impact
