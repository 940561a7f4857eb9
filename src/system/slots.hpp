// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "base/vec3.hpp"
#include "base/zeroed.hpp"

namespace nugget::system {

/// Nodal forces and moments of elements, each in a slot of its own, which ElementGroup::slot numbers. As many slots as
/// the widest register has lanes, whatever the program's own, stand together, component by component: a block of
/// elements writes registers as they are (docs/decisions/0161).
template <class N>
class SlotsOf {
 public:
  static constexpr std::size_t lanes = 64 / sizeof(N);
  /// Where component 0 of a slot stands among the numbers; each further one stands `lanes` behind.
  static constexpr std::size_t place(std::size_t slot) { return slot + 2 * (slot / lanes * lanes); }

  /// All 0. Once only. `slots`: a multiple of `lanes`.
  void resize(std::size_t slots) { numbers_.resize(3 * slots); }
  bool empty() const { return numbers_.empty(); }
  std::size_t size() const { return numbers_.size() / 3; }

  Vec3d operator[](std::size_t slot) const {
    const N* at = &numbers_[place(slot)];
    return {at[0], at[lanes], at[2 * lanes]};
  }
  void set(std::size_t slot, const Vec3d& v) {
    N* at = &numbers_[place(slot)];
    at[0] = static_cast<N>(v.x);
    at[lanes] = static_cast<N>(v.y);
    at[2 * lanes] = static_cast<N>(v.z);
  }
  N* data() { return numbers_.data(); }
  const N* data() const { return numbers_.data(); }

 private:
  ZeroedVector<N> numbers_;
};

using Slots = SlotsOf<double>;
using SingleSlots = SlotsOf<float>;

}  // namespace nugget::system
