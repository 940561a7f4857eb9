// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>

namespace nugget::app {

/// How many processes mpirun says that it has started (Open MPI; MPICH and others by PMI); 1 without it.
inline int started_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* ranks = std::getenv(name); ranks != nullptr && std::atoi(ranks) > 1) return std::atoi(ranks);
  return 1;
}

}  // namespace nugget::app
