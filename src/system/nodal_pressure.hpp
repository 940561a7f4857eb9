// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "base/vec3.hpp"
#include "system/state.hpp"

namespace nugget::system {

/// Mean stress on which the nodes of a group of tetrahedra agree (J. Bonet, A.J. Burton, Commun. Numer. Meth. Engng 14,
/// 1998, in the logarithmic form of the laws here): with v_a the sum of a quarter of the volume of each active element
/// at node a, and V_a the same at the start,
///     p_a = K ln(v_a / V_a)        mean stress of an element: that of its four nodes' mean.
/// Since dv_e/dx = v_e b, the elements' forces are then the derivative of an energy that depends on v_a alone: a node,
/// not an element, keeps its volume, and there are about five elements a node.
class NodalPressure {
 public:
  /// `corners`: system nodes of each element; `x`: nodes at the start.
  NodalPressure(const std::vector<std::array<int, 4>>& corners, std::span<const Vec3d> x, double bulk_modulus);

  /// Mean stresses at the positions of `now`, element by element [stress].
  const std::vector<double>& update(const State& now, const std::function<bool(std::size_t)>& alive);

 private:
  double bulk_modulus_;
  std::vector<std::array<int, 4>> corners_;  ///< system nodes
  std::vector<std::array<int, 4>> local_;    ///< the same, counted among the nodes of the group
  std::vector<double> at_start_, volume_;    ///< of elements; 0 once deleted or inverted
  std::vector<std::size_t> first_;           ///< of each node, in `around_`
  std::vector<int> around_;                  ///< elements at the nodes, node by node, ascending
  std::vector<double> at_node_;              ///< mean stress
  std::vector<double> mean_;                 ///< of elements
};

}  // namespace nugget::system
