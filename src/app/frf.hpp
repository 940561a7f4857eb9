// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "nvh/modes.hpp"

namespace nugget::app {

/// Computes the frequency response that the deck asks for, writes frf.csv, and returns what run.log says of it.
/// Throws nvh::Factorization::SolverError, output::WriteError.
std::string frf_of(const std::filesystem::path& directory, const nvh::Matrices& matrices, const nvh::Modes& modes,
                   const model::FrequencyResponse& request);

}  // namespace nugget::app
