// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/vec3.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// A weld that holds its nodes together as one rigid body until it fails: *CONSTRAINED_SPOTWELD (two nodes),
/// *CONSTRAINED_GENERALIZED_WELD_SPOT (an ordered set), or a *CONSTRAINED_NODAL_RIGID_BODY whose two to four nodes lie
/// on as many different sheets; that one never fails.
struct RigidWeld {
  enum class Kind { spotweld, generalized, nodal_body };
  Kind kind = Kind::spotweld;
  int id = 0;
  Index body = none;         ///< in Model::rigid_bodies
  std::vector<Index> nodes;  ///< in the order of the deck, which is that along the weld
  /// Tensile direction at time 0 where the deck gives it (z of CID); else the line from the first node to the last.
  std::optional<Vec3d> axis;

  double normal_strength = 0.0, shear_strength = 0.0;  ///< SN, SS [force]; 0: left out
  double normal_exponent = 1.0, shear_exponent = 1.0;  ///< N, M [1]
  double failure_time = 0.0;                           ///< TF, TFAIL [time]; 0: none
  double failure_strain = 0.0;  ///< EP, EPSF: plastic strain of the adjoining elements [1]; 0: none
  int filter = 0;               ///< NF, FILTER: force vectors averaged; up to 1: none
  double window = 0.0;          ///< TW, WINDOW: time over which they are averaged [time]; 0: all of them
  Place place;

  bool can_fail() const {
    return normal_strength > 0.0 || shear_strength > 0.0 || failure_time > 0.0 || failure_strain > 0.0;
  }
};

/// *CONSTRAINED_RIVET: a rigid massless truss between two nodes. It keeps their distance; all else is free.
struct Rivet {
  int id = 0;
  std::array<Index, 2> nodes{none, none};
  double failure_time = 0.0;  ///< TF [time]; 0: none
  Place place;
};

}  // namespace nugget::model
