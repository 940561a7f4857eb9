// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "system/brick_element.hpp"

namespace nugget::system {

/// The wedge as BatchGroup wants it; see there. Its six nodes stand as in kernel::WedgeMotion.
template <class Law>
struct WedgeElement : FullBrickElement<Law> {
  using Brick = FullBrickElement<Law>;
  static constexpr int corners = 6;
  template <class R>
  using Motion = kernel::WedgeMotion<R>;
  using Places = std::array<Vec3d, 6>;

  static typename Brick::Places as_brick(const Places& x) { return kernel::brick_of_wedge(x.data()); }

  void start(double* state, int lane, model::Index e, const Places& x) const {
    Brick::start(state, lane, e, as_brick(x));
  }
  double mass(model::Index e, const Places& x) const { return Brick::mass(e, as_brick(x)); }
  double nodal_inertia(model::Index, const Places&) const { return 0.0; }

  template <class R>
  kernel::WedgeForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::wedge_cycle(this->brick, this->law, motion, dt, state);
  }
  WedgeElement inviscid() const {
    WedgeElement e = *this;
    e.make_inviscid();
    return e;
  }
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int k, const Places& x) const {
    return Brick::layer(field, k, as_brick(x));
  }
  template <class Field>
  std::optional<Frame3d> material_axes_of(const Field& field, int k, const Places& x) const {
    return Brick::material_axes_of(field, k, as_brick(x));
  }
  template <class Put>
  void set_layer(const Put& put, int k, const ElementGroup::Layer& l, const Places& x) const {
    Brick::set_layer(put, k, l, as_brick(x));
  }
};

}  // namespace nugget::system
