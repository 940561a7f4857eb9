// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <memory>

#include "kernel/element/tetrahedron.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"
#include "system/imposed_stress.hpp"
#include "system/material_axes.hpp"
#include "system/nodal_pressure.hpp"
#include "system/point_numbers.hpp"

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
  kernel::LawKernel<Law> law;
  std::shared_ptr<NodalPressure> nodal_pressure;  ///< of ELFORM 13; null: each element has its own pressure

  Layout layout() const { return kernel::tetrahedron_layout(law, nodal_pressure != nullptr); }
  int state_size() const { return layout().size(); }
  int layers() const { return 1; }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_tetrahedron(layout(), state, native_width, lane);
    double* history = state + Layout::first_history * native_width + lane;
    start_size(law, history, native_width, std::cbrt(kernel::tetrahedron_volume(x)));
    if (const kernel::MaterialAxes* axes = material_axes(law))
      kernel::start_solid_axes(history, native_width, axes->in_brick(x[1] - x[0], x[3] - x[0]));
  }
  double mass(model::Index, const Places& x) const { return solid.density * kernel::tetrahedron_volume(x); }
  double nodal_inertia(model::Index, const Places&) const { return 0.0; }

  template <class R>
  kernel::TetrahedronForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::tetrahedron_cycle(solid, law, layout(), motion, dt, state);
  }

  /// `put(e, field, value)` sets a field of element e.
  template <class Alive, class Put>
  void before_cycle(const State& now, const Alive& alive, const Put& put) const {
    if (!nodal_pressure) return;
    const std::vector<double>& mean = nodal_pressure->update(now, alive);
    for (std::size_t e = 0; e < mean.size(); ++e) put(e, layout().mean_stress(), mean[e]);
  }

  template <class Field>
  ElementGroup::Layer layer(const Field& field, int, const Places&) const {
    ElementGroup::Layer l;
    for (int i = 0; i < 6; ++i) l.stress[i] = field(Layout::stress + i);
    if (kernel::LawKernel<Law>::has_plastic_strain) l.plastic_strain = field(Layout::first_history);
    l.damage = damage_of(law, field, 1, [](int) { return Layout::first_history; });
    return l;
  }
  template <class Field>
  std::optional<Frame3d> material_axes_of(const Field& field, int, const Places&) const {
    return solid_material_axes(law, field, 1, [](int) { return Layout::first_history; });
  }
  template <class Put>
  void set_layer(const Put& put, int, const ElementGroup::Layer& l, const Places&) const {
    for (int i = 0; i < 6; ++i) put(Layout::stress + i, l.stress[i]);
    if (kernel::LawKernel<Law>::has_plastic_strain) put(Layout::first_history, l.plastic_strain);
  }
  template <class Field, class Put, class Change>
  void change_stresses(const Field& field, const Put& put, const Change& change) const {
    change_solid_point(field, put, Layout::stress, change);
  }
  /// Where nodes have the pressure, an element's own counts for nothing.
  bool takes_stress() const { return nodal_pressure == nullptr; }
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
