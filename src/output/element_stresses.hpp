// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/d3plot.hpp"
#include "system/system.hpp"

namespace nugget::output {

/// Stresses and plastic strains of all elements, resultants of shells and beams, as their kernels hold them. Sizes the
/// records; those of elements without a kernel are left as they are.
void fill_stresses(const system::System& system, const system::State& state, D3plotState& into);

}  // namespace nugget::output
