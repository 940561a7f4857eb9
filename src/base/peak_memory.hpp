// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>

namespace nugget {

/// The most memory [MB of 10^6 bytes] that this process has held at a time up to now, as the system counts it
/// (getrusage).
inline double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024e-6 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace nugget
