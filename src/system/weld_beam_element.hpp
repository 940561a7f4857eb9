// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "system/beam_elements.hpp"
#include "system/point_integrity.hpp"

namespace nugget::system {

/// The spot-weld beam as BatchGroup wants it; see there.
struct WeldBeamElement : IntegratedBeamElement<kernel::Spotweld> {
  std::map<model::Index, std::size_t> joint_of;  ///< in WeldBeamProperties::joints, by beam of the model
  /// Numbers of state that a beam has at most.
  static constexpr std::size_t most_state =
      Layout::first_fibre + Layout::joint_fields +
      kernel::most_fibres * (kernel::FibreTensor<double>::size + kernel::LawKernel<kernel::Spotweld>::fibre_history());

  void start(double* state, int lane, model::Index e, const Places& place) const {
    IntegratedBeamElement::start(state, lane, e, place);
    if (!joint_of.empty()) state[layout().joint_of() * native_width + lane] = static_cast<double>(joint_of.at(e));
  }
  void joint_trial(const Motion<double>& motion, double dt, const double* state, kernel::WeldTrial& trial) const {
    if (!beam.joints.empty()) trial = kernel::weld_beam_trial(beam, law, motion, dt, state);
  }
  template <class Field>
  double plastic_strain(const Field& field, int k) const {
    return field(layout().history_of(k));
  }
  template <class Field>
  double integrity(const Field& field) const {
    return point_integrity(law, field, layers(), [this](int k) { return layout().history_of(k); });
  }
  void freeze_yield(double* state, int lane) const { kernel::freeze_yield(layout(), law, state, native_width, lane); }

  /// Stress of a section point: rr in the first place, rs and rt in the fourth and the sixth.
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int k, const Places&) const {
    const int at = layout().fibre(k);
    const double left = field(Layout::integrity);
    return {{left * field(at), 0.0, 0.0, left * field(at + 1), 0.0, left * field(at + 2)},
            field(layout().history_of(k))};
  }
  /// The stress of the undamaged point, which damage keeps, becomes the same.
  template <class Field, class Put, class Change>
  void change_stresses(const Field& field, const Put& put, const Change& change) const {
    for (int k = 0; k < layers(); ++k) {
      const int undamaged = layout().history_of(k) + kernel::LawKernel<kernel::Spotweld>::undamaged_stress_field;
      change_fibre_point(
          field,
          [&](int i, double value) {
            put(i, value);
            put(undamaged + i - layout().fibre(k), value);
          },
          layout().fibre(k), change);
    }
  }
};

}  // namespace nugget::system
