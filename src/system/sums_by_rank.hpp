// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace nugget::system {

class System;

/// Sums over all nodes, and over the elements of a group, are made of sums over so many in a row, so that their bits do
/// not depend on who adds up what. In a run over several ranks: which of these rows one rank has all of, so that its
/// sum can travel in place of what it is made from (docs/decisions/0142). All ranks find the same.
class SumsByRank {
 public:
  static constexpr std::size_t in_a_row = 1024;
  static constexpr int nobody = -1;  ///< as Share::nobody

  /// Of a system that has been shared out.
  explicit SumsByRank(const System& system);

  /// The rank that follows all nodes [i, i + 1) * in_a_row and those that they depend on: the first one if it does; or
  /// `nobody`.
  int of_nodes(std::size_t i) const { return of_nodes_[i]; }
  /// The rank that computes all elements [i, i + 1) * in_a_row of a group, likewise.
  int of_elements(std::size_t group, std::size_t i) const { return of_elements_[group][i]; }
  /// Whether some rank makes the sums in which elements [begin, begin + count) stand.
  bool has_elements(std::size_t group, std::size_t begin, std::size_t count) const {
    const std::size_t last = std::min((begin + count - 1) / in_a_row, of_elements_[group].size() - 1);
    return of_elements_[group][begin / in_a_row] != nobody && of_elements_[group][last] != nobody;
  }
  std::size_t rows_of_nodes() const { return of_nodes_.size(); }
  std::size_t rows_of_elements(std::size_t group) const { return of_elements_[group].size(); }
  /// Whether a sum that nobody can make alone, or of what has mass besides elements, looks at a node: at once, or by a
  /// row of the constraint map.
  bool travels(int node) const {
    const auto k = static_cast<std::size_t>(node);
    return (travels_[k / bits].mask >> k % bits & 1) != 0;
  }
  /// How many nodes do, and which of these, in the order of nodes, one is.
  std::size_t travelling() const { return travelling_; }
  std::size_t place_among_travelling(int node) const {
    if (!travels(node)) throw std::logic_error("a balance of energies asks for a node whose motion no rank sends");
    const auto k = static_cast<std::size_t>(node);
    const Bits& word = travels_[k / bits];
    return word.before + static_cast<std::size_t>(std::popcount(word.mask & ((std::uint64_t{1} << k % bits) - 1)));
  }

 private:
  std::vector<int> of_nodes_;
  std::vector<std::vector<int>> of_elements_;
  static constexpr std::size_t bits = 64;
  struct Bits {
    std::uint64_t mask = 0;    ///< of nodes in a row
    std::uint32_t before = 0;  ///< how many of the nodes before them travel
  };
  std::vector<Bits> travels_;
  std::size_t travelling_ = 0;
};

}  // namespace nugget::system
