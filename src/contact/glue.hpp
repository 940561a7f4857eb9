// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "contact/nodal_forces.hpp"
#include "contact/surface_contact.hpp"
#include "model/contact.hpp"

namespace nugget::contact {

/// The glue of *CONTACT_..._TIEBREAK: nodes of SURFA that touch a segment of SURFB at the start, or later where the
/// card says so, are held there by a spring in all directions until the glue fails at the node; from then on the
/// ordinary contact has it, but where there is none besides the glue. With a birth time the start is that time: what is
/// glued is what touches then.
///
/// Touching at the start: the node is no farther from the segment than half of both thicknesses and 5 % more (of a
/// brick's face: 5 % of its side); where thicknesses are left out, no farther than a tie reaches,
/// max(0.6 (t_node + t_segment), 0.05 shortest diagonal). Later: the ordinary contact presses the node; the force with
/// which it does so goes on. What has failed does not stick again.
///
/// The place of the node over the segment, gap included, is kept in axes that turn with the segment. The spring has the
/// stiffness of the segment by area, or what the law says, bounded as that of a contact pair, so that it does not set
/// the step. Its force, over the area of the surface that the node stands for, is the stress that damages and fails it
/// (kernel/contact/cohesive.hpp); pressure does neither. Normal and shear are those of the segment. A node that stands
/// in the middle of a shell is pulled off on either side. The force acts at the foot on the segment: the lever of the
/// gap is not balanced, as with ties by _OFFSET, but where the glue hands over moments: see couple().
///
/// Glue that slides holds along the normal alone. Its foot is the closest point of the segment and its neighbours;
/// along the surface acts friction, as in SurfaceContact, or up to a stress of its own. A node that leaves the border
/// of the surface farther than it may stand off it at the start is released.
class Glue {
 public:
  /// `x`: initial coordinates.
  Glue(const SurfaceContactSetup& setup, model::Glue card, std::span<const Row> x);

  /// Adds the forces at the end of a step, see SurfaceContact::apply. Where glue fails, the element below is deleted,
  /// or the contact has ended, the node is taken off `bonded()`.
  void apply(const Step& step, std::span<Row> force);
  /// Nodes that the ordinary contact presses in this step stick from the next one on, if the card says so.
  void bond_touching(const SurfaceContact& surface, const Step& step);

  /// By tracked node of the setup: what the ordinary contact leaves alone.
  const std::vector<unsigned char>& bonded() const { return bonded_; }
  int at_start() const { return at_start_; }  ///< nodes glued at the start; with a birth time they come later
  int later() const { return static_cast<int>(bonds_.size()) - at_start_; }  ///< that stuck in the run
  int failed() const { return failed_; }                                     ///< nodes that were glued and are no more
  /// The first node that was released, by number in the arrays of `apply`, and when; -1: none was.
  int first_node() const { return first_node_; }
  double first_time() const { return first_time_; }
  double last_time() const { return last_time_; }  ///< when the last one was released

  std::array<double, 2> energy_of_sides() const { return forces_.energy_of_sides(); }
  double friction_energy() const { return forces_.friction_energy(); }  ///< as ContactEnergies::friction
  const Vec3d& resultant() const { return resultant_; }                 ///< force on the tracked side [force]
  Vec3d force_on(std::span<const unsigned char> marked) const { return forces_.sum(marked); }
  Vec3d force_on(int node) const { return forces_.on(node); }
  bool presses(int node) const { return forces_.acts_on(node); }
  /// As SurfaceContact::force_between.
  Vec3d force_between(const TwoBodies& bodies) const;

  void archive(Archive& a);

 private:
  struct Bond {
    int tracked = 0;  // in the setup
    int segment = 0;
    std::array<double, 4> weight{};
    Vec3d place;             // of the node from the foot, in the segment's axes
    double outward = 0.0;    // +1, -1: on which side of the segment; 0: in it, and each way is outward
    double stiffness = 0.0;  // in tension, of the whole bond, before the step bounds it
    double area = 0.0;       // that the node stands for; 1 where the law counts forces
    kernel::CohesiveState state;
    Vec3d friction;  // on the node along the surface, of glue that slides [force]
    Vec3d force;     // on the node [force]
    bool intact = true;
  };

  double limit(const TrackedNode& node, const Segment& s, std::span<const Row> x) const;
  void glue_together(std::span<const Row> x, std::span<const unsigned char> element_alive);
  bool stands_free(int node, std::span<const unsigned char> element_alive) const;
  double joined_area(int node, const Vec3d& normal, double outward, std::span<const Row> x) const;
  Bond bond(int tracked, int segment, const kernel::Foot& foot, std::span<const Row> x) const;
  kernel::CohesiveStiffness stiffness(const Bond& bond, const Step& step) const;
  Vec3d pull(Bond& bond, const kernel::CohesiveStiffness& k, const Step& step) const;
  Vec3d sliding_pull(Bond& bond, const kernel::CohesiveStiffness& k, const Step& step) const;
  void release(Bond& bond, double time);
  void spread(const Bond& bond, std::span<const Row> x);

  SurfaceContactSetup setup_;
  model::Glue card_;
  NodeSegments around_;
  NodeSegments around_listed_;             // of the setup's faces_at_nodes
  std::vector<double> segment_stiffness_;  // scaled, at the start
  std::vector<Bond> bonds_;
  std::vector<unsigned char> bonded_;
  std::vector<unsigned char> was_bonded_;  // by tracked node: it has been glued
  NodalForces forces_;
  Vec3d resultant_;
  int at_start_ = 0, failed_ = 0;
  bool waits_ = false;  // for the birth time
  int first_node_ = -1;
  double first_time_ = 0.0, last_time_ = 0.0;
};

}  // namespace nugget::contact
