// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace nugget::kernel {

/// Spot weld (MAT_100): J2 plasticity with linear isotropic hardening and the data of its failure models.
/// The point law uses elasticity, hardening and failure_strain; time, resultants and filter belong to the weld as a
/// whole.
struct Spotweld {
  double E = 0.0;                    ///< Young's modulus [stress]
  double nu = 0.0;                   ///< Poisson's ratio [1]
  double yield = 0.0;                ///< SIGY [stress]
  double hardening = 0.0;            ///< EH, slope of the yield stress over plastic strain [stress]
  double failure_time = 0.0;         ///< TFAIL [time]; 0: none
  double failure_strain = 0.0;       ///< EFAIL, effective plastic strain at which a point fails [1]; 0: none
  double mass_step = 0.0;            ///< DT, time step to which the weld's density is scaled [time]; 0: none
  std::array<double, 6> strength{};  ///< NRR NRS NRT [force], MRR MSS MTT [moment]; 0: omitted
  int filter = 0;                    ///< NF, number of resultant vectors averaged for the failure function
};

}  // namespace nugget::kernel
