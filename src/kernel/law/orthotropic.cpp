// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/law/orthotropic.hpp"
#include "kernel/law/single_points.hpp"

namespace nugget::kernel {

double Orthotropic::definiteness() const {
  // Ratios r_ij = nu_ij^2 E_j / E_i, and the product of all three Poisson's ratios.
  const double ab = poisson_ba * poisson_ba * young_a / young_b, ca = poisson_ca * poisson_ca * young_a / young_c;
  const double cb = poisson_cb * poisson_cb * young_b / young_c;
  const double all = poisson_ba * poisson_ca * poisson_cb * young_a / young_c;
  return std::min({1.0 - ab, 1.0 - ca, 1.0 - cb, 1.0 - ab - ca - cb - 2.0 * all});
}

void Orthotropic::take_isotropic_constants() {
  const double product = std::clamp(poisson_ba * poisson_ba * young_a / young_b, 0.0, 0.99);
  nu = std::min(std::sqrt(product), 0.45);
  E = std::max(young_a, young_b) / (1.0 - product) * (1.0 - nu * nu);
}

double fastest_wave_modulus(const std::array<std::array<double, 3>, 3>& normal, double shear_ab, double shear_bc,
                            double shear_ca) {
  // Christoffel's tensor over a quarter of the directions: the others are their mirror images.
  double fastest = 0.0;
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const double theta = 0.5 * std::numbers::pi * i / steps, phi = 0.5 * std::numbers::pi * j / steps;
      const double x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi), z = std::cos(theta);
      const SolidTensor<double> christoffel{normal[0][0] * x * x + shear_ab * y * y + shear_ca * z * z,
                                            shear_ab * x * x + normal[1][1] * y * y + shear_bc * z * z,
                                            shear_ca * x * x + shear_bc * y * y + normal[2][2] * z * z,
                                            (normal[0][1] + shear_ab) * x * y,
                                            (normal[1][2] + shear_bc) * y * z,
                                            (normal[2][0] + shear_ca) * z * x};
      fastest = std::max(fastest, principal_axes(christoffel).value[2]);
    }
  return fastest;
}

LawKernel<Orthotropic>::LawKernel(const Orthotropic& law)
    : axes_(law.axes), shear_ab_(law.shear_ab), shear_bc_(law.shear_bc), shear_ca_(law.shear_ca) {
  const double ab = -law.poisson_ba / law.young_b, ca = -law.poisson_ca / law.young_c,
               cb = -law.poisson_cb / law.young_c;
  const double aa = 1.0 / law.young_a, bb = 1.0 / law.young_b, cc = 1.0 / law.young_c;
  const double plane = aa * bb - ab * ab;
  layer_aa_ = bb / plane;
  layer_bb_ = aa / plane;
  layer_ab_ = -ab / plane;
  thinning_a_ = ca;
  thinning_b_ = cb;

  const double over = 1.0 / (aa * (bb * cc - cb * cb) - ab * (ab * cc - cb * ca) + ca * (ab * cb - bb * ca));
  solid_[0] = {over * (bb * cc - cb * cb), over * (ca * cb - ab * cc), over * (ab * cb - ca * bb)};
  solid_[1] = {solid_[0][1], over * (aa * cc - ca * ca), over * (ab * ca - aa * cb)};
  solid_[2] = {solid_[0][2], solid_[1][2], over * (aa * bb - ab * ab)};

  wave_modulus_ = fastest_wave_modulus(solid_, shear_ab_, shear_bc_, shear_ca_);
}

}  // namespace nugget::kernel
