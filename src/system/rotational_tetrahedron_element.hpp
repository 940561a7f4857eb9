// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/rotational_tetrahedron.hpp"
#include "kernel/element/tetrahedron.hpp"
#include "system/tetrahedron_points.hpp"

namespace nugget::system {

/// The tetrahedron with nodal rotations as BatchGroup wants it; see there.
template <class Law>
struct RotationalTetrahedronElement : TetrahedronPoints<Law, RotationalTetrahedronElement<Law>> {
  static constexpr int corners = 4;
  static constexpr bool rotational = true;
  using Layout = kernel::RotationalTetrahedronLayout;
  template <class R>
  using Motion = kernel::NodalMotion<R, 4>;
  using Places = std::array<Vec3d, 4>;

  Layout layout() const { return kernel::rotational_tetrahedron_layout(this->law); }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_rotational_tetrahedron(layout(), x, state, native_width, lane);
    this->start_points(state, lane, x);
  }
  static double volume(const Places& x) { return kernel::tetrahedron_volume(x); }
  double mass(model::Index, const Places& x) const { return this->solid.density * volume(x); }
  double nodal_inertia(model::Index, const Places& x) const {
    return kernel::rotational_tetrahedron_inertia(x, this->solid.density);
  }

  template <class R>
  kernel::RotationalTetrahedronForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::rotational_tetrahedron_cycle(this->solid, this->law, motion, dt, state);
  }
};

}  // namespace nugget::system
