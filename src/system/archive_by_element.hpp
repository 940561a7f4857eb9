// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/archive.hpp"
#include "system/element_group.hpp"

namespace nugget::system {

/// Values that stand block by block of `width` elements, field by field, lane by lane: in the file the `fields` of an
/// element follow each other, so that programs of every width read it.
template <class Numbers>
void archive_by_element(Archive& a, Numbers& values, std::size_t fields, std::size_t width) {
  using N = typename Numbers::value_type;
  constexpr std::size_t at_a_time = 512 * widest_block;
  std::size_t size = values.size();
  a(size);
  values.resize(size);
  std::vector<N> piece;
  for (std::size_t begin = 0; fields != 0 && begin < size / fields; begin += at_a_time) {
    const std::size_t end = std::min(begin + at_a_time, size / fields);
    piece.resize((end - begin) * fields);
    const auto each = [&](const auto& visit) {
      for (std::size_t e = begin; e < end; ++e)
        for (std::size_t i = 0; i < fields; ++i)
          visit(piece[(e - begin) * fields + i], values[(e / width * fields + i) * width + e % width]);
    };
    each([](N& kept, const N& value) { kept = value; });
    a(piece);
    each([](const N& kept, N& value) { value = kept; });
  }
}

}  // namespace nugget::system
