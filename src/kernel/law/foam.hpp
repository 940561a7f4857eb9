// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "base/curve.hpp"

namespace nugget::kernel {

/// Highly compressible foam (MAT_057), a law of solids without lateral contraction: each principal direction has the
/// nominal stress of its own stretch, in compression by a curve, in tension linear up to a cutoff. Unloading keeps
/// HU + (1 - HU) (W / Wmax)^SHAPE of the stress, W energy of the curve.
struct LowDensityFoam {
  double E = 0.0;     ///< Young's modulus in tension [stress]
  double nu = 0.0;    ///< 0
  Curve compression;  ///< nominal stress over nominal strain, both positive in compression
  double cutoff = std::numeric_limits<double>::infinity();  ///< TC, greatest nominal tensile stress [stress]
  bool tears = false;      ///< FAIL 1: no tensile stress once the cutoff was reached, else it stays at the cutoff
  double unloading = 1.0;  ///< HU [1]; 1: no hysteresis
  double shape = 1.0;      ///< SHAPE [1]
};

/// Crushable foam (MAT_063, MODEL 0), a law of solids without lateral contraction: elastic, each principal stress at
/// most the yield stress of the volume reached in compression, the cutoff in tension. It does not recover.
struct CrushableFoam {
  double E = 0.0;       ///< Young's modulus of loading and unloading: the last slope of the curve [stress]
  double nu = 0.0;      ///< 0
  Curve yield;          ///< yield stress over volumetric strain 1 - V / V0
  double cutoff = 0.0;  ///< TSC, greatest tensile stress [stress]
};

}  // namespace nugget::kernel
