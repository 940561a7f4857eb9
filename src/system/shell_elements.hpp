// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "base/index.hpp"
#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/c0_triangle.hpp"
#include "kernel/element/full_shell.hpp"
#include "kernel/element/kirchhoff_triangle.hpp"
#include "kernel/element/membrane.hpp"
#include "kernel/law/laminate_kernel.hpp"
#include "kernel/law/own_kernels.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"
#include "system/material_axes.hpp"
#include "system/point_numbers.hpp"

// The shells as BatchGroup wants them; see there.
namespace nugget::system {

/// Global stress of a shell layer, from its components in the element's frame.
std::array<double, 6> global_stress(const Frame3d& frame, double xx, double yy, double xy, double xz, double yz);

/// Components xx yy xy xz yz in the element's frame of a global stress; what else it has there is lost.
std::array<double, 5> local_stress(const Frame3d& frame, const std::array<double, 6>& stress);

/// ELFORM 2, 4, 16 and 17; 5 and 9, and the triangles of both.
enum class ShellKind { one_point, triangle, full, kirchhoff, membrane, full_membrane, membrane_triangle };

constexpr bool is_membrane(ShellKind kind) {
  return kind == ShellKind::membrane || kind == ShellKind::full_membrane || kind == ShellKind::membrane_triangle;
}
constexpr bool is_triangle(ShellKind kind) {
  return kind == ShellKind::triangle || kind == ShellKind::kirchhoff || kind == ShellKind::membrane_triangle;
}
/// Four columns of layers, as those of full_shell_cycle.
constexpr bool is_full(ShellKind kind) {
  return kind == ShellKind::full || kind == ShellKind::full_membrane;
}

/// Formulation of the shells of three nodes in a section: 4, 17, or 0 where they are collapsed quads.
inline int triangle_formulation(const model::SectionShell& section, const model::Control& control) {
  if (section.elform == 4 || section.elform == 17) return section.elform;
  using enum model::SortTriangles;
  return control.sort_triangles == kirchhoff ? 17 : control.sort_triangles == c0 ? 4 : 0;
}

/// Places and shares of thickness of the layers of a section.
kernel::LayerRule layer_rule(const model::SectionShell& section, const model::Control& control);
/// The same of a part of shells.
kernel::LayerRule layer_rule(const model::Model& model, model::Index part);

template <class Law, ShellKind Kind>
struct ShellElement {
  static constexpr int corners = is_triangle(Kind) ? 3 : 4;
  static constexpr int columns = is_full(Kind)                  ? kernel::full_shell_columns
                                 : Kind == ShellKind::kirchhoff ? kernel::kirchhoff_columns
                                                                : 1;
  static constexpr bool rotational = !is_membrane(Kind);
  static constexpr bool single_precision =
      (Kind == ShellKind::one_point || Kind == ShellKind::full) && kernel::built_for_single<Law>;
  using Layout = kernel::ShellLayout;
  template <class R>
  using Motion = kernel::NodalMotion<R, corners>;
  using Places = std::array<Vec3d, corners>;

  kernel::ShellProperties shell;
  kernel::LawKernel<Law> law;
  const model::Shells& shells;
  double mass_per_area;

  kernel::ShellLayout layout() const {
    if constexpr (is_full(Kind))
      return kernel::full_shell_layout(shell, law);
    else if constexpr (Kind == ShellKind::kirchhoff)
      return kernel::kirchhoff_layout(shell, law);
    else
      return kernel::shell_layout(shell, law);
  }
  /// By how much a layer's material axes are turned against those of its material [rad].
  double angle_of(int k) const {
    if constexpr (std::is_same_v<Law, kernel::Laminate>) return law.of(k).angle;
    return 0.0;
  }
  /// Factor on a layer's transverse shear stress.
  double shear_force(int k) const {
    if constexpr (std::is_same_v<Law, kernel::Laminate>) return shell.shear_factor * law.of(k).shear_force;
    return shell.shear_factor;
  }
  int state_size() const { return layout().size(); }
  int layers() const { return shell.layers.count; }

