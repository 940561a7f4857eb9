// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "nvh/matrices/ranks.hpp"

namespace nugget::nvh {

/// On the other ranks: answers what `next` waits for, calls of MUMPS and searches for pairs, to the end.
void follow_calls(Ranks& ranks, const std::function<SolverCall()>& next);

}  // namespace nugget::nvh
