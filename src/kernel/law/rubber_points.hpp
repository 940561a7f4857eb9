// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "kernel/law/relaxation.hpp"
#include "kernel/law/rubber.hpp"
#include "kernel/law/single_points.hpp"

// Rubbers, point by point. Their history begins with b - 1.
namespace nugget::kernel {

class MooneyRivlinPoint {
 public:
  explicit MooneyRivlinPoint(const MooneyRivlin& law);
  int history() const { return SolidTensor<double>::size; }
  int tensors() const { return 1; }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double E_, nu_, a_, b_, c_, d_;
};

class BlatzKoPoint {
 public:
  explicit BlatzKoPoint(const BlatzKo& law);
  int history() const { return SolidTensor<double>::size; }
  int tensors() const { return 1; }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double E_, nu_, shear_, power_;  ///< 2 beta
};

/// What the rubbers of MAT_077 share: `Energy` gives the stress and the wave modulus of a tensor b - 1, to which the
/// overstress adds its own.
template <class Energy>
class RubberPoint {
 public:
  template <class Law>
  explicit RubberPoint(const Law& law) : energy_(law), overstress_(law.overstress) {}
  int history() const { return SolidTensor<double>::size + overstress_.history(); }
  int tensors() const { return 1 + overstress_.tensors(); }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  Energy energy_;
  OverstressBranches overstress_;
};

class OgdenEnergy {
 public:
  explicit OgdenEnergy(const Ogden& law);
  PointUpdate at(const SolidTensor<double>& b_less_one) const;

 private:
  double E_, nu_;
  std::vector<Ogden::Term> terms_;
  double bulk_;
};

class PolynomialEnergy {
 public:
  explicit PolynomialEnergy(const PolynomialRubber& law);
  PointUpdate at(const SolidTensor<double>& b_less_one) const;

 private:
  PolynomialRubber law_;
  double bulk_;
};

using OgdenPoint = RubberPoint<OgdenEnergy>;
using PolynomialPoint = RubberPoint<PolynomialEnergy>;

}  // namespace nugget::kernel
