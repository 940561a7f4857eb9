// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/row.hpp"
#include "system/slots.hpp"

namespace nugget::system {

class ElementGroup;

/// Which slots (nodal forces of elements) each node has, and their sums. A node's are added up in the order of its
/// elements, whoever does it and when: the same bits for any number of threads and ranks.
class NodalSums {
 public:
  using Block = std::pair<int, std::size_t>;  ///< group, and a number in it
  /// By node.
  struct Sums {
    std::span<Row> force, moment;
  };

  /// `doubles`: slots in front of those of single precision.
  void link(const std::vector<std::unique_ptr<ElementGroup>>& groups, std::size_t nodes, std::size_t doubles);
  /// Only of nodes that this rank adds up, from here on.
  void keep(const std::function<bool(int)>& adds_up);
  /// Divides the blocks that this process computes into stretches, whose slots the processor's own cache holds. None
  /// goes across `border`, a place in `blocks`.
  void divide(const std::vector<std::unique_ptr<ElementGroup>>& groups, std::span<const Block> blocks,
              std::size_t border);

  /// Calls `compute(begin, end)` for the places in `blocks` of each stretch before the border, or behind it, side by
  /// side, and then takes the sums of the nodes all of whose slots were written there, while these are near.
  void compute(bool before_border, const Slots& slots, const SingleSlots& single, const Sums& sums,
               const std::function<void(std::size_t, std::size_t)>& compute) const;
  /// Of the other nodes.
  void add_up_others(const Slots& slots, const SingleSlots& single, const Sums& sums) const;
  /// Of all nodes. `single` may be empty: then all slots stand in `slots`.
  void add_up(const Slots& slots, const SingleSlots& single, const Sums& sums) const;

  /// The slots of a node, those of forces, shifted left by one; the lowest bit says that there is one of a moment.
  std::span<const std::uint32_t> of_node(std::size_t node) const {
    return std::span(entry_).subspan(start_[node], start_[node + 1] - start_[node]);
  }
  /// The slot of the moment that belongs to the force in a slot.
  std::size_t moment_of(std::size_t slot) const { return slot + (slot < doubles_ ? Slots::lanes : SingleSlots::lanes); }
  std::size_t nodes() const { return start_.size() - 1; }
  void archive(Archive& a) { a.built(start_, entry_, order_, stretches_, border_, others_, doubles_); }

 private:
  struct Stretch {
    std::size_t end_block, end_node;  ///< places in the list of blocks and in order_; each begins where the last ends
  };
  /// Of the nodes at [begin, end) in order_; `ahead`: asking for slots of so many nodes ahead.
  void add_up(std::size_t begin, std::size_t end, std::size_t ahead, const Slots& slots, const SingleSlots& single,
              const Sums& sums) const;

  std::vector<std::uint32_t> start_{0};  ///< of each node in entry_, and where the last one's end
  std::vector<std::uint32_t> entry_;     ///< see of_node
  std::vector<int> order_;               ///< nodes that are added up here: stretch by stretch, then the others
  std::vector<Stretch> stretches_;
  std::size_t border_ = 0;   ///< stretches before it
  std::size_t others_ = 0;   ///< where these begin in order_
  std::size_t doubles_ = 0;  ///< slots in front of those of single precision
};

}  // namespace nugget::system
