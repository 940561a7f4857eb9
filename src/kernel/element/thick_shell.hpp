// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/element/hexahedron.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::kernel {

/// Section and control data of a block of thick shells: bricks whose nodes 1 to 4 are the bottom and 5 to 8 the top.
struct ThickShellProperties {
  HexahedronProperties brick;  ///< its hourglass_coefficient: share of the elastic stabilisation [1]
  LayerRule layers;
  /// Transverse shear strain of each layer as a multiple of the element's, see shear_by_layer.
  std::array<double, most_layers> shear{};
  bool full = false;  ///< ELFORM 3: 2 x 2 points in the plane; else ELFORM 5: one
};

/// How the transverse shear strain runs through the layers, so that the resultant is `factor` times that of the same
/// strain everywhere: TSHEAR 0 as a parabola that vanishes on both faces, 1 alike in all layers. Where the parabola is
/// zero in all points of the rule (two on the faces) it cannot be had, and the strain is the same everywhere.
std::array<double, most_layers> shear_by_layer(const LayerRule& layers, bool parabolic, double factor);

/// Fields of the state of a thick shell of ELFORM 3 or 5. Field i of lane l stands at state[i * lanes + l].
struct ThickShellLayout {
  static constexpr int alive = 0;                 ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;         ///< factor on the density by mass scaling [1]
  static constexpr int hourglass = 2;             ///< four vectors of generalised hourglass forces; ELFORM 3 has none
  static constexpr int hourglass_energy = 14;     ///< work done against them [energy]
  static constexpr int bulk_viscosity_work = 15;  ///< done against the bulk viscosity so far [energy]
  static constexpr int bulk_pressure = 16;        ///< of the last cycle [stress]
  static constexpr int pinch = 17;                ///< mean of zeta times the stress across the layers [stress]
  static constexpr int first_layer = 18;

  /// Of ELFORM 3: means of xi and of eta times the stress along them [stress].
  static constexpr int pinch_xi = hourglass, pinch_eta = hourglass + 1;

  int layers = 0, history = 0;  ///< number of layers; numbers of history a point
  int columns = 1;              ///< points of a layer

  int size() const { return layer(layers); }
  /// Stress xx yy zz xy yz zx of a point of layer k in global axes, without bulk viscosity, followed by its history.
  int layer(int k, int column = 0) const {
    return first_layer + (k * columns + column) * (SolidTensor<double>::size + history);
  }
  int history_of(int k, int column = 0) const { return layer(k, column) + SolidTensor<double>::size; }
};

template <class Law>
ThickShellLayout thick_shell_layout(const ThickShellProperties& shell, const LawKernel<Law>& law) {
  return {shell.layers.count, law.solid_history(), shell.full ? 4 : 1};
}

/// State of an undeformed, stress-free thick shell in lane `lane` of `width`.
void start_thick_shell(const ThickShellLayout& layout, double* state, int width, int lane);

/// One cycle of the thick shell with one point in its plane and layers through its thickness (ELFORM 5): the law of
/// solids in each layer, assumed strains.
///
/// The mean strain is that of the uniform gradient of Flanagan and Belytschko, exact for constant strain on any shape.
/// Bending: the strain in the plane of the midway surface varies with zeta as the patterns zeta xi and eta zeta make it
/// vary; the strain across is linear in zeta so that the stress across has no linear part, as in a plate (elastic: -nu
/// / (1 - nu) times the sum of the two in the plane; what plastic flow leaves of it is taken back in the cycle after).
/// Transverse shear is the element's mean, distributed by ThickShellProperties::shear. All other patterns meet the
/// elastic stabilisation of Belytschko and Bindeman, as in hexahedron_cycle with hourglass type 6. Spin, bulk viscosity
/// and the stable step, V / largest face over the wave speed, are those of hexahedron_cycle. A failed layer has no
/// stress; the element is deleted with the last one, or with as many as the law says, or when its step falls below the
/// law's deletion step.
///
/// ELFORM 3 (`full`) has 2 x 2 points in each layer and no hourglass patterns: the strains of the patterns are those of
/// AssumedStrain with a stress across that varies, at points that go through the thickness as the layers do; what flow
/// leaves of the first moments of the stresses along xi and eta is taken back as that across is. It goes with its last
/// point, or with as many as the law says, of which one makes a layer a failed one where it counts layers. Sources:
/// Flanagan, Belytschko, IJNME 17 (1981); Belytschko, Bindeman, CMAME 105 (1993); of points in a row through the
/// thickness Abed-Meraim, Combescure, Comput. Struct. 80 (2002); docs/theory/brick.md#thick-shell.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw.
template <class R, class Law>
SolidForces<R> thick_shell_cycle(const ThickShellProperties& shell, const LawKernel<Law>& law,
                                 const SolidMotion<R>& nodes, double dt, double* state);

/// Unit vector across the midway surface, from nodes 1-4 to 5-8.
Vec3d thick_shell_normal(const std::array<Vec3d, 8>& x);

}  // namespace nugget::kernel
