// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "base/vec3.hpp"
#include "nvh/matrices/sparse.hpp"

namespace nugget::nvh {

/// Mode shapes of a run, as its d3eigv family has them.
struct ShapeFile {
  std::vector<int> node;  ///< user ids, ascending
  std::vector<Vec3d> x;   ///< places at rest [length]
  std::vector<double> frequency;
  Columns shape;  ///< 3 translations a node, one column a mode

  /// Words of 4 or 8 bytes, little-endian; from Nugget or from LS-DYNA. Throws ReadError.
  explicit ShapeFile(const std::filesystem::path& directory);
  struct ReadError : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
};

}  // namespace nugget::nvh
