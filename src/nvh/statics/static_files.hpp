// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "nvh/statics/statics.hpp"
#include "output/ascii.hpp"

namespace nugget::nvh {

/// d3plot with two states, at rest and at ENDTIM; of nodout, spcforc, bndout and swforc those that the deck asks for,
/// ASCII or binout, with the same two states. Throws output::WriteError.
void write_statics(const std::filesystem::path& directory, const output::Header& header, const Matrices& matrices,
                   const Statics& statics);

}  // namespace nugget::nvh
