// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::contact {

/// Springs of pairs that were dropped under load: the two no longer press each other, though the motion of the step
/// cannot have parted them, and no other pair has taken the spring over. What it held is lost.
struct Drops {
  double energy = 0.0;   ///< all that they held [energy]
  long count = 0;        ///< how many they are
  double largest = 0.0;  ///< held by the one that held most [energy]
  int node = -1;         ///< of that one: the node, or a node of the first edge, as a position in the arrays of the run
  int other = -1;        ///< and a node of the segment, or of the second edge
  double time = 0.0;     ///< when that was

  void add(double held, int at, int against, double now) {
    energy += held;
    ++count;
    if (held > largest) *this = {energy, count, held, at, against, now};
  }
  void add(const Drops& more) {
    const double sum = energy + more.energy;
    const long all = count + more.count;
    if (more.largest > largest) *this = more;
    energy = sum;
    count = all;
  }
};

/// What became of the energy that the pairs of a contact took, by cause; see
/// SurfaceContact::energy(). What is missing to that is the error of the steps [energy].
struct ContactEnergies {
  double springs = 0.0;   ///< in those that press now
  double friction = 0.0;  ///< minus the work of friction
  double damping = 0.0;   ///< minus the work of VDC
  double deleted = 0.0;   ///< in springs at elements that were deleted
  Drops drops;            ///< springs dropped under load

  double lost() const { return drops.energy + deleted; }
  void add(const ContactEnergies& more) {
    springs += more.springs;
    friction += more.friction;
    damping += more.damping;
    deleted += more.deleted;
    drops.add(more.drops);
  }
};

}  // namespace nugget::contact
