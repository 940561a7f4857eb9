// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/sensors.hpp"

// *TERMINATION_...: what may end a run before its time.
namespace nugget::model {

/// *TERMINATION_NODE, _BODY, _SENSOR: the run ends when a number leaves its bounds, or a switch is on.
struct RunEnd {
  enum class Kind { node, body, sensor };
  Kind kind = Kind::node;
  Index node = none, body = none, of_switch = none;
  int axis = 0;  ///< 0 to 2: x, y, z; 3: the amount
  double least = -1e20, most = 1e20;
  Place place;
};

}  // namespace nugget::model
