// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace nugget::report {

/// Writes what a folder has of histories, welds, modes and responses over frequency as one HDF5 file; gives its groups.
/// docs/manual/convert.md#one-hdf5-file has the layout. Throws std::runtime_error where there is nothing of these, and
/// output::WriteError.
std::vector<std::string> write_hdf5(const std::filesystem::path& directory, const std::filesystem::path& file,
                                    const RunData& run);

}  // namespace nugget::report
