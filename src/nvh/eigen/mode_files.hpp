// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "nvh/eigen/modes.hpp"
#include "output/ascii.hpp"

namespace nugget::nvh {

/// Translations of all nodes of the model in each mode, 3 numbers a node.
Columns nodal_shapes(const Matrices& matrices, const Modes& modes);

/// d3eigv (each mode a state, the frequency as its time, coordinates plus mass-normalized shape), eigout,
/// mode_energy.csv (share of each part and weld in the strain energy of each mode). Throws output::WriteError.
void write_modes(const std::filesystem::path& directory, const output::Header& header, const Matrices& matrices,
                 const Modes& modes, const EnergyShares& shares);

}  // namespace nugget::nvh
