// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace nugget::weld {

/// Forces and moments on a weld's cross-section at mid-length, in its own axes (r along the weld).
struct Resultants {
  double axial = 0.0;                     ///< N_rr, tension positive [force]
  double shear_s = 0.0, shear_t = 0.0;    ///< N_rs, N_rt [force]
  double torsion = 0.0;                   ///< M_rr [moment]
  double moment_s = 0.0, moment_t = 0.0;  ///< M_ss, M_tt [moment]

  double force() const { return std::hypot(axial, shear_s, shear_t); }  ///< the resultant of all three
  double shear() const { return std::hypot(shear_s, shear_t); }         ///< sqrt(N_rs^2 + N_rt^2)
  double moment() const { return std::hypot(moment_s, moment_t); }      ///< sqrt(M_ss^2 + M_tt^2)
  double tension() const { return axial > 0.0 ? axial : 0.0; }          ///< N_rr, compression left out
};

/// Largest magnitudes of a weld's forces and moments so far, each at its own time.
struct Peaks {
  double axial = 0.0, shear = 0.0;     ///< [force]
  double moment = 0.0, torsion = 0.0;  ///< bending and twist [moment]
  double force = 0.0;                  ///< resultant of axial and shear force [force]

  void add(double axial_now, double shear_now, double moment_now, double torsion_now) {
    axial = std::max(axial, std::abs(axial_now));
    shear = std::max(shear, shear_now);
    moment = std::max(moment, moment_now);
    torsion = std::max(torsion, std::abs(torsion_now));
    force = std::max(force, std::hypot(axial_now, shear_now));
  }
};

}  // namespace nugget::weld
