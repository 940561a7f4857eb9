// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "base/vec3.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// A weld without elements. One that holds its nodes together as a rigid body until it fails: *CONSTRAINED_SPOTWELD
/// (two nodes), *CONSTRAINED_GENERALIZED_WELD_SPOT (an ordered set), or a *CONSTRAINED_NODAL_RIGID_BODY whose two to
/// four nodes lie on as many different sheets, which never fails. Or a *CONSTRAINED_RIVET: a rigid massless truss that
/// keeps the distance of its two nodes, leaves all else free and fails by time only; it has no body.
struct RigidWeld {
  enum class Kind { spotweld, generalized, nodal_body, rivet };
  Kind kind = Kind::spotweld;
  int id = 0;
  Index body = none;         ///< in Model::rigid_bodies; none of a rivet
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

}  // namespace nugget::model
