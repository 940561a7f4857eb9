// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/laminated_fabric.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nugget::kernel {
namespace {

/// Of strengths that are met at hardly more than the elastic strain: the stress falls at once.
constexpr double steepest_fall = 100.0;

}  // namespace

LawKernel<LaminatedFabric>::LawKernel(const LaminatedFabric& law)
    : law_(law),
      poisson_ab_(law.poisson_ba * law.young_a / law.young_b),
      thinning_a_(-law.poisson_ca / law.young_c),
      thinning_b_(-law.poisson_cb / law.young_c) {
  const LaminatedFabric::Mode* const mode[] = {&law.tension_a, &law.compression_a, &law.tension_b, &law.compression_b,
                                               &law.shear};
  const double modulus[] = {law.young_a, law.young_a, law.young_b, law.young_b, law.shear_ab};
  for (int m = 0; m < modes; ++m) {
    Fall& fall = fall_[at(m)];
    fall.peak = std::max(modulus[m] * mode[m]->strain / mode[m]->strength, std::exp(1.0 / steepest_fall));
    fall.exponent = 1.0 / std::log(fall.peak);
    fall.share = 1.0 / (fall.exponent * std::numbers::e);
    fall.left = mode[m]->left;
  }
  const double tau = law.first_shear_stress / law.shear.strength,
               r = law.shear_ab * law.first_shear_strain / law.shear.strength;
  curved_ = law.surface == LaminatedFabric::Surface::faceted && r > 0.0 && tau > 0.0;
  if (!curved_) return;
  first_shear_ = r;
  shear_bend_ = std::log(r / tau) / r;
  shear_slope_ = (1.0 - tau) / (fall_[shear].peak - r);
  shear_start_ = tau - shear_slope_ * r;
}

}  // namespace nugget::kernel
