// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "deck/deck.hpp"
#include "kernel/element/section_shape.hpp"

namespace nugget::reading {

/// *INTEGRATION_BEAM: a standard cross-section, or points of the user.
struct BeamRule {
  std::optional<kernel::SectionShape> shape;  ///< ICST, D1 to D6
  int refinement = 0;                         ///< K
  double node_s = 0.0, node_t = 0.0;          ///< SREF, TREF
  // Without a shape: places from -1 to 1, areas as shares of RA times TS times TT.
  kernel::FibreRule points;
  double relative_area = 0.0;  ///< RA
};

}  // namespace nugget::reading
