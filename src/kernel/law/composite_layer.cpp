// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/composite_layer.hpp"

namespace nugget::kernel {

LawKernel<CompositeLayer>::LawKernel(const CompositeLayer& law)
    : law_(law),
      thinning_a_(-law.poisson_ca / law.young_c),
      thinning_b_(-law.poisson_cb / law.young_c),
      half_over_g_(0.5 / law.shear_ab),
      three_quarters_alpha_(0.75 * law.shear_cube),
      by_strain_(law.failure_strain_t > 0.0 || law.effective_failure_strain > 0.0) {
  const double share = 1.0 - law.poisson_ba * law.poisson_ba * law.young_a / law.young_b;
  aa_ = law.young_a / share;
  bb_ = law.young_b / share;
  ab_ = law.poisson_ba * aa_;
  const double square = law.shear_strength * law.shear_strength;
  over_shear_energy_ = 1.0 / (half_over_g_ * square + three_quarters_alpha_ * square * square);
}

}  // namespace nugget::kernel
