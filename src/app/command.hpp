// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include "app/commands.hpp"
#include "app/no_memory.hpp"
#include "app/prepared_deck.hpp"
#include "base/finding.hpp"
#include "output/result_file.hpp"

// What the commands have in common: a log, findings on standard error, exit codes.
namespace nugget::app {

/// run.log or check.log as it grows; written whole each time, so that it is there whatever happens next.
class Log {
 public:
  explicit Log(std::filesystem::path path) : path_(std::move(path)) {}
  /// Continues the log that is there.
  void read();
  void add(const std::string& text) {
    text_ += text;
    output::write_whole_file(path_, text_);
  }
  /// The same where the disk may be full.
  void try_to_add(const std::string& text) {
    try {
      add(text);
    } catch (const output::WriteError&) {
      return;  // the log of before is still there
    }
  }

 private:
  std::filesystem::path path_;
  std::string text_;
};

/// Head, table of keywords, findings.
void start_log(Log& log, const RunArguments& arguments, const PreparedDeck& p, const Findings& findings);

void print_findings(const Findings& findings);

/// A wrong file name leaves the results of earlier runs alone.
ExitCode refuse_missing(const Findings& findings);

/// 0: all cores.
void use_threads(int asked);

/// Runs `work` in a folder, made where it is missing, and turns a failed write, or memory that ran out, into its exit
/// code.
template <class Work>
ExitCode guarded(const std::string& directory, Work work) {
  try {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) throw output::WriteError(directory, error.message());
    return work(std::filesystem::path(directory));
  } catch (const output::WriteError& e) {
    fmt::print(stderr, "nugget: {}\n", e.what());
    return ExitCode::cannot_write;
  } catch (const ArchiveError& e) {
    fmt::print(stderr, "nugget: cannot go on: {}\n", e.what());
    return ExitCode::refused;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "nugget: {}\n", no_memory);
    return ExitCode::error_termination;
  }
}

}  // namespace nugget::app
