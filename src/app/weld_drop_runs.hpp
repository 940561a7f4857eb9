// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/commands.hpp"

// `nugget run --drop-weld all`: one run as the deck is and one without each weld, side by side, ranked.
namespace nugget::app {

/// The word asks for a run without each of some welds: `all`, or `each:` and ids.
bool drops_each(const std::string& word);

/// Runs them in folders of their own, at most as many side by side as there are threads. Writes weld_drop.csv and
/// prints what each weld is worth: the change of the internal energy at the end, of the intrusions that `intrusion`
/// asks for (change of the distance of two nodes, its largest over the run [length]), and how many other welds fail.
/// Its exit code is that of the run as the deck is, or 3 where one of the others could not be run to its end.
ExitCode run_without_each(const RunArguments& arguments);

/// What is wrong with `--intrusion`; empty: nothing.
std::string wrong_intrusion(const std::string& text);

}  // namespace nugget::app
