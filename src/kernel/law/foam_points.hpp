// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "kernel/law/foam.hpp"
#include "kernel/law/single_points.hpp"

// Foams, point by point.
namespace nugget::kernel {

class LowDensityFoamPoint {
 public:
  explicit LowDensityFoamPoint(const LowDensityFoam& law) : law_(law) {}
  int history() const { return tensors() * SolidTensor<double>::size + 2; }
  int tensors() const { return law_.maxwell_modulus > 0.0 ? 2 : 1; }  // b - 1, the stress that relaxes
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  LowDensityFoam law_;
};

class CrushableFoamPoint {
 public:
  explicit CrushableFoamPoint(const CrushableFoam& law) : law_(law) {}
  int history() const { return tensors() * SolidTensor<double>::size + 1; }
  int tensors() const { return law_.damping > 0.0 ? 1 : 0; }  // the viscous part of the stress
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  CrushableFoam law_;
};

class RateFoamPoint {
 public:
  explicit RateFoamPoint(const RateFoam& law);
  int history() const { return SolidTensor<double>::size + 8; }
  int tensors() const { return 1; }  // b - 1
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double look_up(double strain, double rate) const;
  std::array<double, 3> loading_rates(const Principal& axes, const SolidTensor<double>& d, double J, double dt) const;

  RateFoam law_;
  double growth_;  ///< slope by which what the rate adds to the stress grows at most [stress]
};

}  // namespace nugget::kernel
