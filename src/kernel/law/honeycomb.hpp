// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/curve.hpp"
#include "kernel/law/orthotropic.hpp"

namespace nugget::kernel {

/// Honeycomb (MAT_026, and MAT_126 with a curve for each stress): in the material axes each of the six stresses goes by
/// its own strain, with a modulus between that of the uncrushed core and that of the compacted metal,
///   M = M_u + beta (M_c - M_u),  beta = (1 - V) / (1 - VF) between 0 and 1,
/// V the relative volume, M_c = E or E / (2 (1 + PR)), and is held between -s and s, s by a curve. Where V <= VF the
/// material is elastic and perfectly plastic (von Mises). Sources: LS-DYNA keyword manual II and theory manual,
/// material 26.
struct Honeycomb {
  /// What the curves of the largest stress are over.
  enum class Over {
    volume,              ///< 1 - V of all components
    strain,              ///< the component's own logarithmic strain, compression positive; of shears gamma, either sign
    engineering_strain,  ///< the component's own change of length over the length at first; of shears gamma
  };

  double E = 0.0, nu = 0.0;         ///< of the compacted material [stress], [1]
  double yield = 0.0;               ///< SIGY of the compacted material [stress]
  double compacted_volume = 0.0;    ///< VF [1]
  std::array<double, 6> modulus{};  ///< EAAU EBBU ECCU GABU GBCU GCAU of the uncrushed core [stress]
  std::array<Curve, 6> limit;       ///< largest stress aa bb cc ab bc ca [stress]; never below 0
  Over over = Over::volume;
  Curve rate_factor{};     ///< LCSR: factor on the limits over the norm of the deviatoric strain rate; empty: none
  double viscosity = 0.0;  ///< MU: viscous stress MU M dt d of each component [1]
  double tensile_failure = 0.0;  ///< TSEF, strain along a, b or c at which a point fails [1]; 0: none
  double shear_failure = 0.0;    ///< SSEF, the same of gamma ab, bc or ca [1]; 0: none
  MaterialAxes axes;
};

}  // namespace nugget::kernel
