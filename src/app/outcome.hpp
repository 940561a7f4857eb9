// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/command.hpp"

// What the solutions (explicit run, modes) leave behind in the same way.
namespace nugget::app {

/// Writes what a refused deck leaves behind.
ExitCode refuse(const std::filesystem::path& directory, Log& log, const Findings& findings);

/// Name of the deck's units as recognised; empty where they are not.
std::string unit_name(const model::Model& model);

output::Summary::Counts counts(const model::Model& model, const weld::Ties& ties);

/// mm/dd/yyyy
std::string today();

}  // namespace nugget::app
