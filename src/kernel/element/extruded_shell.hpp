// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/element/full_shell.hpp"
#include "kernel/element/hexahedron.hpp"

namespace nugget::kernel {

/// Section and control data of a block of extruded shells: thick shells whose nodes 1 to 4 are the bottom and 5 to 8
/// the top, with laws of shells.
struct ExtrudedShellProperties {
  ShellProperties shell;  ///< on the midway surface; its thickness is that of the brick, its drilling is not used
  bool full = false;      ///< 2 x 2 points in the plane (ELFORM 2) instead of one (ELFORM 1)
  double bulk_quadratic = 1.5, bulk_linear = 0.06;  ///< Q1, Q2, against squeezing across [1]
};

/// Fields of the state of an extruded shell: those of what resists across, then those of its shell. Field i of lane l
/// stands at state[i * lanes + l].
struct ExtrudedShellLayout {
  static constexpr int across = 0;               ///< stress across at the four corners [stress]
  static constexpr int bulk_viscosity_work = 4;  ///< done against the viscosity across so far [energy]
  static constexpr int bulk_pressure = 5;        ///< across, of the last cycle [stress]
  static constexpr int first_of_shell = 6;
  static constexpr int alive = first_of_shell + ShellLayout::alive;
  static constexpr int density_scale = first_of_shell + ShellLayout::density_scale;
  static constexpr int thickness = first_of_shell + ShellLayout::thickness;
  static constexpr int hourglass = first_of_shell + ShellLayout::hourglass;
  static constexpr int hourglass_energy = first_of_shell + ShellLayout::hourglass_energy;

  ShellLayout shell;

  int size() const { return first_of_shell + shell.size(); }
  /// Stress xx yy xy xz yz of layer k of a column in the frame of the midway surface, followed by its history.
  int layer(int k, int column = 0) const { return first_of_shell + shell.layer(k, column); }
  int history_of(int k, int column = 0) const { return first_of_shell + shell.history_of(k, column); }
};

template <class Law>
ExtrudedShellLayout extruded_shell_layout(const ExtrudedShellProperties& extruded, const LawKernel<Law>& law) {
  return {extruded.full ? full_shell_layout(extruded.shell, law) : shell_layout(extruded.shell, law)};
}

/// The four nodes of the midway surface.
std::array<Vec3d, 4> midway_nodes(const std::array<Vec3d, 8>& x);

/// Volume over the area of the midway surface [length].
double extruded_shell_thickness(const std::array<Vec3d, 8>& x);

/// State of an undeformed, stress-free extruded shell in lane `lane` of `width`.
void start_extruded_shell(const ExtrudedShellLayout& layout, const std::array<Vec3d, 8>& x, double* state, int width,
                          int lane);

/// One cycle of the extruded shell: the four-node shell of shell_cycle (ELFORM 1) or of full_shell_cycle (ELFORM 2) on
/// the midway surface of eight nodes, and beside it, uncoupled, a stiffness across.
///
/// A node of the shell moves as the middle of its pair of nodes, bottom and top. At a corner the fibre along the normal
/// turns as linear fields say, and beyond them as the pair's line does: that is the spin of the shell's node. It is
/// strained as linear fields say, and beyond them as that line is. About the normal all nodes spin with the element, as
/// its uniform gradient says. Linear fields are exact and rigid motion strains nothing whatever the shape; bending and
/// twist of curved elements, whose lines fan out, strain nothing across. Nodal forces do the work of the shell's forces
/// and moments on these. The shell's thickness is the volume over the area of the midway surface.
///
/// The strain across meets Young's modulus at each corner, elastically, whatever the law does in the plane: the two
/// know nothing of each other. Squeezing across has the bulk viscosity of bricks, over the least height of a corner
/// times the cosine of its line. An element is deleted as its shell is.
///
/// The stable step is 1 / sqrt(1/a^2 + 1/b^2) of the shell's a and that across b, that length over sqrt(E / rho), with
/// viscosity. Source: docs/theory/brick.md#extruded-shell.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw.
template <class R, class Law>
SolidForces<R> extruded_shell_cycle(const ExtrudedShellProperties& extruded, const LawKernel<Law>& law,
                                    const SolidMotion<R>& nodes, double dt, double* state);

}  // namespace nugget::kernel
