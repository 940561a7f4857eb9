// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/curve.hpp"
#include "model/parts.hpp"

// What the law of a sheet answers to a test, whatever law it is.
namespace nugget::model {

/// Yield stress of a sheet's law over its plastic strain, at rest [stress]: what the law itself gives under shear in
/// small steps. Empty where it does not flow, or has no effective plastic strain. At rest is 2e-19 of the rate at which
/// a wave goes through `thickness` [length].
Curve yield_at_rest(const Material& material, double thickness);
/// Factor on it over the plastic strain rate, at 2 % of plastic strain, by the same test at other speeds; empty where
/// the rate does not count. The speeds are shares of that at which a wave goes through `thickness` [length].
Curve rate_factor(const Material& material, double thickness);

/// The same as a tensile test shows it. Both 0 where there is no such curve.
struct Strength {
  double yield = 0.0;    ///< at a plastic strain of 0.002 [stress]
  double tensile = 0.0;  ///< largest engineering stress, where it necks [stress]: the yield stress over the exponential
                         ///< of the strain, elastic and plastic (Considere)
};
Strength strength_of(const Material& material);

}  // namespace nugget::model
