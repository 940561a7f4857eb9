// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "kernel/element/full_hexahedron.hpp"
#include "kernel/law/own_kernels.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"
#include "system/imposed_stress.hpp"
#include "system/material_axes.hpp"
#include "system/point_integrity.hpp"
#include "system/point_numbers.hpp"

namespace nugget::system {

/// The one-point brick as BatchGroup wants it; see there.
template <class Law>
struct BrickElement {
  static constexpr int corners = 8;
  static constexpr bool rotational = false;
  static constexpr bool single_precision = kernel::built_for_single<Law>;
  using Layout = kernel::HexahedronLayout;
  template <class R>
  using Motion = kernel::SolidMotion<R>;
  using Places = std::array<Vec3d, 8>;

  kernel::HexahedronProperties brick;
  kernel::LawKernel<Law> law;

  Layout layout() const { return kernel::hexahedron_layout(law); }
  int state_size() const { return layout().size(); }
  int layers() const { return 1; }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_hexahedron(layout(), x, state, native_width, lane);
    start_point(state + Layout::first_history * native_width + lane, x);
  }
  /// Size and material axes of the point whose history begins at `history`, of laws that have them.
  void start_point(double* history, const Places& x) const {
    start_size(law, history, native_width, std::cbrt(kernel::hexahedron_volume(x)));
    if (const kernel::MaterialAxes* axes = material_axes(law))
      kernel::start_solid_axes(history, native_width,
                               axes->in_brick(x[1] - x[0], x[3] - x[0], kernel::MaterialAxes::midway_normal(x)));
  }
  double mass(model::Index, const Places& x) const { return 8.0 * kernel::hexahedron_nodal_mass(x, brick.density); }
  double nodal_inertia(model::Index, const Places&) const { return 0.0; }

  template <class R>
  kernel::SolidForces<R> cycle(const Motion<R>& motion, double dt, Number<R>* state) const {
    return kernel::hexahedron_cycle(brick, law, motion, dt, state);
  }

  template <class Field>
  double plastic_strain(const Field& field, int) const {
    return field(Layout::first_history);
  }
  template <class Field>
  double integrity(const Field& field) const requires kernel::LawOfWelds<Law> {
    return point_integrity(law, field, 1, [](int) { return Layout::first_history; });
  }
  void freeze_yield(double* state, int lane) const requires kernel::LawOfWelds<Law> {
    kernel::freeze_yield(law, state, native_width, lane);
  }

