// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/curve.hpp"

namespace nugget::kernel {

/// Elastic-plastic law with a yield curve or a table of them over strain rate, isotropic hardening (MAT_024).
/// Bilinear hardening is a curve of two points. Between the rates of a table yield stresses are interpolated at equal
/// plastic strain, outside they are held; beyond its last point a curve keeps its last slope.
struct PiecewiseLinear {
  double E = 0.0;   ///< Young's modulus [stress]
  double nu = 0.0;  ///< Poisson's ratio [1]
  std::vector<double>
      rates;  ///< strain rates of the table, ascending [1/time]; empty: no table. Plain rates, never logarithms
  std::vector<Curve>
      yield;  ///< yield stress over effective plastic strain, one curve a rate; exactly one without a table
  bool log_rates = false;       ///< interpolate over the logarithm of the rate
  double rate_c = 0.0;          ///< Cowper-Symonds C [1/time]; 0: no rate effect
  double rate_p = 0.0;          ///< Cowper-Symonds P [1]
  double rate_yield = 0.0;      ///< yield stress that C and P raise, added to that at rest [stress]; 0: all of it
  Curve rate_scale;             ///< factor on the yield stress over strain rate (LCSR); empty: none
  double failure_strain = 0.0;  ///< FAIL, effective plastic strain at which a point fails [1]; 0: none
  double deletion_step = 0.0;   ///< TDEL, an element whose stable time step falls below is deleted [time]; 0: never
};

}  // namespace nugget::kernel
