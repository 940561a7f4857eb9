// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "impact/simulation/snapshot.hpp"
#include "output/d3plot.hpp"

namespace nugget::impact {

/// Puts the model at one moment into the words of a state. Rigid and null shells have no stresses; deleted elements
/// keep their last values.
void put_state(const Snapshot& now, output::D3plotWords& words);

}  // namespace nugget::impact
