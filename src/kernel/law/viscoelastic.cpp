// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/viscoelastic.hpp"

#include "kernel/law/relaxation.hpp"
#include "kernel/law/tensor_algebra.hpp"

namespace nugget::kernel {
using namespace tensor;

PointUpdate ViscoelasticPoint::update(const Tensor& s, const Tensor& d, double dt, std::span<double> h) const {
  const double volume = trace(d);
  const Tensor rate = deviator(tensorial(d)), old = load(h);
  const Tensor decaying = relaxed(old, 2.0 * (law_.instantaneous_shear - law_.long_term_shear), law_.decay, rate, dt);
  store(h, decaying);
  const Tensor lasting = s + (-1.0) * old + (2.0 * law_.long_term_shear * dt) * rate;
  return {plus(lasting + decaying, law_.bulk * dt * volume), law_.bulk + 4.0 / 3.0 * law_.instantaneous_shear};
}

}  // namespace nugget::kernel
