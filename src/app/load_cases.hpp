// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "app/commands.hpp"

// *CASE: a deck that holds several analyses.
namespace nugget::app {

/// The deck has cases, and the command line names none of them.
bool has_cases(const RunArguments& arguments);

/// Does `work` for each case of the deck in turn, with its results in a folder of its own below that of the arguments:
/// its JOBID, or `case` and its number. The exit code is that of the first case that did not end well; an interruption
/// ends them all.
ExitCode each_case(const RunArguments& arguments, const std::function<ExitCode(const RunArguments&)>& work);

/// How a log names the deck: with its case, where one is taken.
std::string deck_and_case(const RunArguments& arguments);

}  // namespace nugget::app
