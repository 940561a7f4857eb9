// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "contact/nodal_forces.hpp"
#include "contact/surface_contact.hpp"
#include "kernel/contact/cohesive.hpp"

namespace nugget::contact {

/// The glue of *CONTACT_..._TIEBREAK: nodes of SURFA that touch a segment of SURFB at the start are held there by a
/// spring in all directions until the glue fails at the node; from then on the ordinary contact has it.
///
/// Touching: the node is no farther from the segment than half of both thicknesses and 5 % more (of a brick's face: 5 %
/// of its side). The place of the node over the segment, gap included, is kept in axes that turn with the segment. The
/// spring has the stiffness of the segment by area, or what the law says, bounded as that of a contact pair, so that it
/// does not set the step. Its force, over the area of the surface that the node stands for, is the stress that damages
/// and fails it (kernel/contact/cohesive.hpp); pressure does neither. Normal and shear are those of the segment. The
/// force acts at the foot on the segment: the lever of the gap is not balanced, as
/// with ties by _OFFSET.
class Glue {
 public:
  /// `x`: initial coordinates.
  Glue(const SurfaceContactSetup& setup, kernel::Cohesion law, std::span<const Row> x);

  /// Adds the forces at the end of a step, see SurfaceContact::apply. Where glue fails, the element it stands on has
  /// died, or the contact has, the node is taken off `glued()`.
  void apply(const Step& step, std::span<Row> force);

  const std::vector<unsigned char>& glued() const { return glued_; }  ///< by tracked node of the setup
  int failed() const { return failed_; }                              ///< nodes that have been glued and are no more
  std::size_t size() const { return bonds_.size(); }                  ///< nodes glued at the start
  const std::array<double, 2>& energy_of_sides() const { return energy_; }
  const Vec3d& resultant() const { return resultant_; }  ///< force on the tracked side [force]
  Vec3d force_on(std::span<const unsigned char> marked) const { return forces_.sum(marked); }

  void archive(Archive& a);

 private:
  struct Bond {
    int tracked = 0;  // in the setup
    int node = 0;
    Segment segment;
    std::array<double, 4> weight{};
    Vec3d place;             // of the node from the foot, in the segment's axes at the start
    double stiffness = 0.0;  // in tension, of the whole bond, before the step bounds it
    double area = 0.0;       // that the node stands for
    double damage = 0.0;
    bool holds = true;
  };

  SurfaceContactSetup setup_;
  kernel::Cohesion law_;
  std::vector<Bond> bonds_;
  std::vector<unsigned char> glued_;
  NodalForces forces_;
  std::array<double, 2> energy_{};
  Vec3d resultant_;
  int failed_ = 0;
};

}  // namespace nugget::contact
