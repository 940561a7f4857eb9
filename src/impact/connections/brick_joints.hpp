// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "base/archive.hpp"
#include "system/brick_joint.hpp"
#include "system/system.hpp"
#include "weld/failure/brick_section.hpp"

namespace nugget::impact {

/// The joints of welds of bricks while the model moves (system::BrickJoint): share out what their sheets move against
/// each other, and let the end faces of the bricks slide and turn on their discs by the joints' parts. The bricks'
/// forces go to the discs from where the faces stand, so force and moment stay in balance; what the joints take up
/// becomes internal energy of the welds.
class BrickJoints {
 public:
  /// The system must outlive it.
  explicit BrickJoints(system::System& system);

  bool empty() const { return joints_.empty(); }
  bool has(std::size_t weld) const {
    return std::ranges::any_of(joints_, [&](const Moving& joint) { return joint.source->weld == weld; });
  }
  /// Once a cycle, when the velocities of the faces' nodes are those of their sheets, before nodes move.
  void open(system::State& state);
  /// Once a cycle, after the forces of the elements. The work of the joint of weld i on the side of each end [energy].
  struct Work {
    std::size_t weld;
    std::array<double, 2> at_end;
  };
  std::vector<Work> book();
  /// Plastic work of the joint of a weld so far, at rest (kernel::WeldJoint::State); 0 of one without [energy].
  double plastic_work(std::size_t weld) const;
  void archive(Archive& a);

 private:
  /// A joint, with what it needs of its weld. Nodes are those of the section, both faces.
  struct Moving {
    Moving(const system::System& system, const system::BrickJoint& source);
    /// Forces of the bricks on the faces' nodes.
    void gather(const system::System& system, std::vector<Vec3d>& force) const;

    const system::BrickJoint* source;
    weld::BrickSection section;
    std::vector<int> nodes;  ///< of the system; those of the first face come first
    std::size_t of_first_face = 0;
    struct Corner {
      system::System::ElementLocation location;
      int corner;
      std::size_t node;
    };
    std::vector<Corner> corners;
    kernel::WeldJoint::State state;
    std::vector<Vec3d> slid, force;  ///< in this cycle against their discs; forces before it; empty: it did not act
    void archive(Archive& a);
  };
  void open(Moving& joint, system::State& state);

  system::System& system_;
  std::vector<Moving> joints_;
};

}  // namespace nugget::impact
