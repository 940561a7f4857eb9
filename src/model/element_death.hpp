// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/parts.hpp"

namespace nugget::model {

/// *DEFINE_ELEMENT_DEATH_...: an element that is deleted at a time.
struct ElementDeath {
  ElementKind kind = ElementKind::nothing;  ///< shell, solid or beam
  Index element = none;
  double time = 0.0;  ///< [time]; 0: it is not there from the start
};

}  // namespace nugget::model
