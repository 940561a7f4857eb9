// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <malloc.h>

namespace nugget {

/// Arrays of this size [bytes] and more go back to the machine as soon as they are set free. Left to itself glibc keeps
/// those of up to 32 MiB for the next one, once it has seen some: what reading and tying took would stay with the run.
inline constexpr int large_array = 1 << 20;

/// From now on, for all threads.
inline void give_large_arrays_back() {
  mallopt(M_MMAP_THRESHOLD, large_array);
}

}  // namespace nugget
