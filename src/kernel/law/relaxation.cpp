// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/relaxation.hpp"

#include "kernel/law/tensor_algebra.hpp"

namespace nugget::kernel {
using namespace tensor;

Tensor OverstressBranches::advance(const Tensor& d, double dt, std::span<double> h) const {
  Tensor sum{};
  if (tensors() == 0) return sum;
  const Tensor rate = deviator(tensorial(d));
  for (const Overstress::MaxwellBranch& branch : law_.maxwell_branches) {
    const Tensor stress = relaxed(load(h), 2.0 * branch.shear, branch.decay, rate, dt);
    store(h, stress);
    sum = sum + stress;
    h = h.subspan(Tensor::size);
  }
  if (!has_friction()) return sum;
  Tensor stress = load(h) + (2.0 * law_.friction_shear * dt) * rate;
  const double effective = std::sqrt(1.5 * square(stress));
  if (effective > law_.friction_limit) stress = (law_.friction_limit / effective) * stress;
  store(h, stress);
  return sum + stress;
}

double OverstressBranches::wave_modulus() const {
  double shear = law_.friction_shear;
  for (const Overstress::MaxwellBranch& branch : law_.maxwell_branches) shear += branch.shear;
  return 4.0 / 3.0 * shear;
}

}  // namespace nugget::kernel
