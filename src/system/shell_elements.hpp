// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/c0_triangle.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"

// The shells as BatchGroup wants them; see there.
namespace nugget::system {

/// Global stress of a shell layer, from its components in the element's frame.
std::array<double, 6> global_stress(const Frame3d& frame, double xx, double yy, double xy, double xz, double yz);

template <class Law, int Corners>
struct ShellElement {
  static constexpr int corners = Corners;
  static constexpr bool rotational = true;
  using Layout = kernel::ShellLayout;
  template <class R>
  using Motion = kernel::NodalMotion<R, Corners>;
  using Places = std::array<Vec3d, Corners>;

  kernel::ShellProperties shell;
  kernel::Prepared<Law> law;
  const model::Shells& shells;
  double mass_per_area;

  kernel::ShellLayout layout() const { return kernel::shell_layout(shell, law); }
  int state_size() const { return layout().size(); }
  int layers() const { return shell.layers.count; }

  void start(double* state, int lane, model::Index e, const Places&) const {
    kernel::start_shell(layout(), shells.thickness[static_cast<std::size_t>(e)], state, native_width, lane);
  }
  kernel::NodalMass nodal_mass(model::Index e, const Places& x) const {
    const double t = shells.thickness[static_cast<std::size_t>(e)];
    if constexpr (Corners == 4)
      return kernel::shell_nodal_mass(x, t, shell.density, shell.offset, mass_per_area);
    else
      return kernel::triangle_nodal_mass(x, t, shell.density, shell.offset, mass_per_area);
  }
  double mass(model::Index e, const Places& x) const { return Corners * nodal_mass(e, x).mass; }
  double nodal_inertia(model::Index e, const Places& x) const { return nodal_mass(e, x).inertia; }

  template <class R>
  kernel::NodalForces<R, Corners> cycle(const Motion<R>& motion, double dt, double* state) const {
    if constexpr (Corners == 4)
      return kernel::shell_cycle(shell, law, motion, dt, state);
    else
      return kernel::triangle_cycle(shell, law, motion, dt, state);
  }

  template <class Field>
  ElementGroup::Layer layer(const Field& field, int k, const Places& x) const {
    const int at = layout().layer(k);
    Frame3d frame;
    if constexpr (Corners == 4)
      frame = kernel::shell_frame(x);
    else
      frame = kernel::triangle_frame(x);
    return {global_stress(frame, field(at), field(at + 1), field(at + 2), field(at + 3), field(at + 4)),
            kernel::Prepared<Law>::has_plastic_strain ? field(layout().history_of(k)) : 0.0};
  }
  template <class Field>
  double thickness(const Field& field) const {
    return field(Layout::thickness);
  }
  /// Mx My Mxy Qx Qy Nx Ny Nxy per unit length, in the element's frame.
  template <class Field>
  std::array<double, 8> resultants(const Field& field) const {
    std::array<double, 8> r{};
    const double t = field(Layout::thickness);
    for (int k = 0; k < layers(); ++k) {
      const auto point = static_cast<std::size_t>(k);
      const int at = layout().layer(k);
      const double w = t * shell.layers.weight[point], z = 0.5 * t * (shell.layers.zeta[point] - shell.offset);
      for (int c = 0; c < 3; ++c) r[static_cast<std::size_t>(c)] += w * z * field(at + c);
      for (int c = 0; c < 2; ++c) r[static_cast<std::size_t>(3 + c)] += shell.shear_factor * w * field(at + 3 + c);
      for (int c = 0; c < 3; ++c) r[static_cast<std::size_t>(5 + c)] += w * field(at + c);
    }
    return r;
  }
};

}  // namespace nugget::system
