// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

namespace nugget {

/// Arrays of this size [bytes] and more take pages of their own.
inline constexpr std::size_t zeroed_by_pages = std::size_t{1} << 16;

/// Memory that is 0 to begin with and, where it is long, takes room in the machine only where something is written, a
/// page at a time: for arrays of which a rank of several needs its share. Aligned to lines of the cache. A vector may
/// be sized once: what is left of former values when it shrinks and grows again is not 0.
template <class T>
struct Zeroed {
  using value_type = T;
  Zeroed() = default;
  template <class U>
  Zeroed(const Zeroed<U>&) {}
  T* allocate(std::size_t n) {
    const std::size_t size = n * sizeof(T);
    if (size < long_array) return static_cast<T*>(std::memset(::operator new(size, line), 0, size));
    void* p = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED) throw std::bad_alloc();
    return static_cast<T*>(p);
  }
  void deallocate(T* p, std::size_t n) {
    if (n * sizeof(T) < long_array)
      ::operator delete(p, line);
    else
      ::munmap(p, n * sizeof(T));
  }
  template <class U>
  void construct(U*) {}
  template <class U, class... Values>
  void construct(U* p, Values&&... values) {
    ::new (static_cast<void*>(p)) U(std::forward<Values>(values)...);
  }
  friend bool operator==(const Zeroed&, const Zeroed&) { return true; }

 private:
  static constexpr std::align_val_t line{64};
  static constexpr std::size_t long_array = zeroed_by_pages;
};

template <class T>
using ZeroedVector = std::vector<T, Zeroed<T>>;

/// Values [begin, end) are not asked for until they are written again: pages that they fill take no room any more.
template <class T>
void forget(ZeroedVector<T>& list, std::size_t begin, std::size_t end) {
  if (list.capacity() * sizeof(T) < zeroed_by_pages || begin >= end) return;
  static const std::size_t page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  auto* const first = reinterpret_cast<std::byte*>(list.data());
  const std::size_t from = (begin * sizeof(T) + page - 1) / page * page, to = end * sizeof(T) / page * page;
  if (from < to) ::madvise(first + from, to - from, MADV_DONTNEED);
}

/// Pages on which every bit is 0 take no room any more, as before they were written.
template <class T>
void forget_zeros(ZeroedVector<T>& list) {
  const std::size_t bytes = list.size() * sizeof(T), page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  if (list.capacity() * sizeof(T) < zeroed_by_pages) return;
  auto* const first = reinterpret_cast<std::byte*>(list.data());
  // A byte that is 0 and, from there on, each like the one before it.
  const auto is_zero = [&](std::size_t at) {
    return first[at] == std::byte{0} && std::memcmp(first + at, first + at + 1, page - 1) == 0;
  };
  for (std::size_t begin = 0, end; begin + page <= bytes; begin = end) {
    for (end = begin; end + page <= bytes && is_zero(end);) end += page;
    if (end > begin) ::madvise(first + begin, end - begin, MADV_DONTNEED);
    if (end + page <= bytes || end == begin) end += page;
  }
}

}  // namespace nugget
