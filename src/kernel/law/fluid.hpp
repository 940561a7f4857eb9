// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// A viscous fluid (MAT_009 in solids), whose pressure is that of an equation of state: deviators are 2 MU times those
/// of the strain rate, and nothing resists a change of shape at rest.
struct Fluid {
  // Elastic constants of the fluid's bulk modulus, for contact and for the first guess of a stable step; its stress is
  // not made of them.
  double E = 0.0;          ///< [stress]
  double nu = 0.49;        ///< as near to a fluid's as contact takes it [1]
  double viscosity = 0.0;  ///< MU [stress time]
};

}  // namespace nugget::kernel
