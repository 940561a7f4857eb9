// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "nvh/matrices/equations.hpp"
#include "nvh/matrices/joint_stiffness.hpp"
#include "nvh/matrices/sparse.hpp"

namespace nugget::nvh {

class Prestress;

/// Mass of a node before any constraint: 1/2 m v^2 + v . S w + 1/2 w . J w is its kinetic energy.
struct NodalMass {
  double mass = 0.0;
  system::Inertia inertia{};                     ///< J about the node, xx xy xz yy yz zz
  std::array<std::array<double, 3>, 3> first{};  ///< S, of mass that lies beside the node

  void add(const NodalMass& more);
  bool none() const { return mass == 0.0 && inertia[0] == 0.0; }
  /// Linear and angular momentum of a motion.
  SixDof momentum(const SixDof& motion) const;
};

/// Share of node a in the mass of an element. A quarter of a shell (a third of a triangle) goes with its corner as a
/// rigid plate: its normal velocity is that of the node and of the node's rotation, and the rotary inertia of the
/// material, m t^2 / 12, comes on top (docs/decisions/0027). A resultant beam has the inertia of its section's moments.
NodalMass nodal_share(const system::System& system, const system::ElementGroup& group, std::size_t e, std::size_t a,
                      const system::State& rest);

/// Mass matrix of a node, row-major, in its six freedoms.
std::array<double, 36> mass_matrix(const NodalMass& n);

/// K = T^t K_e T and M = T^t M_e T of a system at rest.
///
/// The element stiffnesses are derivatives of the force kernels (ElementGroup::stiffness). Masses are lumped at the
/// nodes, those of shells as quarters that turn with their node, not with the raised inertia of explicit dynamics. Tied
/// nodes hand their mass over with the same weights as their forces, so M couples the nodes of a segment. A rigid body
/// has the mass of its nodes, or that of *PART_INERTIA. Elements that are not alive take no part.
struct Matrices {
  /// The system must be that of `linear_model` (linear_model.hpp), and outlive the matrices.
  Matrices(const system::System& system, Findings& findings);

  const system::System& system;
  system::State rest;  ///< positions at time 0
  Equations equations;
  int auto_constrained = 0;  ///< unknowns without any stiffness, which are held (AUTOSPC)
  Symmetric stiffness, mass;
  std::vector<NodalMass> nodal_mass;           ///< by system node, virtual ones last
  std::vector<BodyLink> links;                 ///< joints; in K
  std::shared_ptr<const Prestress> prestress;  ///< whose stiffness is in K (`stiffen`); null: none

  std::size_t size() const { return static_cast<std::size_t>(equations.size()); }

  /// Where a system node is at rest; a rigid body's is its centre of mass.
  Vec3d place(std::size_t node) const;

  /// Strain energy of one element in each of the motions q: 1/2 u_e^t K_e u_e.
  std::vector<double> element_energies(const system::ElementGroup& group, std::size_t e, const Columns& q) const;
};

}  // namespace nugget::nvh
