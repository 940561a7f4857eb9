// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/commands.hpp"
#include "impact/simulation/options.hpp"
#include "output/restart_file.hpp"

namespace nugget::app {

/// When restart files are written, from `500cycles`, `10min` (of the clock) or a model time; nothing where the text is
/// none of these.
std::optional<impact::Checkpoints> read_checkpoints(const std::string& text);

/// What restart files say of this run.
output::RestartHead head_of(const RunArguments& arguments, std::uint64_t deck_checksum);

/// What is to be run to resume a run, as it was begun but for what the command line says anew. Changes to the
/// folder from which the run was begun, so that its files are found under their names.
RunArguments resumed_arguments(const RunArguments& asked, const output::RestartHead& head);

/// Throws ArchiveError where the deck is not the one of the restart file.
void expect_same_deck(const std::string& deck, std::uint64_t checksum, const output::RestartHead& head);

}  // namespace nugget::app
