// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

namespace nugget {

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
  static constexpr std::size_t long_array = std::size_t{1} << 20;
  static constexpr std::align_val_t line{64};
};

template <class T>
using ZeroedVector = std::vector<T, Zeroed<T>>;

}  // namespace nugget
