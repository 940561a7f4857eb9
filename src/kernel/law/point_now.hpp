// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/law/stress_space.hpp"

namespace nugget::kernel {

/// One point at the end of a step, for its failure rules.
struct PointNow {
  SolidTensor<double> stress, strain;  ///< both with tensorial shears; the strain only where erosion or limits keep it
  double rate;                         ///< effective total strain rate [1/time]
  double plastic_increment, dt;        ///< of the step
  double heating;                      ///< temperature rise so far
  double impulse, age;
  bool layer;
};

/// a:a of the deviator.
template <class R>
R deviator2(const SolidTensor<R>& a) {
  const R m = (1.0 / 3.0) * (a.xx + a.yy + a.zz), x = a.xx - m, y = a.yy - m, z = a.zz - m;
  return x * x + y * y + z * z + 2.0 * (a.xy * a.xy + a.yz * a.yz + a.zx * a.zx);
}

/// Principal values of a symmetric tensor with tensorial shears, ascending.
std::array<double, 3> principal_values(const SolidTensor<double>& a);

}  // namespace nugget::kernel
