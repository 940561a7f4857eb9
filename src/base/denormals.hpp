// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace nugget {

/// While it lives, results and arguments below the least normal number count as 0: in single precision they are met
/// wherever a wave arrives (1e-38), and each would cost a hundred cycles.
class FlushedDenormals {
 public:
#if defined(__SSE2__)
  FlushedDenormals() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | 0x8040u);
  }
  ~FlushedDenormals() {
    _mm_setcsr(before_);
  }
#else
  FlushedDenormals() = default;
#endif
  FlushedDenormals(const FlushedDenormals&) = delete;
  FlushedDenormals& operator=(const FlushedDenormals&) = delete;

 private:
  unsigned before_ = 0;
};

}  // namespace nugget
