// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/curve.hpp"
#include "system/state.hpp"

namespace nugget::impact {

/// Whether loads and motions follow this curve in the phase of the moment (SIDR).
inline bool in_force(const Curve& curve, const system::State& state) {
  return state.relaxing ? curve.in_relaxation : curve.in_run;
}

}  // namespace nugget::impact
