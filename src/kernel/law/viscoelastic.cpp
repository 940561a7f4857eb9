// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/viscoelastic.hpp"

#include <cmath>

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

GeneralViscoelasticPoint::GeneralViscoelasticPoint(const GeneralViscoelastic& law)
    : bulk_(law.bulk), plane_modulus_(ElasticConstants(law.E, law.nu).plane), branches_(law.overstress) {}

PointUpdate GeneralViscoelasticPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  double& log_volume = h[static_cast<std::size_t>(branches_.history())];
  const double half = 0.5 * dt * trace(d);
  log_volume += std::log1p(2.0 * half / (1.0 - half));
  return {plus(branches_.advance(d, dt, h), bulk_ * log_volume), bulk_ + branches_.wave_modulus(), plane_modulus_};
}

}  // namespace nugget::kernel
