// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "app/command.hpp"
#include "app/commands.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// Where the examples are, seen from the program: installed, and in a folder of a build.
constexpr const char* example_folders[] = {"../share/nugget/examples", "examples"};

/// What to open first, by whom.
constexpr const char* to_open[][2] = {{"report.html", "in a browser: the folded rail, every weld, the energies"},
                                      {"welds.csv", "a row per weld: its ties, largest forces, when it failed"},
                                      {"d3plot", "in LS-PrePost, ParaView or another reader of d3plot"},
                                      {"run.log", "keywords and what became of them, ties, mass added, how it ended"}};

}  // namespace

ExitCode demo(const std::string& directory) {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const char* folder : example_folders) {
    const fs::path deck = (program / folder / "double_hat" / "double_hat.k").lexically_normal();
    if (!fs::exists(deck, unknown)) continue;
    fmt::print(stderr, "nugget run {} -o {}\n", deck.string(), directory);
    RunArguments run;
    run.deck = deck.string();
    run.directory = directory;
    const ExitCode code = nugget::app::run(run);
    if (code != ExitCode::normal) return code;
    fmt::print("\nresults in {}\n", fs::absolute(directory, unknown).lexically_normal().string());
    for (const auto& [file, what] : to_open) fmt::print("    {:<12} {}\n", file, what);
    return ExitCode::normal;
  }
  fmt::print(stderr,
             "nugget: the example is not there: {} is neither in {} nor in {}; install the program together with its "
             "examples (./dev package, or cmake --install build), or run ./dev demo in its sources\n",
             "double_hat/double_hat.k", (program / example_folders[0]).lexically_normal().string(),
             (program / example_folders[1]).string());
  return ExitCode::refused;
}

}  // namespace nugget::app
