// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "app/prepared_deck.hpp"

namespace nugget::app {

/// Linear statics of a prepared deck (*CONTROL_IMPLICIT_GENERAL, NSOLVR 1), results into `directory`.
ExitCode statics_of(const std::filesystem::path& directory, const RunArguments& arguments, PreparedDeck prepared,
                    Findings& findings);

}  // namespace nugget::app
