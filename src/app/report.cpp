// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "app/commands.hpp"
#include "output/result_file.hpp"
#include "report/comparison.hpp"
#include "report/page.hpp"

namespace nugget::app {

ExitCode report(const std::string& directory, const std::string& other) {
  try {
    if (other.empty()) {
      report::write_report(directory);
    } else {
      report::write_comparison(directory, other, directory);
      fmt::print("{}\n", (std::filesystem::path(directory) / "compare.html").string());
    }
    return ExitCode::normal;
  } catch (const output::WriteError& error) {
    fmt::print(stderr, "nugget: {}\n", error.what());
    return ExitCode::cannot_write;
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "nugget: {}\n", error.what());
    return ExitCode::wrong_command;
  }
}

}  // namespace nugget::app
