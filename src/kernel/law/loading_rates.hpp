// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "kernel/law/single_points.hpp"

// What foams and rubbers by tables over the rate share.
namespace nugget::kernel {

/// How fast the principal directions of a point are loaded.
struct LoadingRates {
  std::array<double, 3> of_each;  ///< above 0: the direction is strained further [1/time]
  std::size_t most;               ///< the direction that is strained most, by the logarithm of its stretch
};

/// Of the principal axes of b - 1 after a step of strain rate `d` (engineering shears). `engineering`: change of length
/// over the length at first, else over that in mid-step.
LoadingRates loading_rates(const Principal& b_less_one, const SolidTensor<double>& d, double dt, bool engineering);

/// Between which two curves of a table a rate lies; beyond the ends the end curve holds.
struct RatePlace {
  std::size_t low = 0, high = 0;
  double share = 0.0;  ///< of the way from `low` to `high`
};
RatePlace rate_place(const std::vector<double>& rates, double rate);

}  // namespace nugget::kernel
