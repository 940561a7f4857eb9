// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "kernel/element/cohesive_brick.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"

namespace nugget::system {

/// The cohesive brick as BatchGroup wants it; see there. `between_shells`: its nodes turn.
template <bool between_shells>
struct CohesiveBrickElement {
  static constexpr int corners = 8;
  static constexpr bool rotational = between_shells;
  using Layout = kernel::CohesiveBrickLayout;
  template <class R>
  using Motion = kernel::NodalMotion<R, 8>;
  using Places = std::array<Vec3d, 8>;

  double density;
  std::shared_ptr<const kernel::CohesiveBond> bond;

  kernel::CohesiveBrickProperties brick() const { return {density, between_shells}; }
  int state_size() const { return Layout::count; }
  int layers() const { return 1; }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_cohesive_brick(brick(), *bond, x, state, native_width, lane);
  }
  double mass(model::Index, const Places& x) const { return kernel::cohesive_brick_mass(brick(), *bond, x); }
  double nodal_inertia(model::Index, const Places& x) const {
    return kernel::cohesive_brick_nodal_inertia(brick(), *bond, x);
  }

  template <class R>
  kernel::NodalForces<R, 8> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::cohesive_brick_cycle(brick(), *bond, motion, dt, state);
  }

  /// Tractions, the mean of the points, along e1 and e2 in the first two places and normal to the surface midway in the
  /// third, as LS-DYNA has them; the points' mean damage in place of the plastic strain.
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int, const Places&) const {
    ElementGroup::Layer l;
    for (int p = 0; p < Layout::points; ++p) {
      const int point = Layout::point(p);
      for (int i = 0; i < 3; ++i) l.stress[i] += 0.25 * field(point + Layout::traction + i);
      l.plastic_strain += 0.25 * field(point + Layout::damage);
    }
    return l;
  }
  template <class Field>
  double thickness(const Field&) const {
    return 0.0;
  }
  template <class Field>
  std::array<double, 8> resultants(const Field&) const {
    return {};
  }
};

}  // namespace nugget::system
