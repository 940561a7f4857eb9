// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "kernel/law/point_now.hpp"

namespace nugget::kernel {

/// Fracture of MAT_107 (T. Borvik and others, Eur. J. Mech. A/Solids 20, 2001), without coupling to the stress: damage
/// over its critical value grows, beyond a plastic strain PD, by the plastic strain over pf - PD,
///   pf = [D1 + D2 exp(D3 m/s)] (1 + rate / E0DOT)^D4 (1 + D5 T*),
/// m mean and s effective stress; or by the work of the largest principal stress in tension over the plastic strain,
/// over WC (M.G. Cockcroft, D.J. Latham, J. Inst. Metals 96, 1968). A point fails at 1, at a temperature or at a
/// largest shear stress, too.
struct DuctileFracture {
  bool by_work = false;  ///< Cockcroft and Latham
  double threshold = 0.0, d1 = 0.0, d2 = 0.0, d3 = 0.0, d4 = 0.0, d5 = 0.0;
  double work = 0.0;                                                ///< WC [stress]
  double reference_rate = 1.0;                                      ///< E0DOT [1/time]
  double melting_rise = 1.0, warmth = 0.0;                          ///< as of ModifiedJohnsonCook
  double last_rise = std::numeric_limits<double>::infinity();       ///< TC - T0 [temperature]
  double shear_strength = std::numeric_limits<double>::infinity();  ///< TAUC [stress]
  bool grows = false;                                               ///< damage is asked for

  // History: damage over its critical value; plastic strain.
  static constexpr int history = 2;
  static constexpr bool needs_plastic_flow = false;
  double used(const double* h, int) const { return h[0]; }
  void advance(const PointNow& p, double* h, int stride) const;
};

}  // namespace nugget::kernel
