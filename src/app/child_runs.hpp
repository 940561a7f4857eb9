// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace nugget::app {

/// A deck that this program runs (or checks) in a process of its own, with one thread.
struct ChildRun {
  std::filesystem::path deck, folder;
  std::vector<std::string> options{};  ///< of the command, beside folder and threads
  int exit_code = -1;
  std::string verb = "run";
};

/// Runs them, at most `at_once` side by side; what each says on the terminal goes to terminal.log in its folder.
/// `progress` is called with a name when one has ended. False: a process could not be started.
bool run_children(std::vector<ChildRun>& runs, int at_once, const std::function<void(const ChildRun&)>& progress);

}  // namespace nugget::app
