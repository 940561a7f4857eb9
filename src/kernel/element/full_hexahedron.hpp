// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/hexahedron.hpp"

namespace nugget::kernel {

/// Fields of the state of a fully integrated brick. Field i of lane l stands at state[i * lanes + l].
struct FullHexahedronLayout {
  static constexpr int alive = 0;              ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;      ///< factor on the density by mass scaling [1]
  static constexpr int hourglass_energy = -1;  ///< there is none
  static constexpr int integrity = 2;    ///< share of the forces that the damage of a weld as a whole has left [1]
  static constexpr int strain_rate = 3;  ///< of a weld: effective, mean of the points [1/time]
  static constexpr int bulk_viscosity_work = 4;  ///< done against the bulk viscosity so far [energy]
  static constexpr int bulk_pressure = 5;        ///< of the last cycle [stress]
  static constexpr int first_point = 6;
  static constexpr int points = 8;

  int history = 0;

  int size() const { return point(points); }
  /// Stress xx yy zz xy yz zx of a point in global axes, without bulk viscosity, followed by its history.
  int point(int p) const { return first_point + p * (SolidTensor<double>::size + history); }
  int history_of(int p) const { return point(p) + SolidTensor<double>::size; }
};

/// Where the strains of a fully integrated brick come from. Enhanced ones are for linear analyses; a weld has the
/// assumed ones in their place. Of a wedge they are those of its shape functions, at points of its own.
enum class BrickStrains { shape_functions, assumed, enhanced, wedge };

template <class Law>
FullHexahedronLayout full_hexahedron_layout(const LawKernel<Law>& law) {
  return {law.solid_history()};
}

/// State of an undeformed, stress-free brick in lane `lane` of `width`.
void start_full_hexahedron(const FullHexahedronLayout& layout, double* state, int width, int lane);

/// One cycle of the brick with 2 x 2 x 2 points and one pressure (ELFORM 2, selectively reduced).
///
/// The velocity gradient of each point is taken on the mid-step geometry, with the dilatation rate replaced by the
/// element's mean; nodal forces use the points' deviatoric stresses and the mean pressure on the geometry at the end,
/// which is B-bar (Hughes, IJNME 15 (1980)). Each point's stress turns with its own spin, as in hexahedron_cycle; so do
/// bulk viscosity (of the mean dilatation) and the stable step. It has no hourglass modes, and like every such brick it
/// locks in bending, the more the longer it is for its thickness. An element is deleted when all its points have
/// failed, or its stable step falls below the law's deletion step. A weld of uniaxial stress state has at each point
/// the stresses on its cross-section only, as in hexahedron_cycle; their pressure is not averaged. Sources: LS-DYNA
/// Theory Manual, solid elements;
/// docs/theory/brick.md#selectively-reduced-brick. Hourglass data of `brick` are not used.
///
/// With assumed strains (ELFORM -1, -2) the velocity gradients are those of AssumedStrain, which bend without locking
/// whatever the sides; all points then turn with the brick's spin, and each stands for an eighth of its volume. With
/// enhanced ones (ELFORM 18) they are those of EnhancedStrain, and each point has its own pressure.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, Spotweld, ComposedLaw.
template <class R, class Law>
SolidForces<R> full_hexahedron_cycle(const HexahedronProperties& brick, BrickStrains strains, const LawKernel<Law>& law,
                                     const SolidMotion<R>& nodes, double dt, double* state);

/// Motion of the six nodes of a wedge: 1 2 3 4 around the face that is opposite to the edge 5-6, 5 beside 1 and 2. End
/// position x(t + dt) and velocity at t + dt/2.
template <class R>
struct WedgeMotion {
  Vec3<R> x[6], v[6];
};

template <class R>
struct WedgeForces {
  Vec3<R> f[6];
  R stable_step{}, volume{};
};

/// The wedge as a brick whose edges 5-6 and 7-8 are points.
template <class T>
std::array<T, 8> brick_of_wedge(const T* six) {
  return {six[0], six[1], six[2], six[3], six[4], six[4], six[5], six[5]};
}

/// One cycle of the wedge (ELFORM 15): full_hexahedron_cycle on points among which no corner of its triangles differs
/// from the others (docs/theory/brick.md#wedges-and-repeated-nodes). State, pressure, deletion and step as there.
template <class R, class Law>
WedgeForces<R> wedge_cycle(const HexahedronProperties& brick, const LawKernel<Law>& law, const WedgeMotion<R>& nodes,
                           double dt, double* state) {
  SolidMotion<R> all;
  const std::array<Vec3<R>, 8> x = brick_of_wedge(nodes.x), v = brick_of_wedge(nodes.v);
  for (std::size_t a = 0; a < 8; ++a) {
    all.x[a] = x[a];
    all.v[a] = v[a];
  }
  const SolidForces<R> of = full_hexahedron_cycle(brick, BrickStrains::wedge, law, all, dt, state);
  return {{of.f[0], of.f[1], of.f[2], of.f[3], of.f[4] + of.f[5], of.f[6] + of.f[7]}, of.stable_step, of.volume};
}

/// Freezes each point's yield stress at its present effective stress; see freeze_yield of weld_beam.hpp.
template <LawOfWelds Law>
void freeze_yield(const FullHexahedronLayout& layout, const LawKernel<Law>& law, double* state, int width, int lane);

}  // namespace nugget::kernel
