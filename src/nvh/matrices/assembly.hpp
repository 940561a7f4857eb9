// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/index.hpp"
#include "nvh/matrices/dof_map.hpp"
#include "nvh/matrices/sparse.hpp"

// How matrices of elements and of nodes become a matrix of the unknowns.
namespace nugget::nvh {

inline std::span<const int> element_nodes(const system::ElementGroup& group, const system::ElementNodes& nodes) {
  return {nodes.data(), at(group.nodes_per_element)};
}

/// Rows of the lower triangle for elements with these lists of unknowns.
std::vector<std::vector<int>> pattern(std::size_t size, const std::vector<std::vector<int>>& lists);

/// Adds an element's or a node's matrix, given in its freedoms.
void scatter(const DofMap& dof_map, std::span<const double> k, Symmetric& into);

/// Of two matrices of the same size, which may have different patterns.
Symmetric sum(const Symmetric& a, const Symmetric& b);

}  // namespace nugget::nvh
