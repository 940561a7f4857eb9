// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#if defined(__FMA__)
#include <immintrin.h>
#endif

#include <cstddef>
#include <vector>

// What the machine can do, measured in the same run as the kernels: no figure of a kernel means much without it.
namespace {

/// STREAM triad a = b + s c on one core, arrays of 64 MB each; counted as STREAM does, 24 bytes an item.
void machine_stream_triad(benchmark::State& state) {
  constexpr std::size_t count = std::size_t{1} << 23;
  std::vector<double> a(count, 0.0), b(count, 1.0), c(count, 2.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + 3.0 * c[i];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<long>(state.iterations() * 3 * count * sizeof(double)));
}
BENCHMARK(machine_stream_triad)->Unit(benchmark::kMillisecond);

#if defined(__FMA__)
/// Fused multiply-adds of doubles on one core, as many independent chains as hide their latency; an item is a flop.
void machine_fma_peak(benchmark::State& state) {
  constexpr int chains = 12, steps = 1000, lanes = 4, flops = 2;
  const __m256d factor = _mm256_set1_pd(0.999), term = _mm256_set1_pd(0.001);
  __m256d sum[chains];
  for (auto& s : sum) s = _mm256_set1_pd(1.0);
  for (auto _ : state) {
    for (int i = 0; i < steps; ++i)
      for (auto& s : sum) s = _mm256_fmadd_pd(s, factor, term);
    for (auto& s : sum) benchmark::DoNotOptimize(s);
  }
  state.SetItemsProcessed(static_cast<long>(state.iterations()) * steps * chains * lanes * flops);
}
BENCHMARK(machine_fma_peak)->Unit(benchmark::kMicrosecond);
#endif

}  // namespace
