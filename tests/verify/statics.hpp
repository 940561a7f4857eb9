// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <array>
#include <functional>
#include <vector>

#include "base/vec3.hpp"
#include "kernel/element/shell.hpp"
#include "kernel/law/elastic.hpp"

// Linear statics of a few shells, for verification: the stiffness of the explicit kernels, a sparse factorisation.
namespace nugget::verify {

enum class ShellKind { one_point, full };  ///< ELFORM 2, 16
inline int elform(ShellKind kind) {
  return kind == ShellKind::full ? 16 : 2;
}

/// Tangent stiffness of an unloaded shell, 6 rows a node: v, then spin.
Eigen::Matrix<double, 24, 24> shell_stiffness(ShellKind kind, const kernel::ShellProperties& shell,
                                              const kernel::Elastic& law, double thickness,
                                              const std::array<Vec3d, 4>& x);

/// Shells held and loaded at nodes. ELFORM 16 with warping and drilling stiffness, unless changed.
class Statics {
 public:
  ShellKind kind = ShellKind::full;
  kernel::ShellProperties shell;
  kernel::Elastic law;
  double thickness = 1.0;
  std::vector<Vec3d> x;
  std::vector<std::array<int, 4>> shells;

  Statics(const kernel::Elastic& elastic, double t);
  /// ELFORM 2 leaves drilling and a pattern of the rotations free: where it is chosen, rotations are held softly.
  void use(ShellKind chosen) { kind = chosen; }
  void add(const std::vector<Vec3d>& nodes, const std::vector<std::array<int, 4>>& elements);
  /// A grid of nu x nv shells on a surface of two parameters in 0 .. 1; node (i, j) is i + j (nu + 1).
  void grid(int nu, int nv, const std::function<Vec3d(double, double)>& surface);

  /// Prescribes degrees of freedom of a node: 0-2 displacements, 3-5 rotations.
  void hold(int node, std::initializer_list<int> dofs, double value = 0.0);
  void load(int node, int dof, double value) { force(6 * node + dof) += value; }
  /// A load per area of all elements.
  void distribute(const Vec3d& pressure);

  /// Displacements and rotations of all nodes.
  Eigen::VectorXd solve() const;
  /// Global stresses xx yy zz xy yz zx of element e, of all layers of all columns.
  std::vector<std::array<double, 6>> stresses(const Eigen::VectorXd& u, std::size_t e) const;

  Eigen::VectorXd force;

 private:
  std::array<Vec3d, 4> places(std::size_t e) const;
  std::vector<std::pair<int, double>> held_;
};

}  // namespace nugget::verify
