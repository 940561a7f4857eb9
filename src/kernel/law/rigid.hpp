// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// A part that moves as a rigid body (MAT_020): no stress, no stable time step. No kernel is run for it.
struct Rigid {
  double E = 0.0;   ///< Young's modulus for the contact stiffness [stress]
  double nu = 0.0;  ///< Poisson's ratio for the contact stiffness [1]
};

}  // namespace nugget::kernel
