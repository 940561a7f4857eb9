// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/element/shell.hpp"
#include "kernel/law/cohesive_bond.hpp"

namespace nugget::kernel {

/// Section data of a block of cohesive bricks. Nodes 1 to 4 are the lower face, 5 to 8 the upper one, 5 over 1.
struct CohesiveBrickProperties {
  double density = 0.0;         ///< [mass/volume]; of a law with density_by_area [mass/area]
  bool between_shells = false;  ///< ELFORM 20: the faces that part lie midway between the nodes, which are of shells
};

/// Fields of the state of a cohesive brick. Field i of lane l stands at state[i * lanes + l].
struct CohesiveBrickLayout {
  static constexpr int alive = 0;          ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;  ///< factor on mass and inertia by mass scaling [1]
  static constexpr int hourglass_energy = -1;
  static constexpr int nodal_mass = 2;     ///< before mass scaling [mass]
  static constexpr int nodal_inertia = 3;  ///< likewise [mass length^2]
  static constexpr int thickness = 4;      ///< mean distance of the faces at the start [length]
  static constexpr int first_point = 5;
  static constexpr int points = 4;
  // Of a point:
  static constexpr int area = 0;        ///< of the undeformed surface midway [length^2]
  static constexpr int separation = 1;  ///< along e1 and e2 of the surface midway, and normal to it [length]
  static constexpr int traction = 4;    ///< of the upper face on the lower one, the same axes [stress]
  static constexpr int damage = 7;
  static constexpr int plastic = 8;         ///< separation left without traction, of laws that yield [length]
  static constexpr int rate_at_yield = 11;  ///< strain rate when the point first yielded; negative: it has not [1/time]
  static constexpr int point_size = 12;

  static constexpr int count = first_point + points * point_size;
  static constexpr int point(int p) { return first_point + p * point_size; }
};

/// State of an undeformed brick, free of stress, in lane `lane` of `width`.
void start_cohesive_brick(const CohesiveBrickProperties& brick, const CohesiveBond& bond, const std::array<Vec3d, 8>& x,
                          double* state, int width, int lane);

/// Area of the surface midway between both faces, the sum over the four points [length^2].
double cohesive_brick_area(const std::array<Vec3d, 8>& x);
/// Mean distance of the upper from the lower face along the normal of the surface midway; negative: the faces are
/// exchanged or numbered the wrong way round [length].
double cohesive_brick_thickness(const std::array<Vec3d, 8>& x);
/// Density times the area, or times area and thickness [mass].
double cohesive_brick_mass(const CohesiveBrickProperties& brick, const CohesiveBond& bond,
                           const std::array<Vec3d, 8>& x);
/// Rotary inertia of each node: an eighth of the mass midway of the longest pair of nodes; 0 where the faces are those
/// of the nodes.
double cohesive_brick_nodal_inertia(const CohesiveBrickProperties& brick, const CohesiveBond& bond,
                                    const std::array<Vec3d, 8>& x);

/// One cycle of the cohesive brick of four points (ELFORM 19; between shells 20).
///
/// At a point D = sum N_a D_a with D_a = x_(a+4) - x_a of the pairs of nodes; w is the spin of the axes e1 e2 e3 of the
/// surface midway between them. The separation grows by
///     d' = R (D' - w x D),   between shells by   d' = R sum N_a (v_(a+4) - v_a - (w_(a+4) + w_a) x D_a / 2),
/// taken in the middle of the step: between shells the faces part midway, where each shell's node carries its side. The
/// tractions t follow from the law. e3 is normal to the surface at its centre, e1 and e2 lie at 45 degrees either side
/// of the bisector of its two mean directions. The nodal forces are those whose power is t . d' at the end of the step:
/// +-N_a R t on the faces, and with them, from w x D, forces on both nodes of a pair alike; between shells, moments
/// -D_a x f_(a+4) / 2 on both. So a motion as a rigid body, which has no d', meets no force and no energy at any angle,
/// and the forces have neither resultant nor moment, whatever the thickness. Areas are those of the undeformed brick:
/// the energy of failure is the law's times the area of the mesh. The manual (*SECTION_SOLID, cohesive elements) has
/// the same separations and +-N_a R t, and does not say what balances the couple of these forces over a thickness.
///
/// Stable step: no frequency exceeds omega^2 = k (2 A_a c + s sum A_p |D|^2) / m, with k the stiffer of EN and ET, A_a
/// the largest share of the area at a node, c = 1, between shells 1 + |D_a|^2 m / (4 J), s = (|g1|^2 + |g2|^2) / (2 |g1
/// x g2|^2), of points that carry tractions, 0 between shells; m and J of a node. The first part acts on motions of the
/// faces against each other, the second on those of both alike, which share no kinetic energy.
///
/// A brick in which the law's number of points has failed is deleted: alive 0, no force, infinite stable step.
/// `m` of the result and `w` of the motion are used between shells only.
///
/// Instantiated for R = NativeBatch.
template <class R>
NodalForces<R, 8> cohesive_brick_cycle(const CohesiveBrickProperties& brick, const CohesiveBond& bond,
                                       const NodalMotion<R, 8>& nodes, double dt, double* state);

}  // namespace nugget::kernel
