// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::kernel {

/// Fields of the state of a truss, and after them the stress and history of its one fibre. Field i of lane l stands at
/// state[i * lanes + l].
struct TrussLayout {
  static constexpr int alive = 0;
  static constexpr int density_scale = 1;
  static constexpr int length = 2;  ///< current length [length]
  static constexpr int force = 3;   ///< axial [force]
  static constexpr int stress = 4;  ///< rr, then rs and rt, which stay 0
  static constexpr int history = stress + FibreTensor<double>::size;
};

/// One cycle of a truss (ELFORM 3): uniaxial stress over the logarithmic strain, N = A sigma with the area of the
/// start. A truss whose fibre has failed is deleted. Stable step L / sqrt(E / rho). Instantiated for R =
/// NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw.
template <class R, class Law>
NodalForces<R, 2> truss_cycle(double area, double density, const LawKernel<Law>& law, const NodalMotion<R, 2>& nodes,
                              double dt, double* state);

}  // namespace nugget::kernel
