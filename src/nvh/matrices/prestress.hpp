// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "nvh/matrices/matrices.hpp"

namespace nugget::nvh {

/// Stresses that a structure carries at rest, as far as they stiffen it (or weaken it, where they press).
///
/// A motion u does the work 1/2 sum_k grad u_k . s grad u_k of second order against a stress s (Green and Lagrange's
/// strain, e.g. Zienkiewicz and Taylor, The Finite Element Method for Solid and Structural Mechanics, initial stress
/// matrix). Over a brick s is the stress, over the middle surface of a shell the membrane force, along a beam or spring
/// the axial force; displacements go by the nodes' shape functions. Stresses of bending do no such work to first order.
///
/// A node at r from the centre of its rigid body moves by 1/2 w x (w x r) to second order where the body turns by w,
/// and the forces on it do work against that: of the elements there, less of the loads.
class Prestress {
 public:
  explicit Prestress(const Matrices& matrices);

  /// *INITIAL_STRESS_SHELL, _SOLID, _SECTION and *INITIAL_AXIAL_FORCE_BEAM at time 0, and what springs and discrete
  /// beams carry by their offsets and preloads.
  void add_initial();
  /// Those of a linear solution, by the motion of each system node.
  void add(const std::vector<SixDof>& motion);
  /// Loads on the nodes with which those are in balance.
  void add_loads(const std::vector<SixDof>& loads);
  /// Those that another system of the same deck carries, one that has been run; axes are the global ones of then.
  void add(const system::System& run, const system::State& now);

  /// Number of elements that have any.
  std::size_t elements() const;
  /// K_s over the unknowns.
  Symmetric stiffness(const Equations& equations) const;
  /// Forces of the arms of rigid bodies in a motion of the system nodes, added to those on the bodies.
  void add_arm_forces(const std::vector<SixDof>& motion, std::vector<SixDof>& force) const;
  /// Adds that of one element, in its freedoms, row-major.
  void add_element_stiffness(const system::ElementGroup& group, std::size_t e, std::span<double> k) const;

 private:
  /// Stress, membrane force or axial force: xx yy zz xy yz zx, global axes.
  using Tensor = std::array<double, 6>;
  Tensor& of(const system::System::ElementLocation& location);
  /// Adds the axial force of an element between two nodes: `force` is that at its second end. Of a spring whose
  /// direction stays when its nodes move there is none.
  void add_along(const system::System::ElementLocation& location, const Vec3d& force);
  /// Whether a node of the element belongs to a rigid body, whose arm its forces have.
  bool at_body(const system::ElementGroup& group, std::size_t e) const;
  /// Adds what elements with stresses of their own, those that stand in `tensor_`, do to nodes of rigid bodies.
  void add_forces_of_stresses();
  void add_joints(const std::vector<SixDof>* motion);
  /// Over the rotations of a body's virtual node, row-major; by body.
  std::vector<std::array<double, 9>> arms() const;

  const Matrices& matrices_;
  const system::System& system_;
  const system::State& rest_;
  std::vector<std::vector<Tensor>> tensor_;        ///< by group and element
  std::vector<Vec3d> force_;                       ///< internal forces less loads, of the nodes of rigid bodies
  std::vector<std::array<double, 9>> joint_arms_;  ///< by body, of the forces of joints
};

/// K := K + K_s, of the matrices that the prestress was made for, which must outlive it. Unknowns that had no stiffness
/// but for K_s, such as the motion of a string across its line, come back: the unknowns are counted anew.
void stiffen(Matrices& matrices, std::shared_ptr<const Prestress> prestress);

}  // namespace nugget::nvh
