// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "base/dual.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::kernel {

/// Section of a block of resultant beams; s and t are the axes of the cross-section.
struct ResultantBeamProperties {
  double density = 0.0;                                  ///< [mass/volume], before mass scaling
  double area = 0.0;                                     ///< [length^2]
  double moment_s = 0.0, moment_t = 0.0, torsion = 0.0;  ///< ISS (about s), ITT (about t), J [length^4]
  double shear_area = 0.0;                               ///< SA [length^2]; 0: no shear deformation
  double mass_per_length = 0.0;                          ///< non-structural [mass/length]
};

/// Fields of the state of a resultant beam. Field i of lane l stands at state[i * lanes + l].
struct ResultantBeamLayout {
  static constexpr int alive = 0;
  static constexpr int density_scale = 1;
  static constexpr int length = 2;        ///< current length [length]
  static constexpr int first_length = 3;  ///< at the start [length]
  static constexpr int axes = 4;          ///< at each node its image of r and of s, four vectors
  static constexpr int resultant = 16;    ///< N_rr N_rs N_rt [force], M_rr M_ss M_tt [moment], at mid-length
  static constexpr int count = 22;
};

/// State of an undeformed beam between x1 and x2 in lane `lane` of `width`; s as start_weld_beam chooses it.
void start_resultant_beam(const Vec3d& x1, const Vec3d& x2, const Vec3d& towards, double* state, int width, int lane);

/// One cycle of the Belytschko-Schwer beam (ELFORM 2), linear elastic. Each node carries an image of the beam's axes;
/// what these are turned against the line between the nodes bends the beam, so rotations may be large and strains
/// small: with theta_1, theta_2 the rotations of both ends about one axis and phi = 12 E I / (G A_s l^2),
///     (m_1, m_2) = E I / (l (1 + phi)) ((4 + phi) theta_1 + (2 - phi) theta_2, (2 - phi) theta_1 + (4 + phi) theta_2),
/// axial force E A (l - l0) / l0, moment of torsion G J / l0 times the angle between the ends about the line; shear by
/// equilibrium. Exact for Bernoulli's and Timoshenko's cantilever. Source: docs/theory/beam.md#resultant-beam; T.
/// Belytschko and L. Schwer, Comput. Struct. 7 (1977) 167-175.
///
/// Step: that of the fastest of the axial and the two antisymmetric bending modes with the masses of
/// resultant_beam_nodal_mass. Instantiated for R = NativeBatch, Dual<12>.
template <class R>
NodalForces<R, 2> resultant_beam_cycle(const ResultantBeamProperties& beam, double E, double shear,
                                       const NodalMotion<R, 2>& nodes, double dt, double* state);

/// Mass of each node and isotropic inertia max(rho I l / 2 + rho A l^3 / 24, 3 rho I l).
NodalMass resultant_beam_nodal_mass(const ResultantBeamProperties& beam, double length);

}  // namespace nugget::kernel
