// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/law/laminate.hpp"
#include "kernel/law/law_kernel.hpp"

// What the four-node and the three-node shell share: section, state, and how nodal motion and forces are handed over.
namespace nugget::kernel {

inline constexpr int most_layers = 32;  ///< Gauss and Lobatto rules: 10

/// Integration points through the thickness: zeta in -1 (bottom) .. 1 (top), weights of sum 1.
struct LayerRule {
  int count = 0;
  std::array<double, most_layers> zeta{}, weight{};
};
/// Gauss points, 1 to 10 (CONTROL_SHELL INTGRD 0).
LayerRule gauss_layers(int count);
/// Gauss-Lobatto points, 3 to 10: the outermost lie on the faces (INTGRD 1). Fewer than 3 have no such rule: Gauss.
LayerRule lobatto_layers(int count);

/// Points with equal spaces between them, the outermost on the faces, weights of the trapezoidal rule.
LayerRule equally_spaced_layers(int count);

enum class ThicknessUpdate { none, all, plastic };                   ///< ISTUPD 0, 1, 4
enum class ShellLength { area_over_side, area_over_diagonal, bar };  ///< ISDO 0, 1, 2

/// Share for ShellProperties::drilling where it is wanted; ten times more or less hardly changes a result
/// (docs/decisions/0018).
inline constexpr double usual_drilling = 0.1;

/// Section and control data of a block of shells; the thickness of each element is part of its state.
struct ShellProperties {
  double density = 0.0;  ///< [mass/volume], before mass scaling
  LayerRule layers;
  double shear_factor = 5.0 / 6.0;  ///< SHRF [1]
  double offset = 0.0;  ///< NLOC: the nodes lie at offset * thickness / 2 from the mid-surface, up positive [1]
  ThicknessProfile profile;
  int hourglass = 4;  ///< IHQ 1-3 viscous, 4-5 stiffness
  double membrane_hourglass = 0.1, bending_hourglass = 0.1, warping_hourglass = 0.1;  ///< QM, QB, QW [1]
  ThicknessUpdate thickness_update = ThicknessUpdate::none;
  bool warping_stiffness = false;  ///< BWC 1; of the fully integrated shell IHQ 8
  bool rates_at_end = false;       ///< of ELFORM 2: on the geometry at the end of the step, else in its middle (OSU)
  /// Stiffness against drilling rotations, a share of G t min(t^2, A) / corners a node; not in ELFORM 2.
  double drilling = 0.0;
  ShellLength length = ShellLength::area_over_side;
  double bulk_quadratic = 0.0, bulk_linear = 0.0;  ///< Q1, Q2 of CONTROL_BULK_VISCOSITY TYPE -1, -2; 0: off
};

/// Fields of the state of a shell. Field i of lane l stands at state[i * lanes + l]. Layers stand column by column: one
/// column through the thickness, or four in the fully integrated shell.
struct ShellLayout {
  static constexpr int alive = 0;             ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;     ///< factor on the density by mass scaling [1]
  static constexpr int thickness = 2;         ///< [length]
  static constexpr int hourglass = 3;         ///< five generalised hourglass forces, or drilling moments
  static constexpr int hourglass_energy = 8;  ///< work done against them [energy]
  static constexpr int first_layer = 9;

  int layers = 0, history = 0;  ///< number of layers of a column; numbers of history a layer
  int columns = 1;

  int size() const { return layer(0, columns); }
  // In single precision two fields more, behind these: what the thickness and the work against hourglass forces could
  // not take of their parts (add_to_field).
  static constexpr int rests = 2;
  int rest_of_thickness() const { return size(); }
  int rest_of_hourglass_energy() const { return size() + 1; }
  /// Stress xx yy xy xz yz of layer k of a column in the element's frame, followed by its history.
  int layer(int k, int column = 0) const {
    return first_layer + (column * layers + k) * (LayerTensor<double>::size + history);
  }
  int history_of(int k, int column = 0) const { return layer(k, column) + LayerTensor<double>::size; }
};

template <class Law>
ShellLayout shell_layout(const ShellProperties& shell, const LawKernel<Law>& law) {
  return {shell.layers.count, law.layer_history()};
}

/// State of an undeformed, stress-free shell in lane `lane` of `width`.
void start_shell(const ShellLayout& layout, double thickness, double* state, int width, int lane);

/// Motion of N nodes: end position x(t + dt), velocity and spin at t + dt/2.
template <class R, int N>
struct NodalMotion {
  Vec3<R> x[N], v[N], w[N];
};

/// Internal forces and moments on N nodes, m a = f_ext - f; and the stable time step on the end geometry before TSSFAC
/// (infinite for a deleted element).
template <class R, int N>
struct NodalForces {
  Vec3<R> f[N], m[N];
  R stable_step{};
};

/// Nodal mass and isotropic rotational inertia.
struct NodalMass {
  double mass = 0.0, inertia = 0.0;
};

}  // namespace nugget::kernel
