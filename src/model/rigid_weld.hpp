// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/vec3.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// A seam between two nodes of a rigid weld: a fillet or a butt weld. The force F of the second node on the first has
/// F_n along the normal of the seam's throat and F_t across it; it fails when
///     sqrt(max(F_n, 0)^2 + 3 F_t^2) >= strength
/// which is beta sqrt(sigma_n^2 + 3 (tau_n^2 + tau_t^2)) >= sigma_f (docs/theory/weld.md#seam-welds).
struct Seam {
  std::array<std::size_t, 2> nodes{};  ///< in RigidWeld::nodes; the second is pulled along `tension` off the first
  Vec3d tension, normal;               ///< tensile direction, normal of the throat, at time 0; zero where none is given
  double strength = 0.0;               ///< SIGY L A / BETA: normal force at failure [force]; 0: none
  double failure_time = 0.0;           ///< TFAIL [time]; 0: none
  double failure_strain = 0.0;         ///< EPSF: plastic strain of the adjoining elements [1]; 0: none

  bool can_fail() const { return strength > 0.0 || failure_time > 0.0 || failure_strain > 0.0; }
};

/// A weld without elements. One that holds its nodes together as a rigid body until it fails: *CONSTRAINED_SPOTWELD
/// (two nodes), *CONSTRAINED_GENERALIZED_WELD_SPOT (an ordered set), the seams of
/// *CONSTRAINED_GENERALIZED_WELD_FILLET, _BUTT, _CROSS_FILLET and _COMBINED, or a *CONSTRAINED_NODAL_RIGID_BODY whose
/// two to four nodes lie on as many different sheets, which never fails. Or a *CONSTRAINED_RIVET: a rigid massless
/// truss that keeps the distance of its two nodes, leaves all else free and fails by time only; it has no body.
struct RigidWeld {
  enum class Kind { spotweld, generalized, nodal_body, rivet, fillet, butt, cross_fillet, combined };
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
  /// Of fillet and butt welds, which have their failure here and none above. Any two of them share a node, so that
  /// what some of them let go are single nodes.
  std::vector<Seam> seams;
  Place place;

  /// Written on a set of nodes with a coordinate system (*CONSTRAINED_GENERALIZED_WELD_...).
  bool on_a_set() const { return kind == Kind::generalized || kind > Kind::rivet; }
  bool can_fail() const {
    return normal_strength > 0.0 || shear_strength > 0.0 || failure_time > 0.0 || failure_strain > 0.0 ||
           std::any_of(seams.begin(), seams.end(), [](const Seam& seam) { return seam.can_fail(); });
  }
};

}  // namespace nugget::model
