// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace nugget::weld {

/// Forces and moments on a weld's cross-section at mid-length, in its own axes (r along the weld).
struct Resultants {
  double axial = 0.0;                     ///< N_rr, tension positive [force]
  double shear_s = 0.0, shear_t = 0.0;    ///< N_rs, N_rt [force]
  double torsion = 0.0;                   ///< M_rr [moment]
  double moment_s = 0.0, moment_t = 0.0;  ///< M_ss, M_tt [moment]

  double shear() const { return std::hypot(shear_s, shear_t); }     ///< sqrt(N_rs^2 + N_rt^2)
  double moment() const { return std::hypot(moment_s, moment_t); }  ///< sqrt(M_ss^2 + M_tt^2)
  double tension() const { return axial > 0.0 ? axial : 0.0; }      ///< N_rr, compression left out
};

}  // namespace nugget::weld
