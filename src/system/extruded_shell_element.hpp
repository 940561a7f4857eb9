// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "base/index.hpp"
#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/extruded_shell.hpp"
#include "system/shell_elements.hpp"

namespace nugget::system {

/// The extruded shell (thick shells with laws of shells) as BatchGroup wants it; see there. It takes no imposed
/// stresses (INITIAL_STRESS_SECTION).
template <class Law>
struct ExtrudedShellElement {
  static constexpr int corners = 8;
  static constexpr bool rotational = false;
  static constexpr bool single_precision = false;
  using Layout = kernel::ExtrudedShellLayout;
  template <class R>
  using Motion = kernel::SolidMotion<R>;
  using Places = std::array<Vec3d, 8>;

  kernel::ExtrudedShellProperties extruded;
  kernel::LawKernel<Law> law;

  Layout layout() const { return kernel::extruded_shell_layout(extruded, law); }
  int state_size() const { return layout().size(); }
  int layers() const { return extruded.shell.layers.count; }
  int columns() const { return layout().shell.columns; }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_extruded_shell(layout(), x, state, native_width, lane);
    const double size = std::sqrt(kernel::shell_area(kernel::midway_nodes(x)));
    for (int k = 0; k < layers(); ++k)
      for (int column = 0; column < columns(); ++column)
        start_size(law, state + layout().history_of(k, column) * native_width + lane, native_width, size);
  }
  double mass(model::Index, const Places& x) const {
    return 8.0 * kernel::hexahedron_nodal_mass(x, extruded.shell.density);
  }
  double nodal_inertia(model::Index, const Places&) const { return 0.0; }

  template <class R>
  kernel::SolidForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::extruded_shell_cycle(extruded, law, motion, dt, state);
  }

  /// Component `c` of layer k, counted on into its history: the mean over the columns.
  template <class Field>
  double component(const Field& field, int k, int c) const {
    double sum = 0.0;
    for (int column = 0; column < columns(); ++column) sum += field(layout().layer(k, column) + c);
    return sum / columns();
  }
  /// In global axes; across the midway surface there is none of the stress that resists there.
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int k, const Places& x) const {
    std::array<double, 5> s;
    for (int c = 0; c < 5; ++c) s[at(c)] = component(field, k, c);
    return {global_stress(kernel::shell_frame(kernel::midway_nodes(x)), s[0], s[1], s[2], s[3], s[4]),
            kernel::LawKernel<Law>::has_plastic_strain ? component(field, k, 5) : 0.0,
            damage_of(law, field, columns(), [&](int column) { return layout().history_of(k, column); })};
  }
  /// The other way round: all columns get the same stress.
  template <class Put>
  void set_layer(const Put& put, int k, const ElementGroup::Layer& l, const Places& x) const {
    const std::array<double, 5> s = local_stress(kernel::shell_frame(kernel::midway_nodes(x)), l.stress);
    for (int column = 0; column < columns(); ++column) {
      for (int c = 0; c < 5; ++c) put(layout().layer(k, column) + c, s[at(c)]);
      if (kernel::LawKernel<Law>::has_plastic_strain) put(layout().layer(k, column) + 5, l.plastic_strain);
    }
  }
  /// The same element without viscous forces.
  ExtrudedShellElement inviscid() const {
    ExtrudedShellElement e = *this;
    e.extruded.bulk_quadratic = e.extruded.bulk_linear = 0.0;
    kernel::ShellProperties& shell = e.extruded.shell;
    if (shell.hourglass <= 3) shell.membrane_hourglass = shell.bending_hourglass = shell.warping_hourglass = 0.0;
    return e;
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
