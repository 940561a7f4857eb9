// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "output/history_samples.hpp"

namespace nugget::output {

/// Reads an ASCII history file as this program, or LS-DYNA, writes it; which one, its name says. Empty where the file
/// is missing. Numbers have the digits of the file.
HistoryRecord read_ascii_history(const std::filesystem::path& path);

/// Whether there is a reader for a file of that name.
bool can_read_ascii_history(std::string_view name);

}  // namespace nugget::output
