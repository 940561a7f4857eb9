// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "output/nodfor.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Forces that the elements ask of the nodes of *DATABASE_NODAL_FORCE_GROUP: m a + (this force) = outer forces. On a
/// node that is held or driven it is the reaction, but for its own inertia. Its work is added up in every cycle.
class NodalForceGroups {
 public:
  explicit NodalForceGroups(const system::System& system);

  /// After the internal forces at the end of a step of length state.dt.
  void update(const system::State& state);
  /// As Supports::reset_work.
  void reset_work() {
    for (Group& group : groups_)
      for (Node& node : group.nodes) node.work = 0.0;
  }
  output::NodforState state(const system::State& now) const;

  /// See Components::elements_read.
  template <class Visit>
  void elements_read(const Visit& visit) const {
    for (const Group& group : groups_)
      for (const Node& node : group.nodes)
        for (const Corner& c : node.corners) visit(c.location);
  }

  void archive(Archive& a);

 private:
  struct Corner {
    system::System::ElementLocation location;
    int corner;
  };
  struct Node {
    model::Index node;  ///< of the model
    std::vector<Corner> corners;
    Vec3d force;
    double work = 0.0;
    void archive(Archive& a);
  };
  struct Group {
    const model::NodalForceGroup* card;
    std::vector<Node> nodes;
    void archive(Archive& a);
  };
  const system::System& system_;
  std::vector<Group> groups_;
};

}  // namespace nugget::impact
