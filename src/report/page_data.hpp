// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "report/packed_arrays.hpp"
#include "report/run_data.hpp"

namespace nugget::report {

/// What the viewer of the page is given, packed: the view of d3plot or d3eigv (view.hpp), units, welds.csv, the strain
/// energy of welds in each mode, responses over frequency, histories. `about` has the keys view, units, second, welds,
/// shares, responses, histories, notes; web/src/main.js reads them.
PackedArrays page_data(const std::filesystem::path& directory, const RunData& run);

/// The viewer's script, made from web/ by `./dev build`; empty where the program was built without Node.
std::string_view viewer_script();

}  // namespace nugget::report