  template <class Field>
  ElementGroup::Layer layer(const Field& field, int, const Places&) const {
    ElementGroup::Layer l;
    const double left = field(Layout::integrity);
    for (int i = 0; i < 6; ++i) l.stress[i] = left * field(Layout::stress + i);
    if (kernel::LawKernel<Law>::has_plastic_strain) l.plastic_strain = field(Layout::first_history);
    l.damage = damage_of(law, field, 1, [](int) { return Layout::first_history; });
    return l;
  }
  template <class Field>
  std::optional<Frame3d> material_axes_of(const Field& field, int, const Places&) const {
    return solid_material_axes(law, field, 1, [](int) { return Layout::first_history; });
  }
  template <class Put>
  void set_layer(const Put& put, int, const ElementGroup::Layer& l, const Places& x) const {
    set_point(put, Layout::stress, Layout::first_history, l, x);
  }
  /// Of the point whose stress and history stand there in the state.
  template <class Put>
  void set_point(const Put& put, int stress, int history, const ElementGroup::Layer& l, const Places& x) const {
    for (int i = 0; i < 6; ++i) put(stress + i, l.stress[i]);
    if (kernel::LawKernel<Law>::has_plastic_strain) put(history, l.plastic_strain);
    if constexpr (kernel::LawOfWelds<Law>) start_weld_point(law, put, history, l.stress, l.plastic_strain, x);
  }
  template <class Field, class Put, class Change>
  void change_stresses(const Field& field, const Put& put, const Change& change) const {
    change_point(field, put, Layout::stress, Layout::first_history, change);
  }
  template <class Field, class Put, class Change>
  void change_point(const Field& field, const Put& put, int stress, int history, const Change& change) const {
    change_solid_point(field, put, stress, [&](std::array<double, 6>& of_point) {
      change(of_point);
      if constexpr (kernel::LawOfWelds<Law>) put_undamaged(law, field, put, history, of_point);
    });
  }
  /// The axes of a uniaxial stress state are not those in which stresses are imposed.
  bool takes_stress() const requires kernel::LawOfWelds<Law> { return !law.uniaxial(); }
  /// The same element without viscous forces.
  BrickElement inviscid() const {
    BrickElement e = *this;
    e.make_inviscid();
    return e;
  }
  void make_inviscid() {
    brick.bulk_quadratic = brick.bulk_linear = 0.0;
    if (brick.hourglass <= 3) brick.hourglass_coefficient = 0.0;
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

/// The fully integrated brick as BatchGroup wants it; see there.
template <class Law>
struct FullBrickElement : BrickElement<Law> {
  static constexpr bool single_precision = false;
  using Layout = kernel::FullHexahedronLayout;
  using typename BrickElement<Law>::Places;
  template <class R>
  using Motion = kernel::SolidMotion<R>;

  kernel::BrickStrains strains = kernel::BrickStrains::shape_functions;

  Layout layout() const { return kernel::full_hexahedron_layout(this->law); }
  int state_size() const { return layout().size(); }

  void start(double* state, int lane, model::Index, const Places& x) const {
    kernel::start_full_hexahedron(layout(), state, native_width, lane);
    for (int p = 0; p < Layout::points; ++p) this->start_point(state + layout().history_of(p) * native_width + lane, x);
  }
  template <class R>
  kernel::SolidForces<R> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::full_hexahedron_cycle(this->brick, strains, this->law, motion, dt, state);
  }
  void freeze_yield(double* state, int lane) const requires kernel::LawOfWelds<Law> {
    kernel::freeze_yield(layout(), this->law, state, native_width, lane);
  }
  template <class Field>
  double plastic_strain(const Field& field, int) const {
    return mean_of_points(field, 0);
  }
  /// The i-th number of the history.
  template <class Field>
  double mean_of_points(const Field& field, int i) const {
    double mean = 0.0;
    for (int p = 0; p < Layout::points; ++p) mean += field(layout().history_of(p) + i) / Layout::points;
    return mean;
  }
  template <class Field>
  double integrity(const Field& field) const requires kernel::LawOfWelds<Law> {
    return point_integrity(this->law, field, Layout::points, [this](int p) { return layout().history_of(p); });
  }
  FullBrickElement inviscid() const {
    FullBrickElement e = *this;
    e.make_inviscid();
    return e;
  }
  template <class Field>
  std::optional<Frame3d> material_axes_of(const Field& field, int, const Places&) const {
    return solid_material_axes(this->law, field, Layout::points, [this](int p) { return layout().history_of(p); });
  }
  /// All points get the same stress.
  template <class Put>
  void set_layer(const Put& put, int, const ElementGroup::Layer& l, const Places& x) const {
    for (int p = 0; p < Layout::points; ++p) this->set_point(put, layout().point(p), layout().history_of(p), l, x);
  }
  template <class Field, class Put, class Change>
  void change_stresses(const Field& field, const Put& put, const Change& change) const {
    for (int p = 0; p < Layout::points; ++p)
      this->change_point(field, put, layout().point(p), layout().history_of(p), change);
  }
  /// The mean of the points.
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int, const Places&) const {
    const double share = field(Layout::integrity) / Layout::points;
    ElementGroup::Layer l;
    for (int p = 0; p < Layout::points; ++p)
      for (int i = 0; i < 6; ++i) l.stress[i] += share * field(layout().point(p) + i);
    if (kernel::LawKernel<Law>::has_plastic_strain) l.plastic_strain = mean_of_points(field, 0);
    l.damage = damage_of(this->law, field, Layout::points, [this](int p) { return layout().history_of(p); });
    return l;
  }
};

}  // namespace nugget::system
