// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driven_shell.hpp"
#include "kernel/element/membrane.hpp"

namespace nugget::kernel {

struct OnePointMembrane : OnePoint {
  template <class R, class Law>
  static NodalForces<R, 4> cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 4>& nodes, double dt, double* state) {
    return membrane_cycle<R>(shell, law, nodes, dt, state);
  }
};
struct FullMembrane : Full {
  template <class R, class Law>
  static NodalForces<R, 4> cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 4>& nodes, double dt, double* state) {
    return full_membrane_cycle<R>(shell, law, nodes, dt, state);
  }
};
struct TriangleMembrane : C0 {
  template <class R, class Law>
  static NodalForces<R, 3> cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 3>& nodes, double dt, double* state) {
    return membrane_triangle_cycle<R>(shell, law, nodes, dt, state);
  }
};

}  // namespace nugget::kernel
