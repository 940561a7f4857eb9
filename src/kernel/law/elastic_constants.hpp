// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "kernel/law/stress_space.hpp"

namespace nugget::kernel {

/// What Young's modulus and Poisson's ratio give, made once.
struct ElasticConstants {
  ElasticConstants(double young, double poisson)
      : E(young),
        nu(poisson),
        shear(E / (2.0 * (1.0 + nu))),
        lambda(E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))),
        plane(E / (1.0 - nu * nu)),
        thinning(nu / (1.0 - nu)) {}

  double E, nu;     ///< Young's modulus [stress], Poisson's ratio [1]
  double shear;     ///< G [stress]
  double lambda;    ///< first Lame constant [stress]
  double plane;     ///< E / (1 - nu^2): wave modulus of a plate [stress]
  double thinning;  ///< nu / (1 - nu): elastic strain through the thickness over the sum of those in the plane,
                    ///< negative [1]

  /// Wave modulus of a solid, K + 4 G / 3 [stress].
  double bulk_wave() const { return lambda + 2.0 * shear; }

  template <class R>
  void add(LayerTensor<R>& s, const LayerTensor<R>& strain) const {
    s.xx += plane * (strain.xx + nu * strain.yy);
    s.yy += plane * (strain.yy + nu * strain.xx);
    s.xy += shear * strain.xy;
    s.xz += shear * strain.xz;
    s.yz += shear * strain.yz;
  }
  template <class R>
  void add(SolidTensor<R>& s, const SolidTensor<R>& strain) const {
    const R volume = lambda * (strain.xx + strain.yy + strain.zz);
    s.xx += volume + 2.0 * shear * strain.xx;
    s.yy += volume + 2.0 * shear * strain.yy;
    s.zz += volume + 2.0 * shear * strain.zz;
    s.xy += shear * strain.xy;
    s.yz += shear * strain.yz;
    s.zx += shear * strain.zx;
  }
  template <class R>
  void add(FibreTensor<R>& s, const FibreTensor<R>& strain) const {
    s.rr += E * strain.rr;
    s.rs += shear * strain.rs;
    s.rt += shear * strain.rt;
  }
};

}  // namespace nugget::kernel
