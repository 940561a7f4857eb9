// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "system/system.hpp"

// Strains for results (STRFLG): rates of deformation on the geometry of mid-step, added up by the element groups in
// axes that turn with the element (system::BlockStrains). In a stretch along fixed axes they are the logarithmic
// strains. Components xx yy zz xy yz zx in global axes; xy is half the angle. Laws do not need them, so they cost
// something only where they are asked for.
namespace nugget::impact {

using Strain = std::array<double, 6>;
/// At the lowest and the uppermost integration point of a shell or a thick shell.
struct FaceStrains {
  Strain lower{}, upper{};
};

/// From the next cycle on the groups of shells and solids add up strains.
void add_up_strains(system::System& system);
/// The strains of *INITIAL_STRAIN_SHELL, at time 0.
void start_strains(system::System& system, const system::State& state);

// Of element e of a group; 0 where none are added up. Through the thickness a shell's strain follows from its stress:
// what changes the volume is elastic, zz = -(xx + yy) + (1 - 2 nu)/E (s_xx + s_yy).
FaceStrains shell_strains(const system::System& system, const system::ElementGroup& group, std::size_t e,
                          const system::State& now);
Strain solid_strain(const system::ElementGroup& group, std::size_t e);
FaceStrains thick_shell_strains(const system::ElementGroup& group, std::size_t e);

}  // namespace nugget::impact
