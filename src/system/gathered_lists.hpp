// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "base/index.hpp"
#include "base/ranks.hpp"

namespace nugget::system {

/// Lists that are about as long from one time to the next: `gather` sends them, with plain values of a number that all
/// know, in one message, in which there is room for what the last time would have wanted; in two where one is longer.
template <class T>
class GatheredLists {
 public:
  /// The lists of all ranks, one behind the other in the order of ranks, on all of them. `values`: this rank's;
  /// `of_all`: those of the ranks likewise, which it sizes.
  template <class V>
  std::vector<T> gather(Ranks& ranks, const std::vector<T>& own, const std::vector<V>& values, std::vector<V>& of_all) {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_copyable_v<V>);
    const std::size_t count = at(ranks.count()), values_end = sizeof(std::uint64_t) + values.size() * sizeof(V),
                      size = values_end + room_ * sizeof(T);
    std::vector<std::byte> message(size), messages(count * size);
    const std::uint64_t length = own.size();
    const bool fits = length <= room_;
    copy(message.data(), &length, sizeof(length));
    copy(message.data() + sizeof(length), values.data(), values.size() * sizeof(V));
    if (fits) copy(message.data() + values_end, own.data(), own.size() * sizeof(T));
    ranks.gather(message, messages);

    of_all.resize(count * values.size());
    std::vector<std::uint64_t> lengths(count);
    for (std::size_t r = 0; r < count; ++r) {
      const std::byte* const from = messages.data() + r * size;
      copy(&lengths[r], from, sizeof(length));
      copy(of_all.data() + r * values.size(), from + sizeof(length), values.size() * sizeof(V));
    }
    const std::size_t longest = *std::ranges::max_element(lengths);
    const bool all_fit = longest <= room_;
    std::vector<T> padded(own), rest;
    if (!all_fit) {
      padded.resize(longest);
      rest.resize(count * longest);
      ranks.gather(std::as_bytes(std::span(padded)), std::as_writable_bytes(std::span(rest)));
    }
    std::vector<T> joined;
    for (std::size_t r = 0; r < count; ++r) {
      const std::size_t before = joined.size();
      joined.resize(before + lengths[r]);
      if (all_fit)
        copy(joined.data() + before, messages.data() + r * size + values_end, lengths[r] * sizeof(T));
      else
        std::copy_n(rest.begin() + static_cast<std::ptrdiff_t>(r * longest), lengths[r],
                    joined.begin() + static_cast<std::ptrdiff_t>(before));
    }
    room_ = longest + longest / 4;
    return joined;
  }

 private:
  static void copy(void* to, const void* from, std::size_t bytes) {
    if (bytes > 0) std::memcpy(to, from, bytes);
  }

  std::size_t room_ = 0;  ///< for so many of each rank; the same on all
};

}  // namespace nugget::system
