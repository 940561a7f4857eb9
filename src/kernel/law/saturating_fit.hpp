// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/curve.hpp"

namespace nugget::kernel {

/// Two saturating terms, start + sum Q (1 - exp(-C e)), that come nearest to a curve.
struct SaturatingFit {
  std::array<double, 2> stress{}, exponent{};  ///< Q [stress], not below 0, and C [1]
  double farthest = 0.0;                       ///< greatest distance from a point of the curve, over its stress [1]
};

/// By least squares over the points of `curve`, stress over plastic strain, which does not fall. The terms are linear
/// in Q: C is sought on a grid of logarithms, then by steps that get smaller, with the best Q not below 0 for each.
SaturatingFit saturating_fit(const Curve& curve, double start);

}  // namespace nugget::kernel
