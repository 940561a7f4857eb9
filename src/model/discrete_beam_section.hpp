// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/discrete_beam.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// What a discrete beam is by its section and its law, `law` that of `material`.
inline kernel::DiscreteBeamProperties discrete_beam_properties(const SectionBeam& section, const Material& material,
                                                               const kernel::DiscreteBeam& law) {
  return {.mass = material.density * section.volume,
          .inertia = section.inertia,
          .scoor = section.scoor,
          .between_points = law.between_points,
          .cable_area = section.cable_area,
          .cable_offset = section.cable_offset,
          .joins_sheets = law.joint.has_value()};
}

}  // namespace nugget::model
