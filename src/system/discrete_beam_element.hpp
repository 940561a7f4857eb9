// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "base/index.hpp"
#include "kernel/element/discrete_beam.hpp"
#include "model/model.hpp"
#include "system/beam.hpp"
#include "system/element_group.hpp"

namespace nugget::system {

/// The discrete beam as BatchGroup wants it; see there.
struct DiscreteBeamElement {
  static constexpr int corners = 2;
  static constexpr bool rotational = true;
  using Layout = BeamLayout<kernel::DiscreteBeamLayout>;
  template <class R>
  using Motion = kernel::NodalMotion<R, 2>;
  using Places = std::array<Vec3d, 2>;

  kernel::DiscreteBeamProperties beam;
  const kernel::DiscreteBeam& law;
  std::optional<Frame3d> axes;  ///< of CID
  const model::Beams& beams;
  const std::vector<Vec3d>& x;  ///< by model node

  int state_size() const { return Layout::count; }
  int layers() const { return 0; }

  void start(double* state, int lane, model::Index element, const Places& place) const {
    kernel::start_discrete_beam(beam, law, triad(element, place), place[0], place[1], state, native_width, lane);
  }
  double mass(model::Index, const Places&) const { return beam.mass; }
  double nodal_inertia(model::Index, const Places&) const { return 0.5 * beam.inertia; }

  template <class R>
  kernel::NodalForces<R, 2> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::discrete_beam_cycle(beam, law, motion, dt, state);
  }

  /// Curves and dampers have no exact derivative by a tiny step, so the stiffness is written down; see BatchGroup.
  template <class Field>
  void stiffness(const Field& field, const Places& place, std::span<double> k) const {
    kernel::discrete_beam_stiffness(beam, law, axes_now(field), place[1] - place[0], k);
  }
  template <class Field>
  bool viscosity(const Field& field, const Places& place, std::span<double> c) const {
    return kernel::discrete_beam_viscosity(beam, law, axes_now(field), place[1] - place[0], c);
  }

  template <class Field>
  bool force_at_start(const Field& field, const Places& place, std::span<double> f) const {
    return kernel::discrete_beam_force_at_start(beam, law, axes_now(field), place[1] - place[0], f);
  }

  template <class Field>
  ElementGroup::Layer layer(const Field&, int, const Places&) const {
    return {};
  }
  template <class Field>
  double thickness(const Field& field) const {
    return field(Layout::length);
  }
  template <class Field>
  std::array<double, 8> resultants(const Field& field) const {
    std::array<double, 8> r = beam_resultants<Layout>(field);
    if (law.joint) r[6] = field(Layout::joint_plastic), r[7] = field(Layout::joint_damage);
    return r;
  }

  template <class Field>
  std::array<double, 6> displacements(const Field& field) const {
    std::array<double, 6> u{};
    for (int i = 0; i < 6; ++i) u[at(i)] = field(Layout::displacement + i);
    return u;
  }
  template <class Field>
  static Frame3d axes_now(const Field& field) {
    const Vec3d r{field(Layout::axis_r), field(Layout::axis_r + 1), field(Layout::axis_r + 2)};
    const Vec3d s{field(Layout::axis_s), field(Layout::axis_s + 1), field(Layout::axis_s + 2)};
    return {r, s, cross(r, s)};
  }

 private:
  /// A global axis that is not along r: the law of a joint is the same in all directions of the sheets.
  static Vec3d any_other(const Vec3d& r) { return std::abs(r.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}; }
  /// Axes of CID; else r from node 1 to node 2 with s towards the third node; else the global ones.
  Frame3d triad(model::Index element, const Places& place) const {
    const Frame3d global{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (axes) return *axes;
    const Vec3d line = place[1] - place[0];
    if (!(norm(line) > 0.0)) return global;
    const Vec3d r = unit(line);
    const Vec3d towards = beam.joins_sheets ? any_other(r) : beams.side(at(element), x);
    const Vec3d s = towards - dot(towards, r) * r;
    if (!(norm(s) > 1e-9 * norm(towards))) return global;
    return {r, unit(s), cross(r, unit(s))};
  }
};

}  // namespace nugget::system
