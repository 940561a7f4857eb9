// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "kernel/law/rubber.hpp"
#include "kernel/law/single_points.hpp"
#include "kernel/law/viscoelastic.hpp"

// Stresses that relax or slide, point by point.
namespace nugget::kernel {

/// Stress of a spring and a damper in series after a step: `modulus` of the spring over the strain of which `d` is the
/// rate, exact for a constant rate.
inline SolidTensor<double> relaxed(const SolidTensor<double>& stress, double modulus, double decay,
                                   const SolidTensor<double>& d, double dt) {
  const double x = decay * dt, mean = x > 0.0 ? -std::expm1(-x) / x : 1.0;
  return std::exp(-x) * stress + (modulus * mean * dt) * d;
}

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

class ViscoelasticPoint {
 public:
  explicit ViscoelasticPoint(const Viscoelastic& law) : law_(law) {}
  int history() const { return SolidTensor<double>::size; }  // the part of the stress that decays
  int tensors() const { return 1; }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  Viscoelastic law_;
};

}  // namespace nugget::kernel
