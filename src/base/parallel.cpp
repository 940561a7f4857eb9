// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <thread>
#include <vector>

namespace nugget {
namespace {
int thread_count = 1;
std::unique_ptr<tbb::global_control> limit;

/// Calls body(r) for r in [0, count), on several threads.
template <class Body>
void each_range(std::size_t count, const Body& body) {
#ifdef NUGGET_THREAD_SANITIZER
  // The sanitizer cannot see how the distribution's libtbb hands over its work and would call every use of it a race.
  std::vector<std::jthread> workers;
  for (std::size_t r = 0; r < count; ++r) workers.emplace_back([&body, r] { body(r); });
#else
  tbb::parallel_for(std::size_t{0}, count, body);
#endif
}
}  // namespace

void set_threads(int count) {
  thread_count = std::max(1, count);
  limit.reset();
  limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                static_cast<std::size_t>(thread_count));
}

int threads() {
  return thread_count;
}

void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  if (thread_count == 1 || count <= grain) {
    body(0, count);
    return;
  }
  // A few ranges per thread even out the load; more would only cost dispatch.
  const std::size_t pieces =
      std::min<std::size_t>((count + grain - 1) / grain, static_cast<std::size_t>(4 * thread_count));
  const std::size_t length = ((count + pieces - 1) / pieces + grain - 1) / grain * grain;
  const std::size_t ranges = (count + length - 1) / length;
  each_range(ranges, [&](std::size_t r) { body(r * length, std::min(count, (r + 1) * length)); });
}

double ordered_sum(std::size_t count, const std::function<double(std::size_t)>& term) {
  constexpr std::size_t block = 1024;
  const std::size_t blocks = (count + block - 1) / block;
  std::vector<double> part(blocks);
  parallel_for(blocks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      double sum = 0.0;
      for (std::size_t i = b * block; i < std::min(count, (b + 1) * block); ++i) sum += term(i);
      part[b] = sum;
    }
  });
  double total = 0.0;
  for (double p : part) total += p;
  return total;
}

}  // namespace nugget
