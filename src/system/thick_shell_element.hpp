// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "base/index.hpp"
#include "kernel/element/thick_shell.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"
#include "system/point_numbers.hpp"

namespace nugget::system {

/// The layers that *SECTION_TSHELL asks for, and INTGRD of *CONTROL_SHELL where it leaves the choice.
kernel::LayerRule layer_rule(const model::SectionSolid::Thickness& through, const model::Control& control);

/// The thick shell as BatchGroup wants it; see there. It takes no imposed stresses (INITIAL_STRESS_SECTION).
template <class Law>
struct ThickShellElement {
  static constexpr int corners = 8;
  static constexpr bool rotational = false;
  static constexpr bool single_precision = false;
  using Layout = kernel::ThickShellLayout;
  template <class R>
  using Motion = kernel::SolidMotion<R>;
  using Places = std::array<Vec3d, 8>;

  kernel::ThickShellProperties shell;
  kernel::LawKernel<Law> law;

  Layout layout() const { return kernel::thick_shell_layout(shell, law); }
  int state_size() const { return layout().size(); }
  int layers() const { return shell.layers.count; }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_thick_shell(layout(), state, native_width, lane);
    const double size = std::cbrt(kernel::hexahedron_volume(x));
    for (int k = 0; k < layers(); ++k)
      for (int c = 0; c < layout().columns; ++c)
        start_size(law, state + layout().history_of(k, c) * native_width + lane, native_width, size);
  }
  double mass(model::Index, const Places& x) const {
    return 8.0 * kernel::hexahedron_nodal_mass(x, shell.brick.density);
  }
  double nodal_inertia(model::Index, const Places&) const { return 0.0; }

  template <class R>
  kernel::SolidForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::thick_shell_cycle(shell, law, motion, dt, state);
  }

  template <class Field>
  ElementGroup::Layer layer(const Field& field, int k, const Places&) const {
    ElementGroup::Layer l;  // of four points their mean
    const Layout of = layout();
    const double share = 1.0 / of.columns;
    for (int c = 0; c < of.columns; ++c) {
      for (int i = 0; i < 6; ++i) l.stress[at(i)] += share * field(of.layer(k, c) + i);
      if (kernel::LawKernel<Law>::has_plastic_strain) l.plastic_strain += share * field(of.history_of(k, c));
    }
    l.damage = damage_of(law, field, of.columns, [&of, k](int c) { return of.history_of(k, c); });
    return l;
  }
  template <class Put>
  void set_layer(const Put& put, int k, const ElementGroup::Layer& l, const Places&) const {
    for (int c = 0; c < layout().columns; ++c) {
      for (int i = 0; i < 6; ++i) put(layout().layer(k, c) + i, l.stress[at(i)]);
      if (kernel::LawKernel<Law>::has_plastic_strain) put(layout().history_of(k, c), l.plastic_strain);
    }
  }
  /// The same element without viscous forces.
  ThickShellElement inviscid() const {
    ThickShellElement e = *this;
    e.shell.brick.bulk_quadratic = e.shell.brick.bulk_linear = 0.0;
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
