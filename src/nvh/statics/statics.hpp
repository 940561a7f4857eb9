// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "nvh/matrices/factorization.hpp"
#include "weld/failure/resultants.hpp"

namespace nugget::nvh {

/// A weld in a linear solution: resultants at mid-length in the axes it has at rest, value of its failure function (not
/// a number where it is one of plastic displacements: interpolation spot welds and self-piercing rivets). Nothing
/// fails.
struct WeldForce {
  weld::Resultants resultants;
  double failure = 0.0;
};

/// The structure at rest under the loads and prescribed displacements that the deck's curves have at ENDTIM.
struct Statics {
  std::vector<SixDof> motion;  ///< by system node, virtual ones included
  /// What holds each independent node, all of it: internal forces less loads, with the shares of nodes that follow it.
  /// Zero to `residual` where nothing is held [force, force length].
  std::vector<SixDof> reaction;
  std::vector<double> support_force;           ///< along Support::taken, by Equations::supports()
  std::vector<std::optional<WeldForce>> weld;  ///< by Ties::welds; none: rigid, a discrete beam, or deleted
  /// What joints do to their second body, at the joint: by Matrices::links, force and moment in global axes.
  std::vector<SixDof> joint;
  std::vector<double> part_energy;  ///< strain energy, by model part
  double energy = 0.0;              ///< that of joints included
  double external = 0.0;            ///< half the work of loads and supports; equals `energy`
  double residual = 0.0;            ///< largest |K q - f| over largest |f|
  Factorization::Cost cost;
};

/// Refuses by name what linear statics cannot obey; warnings for what takes no part.
void check_statics(const model::Model& model, Findings& findings);

/// Errors for motions that supports or other motions of the same nodes contradict.
void check_motions(const Matrices& matrices, Findings& findings);

/// u = T q + u_p with K q = T^t (f - K_e u_p); u_p are the prescribed displacements and what follows them. Loads that
/// follow the structure stand as they do at rest. Throws Factorization::SolverError, also where the structure is not
/// held.
Statics solve_statics(const Matrices& matrices, Findings& findings);

}  // namespace nugget::nvh
