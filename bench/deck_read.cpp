// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "deck/deck.hpp"

// Reading of nodes and shells in MB/s, from a warm file, on one core. The aim is 1000 MB/s.
namespace nugget::deck {
namespace {

namespace fs = std::filesystem;

/// A square sheet of shells as a deck of about 100 MB, in standard or I10 format, in a temporary file that goes with
/// it.
class SheetFile {
 public:
  explicit SheetFile(bool i10)
      : path_(fs::temp_directory_path() / fmt::format("nugget_bench_{}_{}.k", ::getpid(), i10)) {
    constexpr int n = 860;  // nodes along an edge
    const int width = i10 ? 10 : 8;
    fmt::memory_buffer out;
    auto to = std::back_inserter(out);
    fmt::format_to(to, "*KEYWORD\n$ nid               x               y               z\n*NODE{}\n", i10 ? " %" : "");
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        fmt::format_to(to, "{:{}}{:16.7g}{:16.7g}{:16.7g}{:{}}{:{}}\n", 1 + j * n + i, width, 2.5 * i - 1819.511,
                       2.5 * j + 295.2146, 100.0 * std::sin(0.01 * i) * std::cos(0.01 * j), 0, width, 0, width);
      }
    }
    fmt::format_to(to, "*ELEMENT_SHELL{}\n", i10 ? " %" : "");
    for (int j = 0; j + 1 < n; ++j) {
      for (int i = 0; i + 1 < n; ++i) {
        const int first = 1 + j * n + i;
        for (const int id :
             {1 + j * (n - 1) + i, 1 + j % 100, first, first + 1, first + 1 + n, first + n, 0, 0, 0, 0}) {
          fmt::format_to(to, "{:{}}", id, width);
        }
        out.push_back('\n');
      }
    }
    fmt::format_to(to, "*END\n");
    std::ofstream(path_, std::ios::binary).write(out.data(), static_cast<std::streamsize>(out.size()));
    if (fs::file_size(path_) != out.size()) throw std::runtime_error("no room for " + path_.string());
  }
  ~SheetFile() { fs::remove(path_); }
  SheetFile(const SheetFile&) = delete;
  SheetFile& operator=(const SheetFile&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void measure(benchmark::State& state, bool i10) {
  const SheetFile file(i10);
  for (auto _ : state) {
    Findings findings;
    const Deck deck = read(file.path(), findings);
    NodeTable nodes;
    ElementTable shells;
    for (const Block& block : deck.blocks) {
      if (block.keyword == "NODE") read_nodes(deck, block, nodes, findings);
      if (block.keyword == "ELEMENT_SHELL") read_shells(deck, block, shells, findings);
    }
    if (nodes.id.size() != 860 * 860 || shells.id.size() != 859 * 859 || !findings.all().empty()) {
      state.SkipWithError("the deck was not read whole");
      break;
    }
    benchmark::DoNotOptimize(nodes.x.data());
    benchmark::DoNotOptimize(shells.node.data());
  }
  const auto bytes = static_cast<double>(fs::file_size(file.path()));
  state.counters["MB/s"] = benchmark::Counter(bytes / 1e6, benchmark::Counter::kIsIterationInvariantRate);
}

void deck_read_standard(benchmark::State& state) {
  measure(state, false);
}
void deck_read_i10(benchmark::State& state) {
  measure(state, true);
}
BENCHMARK(deck_read_standard)->Unit(benchmark::kMillisecond);
BENCHMARK(deck_read_i10)->Unit(benchmark::kMillisecond);

/// What the kernel takes of it: the same files, only cut into blocks.
void deck_split(benchmark::State& state) {
  const SheetFile file(false);
  for (auto _ : state) {
    Findings findings;
    const Deck deck = read(file.path(), findings);
    benchmark::DoNotOptimize(deck.blocks.data());
  }
  const auto bytes = static_cast<double>(fs::file_size(file.path()));
  state.counters["MB/s"] = benchmark::Counter(bytes / 1e6, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(deck_split)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nugget::deck
