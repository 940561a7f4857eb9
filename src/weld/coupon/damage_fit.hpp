// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace nugget::weld {

/// Work of a force behind its largest value [force length], by trapezoids.
double work_after_peak(std::span<const double> displacement, std::span<const double> force);

/// RS of a weld whose force fades (DMGOPT 10, 11).
struct DamageFit {
  double rupture = 0.0;          ///< RS: plastic strain from the onset to rupture
  double low = 0.0, high = 0.0;  ///< 95 % confidence; 0: a single specimen
  std::vector<double> ratio;     ///< of each specimen: simulated over measured work
  std::string fault;             ///< why there is no fit; empty: there is one
};

/// The rupture strain with which the simulated work behind the peak is that measured, as nearly as one number can:
/// least squares of r_i = ln(simulated / measured) by Levenberg and Marquardt over ln RS, slopes by
/// differences. `measured`: work of each specimen [force length], above 0. `simulated`: the same for a given RS, in
/// their order; dear. Confidence as in `fit_strengths`. Refused: work that does not depend on RS.
DamageFit fit_damage(const std::vector<double>& measured, double start,
                     const std::function<std::vector<double>(double rupture)>& simulated);

}  // namespace nugget::weld
