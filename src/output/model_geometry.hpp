// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/d3plot.hpp"
#include "system/system.hpp"

namespace nugget::output {

/// What of the model goes into the head of the d3plot families.
D3plotGeometry d3plot_geometry(const system::System& system);
/// By solid: 1 where it is a thick shell; empty where none is.
std::vector<char> thick_shells(const model::Model& model);
/// The model at rest, elements without stresses; velocities and accelerations are left empty.
D3plotState unstressed_state(const system::System& system, const D3plotGeometry& geometry);

}  // namespace nugget::output
