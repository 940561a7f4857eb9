// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "impact/simulation/sensors.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Watches *TERMINATION_NODE, _BODY and _SENSOR. Why the run ends at the time of `state`; empty: it does not. The
/// switches are those of this time.
std::string reason_to_end(const system::System& system, const system::State& state, const Sensors& sensors);

}  // namespace nugget::impact
