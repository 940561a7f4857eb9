// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "base/archive.hpp"
#include "base/finding.hpp"
#include "impact/energy/energy.hpp"
#include "system/mobility.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The springs of ties by penalty. Each holds its node at its anchor, a virtual node that follows the segment like a
/// node tied by constraint would (system::System::springs): force -k u on the node, +k u on the anchor, from where the
/// constraint map brings it to the segment. Where the tie hands over rotations a rotary spring holds the relative
/// angle.
///
/// u is the distance that has come up since the start. With a lever node and anchor start at one place, so that the
/// pair of forces turns nothing: rigid motion gives no force, and linear and angular momentum are kept. Without
/// (_OFFSET) the anchor is the foot and the gap a vector constant in space: forces come in pairs, but a rotation of the
/// assembly is resisted, as LS-DYNA documents of this form.
///
/// Stiffness: k = SFSA times that of the segment, K A / longest diagonal of a shell, K A^2 / V of a brick
/// (kernel/contact/penalty.hpp), and of the rotary spring k A; each at most the stability limit of the step. With G =
/// sum over independent nodes of B (M / n)^-1 B^t, the inverse mass seen by the relative motion when every node shares
/// its mass evenly among the n springs at it, lambda_max(K G) <= bearable / dt^2 for each spring implies the same for
/// all together; `stability_limit` = min(1/2, 3 (1 - TSSFAC^2)) stays below the 4 (1 - TSSFAC^2) that elements with
/// lambda_max <= 4 TSSFAC^2 / dt^2 leave of the 4 / dt^2 of central differences. The stiffness never rises in a run.
class TieForces {
 public:
  explicit TieForces(const system::System& system);

  bool empty() const { return springs_.empty(); }
  /// To be called at the start, and when masses may have become smaller: when a tie has ended, not at mass scaling.
  void find_bounds();
  /// The longest step that may come next: the stiffness of springs follows the longest step so far, and is one step
  /// late. Infinite without springs. With it lambda_max(K G) stays below 4 (1 - TSSFAC^2) / dt^2, see above.
  double longest_next_step() const;
  /// Adds the forces at state.time to state.f and state.m, and books their work over the step that ends there.
  void apply(system::State& state);
  /// Ends one tie, an index of Ties::ties.
  void release(std::size_t tie);
  /// Keeps the forces on the nodes of ties by constraint that stand for springs, before they go to the segments.
  void store_loads(const system::State& state);
  /// A warning of springs through which less than 95 % of the load comes that a constraint would carry: 1/(1 + r/k), k
  /// the spring's stiffness with the `step` of the run, r that of what it ties, the elements at the node and those at
  /// the segment one after the other, each by its stiffness at the start with all other nodes held.
  void report_weak(const system::State& start, double step, Findings& findings) const;

  /// Stored in the springs, and lost to their softening where the step grew: minus the work of their forces [energy].
  double energy() const { return energy_; }
  /// Sum of the forces on the tied nodes of a contact, an index of Model::contacts; of ties by constraint, what their
  /// nodes hand over to the segments, whose motion their mass takes part in.
  Vec3d resultant(model::Index contact) const;

  void add_energy(Energy& energy) const { energy.contact += energy_; }
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel);
  void archive(Archive& a);

 private:
  struct Spring {
    std::size_t tie;
    int node, anchor;
    bool rotary = false;
    Vec3d gap;                                       ///< from anchor to node at rest, constant in space
    double stiffness = 0.0, rotary_stiffness = 0.0;  ///< of the segment
    double bound = 0.0, rotary_bound = 0.0;          ///< times dt^2: the largest stiffness
    Vec3d angle;                                     ///< of the node against the anchor
    Vec3d force, moment;                             ///< on the node
    bool released = false, ended = false;            ///< ended: the work of its last force is booked
  };
  void set_stiffness(Spring& spring) const;
  /// Of nodes by system number: the sum of what their elements resist translations with [force/length].
  std::map<int, system::Mobility::Matrix> stiffness_of_surroundings(const system::State& start) const;

  /// A tie by constraint of a contact by springs.
  struct StandIn {
    std::size_t tie;
    int node;
    Vec3d force;  ///< on the node
  };
  const system::System& system_;
  std::vector<Spring> springs_;
  std::vector<StandIn> stand_ins_;
  double longest_step_ = 0.0;
  double energy_ = 0.0;
};

}  // namespace nugget::impact
