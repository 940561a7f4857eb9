// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/point_now.hpp"

namespace nugget::kernel {

/// Johnson and Cook's strain at fracture (Eng. Fract. Mech. 21, 1985):
///   max{[D1 + D2 exp(D3 p*)] [1 + D4 ln(rate / EPSO)] [1 + D5 T*], EFMIN},
/// p* mean stress over effective stress, tension positive. A point fails when its plastic strain increments, each over
/// the strain at fracture of its moment, add up to 1; until then it has all its stress.
struct JohnsonCookFracture {
  double d1 = 0.0, d2 = 0.0, d3 = 0.0, d4 = 0.0, d5 = 0.0;
  double least = 1e-6;           ///< EFMIN [1]
  double reference_rate = 1.0;   ///< EPSO [1/time]
  double melting_rise = 0.0;     ///< TM - TR [temperature]; 0: cold, T* = 0
  bool by_plastic_rate = false;  ///< VP 1: the rate is the plastic strain rate, else the total strain rate

  // History: the sum so far.
  static constexpr int history = 1;
  static constexpr bool needs_plastic_flow = true;
  double used(const double* h, int) const { return h[0]; }
  void advance(const PointNow& p, double* h, int stride) const;

 private:
  double fracture_strain(double triaxiality, double rate, double heating) const;
};

}  // namespace nugget::kernel
