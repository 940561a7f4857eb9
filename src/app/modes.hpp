// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "app/commands.hpp"
#include "app/prepared_deck.hpp"
#include "impact/simulation/simulation.hpp"
#include "nvh/eigen/shape_file.hpp"

namespace nugget::app {

/// Natural modes of a prepared deck, into a folder whose old results are gone; `other`: modes to compare them with;
/// `after`: the explicit run whose end they are of.
ExitCode modes_of(const std::filesystem::path& directory, const ModesArguments& arguments, PreparedDeck prepared,
                  Findings& findings, const std::optional<nvh::ShapeFile>& other = {},
                  const impact::Simulation* after = nullptr);

}  // namespace nugget::app
