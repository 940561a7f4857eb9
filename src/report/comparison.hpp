// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace nugget::report {

/// Reads the results of two runs and writes compare.html into `target`: numbers side by side with their differences,
/// welds whose verdict changed, frequencies, and, where the program has its viewer, both models under one camera at one
/// time, histories laid over each other, modes paired by their shapes. Throws as write_report().
void write_comparison(const std::filesystem::path& first, const std::filesystem::path& second,
                      const std::filesystem::path& target);

}  // namespace nugget::report
