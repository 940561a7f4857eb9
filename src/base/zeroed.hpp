// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace nugget {

/// Memory that is 0 to begin with and takes room in the machine, a page at a time, only where something is written: for
/// long arrays of which a rank of several needs its share. Aligned to pages. A vector may be sized once: what is left
/// of former values when it shrinks and grows again is not 0.
template <class T>
struct Zeroed {
  using value_type = T;
  Zeroed() = default;
  template <class U>
  Zeroed(const Zeroed<U>&) {}
  T* allocate(std::size_t n) {
    void* p = ::mmap(nullptr, n * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED) throw std::bad_alloc();
    return static_cast<T*>(p);
  }
  void deallocate(T* p, std::size_t n) { ::munmap(p, n * sizeof(T)); }
  template <class U>
  void construct(U*) {}
  template <class U, class... Values>
  void construct(U* p, Values&&... values) {
    ::new (static_cast<void*>(p)) U(std::forward<Values>(values)...);
  }
  friend bool operator==(const Zeroed&, const Zeroed&) { return true; }
};

template <class T>
using ZeroedVector = std::vector<T, Zeroed<T>>;

}  // namespace nugget
