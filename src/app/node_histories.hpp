// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "base/vec3.hpp"

namespace nugget::app {

/// Where a node is at the times of nodout.
struct NodeHistory {
  std::vector<double> time;
  std::vector<Vec3d> displacement, place;  ///< [length]
};

/// Of the nodes of the text file nodout in `folder`, by user id; none where there is no such file.
std::map<int, NodeHistory> read_node_histories(const std::filesystem::path& folder);

}  // namespace nugget::app
