// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// Motion of one rigid body at its centre of mass, in global axes [length, time, radian].
struct RbdoutRow {
  int id = 0;        ///< user id of the part or of the nodal rigid body
  Vec3d coordinate;  ///< now
  Vec3d displacement, rotation;
  Vec3d velocity, angular_velocity;
  Vec3d acceleration, angular_acceleration;
  Frame3d axes;  ///< principal or user defined axes a, b, c, now; the local motion is printed in them
};

struct RbdoutState {
  long cycle = 0;
  double time = 0.0;
  std::vector<RbdoutRow> parts;  ///< rigid parts; the same in every state
  std::vector<RbdoutRow> nodal;  ///< nodal rigid bodies; the same in every state
};

/// The file `rbdout`.
const HistoryFormat<RbdoutState>& rbdout();

}  // namespace nugget::output
