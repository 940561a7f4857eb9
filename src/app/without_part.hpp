// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/finding.hpp"
#include "model/model.hpp"

namespace nugget::app {

/// A note that lists what of the deck takes no part in modes and responses over frequency: contacts, walls, loads,
/// initial velocities, damping. `statics_first`: loads act in the linear statics of a preload (NEIG below 0).
void note_what_takes_no_part(const model::Model& model, bool statics_first, Findings& findings);

}  // namespace nugget::app
