// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "kernel/law/single_points.hpp"

// Stresses that relax or slide, point by point.
namespace nugget::kernel {

/// Stress of a spring and a damper in series after a step: `modulus` of the spring over the strain of which `d` is the
/// rate, exact for a constant rate.
inline SolidTensor<double> relaxed(const SolidTensor<double>& stress, double modulus, double decay,
                                   const SolidTensor<double>& d, double dt) {
  const double x = decay * dt, mean = x > 0.0 ? -std::expm1(-x) / x : 1.0;
  return std::exp(-x) * stress + (modulus * mean * dt) * d;
}

/// What a rubber has beside its energy: stresses that relax, each a spring (2 G of the deviator) and a damper in
/// series, and one that slides, a spring and a friction element in series.
struct Overstress {
  struct MaxwellBranch {
    double shear = 0.0;  ///< GI [stress]
    double decay = 0.0;  ///< BETAI [1/time]
  };
  std::vector<MaxwellBranch> maxwell_branches;
  double friction_shear = 0.0;  ///< G of the friction branch [stress]; 0: none
  double friction_limit = 0.0;  ///< SIGF, its greatest effective stress [stress]
};

/// The branches of an Overstress. History: a tensor each.
class OverstressBranches {
 public:
  explicit OverstressBranches(const Overstress& law) : law_(law) {}

  int tensors() const { return static_cast<int>(law_.maxwell_branches.size()) + (has_friction() ? 1 : 0); }
  int history() const { return tensors() * SolidTensor<double>::size; }
  /// Sum of their stresses after a step of strain rate `d` (engineering shears).
  SolidTensor<double> advance(const SolidTensor<double>& d, double dt, std::span<double> h) const;
  /// What they add to the wave modulus.
  double wave_modulus() const;

 private:
  bool has_friction() const { return law_.friction_shear > 0.0; }
  Overstress law_;
};

}  // namespace nugget::kernel
