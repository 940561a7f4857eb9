// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "impact/simulation/snapshot.hpp"
#include "output/elout.hpp"

namespace nugget::impact {

/// Stresses, strains and resultants of the elements of *DATABASE_HISTORY_... Elements without a kernel (rigid parts)
/// are not in it; deleted ones stay, without stress.
output::EloutState elout_state(const Snapshot& now);

/// LS-DYNA's number of the laws that beams can have; 0 where it is not known.
int number_of_law(const model::Material& material);

}  // namespace nugget::impact
