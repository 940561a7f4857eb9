// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/batch.hpp"
#include "kernel/element/fibre_rule.hpp"
#include "kernel/element/shell.hpp"
#include "kernel/element/weld_joint.hpp"
#include "kernel/law/spotweld.hpp"

namespace nugget::kernel {

/// Rule for a disc or ring of the diameters given, by QR/IRID: up to 2: 4 points; 3: 2 radii x 8 angles; from 4 on: 3
/// x 16. All have the exact area and second moments; their fully plastic moments are those of
/// docs/theory/beam.md#section-points.
FibreRule disc_fibres(double outer_diameter, double inner_diameter, int quadrature);
/// Rule for a rectangle with the sides given along s and t, by QR/IRID: 1: one point; 2: 2 x 2 Gauss; 3: 3 x 3 Gauss;
/// 4: 3 x 3 Lobatto; 5: 4 x 4 Gauss. From 2 on they have the exact second moments.
FibreRule rectangle_fibres(double side_s, double side_t, int quadrature);
/// Saint-Venant's torsion constant of a rectangle (Roark) over its polar moment: the share of the torsional stiffness
/// that the points' shear would have without warping.
double rectangle_torsion_share(double side_s, double side_t);

/// Section and control data of a block of spot-weld beams or integrated beams.
struct WeldBeamProperties {
  double density = 0.0;  ///< [mass/volume], before mass scaling
  FibreRule fibres;
  double shear_factor = 1.0;     ///< SHRF, on the transverse shear, not on the torsion [1]
  bool no_torsion = false;       ///< ITOFF 1, or tied to shells without drilling stiffness: M_rr = 0
  double torsion_share = 1.0;    ///< torsion constant over polar moment [1]
  double mass_per_length = 0.0;  ///< non-structural [mass/length]
  /// Place of the middle of the section, where its transverse shear acts, seen from the nodes [length]. The fibres are
  /// placed from the nodes, too.
  double offset_s = 0.0, offset_t = 0.0;
  std::vector<WeldJoint> joints;  ///< in series with the beams, by WeldBeamLayout::joint_of; empty: none has one
};

/// Fields of the state of a weld beam. Field i of lane l stands at state[i * lanes + l].
struct WeldBeamLayout {
  static constexpr int alive = 0;          ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;  ///< factor on the density by mass scaling [1]
  static constexpr int axis_s = 2;         ///< global components of the unit vector s; r is along the beam, t = r x s
  static constexpr int resultant = 5;      ///< N_rr N_rs N_rt [force], M_rr M_ss M_tt [moment], at mid-length
  static constexpr int length = 11;        ///< current length [length]
  static constexpr int integrity = 12;     ///< share of the forces that the damage of the weld as a whole has left [1]
  static constexpr int strain_rate = 13;   ///< effective, mean over the section [1/time]
  static constexpr int first_fibre = 14;

  int fibres = 0, history = 0;
  bool joined = false;  ///< a joint is in series with each beam

  int size() const { return fibre(fibres) + (joined ? joint_fields : 0); }
  /// Of the joint: its place in WeldBeamProperties::joints, its plastic work [energy], its plastic strain rate
  /// [1/time], its elastic part, its flow in the step to come, where that comes from outside, and how far it has slid,
  /// global components [length].
  static constexpr int joint_fields = 6 + 2 * WeldJoint::size;
  int joint_of() const { return fibre(fibres); }
  int joint_work() const { return joint_of() + 1; }
  int joint_rate() const { return joint_of() + 2; }
  int joint_elastic() const { return joint_of() + 3; }
  int joint_flow() const { return joint_elastic() + WeldJoint::size; }
  int joint_slid() const { return joint_flow() + WeldJoint::size; }
  /// Stress rr rs rt of point k, followed by its history.
  int fibre(int k) const { return first_fibre + k * (FibreTensor<double>::size + history); }
  int history_of(int k) const { return fibre(k) + FibreTensor<double>::size; }
};

template <class Law>
WeldBeamLayout weld_beam_layout(const WeldBeamProperties& beam, const LawKernel<Law>& law) {
  return {beam.fibres.count, law.fibre_history(), !beam.joints.empty()};
}

/// State of an undeformed, stress-free beam between x1 and x2 in lane `lane` of `width`. s lies in the plane of the
/// beam and the global axis most across it, or in that of `towards` (the direction to a third node) if that is not
/// zero.
void start_weld_beam(const WeldBeamLayout& layout, const Vec3d& x1, const Vec3d& x2, const Vec3d& towards,
                     double* state, int width, int lane);

/// One cycle of the spot-weld beam (ELFORM 9) and of the integrated beam (ELFORM 1): Hughes-Liu kinematics with one
/// station at mid-length and points over the section; Poisson's effect is ignored, the section does not change, axial
/// strain is logarithmic.
///
/// Rates are formed on the mid-step geometry, forces on that of the end. s turns with the mean spin of the nodes and
/// stays normal to the beam. Points whose plastic strain reaches the failure strain carry no stress; a beam of which
/// every point has failed is deleted: alive 0, no force, infinite stable step. The resultants, damaged as the forces
/// are, are left in the state for the weld's failure function. The stable step is L / sqrt(E / rho). Source:
/// docs/theory/beam.md#weld-beam.
///
/// With joints, each is in series with its beam at mid-length: what the nodes move there is shared out to both
/// (WeldJoint::advance), and the law gets the beam's part. A joint that has slid has the two halves of its beam beside
/// each other: the beam's length and direction are those of its halves, so that it neither stretches nor tilts by the
/// slip, and forces have the arms of the nodes' line. Only welds have them (Spotweld).
///
/// Instantiated for R = NativeBatch with Elastic, Spotweld, PlasticKinematic, PiecewiseLinear, ComposedLaw.
template <class R, class Law>
NodalForces<R, 2> weld_beam_cycle(const WeldBeamProperties& beam, const LawKernel<Law>& law,
                                  const NodalMotion<R, 2>& nodes, double dt, double* state);

/// What the joint of one beam will meet in the next call of weld_beam_cycle.
/// `nodes` as for the cycle; `state`: of this beam alone, field after field.
WeldTrial weld_beam_trial(const WeldBeamProperties& beam, const LawKernel<Spotweld>& law,
                          const NodalMotion<double, 2>& nodes, double dt, const double* state);

/// Freezes the yield stress of every point at its present effective stress, from now on: the stress limit after the
/// onset of damage of the weld as a whole (DMGOPT 11, 12). The law must allow it (Spotweld::yield_can_be_frozen).
template <LawOfWelds Law>
void freeze_yield(const WeldBeamLayout& layout, const LawKernel<Law>& law, double* state, int width, int lane);

/// Stable time step L / sqrt(E / rho) before TSSFAC [time].
double weld_beam_stable_step(double length, double E, double density);

/// Mass of each node, rho A L / 2, and isotropic inertia: the physical one raised until no mode is faster than the
/// axial one (docs/theory/beam.md#mass-and-rotary-inertia-of-a-beam), and further where the nodes are off the middle
/// (eccentric_gyration2).
NodalMass weld_beam_nodal_mass(const WeldBeamProperties& beam, double length, double density, double nu);

}  // namespace nugget::kernel
