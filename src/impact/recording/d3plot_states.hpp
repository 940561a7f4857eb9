// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "impact/recording/result_parcels.hpp"
#include "impact/simulation/snapshot.hpp"
#include "output/d3plot.hpp"

namespace nugget::impact {

/// Puts the model at one moment into the words of a state, piece by piece in the order of the file: `take` gets them on
/// the process that writes, others give theirs to it. Rigid and null shells have no stresses; deleted elements keep
/// their last values.
void put_state(const Snapshot& now, const output::D3plotLayout& layout, ResultParcels& parcels,
               const std::function<void(std::string)>& take);

}  // namespace nugget::impact
