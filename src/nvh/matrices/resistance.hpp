// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nvh/matrices/nodal.hpp"
#include "nvh/matrices/sparse.hpp"

// Directions of nodes in which nothing resists motion: which they are, and what acts along them.
namespace nugget::nvh {

/// Marks the unknowns whose row of K is zero.
std::vector<char> unresisted(const Symmetric& stiffness);

/// Nodes that nothing resists along directions askew to their unknowns, such as across a spring that does not lie along
/// an axis: their translations, or rotations, in the directions that are resisted and, behind those, the others.
/// Without resistance is what the round-off of the resisted directions leaves, 1e-13 of them. K has no zero row.
std::vector<Equations::Turned> unresisted_askew(const Equations& equations, const Symmetric& stiffness);

/// A force, or moment, that acts on a node along a direction in which nothing resists its motion and nothing holds it,
/// or on a node that has no such motion.
struct UnresistedLoad {
  int node = 0;  ///< of the system
  bool moment = false;
  bool nothing_there = false;  ///< no element, mass or body knows the node, or its rotation
  Vec3d direction;             ///< unit, of the part that nothing takes
};
/// Those among these loads, which go on to what carries dependent nodes; ascending by node.
std::vector<UnresistedLoad> unresisted_loads(const Matrices& matrices, Nodal load);

/// "node 7", "rigid body 3": of a system node, virtual ones included.
std::string name_of(const system::System& system, int node);

}  // namespace nugget::nvh
