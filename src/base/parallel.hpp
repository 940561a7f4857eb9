// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace nugget {

/// Number of threads that `parallel_for` may use from here on (at least 1).
void set_threads(int count);
int threads();

/// Calls `body(begin, end)` on disjoint ranges that cover [0, count). Which thread gets which range is not fixed, so a
/// body must write only what belongs to its own range; then results do not depend on the number of threads.
/// Ranges are multiples of `grain`, except the last. Workers sleep while there is nothing to do.
void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

/// Sum of `term(i)` over [0, count), added up in blocks of fixed size and then block by block: the same bits for any
/// number of threads.
double ordered_sum(std::size_t count, const std::function<double(std::size_t)>& term);

}  // namespace nugget
