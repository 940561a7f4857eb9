// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/units.hpp"

namespace nugget::weld {

/// A sheet of a stack that is to be welded.
struct StackSheet {
  double thickness = 0.0;         ///< [mm]
  double tensile_strength = 0.0;  ///< R_m [MPa]
};

/// A spot weld of a stack by published rules (docs/manual/stack.md#the-rules), in mm and N.
struct StackWeld {
  double diameter = 0.0;  ///< factor sqrt(t), t the thinner sheet of the weakest pair in mm
  double shear = 0.0;     ///< NRS = NRT, EN 1993-1-3 without its partial factor
  double tension = 0.0;   ///< NRR, 0.74 of it (Y. J. Chao)
  std::size_t pair = 0;   ///< the weakest: sheets `pair` and `pair` + 1
  std::string governed;   ///< what limits the shear force: `tearing and bearing`, `shear of the nugget`, ...
};

/// `factor`: 5 (a sound weld), or 4 (the smallest that passes). `diameter` above 0: instead of the rule.
StackWeld weld_of_stack(const std::vector<StackSheet>& stack, double factor, double diameter);

/// A card for it: *MAT_SPOTWELD, *SECTION_BEAM, *SECTION_SHELL of the weakest pair, each number with its rule as a
/// remark; what `nugget coupon` takes.
std::string write_stack_card(const std::vector<StackSheet>& stack, double factor, double diameter,
                             const model::Units& units);

}  // namespace nugget::weld
