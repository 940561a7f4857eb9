// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
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
  /// Once a cycle, when the velocities of the faces' nodes are those of their sheets, before nodes move: first what the
  /// joints meet, then, when `set_flow` has been called of those that flow from outside, how the faces slide.
  void meet(const system::State& state);
  void slide(system::State& state);
  /// The place of a weld's joint below; nothing of a weld without.
  std::optional<std::size_t> of(std::size_t weld) const;
  kernel::WeldTrial trial(std::size_t joint) const;
  void set_flow(std::size_t joint, const kernel::WeldJoint::Freedoms& flow) { joints_[joint].state.flow = flow; }
  /// Once a cycle, after the forces of the elements. The work of the joint of weld i on the side of each end [energy].
  struct Work {
    std::size_t weld;
    std::array<double, 2> at_end;
  };
  const std::vector<Work>& book();
  void archive(Archive& a);

 private:
  /// A joint, with what it needs of its weld. Nodes are those of the section, both faces.
  struct Moving {
    Moving(const system::System& system, const system::BrickJoint& source);
    /// Forces of the bricks on the faces' nodes.
    void gather(const system::System& system, std::vector<Vec3d>& force) const;
    /// The joint's axes where the section has these: turned about r by the angle between both at the start.
    Frame3d axes_in(const Frame3d& section_axes) const;
    std::size_t end_of(std::size_t node) const { return node < of_first_face ? 0 : 1; }

    const system::BrickJoint* source;
    weld::BrickSection section;
    double cosine = 1.0, sine = 0.0;  ///< of that angle
    std::vector<int> nodes;           ///< of the system; those of the first face come first
    std::size_t of_first_face = 0;
    struct Corner {
      system::System::ElementLocation location;
      int corner;
      std::size_t node;
    };
    std::vector<Corner> corners;
    kernel::WeldJoint::State state;
    bool acts = false;                            ///< in this cycle
    std::vector<Vec3d> slid, force, force_after;  ///< in this cycle against their discs; forces before and after it
    // What it meets in this cycle, in the middle of the step.
    std::vector<Vec3d> x, v;
    system::JointMotions motions;
    std::array<system::FaceMotion, 2> face;
    kernel::WeldJoint::Freedoms moved{}, stiffness{}, resultant{};
    void archive(Archive& a);
  };
  void meet(Moving& joint, const system::State& state);
  void slide(Moving& joint, system::State& state);

  system::System& system_;
  std::vector<Moving> joints_;
  std::vector<Work> works_;
};

}  // namespace nugget::impact
