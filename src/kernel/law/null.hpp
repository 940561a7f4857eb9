// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// A coating without stress (MAT_009 on shells and beams): mass and contact, no force, no stable time step. No kernel
/// is run for it. Solids of MAT_009 are a Fluid with an equation of state, of the same viscosity and tension cutoff.
struct Null {
  double E = 0.0;          ///< Young's modulus for the contact stiffness [stress]
  double nu = 0.0;         ///< Poisson's ratio for the contact stiffness [1]
  double viscosity = 0.0;  ///< MU [stress time]
  double tension = 0.0;    ///< -PC: the pressure falls no further than its opposite [stress]; 0: no limit
  double most_volume = 0.0, least_volume = 0.0;  ///< TEROD, CEROD: relative volumes at which it erodes; 0: none
};

}  // namespace nugget::kernel
