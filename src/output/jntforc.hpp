// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// What a joint does to its second body, at the joint, global axes.
struct JntforcRow {
  int joint = 0;  ///< user id
  Vec3d force, moment;
  double energy = 0.0;  ///< stored and lost in the joint; in binout only
  bool local = false;   ///< in the axes that _LOCAL names, not in global ones
};

/// What a joint stiffness does about each of its three axes: moments over angles, or forces over displacements.
struct JntforcStiffness {
  struct Axis {
    double place = 0.0;                     ///< [degrees] or [length]
    double rate = 0.0;                      ///< of it
    double stiffness = 0.0, damping = 0.0;  ///< parts of the moment or force that resists: springs, friction and stops;
                                            ///< dampers
  };
  int id = 0;  ///< user id
  std::array<Axis, 3> axis;
  double energy = 0.0;
};

struct JntforcState {
  double time = 0.0;
  std::vector<JntforcRow> rows;  ///< the same joints in the same order in every state
  std::vector<JntforcStiffness> displacements, rotations;
};

/// The file `jntforc`; the legend holds the headings of *CONSTRAINED_JOINT_..._ID.
const HistoryFormat<JntforcState>& jntforc();

}  // namespace nugget::output