  void start(double* state, int lane, model::Index e, const Places& x) const {
    kernel::start_shell(layout(), shells.thickness[e], state, native_width, lane);
    const Frame3d frame = frame_of(x);
    const double size = std::sqrt(area(x));
    for (int k = 0; k < layers(); ++k) {
      const auto& own = kernel::law_of(law, k);
      const auto each_point = [&](const auto& begin) {
        for (int column = 0; column < columns; ++column)
          begin(state + layout().history_of(k, column) * native_width + lane);
      };
      each_point([&](double* history) { start_size(own, history, native_width, size); });
      const kernel::MaterialAxes* axes = material_axes(own);
      if (!axes) continue;
      const Vec3d a = unit(frame.local(axes->in_shell(x[1] - x[0], frame.e3, shells.own_angle(e))));
      const double angle = angle_of(k), c = std::cos(angle), s = std::sin(angle);
      each_point([&](double* history) {
        kernel::start_layer_axes(history, native_width, c * a.x - s * a.y, c * a.y + s * a.x);
      });
    }
  }
  /// Numbers of an element's state that say, by 1, that it stands beside a deleted element; none where that is nothing
  /// to its laws.
  std::vector<int> crash_front_fields() const {
    std::vector<int> fields;
    for (int k = 0; k < layers(); ++k) {
      const auto& own = kernel::law_of(law, k);
      if constexpr (requires { own.crash_front_field(); })
        if (const int field = own.crash_front_field(); field > 0)
          for (int column = 0; column < columns; ++column) fields.push_back(layout().history_of(k, column) + field);
    }
    return fields;
  }
  static double area(const Places& x) {
    if constexpr (corners == 4)
      return kernel::shell_area(x);
    else
      return kernel::triangle_area(x);
  }
  kernel::NodalMass nodal_mass(model::Index e, const Places& x) const {
    const double t = shells.thickness[e];
    const double shear_share = shell.shear_factor * law.elastic().shear / law.elastic().plane;
    if constexpr (is_membrane(Kind) && corners == 4)
      return {kernel::shell_nodal_mass(x, t, shell.density, 0.0, mass_per_area).mass, 0.0};
    else if constexpr (is_membrane(Kind))
      return {kernel::triangle_nodal_mass(x, t, shell.density, 0.0, mass_per_area).mass, 0.0};
    else if constexpr (corners == 4)
      return kernel::shell_nodal_mass(x, t, shell.density, shell.offset, mass_per_area, shear_share, shell.profile);
    else if constexpr (Kind == ShellKind::kirchhoff)
      return kernel::kirchhoff_nodal_mass(x, t, shell.density, shell.offset, mass_per_area, shell.profile);
    else
      return kernel::triangle_nodal_mass(x, t, shell.density, shell.offset, mass_per_area, shear_share, shell.profile);
  }
  double mass(model::Index e, const Places& x) const { return corners * nodal_mass(e, x).mass; }
  double nodal_inertia(model::Index e, const Places& x) const { return nodal_mass(e, x).inertia; }

  template <class R>
  kernel::NodalForces<R, corners> cycle(const Motion<R>& motion, double dt, Number<R>* state) const {
    if constexpr (Kind == ShellKind::one_point)
      return kernel::shell_cycle(shell, law, motion, dt, state);
    else if constexpr (Kind == ShellKind::full)
      return kernel::full_shell_cycle(shell, law, motion, dt, state);
    else if constexpr (Kind == ShellKind::kirchhoff)
      return kernel::kirchhoff_triangle_cycle(shell, law, motion, dt, state);
    else if constexpr (Kind == ShellKind::membrane)
      return kernel::membrane_cycle(shell, law, motion, dt, state);
    else if constexpr (Kind == ShellKind::full_membrane)
      return kernel::full_membrane_cycle(shell, law, motion, dt, state);
    else if constexpr (Kind == ShellKind::membrane_triangle)
      return kernel::membrane_triangle_cycle(shell, law, motion, dt, state);
    else
      return kernel::triangle_cycle(shell, law, motion, dt, state);
  }

