// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace nugget::report {

/// Writes what d3plot and d3eigv in `directory` hold as VTK files into `target`: `states.pvd` or `modes.pvd` with a
/// `.vtu` for each, cells by element with named fields, deleted elements left out; `welds.pvd` with a line for each
/// weld between its ends, with what swforc says at that time. Gives the names of the `.pvd` files. Throws
/// std::runtime_error where there is neither file, or one that cannot be read, and output::WriteError.
std::vector<std::string> write_vtk(const std::filesystem::path& directory, const std::filesystem::path& target,
                                   const RunData& run);

}  // namespace nugget::report
