// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "report/packed_arrays.hpp"

namespace nugget::report {

/// How much of a run goes into its page.
struct ViewLimits {
  std::size_t text = 9'000'000;    ///< characters of packed shapes and fields; fewer states are kept until they fit
  std::size_t points = 3'000'000;  ///< nodes and facets together up to which there is a view at all
};

/// What the view of the page shows of d3plot (or, of modes, d3eigv): nodes in 16 bits of the box that holds them all,
/// facets with part and element, plastic strain, von Mises stress and thickness in 8 bits of their range, at the first
/// state, the last, and as many between as `limits` allow. `about.view` says what is there and what was left out, with
/// a word for the reader in `note`; without a readable file it has nothing but the note. Modes are brought to one size
/// by `factors`.
PackedArrays packed_view(const std::filesystem::path& directory, bool modes, const ViewLimits& limits = {});

}  // namespace nugget::report
