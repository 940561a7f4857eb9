// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/parts.hpp"

namespace nugget::model {

/// *DEFINE_ELEMENT_DEATH_...: an element that is deleted at a time. *SENSOR_CONTROL with ELESET: by a switch.
struct ElementDeath {
  ElementKind kind = ElementKind::nothing;  ///< shell, solid or beam
  Index element = none;
  double time = 0.0;     ///< [time]; 0: it is not there from the start
  Index control = none;  ///< *SENSOR_CONTROL: it is deleted when that is off, whatever the time
};

}  // namespace nugget::model
