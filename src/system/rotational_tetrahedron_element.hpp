// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/element/rotational_tetrahedron.hpp"
#include "kernel/element/tetrahedron.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"
#include "system/imposed_stress.hpp"
#include "system/material_axes.hpp"

namespace nugget::system {

/// The tetrahedron with nodal rotations as BatchGroup wants it; see there.
template <class Law>
struct RotationalTetrahedronElement {
  static constexpr int corners = 4;
  static constexpr bool rotational = true;
  using Layout = kernel::RotationalTetrahedronLayout;
  template <class R>
  using Motion = kernel::NodalMotion<R, 4>;
  using Places = std::array<Vec3d, 4>;

  kernel::HexahedronProperties solid;
  kernel::Prepared<Law> law;

  Layout layout() const { return kernel::rotational_tetrahedron_layout(law); }
  int state_size() const { return layout().size(); }
  int layers() const { return 1; }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_rotational_tetrahedron(layout(), x, state, native_width, lane);
    if (const kernel::MaterialAxes* axes = material_axes(law))
      for (int p = 0; p < Layout::points; ++p)
        kernel::start_solid_axes(state + layout().history_of(p) * native_width + lane, native_width,
                                 axes->in_brick(x[1] - x[0], x[3] - x[0]));
  }
  double mass(model::Index, const Places& x) const { return solid.density * kernel::tetrahedron_volume(x); }
  double nodal_inertia(model::Index, const Places& x) const {
    return kernel::rotational_tetrahedron_inertia(x, solid.density);
  }

  template <class R>
  kernel::RotationalTetrahedronForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::rotational_tetrahedron_cycle(solid, law, motion, dt, state);
  }
  /// The same element without viscous forces.
  RotationalTetrahedronElement inviscid() const {
    RotationalTetrahedronElement e = *this;
    e.solid.bulk_quadratic = e.solid.bulk_linear = 0.0;
    return e;
  }

  /// The mean of the points.
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int, const Places&) const {
    constexpr double share = 1.0 / Layout::points;
    ElementGroup::Layer l;
    for (int p = 0; p < Layout::points; ++p) {
      for (int i = 0; i < 6; ++i) l.stress[static_cast<std::size_t>(i)] += share * field(layout().point(p) + i);
      if (kernel::Prepared<Law>::has_plastic_strain) l.plastic_strain += share * field(layout().history_of(p));
    }
    return l;
  }
  /// All points get the same stress.
  template <class Put>
  void set_layer(const Put& put, int, const ElementGroup::Layer& l, const Places&) const {
    for (int p = 0; p < Layout::points; ++p) {
      for (int i = 0; i < 6; ++i) put(layout().point(p) + i, l.stress[static_cast<std::size_t>(i)]);
      if (kernel::Prepared<Law>::has_plastic_strain) put(layout().history_of(p), l.plastic_strain);
    }
  }
  template <class Field, class Put, class Change>
  void change_stresses(const Field& field, const Put& put, const Change& change) const {
    for (int p = 0; p < Layout::points; ++p) change_solid_point(field, put, layout().point(p), change);
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
