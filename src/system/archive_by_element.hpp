// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/archive.hpp"

namespace nugget::system {

/// Values that stand block by block of `width` elements, field by field, lane by lane: in the file the `fields` of an
/// element follow each other, so that programs of every width read it. `holders`: by element.
template <class N>
void archive_by_element(Archive& a, std::span<N> values, std::size_t fields, std::size_t width,
                        const Archive::Holders& holders) {
  constexpr std::size_t together = 1024;
  if (fields == 0) return;
  std::vector<N> of_element(fields);
  a.each_part(values.size() / fields, together, holders, [&](std::size_t e, bool here) {
    const auto value = [&](std::size_t i) -> auto& {
      return values[(e / width * fields + i) * width + e % width];
    };
    if (here && !a.reading())
      for (std::size_t i = 0; i < fields; ++i) of_element[i] = value(i);
    a.parts(std::span(of_element), fields, {});
    if (here && a.reading())
      for (std::size_t i = 0; i < fields; ++i) value(i) = of_element[i];
  });
}

/// The same of a list, which takes the length that is read.
template <class Numbers>
void archive_by_element(Archive& a, Numbers& values, std::size_t fields, std::size_t width,
                        const Archive::Holders& holders) {
  std::size_t size = values.size();
  a(size);
  values.resize(size);
  archive_by_element(a, std::span(values), fields, width, holders);
}

}  // namespace nugget::system
