// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nvh/equations.hpp"
#include "nvh/sparse.hpp"

namespace nugget::nvh {

/// Mass of a node with its rotary inertia about the node, xx xy xz yy yz zz, before any constraint.
struct NodalMass {
  double mass = 0.0;
  system::Inertia inertia{};
};

/// K = T^t K_e T and M = T^t M_e T of a system at rest.
///
/// The element stiffnesses are derivatives of the force kernels (ElementGroup::stiffness). Masses are lumped at the
/// nodes; shells have the rotary inertia of their material, m t^2 / 12, not the raised one of explicit dynamics. Tied
/// nodes hand their mass over with the same weights as their forces, so M couples the nodes of a segment. A rigid body
/// has the mass of its nodes, or that of *PART_INERTIA.
struct Matrices {
  /// The system must be that of `linear_model` (linear_model.hpp), and outlive the matrices.
  Matrices(const system::System& system, Findings& findings);

  const system::System& system;
  system::State rest;  ///< positions at time 0
  Equations equations;
  int held = 0;  ///< unknowns without any stiffness, which are held (AUTOSPC)
  Symmetric stiffness, mass;
  std::vector<NodalMass> nodal_mass;  ///< by system node, virtual ones last

  std::size_t size() const { return static_cast<std::size_t>(equations.size()); }

  /// Strain energy of one element in each of the motions q: 1/2 u_e^t K_e u_e.
  std::vector<double> element_energies(const system::ElementGroup& group, std::size_t e, const Columns& q) const;
};

}  // namespace nugget::nvh
