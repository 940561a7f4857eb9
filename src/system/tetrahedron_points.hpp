// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "kernel/element/hexahedron.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"
#include "system/imposed_stress.hpp"
#include "system/material_axes.hpp"
#include "system/point_numbers.hpp"

namespace nugget::system {

/// What the tetrahedra of several points share as BatchGroup wants it; see there. `Element` derives from it and gives
/// `layout()`, whose Layout has `points`, `point(p)` (the six stresses) and `history_of(p)`.
template <class Law, class Element>
struct TetrahedronPoints {
  kernel::HexahedronProperties solid;
  kernel::LawKernel<Law> law;

  int state_size() const { return self().layout().size(); }
  int layers() const { return 1; }

  /// The same element without viscous forces.
  Element inviscid() const {
    Element e = self();
    e.solid.bulk_quadratic = e.solid.bulk_linear = 0.0;
    return e;
  }

  /// The mean of the points.
  template <class Field, class Places>
  ElementGroup::Layer layer(const Field& field, int, const Places&) const {
    const auto layout = self().layout();
    const double share = 1.0 / layout.points;
    ElementGroup::Layer l;
    for (int p = 0; p < layout.points; ++p) {
      for (int i = 0; i < 6; ++i) l.stress[i] += share * field(layout.point(p) + i);
      if (kernel::LawKernel<Law>::has_plastic_strain) l.plastic_strain += share * field(layout.history_of(p));
    }
    l.damage = damage_of(law, field, layout.points, [&](int p) { return layout.history_of(p); });
    return l;
  }
  template <class Field, class Places>
  std::optional<Frame3d> material_axes_of(const Field& field, int, const Places&) const {
    const auto layout = self().layout();
    return solid_material_axes(law, field, layout.points, [&](int p) { return layout.history_of(p); });
  }
  /// All points get the same stress.
  template <class Put, class Places>
  void set_layer(const Put& put, int, const ElementGroup::Layer& l, const Places&) const {
    const auto layout = self().layout();
    for (int p = 0; p < layout.points; ++p) {
      for (int i = 0; i < 6; ++i) put(layout.point(p) + i, l.stress[i]);
      if (kernel::LawKernel<Law>::has_plastic_strain) put(layout.history_of(p), l.plastic_strain);
    }
  }
  template <class Field, class Put, class Change>
  void change_stresses(const Field& field, const Put& put, const Change& change) const {
    const auto layout = self().layout();
    for (int p = 0; p < layout.points; ++p) change_solid_point(field, put, layout.point(p), change);
  }
  template <class Field>
  double thickness(const Field&) const {
    return 0.0;
  }
  template <class Field>
  std::array<double, 8> resultants(const Field&) const {
    return {};
  }

 protected:
  /// Size and material axes of all points, of laws that have them; x: the nodes, corners first.
  template <class Places>
  void start_points(double* state, int lane, const Places& x) const {
    const auto layout = self().layout();
    const double size = std::cbrt(self().volume(x));
    for (int p = 0; p < layout.points; ++p) {
      double* history = state + layout.history_of(p) * native_width + lane;
      start_size(law, history, native_width, size);
      if (const kernel::MaterialAxes* axes = material_axes(law))
        kernel::start_solid_axes(history, native_width, axes->in_brick(x[1] - x[0], x[3] - x[0]));
    }
  }

 private:
  const Element& self() const { return static_cast<const Element&>(*this); }
};

}  // namespace nugget::system
