// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/batch.hpp"
#include "kernel/law/law_kernel.hpp"

namespace nugget::kernel {

/// Section and control data of a block of bricks.
struct HexahedronProperties {
  double density = 0.0;                ///< [mass/volume], before mass scaling
  int hourglass = 2;                   ///< IHQ 1 viscous, 2-3 viscous orthogonal, 4-5 stiffness, 6 Belytschko-Bindeman
  double hourglass_coefficient = 0.1;  ///< QM [1]
  double bulk_quadratic = 1.5, bulk_linear = 0.06;  ///< Q1, Q2 of CONTROL_BULK_VISCOSITY [1]
};

/// Fields of the state of a brick. Field i of lane l stands at state[i * lanes + l].
struct HexahedronLayout {
  static constexpr int alive = 0;              ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;      ///< factor on the density by mass scaling [1]
  static constexpr int side = 2;               ///< V^(1/3) [length]
  static constexpr int hourglass = 3;          ///< four vectors of generalised hourglass forces
  static constexpr int hourglass_energy = 15;  ///< work done against them [energy]
  static constexpr int stress = 16;            ///< xx yy zz xy yz zx, global axes, without bulk viscosity
  static constexpr int integrity = 22;    ///< share of the forces that the damage of a weld as a whole has left [1]
  static constexpr int strain_rate = 23;  ///< of a weld: effective [1/time]
  static constexpr int bulk_viscosity_work = 24;  ///< done against the bulk viscosity so far [energy]
  static constexpr int bulk_pressure = 25;        ///< of the last cycle [stress]
  static constexpr int first_history = 26;

  int history = 0;

  int size() const { return first_history + history; }
  // In single precision two fields more, as in ShellLayout.
  static constexpr int rests = 2;
  int rest_of_hourglass_energy() const { return size(); }
  int rest_of_bulk_viscosity_work() const { return size() + 1; }
};

template <class Law>
HexahedronLayout hexahedron_layout(const LawKernel<Law>& law) {
  return {law.solid_history()};
}

/// State of an undeformed, stress-free brick in lane `lane` of `width`.
void start_hexahedron(const HexahedronLayout& layout, const std::array<Vec3d, 8>& x, double* state, int width,
                      int lane);

/// Motion of eight nodes: end position x(t + dt) and velocity at t + dt/2.
template <class R>
struct SolidMotion {
  Vec3<R> x[8], v[8];
};

/// Internal forces on eight nodes, m a = f_ext - f; stable time step on the end geometry before TSSFAC; volume, of
/// several points that of the least, which must be above zero (the caller stops the run, or deletes the element, if it
/// is not).
template <class R>
struct SolidForces {
  Vec3<R> f[8];
  R stable_step{}, volume{};
};

/// One cycle of the one-point brick (ELFORM 1) with the exact uniform gradient of Flanagan and Belytschko (1981).
///
/// Gradients of velocity are taken on the mid-step geometry; the stress (and the law's tensor history) is turned by the
/// Hughes-Winget rotation of the spin there, exact for a rigid rotation by any angle; nodal forces use the geometry at
/// the end. Bulk viscosity (von Neumann, Richtmyer) acts under compression and enters the stable step L / (Q + sqrt(Q^2
/// + c^2)), L = V / largest face; its linear part Q2 c counts at rest and in expansion too. Hourglass control: 1
/// viscous on the plain patterns (not free of rigid rotation), 2 and 3 viscous on the patterns orthogonal to linear
/// fields, 4 and 5 stiffness on them, turned with the material; 6 the physical stabilisation of Belytschko and Bindeman
/// in the frame of the element's axes (QM 1 is the elastic value). 2 and 4 use the exact gradient as 3 and 5 do. Wedges
/// and tetrahedra written with repeated nodes are computed as they come; their step is on the safe side. A weld of
/// uniaxial stress state has only the stresses on its cross-section, in axes that go with the faces 1-2-3-4 and
/// 5-6-7-8; of a damaged weld stress, hourglass forces and bulk viscosity are damaged alike. A brick whose point has
/// failed, or whose stable step falls below the law's deletion step, is deleted: alive 0, no force, infinite stable
/// step. Internal energy is the work of the nodal forces, less the hourglass energy. Sources: Flanagan, Belytschko,
/// IJNME 17 (1981); Hughes, Winget, IJNME 15 (1980); Belytschko, Bindeman, CMAME 105 (1993);
/// docs/theory/brick.md.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, Spotweld, ComposedLaw, and for
/// SingleBatch with the first three. Of one element alone: the same numbers in all lanes, as tests/one_element.hpp has
/// it.
template <class R, class Law>
SolidForces<R> hexahedron_cycle(const HexahedronProperties& brick, const LawKernel<Law>& law,
                                const SolidMotion<R>& nodes, double dt, Number<R>* state);

/// Freezes the yield stress of a weld brick at its present effective stress, from now on; see freeze_yield of
/// weld_beam.hpp.
template <LawOfWelds Law>
void freeze_yield(const LawKernel<Law>& law, double* state, int width, int lane);

/// Volume; negative for inverted node order [length^3].
double hexahedron_volume(const std::array<Vec3d, 8>& x);

/// Stable time step without bulk viscosity, before TSSFAC [time].
double hexahedron_stable_step(const std::array<Vec3d, 8>& x, double E, double nu, double density);

/// Mass of each node, rho V / 8 [mass].
double hexahedron_nodal_mass(const std::array<Vec3d, 8>& x, double density);

}  // namespace nugget::kernel
