// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/elastic.hpp"
#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/law_kernel.hpp"

namespace nugget::kernel {

template <>
class LawKernel<Elastic> {
 public:
  static constexpr int layer_history() { return 0; }
  static constexpr int solid_history() { return 0; }
  static constexpr int fibre_history() { return 0; }
  static constexpr bool has_plastic_strain = false;

  explicit LawKernel(const Elastic& law) : elastic_(law.E, law.nu) {}

  const ElasticConstants& elastic() const { return elastic_; }
  double deletion_step() const { return 0.0; }
  bool can_fail() const { return false; }
  static constexpr double points_to_delete() { return 0.0; }
  template <class R>
  MaskOf<R> failed(const Number<R>*) const {
    return R(1.0) < R(0.0);
  }
  template <class R>
  R wave_modulus(const Number<R>*) const {
    return R(elastic_.bulk_wave());
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, Number<R>*) const {
    const LayerTensor<R> strain = R(dt) * rate;
    elastic_.add(s, strain);
    return {-elastic_.thinning * (strain.xx + strain.yy), R(0.0)};
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, Number<R>*) const {
    elastic_.add(s, R(dt) * rate);
  }
  template <class R>
  void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt, Number<R>*) const {
    elastic_.add(s, R(dt) * rate);
  }
  template <class R>
  void rotate(const Frame<R>&, Number<R>*) const {}

 private:
  ElasticConstants elastic_;
};

}  // namespace nugget::kernel
