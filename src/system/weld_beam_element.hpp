// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/element/weld_beam.hpp"
#include "model/model.hpp"
#include "system/element_group.hpp"
#include "system/point_integrity.hpp"

namespace nugget::system {

/// The spot-weld beam as BatchGroup wants it; see there.
struct WeldBeamElement {
  static constexpr int corners = 2;
  static constexpr bool rotational = true;
  struct Layout : kernel::WeldBeamLayout {
    static constexpr int hourglass_energy = -1;  ///< it has none
  };
  template <class R>
  using Motion = kernel::NodalMotion<R, 2>;
  using Places = std::array<Vec3d, 2>;

  kernel::WeldBeamProperties beam;
  kernel::Prepared<kernel::Spotweld> law;
  double nu;
  const model::Beams& beams;
  const std::vector<Vec3d>& x;  ///< by model node

  kernel::WeldBeamLayout layout() const { return kernel::weld_beam_layout(beam, law); }
  int state_size() const { return layout().size(); }
  int layers() const { return beam.fibres.count; }

  void start(double* state, int lane, model::Index e, const Places& place) const {
    const model::Index third = beams.orientation[static_cast<std::size_t>(e)];
    const Vec3d towards = third == model::none ? Vec3d{} : x[static_cast<std::size_t>(third)] - place[0];
    kernel::start_weld_beam(layout(), place[0], place[1], towards, state, native_width, lane);
  }
  kernel::NodalMass nodal_mass(const Places& place) const {
    return kernel::weld_beam_nodal_mass(beam, norm(place[1] - place[0]), beam.density, nu);
  }
  double mass(model::Index, const Places& place) const { return 2.0 * nodal_mass(place).mass; }
  double nodal_inertia(model::Index, const Places& place) const { return nodal_mass(place).inertia; }

  template <class R>
  kernel::NodalForces<R, 2> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::weld_beam_cycle(beam, law, motion, dt, state);
  }

  template <class Field>
  double plastic_strain(const Field& field, int k) const {
    return field(layout().history_of(k));
  }
  template <class Field>
  double integrity(const Field& field) const {
    return point_integrity(law, field, layers(), [this](int k) { return layout().history_of(k); });
  }
  void hold_yield(double* state, int lane) const { kernel::hold_yield(layout(), law, state, native_width, lane); }

  /// Stress of a section point: rr in the first place, rs and rt in the fourth and the sixth.
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int k, const Places&) const {
    const int at = layout().fibre(k);
    const double left = field(Layout::integrity);
    return {{left * field(at), 0.0, 0.0, left * field(at + 1), 0.0, left * field(at + 2)},
            field(layout().history_of(k))};
  }
  /// The other way round; the stress of the sound point, which damage keeps, is the same.
  template <class Put>
  void set_layer(const Put& put, int k, const ElementGroup::Layer& l, const Places&) const {
    const double stress[3] = {l.stress[0], l.stress[3], l.stress[5]};
    for (int i = 0; i < 3; ++i) {
      put(layout().fibre(k) + i, stress[i]);
      put(layout().history_of(k) + kernel::Prepared<kernel::Spotweld>::sound + i, stress[i]);
    }
    put(layout().history_of(k), l.plastic_strain);
  }
  template <class Field>
  double thickness(const Field& field) const {
    return field(Layout::length);
  }
  /// N_rr N_rs N_rt M_rr M_ss M_tt.
  template <class Field>
  std::array<double, 8> resultants(const Field& field) const {
    std::array<double, 8> r{};
    for (int i = 0; i < 6; ++i) r[static_cast<std::size_t>(i)] = field(Layout::resultant + i);
    return r;
  }
};

}  // namespace nugget::system
