// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "output/d3plot.hpp"

namespace nugget::output {

/// A d3plot family that a run left in a folder, state by state. Reads what D3plot writes, and of other programs' files
/// those with the same kinds of words: single precision, coordinates, velocities and accelerations, solids, beams and
/// shells, deletion table.
class D3plotReader {
 public:
  /// Opens `directory/stem` and finds the whole states of its members. Throws std::runtime_error with the file and the
  /// reason where it is missing, cut off or holds what is not read here (thick shells, particles, rigid road).
  explicit D3plotReader(const std::filesystem::path& directory, D3plotGeometry::Family family = {});

  const D3plotGeometry& geometry() const { return geometry_; }
  /// Of each whole state; a frequency [cycles/time] in d3eigv.
  const std::vector<double>& times() const { return times_; }
  /// Throws std::runtime_error where the file has become shorter.
  D3plotState read(std::size_t state) const;
  /// Into a state that is there already: of a large file that saves most of the time.
  void read(std::size_t state, D3plotState& into) const;

 private:
  struct Place {
    std::filesystem::path member;
    std::uint64_t offset = 0;  // bytes
  };
  void find_states(const std::filesystem::path& directory);

  D3plotGeometry geometry_;
  bool velocities_ = false, accelerations_ = false;
  std::size_t state_words_ = 0;
  std::vector<double> times_;
  std::vector<Place> places_;
};

}  // namespace nugget::output
