// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/quadratic_tetrahedron.hpp"
#include "system/tetrahedron_points.hpp"

namespace nugget::system {

/// The tetrahedron of ten nodes as BatchGroup wants it; see there.
template <class Law>
struct QuadraticTetrahedronElement : TetrahedronPoints<Law, QuadraticTetrahedronElement<Law>> {
  static constexpr int corners = 10;
  static constexpr bool rotational = false;
  using Layout = kernel::QuadraticTetrahedronLayout;
  template <class R>
  using Motion = kernel::QuadraticTetrahedronMotion<R>;
  using Places = std::array<Vec3d, 10>;

  Layout layout() const { return kernel::quadratic_tetrahedron_layout(this->law); }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_quadratic_tetrahedron(layout(), x, state, native_width, lane);
    this->start_points(state, lane, x);
  }
  static double volume(const Places& x) { return kernel::quadratic_tetrahedron_volume(x); }
  double mass(model::Index, const Places& x) const { return this->solid.density * volume(x); }
  double nodal_inertia(model::Index, const Places&) const { return 0.0; }
  static double mass_share(int node) { return kernel::quadratic_tetrahedron_mass_share(node); }

  template <class R>
  kernel::QuadraticTetrahedronForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::quadratic_tetrahedron_cycle(this->solid, this->law, motion, dt, state);
  }
};

}  // namespace nugget::system
