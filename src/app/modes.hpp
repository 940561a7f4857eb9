// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "app/commands.hpp"
#include "app/prepared.hpp"

namespace nugget::app {

/// Natural modes of a prepared deck, into a folder whose old results are gone.
ExitCode modes_of(const std::filesystem::path& directory, const ModesArguments& arguments, Prepared prepared,
                  Findings& findings);

}  // namespace nugget::app
