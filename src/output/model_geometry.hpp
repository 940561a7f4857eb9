// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/d3plot.hpp"
#include "system/system.hpp"

namespace nugget::output {

/// What of the model goes into the head of the d3plot and d3eigv families.
D3plotGeometry d3plot_geometry(const system::System& system);

}  // namespace nugget::output
