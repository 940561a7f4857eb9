// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "impact/snapshot.hpp"
#include "output/d3plot.hpp"

namespace nugget::impact {

/// What of the model goes into the head of the d3plot family.
output::D3plotGeometry d3plot_geometry(const system::System& system);
/// The model at one moment. Rigid and null shells have no stresses; deleted elements keep their last values.
output::D3plotState d3plot_state(const Snapshot& now);

}  // namespace nugget::impact
