// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/index.hpp"
#include "base/ranks.hpp"

namespace nugget::system {

/// Sends each rank its list of `to` (none to itself), of whatever length, and puts what the others sent here into
/// `from`, by rank. All ranks call it together.
template <class T>
void exchange(Ranks& ranks, const std::vector<std::vector<T>>& to, std::vector<std::vector<T>>& from) {
  const int count = ranks.count(), own = ranks.rank();
  std::vector<std::uint64_t> sizes(at(count)), of_all(at(count) * at(count));
  for (int r = 0; r < count; ++r) sizes[r] = to[r].size();
  ranks.gather(std::as_bytes(std::span(sizes)), std::as_writable_bytes(std::span(of_all)));
  from.resize(at(count));
  for (int r = 0; r < count; ++r) {
    from[r].resize(of_all[at(r) * at(count) + at(own)]);
    if (!from[r].empty()) ranks.receive(r, std::as_writable_bytes(std::span(from[r])));
    if (!to[r].empty()) ranks.send(r, std::as_bytes(std::span(to[r])));
  }
  ranks.finish();
}

}  // namespace nugget::system
