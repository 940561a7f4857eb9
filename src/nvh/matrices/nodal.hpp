// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nvh/matrices/matrices.hpp"

// Motions of all nodes of a linear model, and the forces of its elements.
namespace nugget::nvh {

using Nodal = std::vector<SixDof>;  ///< motion of each system node, virtual ones included, or force on it

Vec3d part_of(const SixDof& six, bool rotation);
void add_to(SixDof& six, bool rotation, const Vec3d& v);

/// Gives dependent nodes the motion of those that they follow, on top of what they have.
void apply_constraints(const system::System& system, Nodal& motion);
/// Forces on dependent nodes go to those that they follow.
void transfer_forces(const system::System& system, Nodal& force);

/// K_e of one element, the mean of both triangles, as the assembled matrix has it; row-major.
std::vector<double> element_stiffness(const Matrices& matrices, const system::ElementGroup& group, std::size_t e);
/// The same with the geometric stiffness of what it carries at rest.
std::vector<double> tangent_stiffness(const Matrices& matrices, const system::ElementGroup& group, std::size_t e);

/// Internal forces K_e u_e of one element, in its freedoms.
std::vector<double> element_force(const Matrices& matrices, const system::ElementGroup& group, std::size_t e,
                                  const Nodal& motion);

/// Motion of the twelve freedoms of the bodies that a link joins.
ConstrainedMotion::Row motion_of(const BodyLink& link, const Nodal& motion);

/// Internal forces of springs, discrete beams and joint stiffnesses at time 0, by their offsets and preloads.
Nodal forces_at_start(const Matrices& matrices);

/// Forces K_e u_e of all elements and joints on the nodes, and what strain energy they hold.
struct Internal {
  Nodal force;
  std::vector<double> part_energy;  ///< by model part
  double link_energy = 0.0;         ///< of joints
};
Internal internal_forces(const Matrices& matrices, const Nodal& motion);

/// Force of a pressure of 1 on a segment, against its normal (corners in order, seen from its tip).
Vec3d force_of_pressure(const Matrices& matrices, const model::Segment& segment);

}  // namespace nugget::nvh
