// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "base/batch.hpp"
#include "contact/surface_contact.hpp"

// Included by the .cpp files of SurfaceContact only.
namespace nugget::contact {

/// Asks the memory for `size` bytes from `data` on.
inline void ask_for_lines(const void* data, std::size_t size) {
  for (std::size_t byte = 0; byte < size; byte += 64) __builtin_prefetch(static_cast<const char*>(data) + byte);
}

/// What a thread needs for the block that it works on. Apart from the class: how many pairs are projected at a time
/// depends on the program (docs/decisions/0094), what others see of a contact does not.
struct SurfaceContact::Work {
  static constexpr std::size_t width = lanes<NativeBatch>;  ///< pairs that are projected at a time

  Awake awake, next;                            ///< of the block, and of the one after it
  std::vector<kernel::Feet<NativeBatch>> feet;  ///< of the pairs that are awake
  std::vector<NativeBatch> clear;               ///< least_distance()
  std::vector<int> close;                       ///< of the pairs of a node that are awake: those close enough
  std::vector<Candidate> candidates;            ///< of a node, and of earlier ones
  std::vector<Pair> listed;                     ///< the new lists of a block, in a search
  std::vector<std::pair<int, Box>> around;      ///< segments near some nodes of the block, with their boxes
  std::vector<Share> shares;                    ///< of the hits of a block, in the order of these
};

}  // namespace nugget::contact
