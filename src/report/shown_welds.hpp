// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "output/d3plot.hpp"
#include "report/run_data.hpp"

namespace nugget::report {

/// A weld of welds.csv as pictures show it.
struct ShownWeld {
  int id = 0;
  double diameter = 0.0, failure_time = 0.0;
  bool tied = false, failed = false;
  double peak_failure = 0.0, peak_failure_time = 0.0;
  std::vector<int> parts;            ///< ids: its own, and those of its sheets
  std::optional<double> damage;      ///< at the end of the run, 0 to 1, where its law has one
  std::vector<std::size_t> nodes;    ///< its own, as positions in D3plotGeometry::node_ids
  std::vector<std::size_t> segment;  ///< those of the segment that its first end is tied to

  bool has_failed_by(double time) const { return failed && failure_time <= time; }
  bool is_damaged() const { return damage.value_or(0.0) > 0.0; }
};

/// Those that have nodes in the file.
std::vector<ShownWeld> shown_welds(const RunData& run, const output::D3plotGeometry& geometry);

/// The mean of the places of some nodes.
Vec3d middle_of(const std::vector<std::size_t>& nodes, const std::vector<Vec3d>& x);

}  // namespace nugget::report