  /// Component `c` of layer k, counted on into its history: the mean over the columns.
  template <class Field>
  double component(const Field& field, int k, int c) const {
    double sum = 0.0;
    for (int column = 0; column < columns; ++column) sum += field(layout().layer(k, column) + c);
    return sum / columns;
  }
  static Frame3d frame_of(const Places& x) {
    if constexpr (corners == 4)
      return kernel::shell_frame(x);
    else
      return kernel::triangle_frame(x);
  }
  template <class Field>
  std::optional<Frame3d> material_axes_of(const Field& field, int k, const Places& x) const {
    if (material_axes(kernel::law_of(law, k)) == nullptr) return {};
    const int i = layout().history_of(k) + kernel::first_axis_field;
    const Frame3d frame = frame_of(x);
    const Vec3d a = field(i) * frame.e1 + field(i + 1) * frame.e2;
    return Frame3d{a, cross(frame.e3, a), frame.e3};
  }
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int k, const Places& x) const {
    return layer_in(frame_of(x), field, k);
  }
  template <class Field>
  ElementGroup::Layer layer_in(const Frame3d& frame, const Field& field, int k) const {
    std::array<double, 5> s;
    for (int c = 0; c < 5; ++c) s[c] = component(field, k, c);
    return {
        global_stress(frame, s[0], s[1], s[2], s[3], s[4]),
        kernel::LawKernel<Law>::has_plastic_strain ? component(field, k, 5) : 0.0,
        damage_of(kernel::law_of(law, k), field, columns, [&](int column) { return layout().history_of(k, column); })};
  }
  /// The other way round: all columns get the same stress.
  template <class Put>
  void set_layer(const Put& put, int k, const ElementGroup::Layer& l, const Places& x) const {
    const std::array<double, 5> s = local_stress(frame_of(x), l.stress);
    for (int column = 0; column < columns; ++column) {
      for (int c = 0; c < 5; ++c) put(layout().layer(k, column) + c, s[c]);
      if (kernel::LawKernel<Law>::has_plastic_strain) put(layout().layer(k, column) + 5, l.plastic_strain);
    }
  }
  /// A law whose stress has the part D of its change in it, as that of fabric, has (1 + D) of the stiffness in the
  /// forces of a step, and (1 + 2 D) of it in the limit of the step, 1 / step_share^2.
  double viscous_stiffness() const {
    if constexpr (is_membrane(Kind) && requires { law.step_share(); }) {
      const double whole = 1.0 / (law.step_share() * law.step_share());
      return 2.0 * whole / (1.0 + whole);
    }
    return 1.0;
  }
  /// The same element without viscous forces.
  ShellElement inviscid() const {
    ShellElement e = *this;
    e.shell.bulk_quadratic = e.shell.bulk_linear = 0.0;
    if (e.shell.hourglass <= 3)
      e.shell.membrane_hourglass = e.shell.bending_hourglass = e.shell.warping_hourglass = 0.0;
    if (is_membrane(Kind)) e.shell.warping_hourglass = 0.0;
    return e;
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
      const auto point = at(k);
      const double w = t * shell.layers.weight[point], z = 0.5 * t * (shell.layers.zeta[point] - shell.offset);
      for (int c = 0; c < 3; ++c) r[c] += w * z * component(field, k, c);
      for (int c = 0; c < 2; ++c) r[3 + c] += shear_force(k) * w * component(field, k, 3 + c);
      for (int c = 0; c < 3; ++c) r[5 + c] += w * component(field, k, c);
    }
    return r;
  }
};

}  // namespace nugget::system
