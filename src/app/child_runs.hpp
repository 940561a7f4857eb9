// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace nugget::app {

/// A deck that this program runs (or checks) in a process of its own.
struct ChildRun {
  std::filesystem::path deck, folder;
  std::vector<std::string> options{};  ///< of the command, beside folder and threads
  int exit_code = -1;                  ///< -1: it was not started
  std::string verb = "run";
  int threads = 1;
  bool resumed = false;  ///< goes on from the restart file in the folder
};

/// How a set of runs came to its end.
enum class ChildrenEnd { all_ended, interrupted, not_started };

/// Runs them, at most `at_once` side by side; what each says on the terminal goes to terminal.log in its folder.
/// `progress` is called when one has ended. SIGINT, SIGTERM and SIGHUP are passed on, so that each leaves a restart
/// file; those that wait are not started then. `not_started`: a process could not be.
ChildrenEnd run_children(std::vector<ChildRun>& runs, int at_once,
                         const std::function<void(const ChildRun&)>& progress);

}  // namespace nugget::app
