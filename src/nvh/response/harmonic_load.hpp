// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nvh/matrices/nodal.hpp"

namespace nugget::nvh {

/// A harmonic excitation of amplitude 1 as the equations of motion see it.
///
/// Motions of the base and of enforced nodes are taken relative: u = s a_b + u_r, where a_b is what is driven and s how
/// the structure goes along with it without inertia (docs/decisions/0030). What is left of the equation of motion is
/// the structure held at what drives it, under the inertia forces -M s of a unit acceleration.
struct HarmonicLoad {
  std::vector<double> force;  ///< T^t of the forces, or of -M s
  Nodal applied;              ///< the forces, on independent nodes; empty for motions
  Nodal carried;              ///< s; empty for forces
};

/// `excitation` must have passed check_excitation. Enforced nodes must be held by the equations, see linear_model.
/// Throws Factorization::SolverError.
HarmonicLoad harmonic_load(const Matrices& matrices, const model::FrequencyResponse::Excitation& excitation);

/// Errors for a torque on a node that does not turn; a warning for forces on what supports hold.
void check_excitation(const Matrices& matrices, const model::FrequencyResponse::Excitation& excitation,
                      const char* keyword, Findings& findings);

/// Whether a node turns, with an unknown of its own or with others, or is held against turning.
bool turns(const Equations& equations, int node);

}  // namespace nugget::nvh
