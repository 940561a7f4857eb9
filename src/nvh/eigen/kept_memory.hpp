// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <malloc.h>

namespace nugget::nvh {

/// While it lives, memory that is freed stays with the process: each solution of MUMPS and each block of Lanczos takes
/// arrays as long as the model and gives them back, and pages that the system clears and maps anew cost a tenth of
/// the whole.
class KeptMemory {
 public:
  KeptMemory() {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
  }
  ~KeptMemory() {
    mallopt(M_MMAP_MAX, 65536);  // the defaults of glibc
    mallopt(M_TRIM_THRESHOLD, 128 * 1024);
    malloc_trim(0);
  }
  KeptMemory(const KeptMemory&) = delete;
  KeptMemory& operator=(const KeptMemory&) = delete;
};

}  // namespace nugget::nvh
