// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/finding.hpp"
#include "weld/coupon/coupon.hpp"

namespace nugget::app {

/// One specimen that was pulled.
struct MeasuredCurve {
  weld::CouponTest test;
  std::string sample;  ///< its name; empty: there is one
  std::vector<double> displacement, force;
  double peak = 0.0, at = 0.0;  ///< largest force, and the displacement there
  Place place;                  ///< of its first line
};

/// Reads a table of measured curves: columns test (lap_shear, coach_peel, cross_tension, ks2_ANGLE), displacement,
/// force, and sample where there are several of a test, in any order under a line of their names; others are left
/// alone. Separators are commas, semicolons or tabs; `#` and `$` begin remarks. Lines of a specimen need not stand
/// together. Findings: what is no number, no test, missing.
std::vector<MeasuredCurve> read_curves(const std::string& file, Findings& findings);

}  // namespace nugget::app
