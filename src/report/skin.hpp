// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "output/d3plot.hpp"

namespace nugget::report {

/// A facet that can be seen: a shell, or a face of a brick that has no living neighbour behind it.
struct Facet {
  std::array<int, 4> nodes{};  ///< a triangle repeats its third
  int part = 0;
  int element = 0;  ///< position among the shells, or among the solids
  bool of_shell = true;
  int from = 0, until = 0;  ///< states in which it is seen, `until` not among them
};

/// Facets of all shells, and of bricks those that are seen in some state. `shell_end[i]` and `solid_end[i]` are the
/// first states in which an element is deleted, `states` where it never is.
std::vector<Facet> facets(const output::D3plotGeometry& geometry, const std::vector<int>& shell_end,
                          const std::vector<int>& solid_end, int states);

}  // namespace nugget::report
