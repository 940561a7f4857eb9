// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/zeroed.hpp"

namespace nugget {

/// Values [begin, end) are 0 again, and pages that they fill take no room any more until somebody writes them. `T` is
/// plain data.
template <class T>
void clear_range(ZeroedVector<T>& list, std::size_t begin, std::size_t end) {
  if (begin >= end) return;
  static const std::size_t page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  auto* const first = reinterpret_cast<std::byte*>(list.data());
  const std::size_t low = begin * sizeof(T), high = end * sizeof(T);
  const std::size_t from = (low + page - 1) / page * page, to = high / page * page;
  if (list.capacity() * sizeof(T) < zeroed_by_pages || from >= to) {
    std::memset(first + low, 0, high - low);
    return;
  }
  std::memset(first + low, 0, from - low);
  ::madvise(first + from, to - from, MADV_DONTNEED);
  std::memset(first + to, 0, high - to);
}

/// Values [begin, end) of a list that is about to be set free are not asked for any more: pages that they fill take no
/// room. `T` is plain data.
template <class T>
void forget(std::vector<T>& list, std::size_t begin, std::size_t end) {
  static const std::size_t page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  auto* const first = reinterpret_cast<std::byte*>(list.data());
  const auto start = reinterpret_cast<std::uintptr_t>(first);
  const std::uintptr_t from = (start + begin * sizeof(T) + page - 1) / page * page,
                       to = (start + end * sizeof(T)) / page * page;
  if (from < to) ::madvise(first + (from - start), to - from, MADV_DONTNEED);
}

}  // namespace nugget
