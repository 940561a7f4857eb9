// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "nvh/eigen/modes.hpp"
#include "nvh/eigen/shape_file.hpp"

namespace nugget::nvh {

/// Modes of this run against those of another one, over the nodes that both have: those of the same id at the
/// same place, and of the others those that stand at the same place, whatever their ids.
struct ModeComparison {
  std::size_t nodes = 0;          ///< compared
  std::size_t renumbered = 0;     ///< of them those with another id
  std::size_t absent = 0;         ///< of this run, without a node in the other within a thousandth of the model's size
  std::vector<double> frequency;  ///< of the other run
  Columns mac;                    ///< entry j of column i: mode i of this run with mode j of the other
  std::vector<int> partner;       ///< of each mode of this run, or -1
};
ModeComparison compare(const Matrices& matrices, const Modes& modes, const ShapeFile& other);

/// mac.csv: a row for each mode of this run, a column for each of the other. Throws output::WriteError.
void write_mac(const std::filesystem::path& directory, const Modes& modes, const ModeComparison& comparison);

}  // namespace nugget::nvh
