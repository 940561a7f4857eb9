// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/element/tetrahedron.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"

namespace nugget::system {

/// The tetrahedron as BatchGroup wants it; see there.
template <class Law>
struct TetrahedronElement {
  static constexpr int corners = 4;
  static constexpr bool rotational = false;
  using Layout = kernel::TetrahedronLayout;
  template <class R>
  using Motion = kernel::TetrahedronMotion<R>;
  using Places = std::array<Vec3d, 4>;

  kernel::HexahedronProperties solid;
  kernel::Prepared<Law> law;

  Layout layout() const { return kernel::tetrahedron_layout(law); }
  int state_size() const { return layout().size(); }
  int layers() const { return 1; }

  void start(double* state, int lane, model::Index, const Places&) const {
    kernel::start_tetrahedron(layout(), state, native_width, lane);
  }
  double mass(model::Index, const Places& x) const { return solid.density * kernel::tetrahedron_volume(x); }
  double nodal_inertia(model::Index, const Places&) const { return 0.0; }

  template <class R>
  kernel::TetrahedronForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::tetrahedron_cycle(solid, law, motion, dt, state);
  }

  template <class Field>
  ElementGroup::Layer layer(const Field& field, int, const Places&) const {
    ElementGroup::Layer l;
    for (int i = 0; i < 6; ++i) l.stress[static_cast<std::size_t>(i)] = field(Layout::stress + i);
    if (kernel::Prepared<Law>::has_plastic_strain) l.plastic_strain = field(Layout::first_history);
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
