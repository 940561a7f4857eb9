// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/rubber.hpp"

#include <cmath>

#include "kernel/law/tensor_algebra.hpp"

namespace nugget::kernel {
using namespace tensor;

namespace {

/// A bound of the greatest principal value that is the same in all axes: mean + sqrt(2) standard deviations.
double greatest_value(const Tensor& b) {
  return trace(b) / 3.0 + std::sqrt(2.0 / 3.0 * square(deviator(b)));
}

// Waves in the plane of a layer without stress through the thickness, at constant volume: d(sigma_i - sigma_3) / d ln
// l_i, with l_3 going against l_i. Of W1 and W2, the derivatives over the invariants, 4 / J (W1 + W2 l_j^2) (l_i^2 +
// l_3^2), at rest 4 G.

double bulk_modulus(double E, double nu) {
  return E / (3.0 * (1.0 - 2.0 * nu));
}

}  // namespace

MooneyRivlinPoint::MooneyRivlinPoint(const MooneyRivlin& law)
    : E_(law.E),
      nu_(law.nu),
      a_(law.a),
      b_(law.b),
      c_(0.5 * law.a + law.b),
      d_((law.a * (5.0 * law.nu - 2.0) + law.b * (11.0 * law.nu - 5.0)) / (2.0 * (1.0 - 2.0 * law.nu))) {}

PointUpdate MooneyRivlinPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  if (is_linear(e)) return linear_point(E_, nu_, e);
  const Tensor b = plus(e, 1.0);
  const double first = trace(b), third = determinant(b), J = std::sqrt(third);
  // sigma = 2/J [(W1 + I W2) b - W2 b b + III W3]
  const double volume = third * (-2.0 * c_ / (third * third * third) + 2.0 * d_ * (third - 1.0));
  const Tensor stress = (2.0 / J) * plus((a_ + first * b_) * b + (-b_) * times(b, b), volume);
  // d(2 III W3 / J) / d ln J, and at most 2 (A + 2 B I) I / J of the rest.
  const double V = 20.0 * c_ / std::pow(J, 5.0) + 4.0 * d_ * (3.0 * J * J * J - J);
  const double greatest = greatest_value(b);
  return {stress, V + 2.0 / J * (std::abs(a_) + 2.0 * std::abs(b_) * first) * first,
          8.0 / J * (a_ + b_ * greatest) * greatest};
}

BlatzKoPoint::BlatzKoPoint(const BlatzKo& law)
    : E_(law.E), nu_(law.nu), shear_(law.shear), power_(2.0 * law.nu / (1.0 - 2.0 * law.nu)) {}

PointUpdate BlatzKoPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  if (is_linear(e)) return linear_point(E_, nu_, e);
  const Tensor b = plus(e, 1.0);
  const double J = std::sqrt(determinant(b)), volume = std::pow(J, -power_);
  const double greatest = greatest_value(b);
  return {shear_ / J * plus(b, -volume), shear_ / J * (greatest + (power_ + 1.0) * volume),
          4.0 * shear_ / J * greatest};
}

template <class Energy>
PointUpdate RubberPoint<Energy>::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  PointUpdate now = energy_.at(e);
  now.stress = now.stress + overstress_.advance(d, dt, h.subspan(Tensor::size));
  now.wave_modulus += overstress_.wave_modulus();
  now.plane_modulus += overstress_.wave_modulus();
  return now;
}

template class RubberPoint<OgdenEnergy>;
template class RubberPoint<PolynomialEnergy>;

OgdenEnergy::OgdenEnergy(const Ogden& law)
    : E_(law.E), nu_(law.nu), terms_(law.terms), bulk_(bulk_modulus(law.E, law.nu)) {}

PointUpdate OgdenEnergy::at(const Tensor& e) const {
  if (is_linear(e)) return linear_point(E_, nu_, e);
  const Tensor b = plus(e, 1.0);
  const Principal axes = principal_axes(b);
  const double J = std::sqrt(determinant(b)), shrink = 1.0 / std::cbrt(J);
  std::array<double, 3> stress{};
  double stiffness = 0.0;
  for (const Ogden::Term& term : terms_) {
    std::array<double, 3> power;
    for (std::size_t i = 0; i < 3; ++i)
      power[i] = term.mu * std::pow(shrink * std::sqrt(axes.value[i]), term.alpha) / J;
    const double mean = (power[0] + power[1] + power[2]) / 3.0;
    for (std::size_t i = 0; i < 3; ++i) stress[i] += power[i] - mean;
    stiffness += std::abs(term.alpha) * std::abs(std::max(std::abs(power[0]), std::abs(power[2])));
  }
  for (double& s : stress) s += bulk_ * (J - 1.0) / J;
  return {with_values(axes, stress), bulk_ / J + 2.0 * stiffness, 2.0 * stiffness};
}

PolynomialEnergy::PolynomialEnergy(const PolynomialRubber& law) : law_(law), bulk_(bulk_modulus(law.E, law.nu)) {}

PointUpdate PolynomialEnergy::at(const Tensor& e) const {
  if (is_linear(e)) return linear_point(law_.E, law_.nu, e);
  const Tensor whole = plus(e, 1.0);
  const double J = std::sqrt(determinant(whole)), shrink = 1.0 / std::cbrt(J * J);
  const Tensor b = shrink * whole, bb = times(b, b);
  const double first = trace(b), second = 0.5 * (first * first - trace(bb)), x = first - 3.0, y = second - 3.0;
  // Derivatives of W over the invariants.
  const double w1 = law_.c10 + law_.c11 * y + 2.0 * law_.c20 * x + 3.0 * law_.c30 * x * x;
  const double w2 = law_.c01 + law_.c11 * x + 2.0 * law_.c02 * y;
  const double w11 = 2.0 * law_.c20 + 6.0 * law_.c30 * x, w12 = law_.c11, w22 = 2.0 * law_.c02;
  // sigma = 2/J dev[W1 b + W2 (I b - b b)] + K (J - 1) / J
  const Tensor of_first = deviator(b), of_second = deviator(first * b + (-1.0) * bb);
  const Tensor stress = plus((2.0 / J) * (w1 * of_first + w2 * of_second), bulk_ * (J - 1.0) / J);
  // A bound as in Mooney and Rivlin's rubber; what the second derivatives add, d being a unit tensor: 4/J W11 (dev
  // b:d)^2 and so on.
  const double a = std::sqrt(square(of_first)), c = std::sqrt(square(of_second));
  const double bending = std::abs(w11) * a * a + 2.0 * std::abs(w12) * a * c + std::abs(w22) * c * c;
  const double greatest = greatest_value(b);
  return {stress, bulk_ / J + 2.0 / J * (std::abs(w1) + 2.0 * std::abs(w2) * first) * first + 4.0 / J * bending,
          8.0 / J * (std::abs(w1) + std::abs(w2) * greatest) * greatest + 4.0 / J * bending};
}

}  // namespace nugget::kernel
