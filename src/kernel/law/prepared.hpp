// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/elastic.hpp"
#include "kernel/law/j2.hpp"
#include "kernel/law/piecewise_linear.hpp"
#include "kernel/law/plastic_kinematic.hpp"
#include "kernel/law/spotweld.hpp"

namespace nugget::kernel {

/// A law made ready for the kernels: moduli, look-up tables. Made once from the parameters, then only read (by any
/// number of threads).
///   elastic()                               elastic constants
///   layer_history, solid_history, fibre_history   numbers of history a point needs in each stress space, beside its
///   stress has_plastic_strain                      the first number of the history is the effective plastic strain
///   layer(), solid(), fibre()               add a step of strain rate to a stress
///   rotate()                                turns a solid point's history with the material
///   can_fail(), failed()                    whether, and which, points have failed (their stress is 0)
///   deletion_step()                         an element whose stable time step falls below is deleted; 0: never
template <class Law>
class Prepared;

template <>
class Prepared<Elastic> {
 public:
  static constexpr int layer_history = 0, solid_history = 0, fibre_history = 0;
  static constexpr bool has_plastic_strain = false;

  explicit Prepared(const Elastic& law) : elastic_(law.E, law.nu) {}

  const ElasticConstants& elastic() const { return elastic_; }
  double deletion_step() const { return 0.0; }
  bool can_fail() const { return false; }
  template <class R>
  MaskOf<R> failed(const double*) const {
    return R(1.0) < R(0.0);
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double*) const {
    const LayerTensor<R> strain = R(dt) * rate;
    elastic_.add(s, strain);
    return {-elastic_.thinning * (strain.xx + strain.yy), R(0.0)};
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double*) const {
    elastic_.add(s, R(dt) * rate);
  }
  template <class R>
  void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt, double*) const {
    elastic_.add(s, R(dt) * rate);
  }
  template <class R>
  void rotate(const Frame<R>&, double*) const {}

 private:
  ElasticConstants elastic_;
};

template <>
class Prepared<PlasticKinematic> : public J2<BilinearHardening, true> {
 public:
  explicit Prepared(const PlasticKinematic& law) : J2(law.E, law.nu, BilinearHardening(law), law.failure_strain) {}
  double deletion_step() const { return 0.0; }
};

template <>
class Prepared<PiecewiseLinear> : public J2<CurveHardening, false> {
 public:
  explicit Prepared(const PiecewiseLinear& law)
      : J2(law.E, law.nu, CurveHardening(law), law.failure_strain), deletion_step_(law.tdel) {}
  double deletion_step() const { return deletion_step_; }

 private:
  double deletion_step_;
};

template <>
class Prepared<Spotweld> : public J2<BilinearHardening, false> {
 public:
  explicit Prepared(const Spotweld& law) : J2(law.E, law.nu, BilinearHardening(law), law.failure_strain) {}
  double deletion_step() const { return 0.0; }
};

}  // namespace nugget::kernel
