// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "output/ascii.hpp"

namespace nugget::output {

/// One natural mode. Participation and effective mass: translations x y z, rotations about them.
struct EigoutMode {
  double eigenvalue = 0.0;  ///< omega^2 [1/time^2]
  std::array<double, 6> participation{}, effective_mass{};
};

/// The ASCII file `eigout`: frequencies, participation factors, effective masses with what they add up to as a share of
/// `total` (mass, inertia about the centre of mass). Throws WriteError.
void write_eigout(const std::filesystem::path& path, const Header& header, const std::vector<EigoutMode>& modes,
                  const std::array<double, 6>& total);

}  // namespace nugget::output
