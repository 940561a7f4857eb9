// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "contact/surface.hpp"
#include "impact/contact/element_alive.hpp"
#include "impact/simulation/snapshot.hpp"
#include "output/ncforc.hpp"

namespace nugget::impact {

/// Marks the system's nodes of a surface, by node.
std::vector<unsigned char> nodes_of(const system::System& system, const model::Surface& surface);

/// The sides of contacts that ask for forces by node (ncforc): those of sliding contacts, and transducers of one side.
class ContactSides {
 public:
  /// While the places of the start are there.
  explicit ContactSides(const system::System& system);

  /// Contact and side of each, without rows: by id, the tracked side first.
  std::vector<output::NcforcSide> sides() const;
  /// All that can be pressed of each side, by user id. The pressure is that of the normal component of the force, on a
  /// quarter or a third of each segment of the side that is there, as they stand at that time; 0 without segments.
  output::NcforcState state(const Snapshot& now);

 private:
  struct Face : contact::Facet {
    int element = -1, covered_by = -1;  ///< as of contact::Segment
  };
  struct Side {
    const model::Contact* card;
    int place;  ///< in Contacts::all(); -1: a transducer
    output::ContactSide side;
    std::vector<Face> faces;
    contact::NodeSegments around;
    std::vector<int> nodes;  ///< in the order of the file; known with the first state
  };
  void add(const system::System& system, const model::Contact& card, int place, output::ContactSide side);
  void list_nodes(const Snapshot& now, Side& side) const;
  Vec3d force(const Snapshot& now, const Side& side, int node) const;
  double pressure(const Snapshot& now, const Side& side, int node, const Vec3d& force) const;

  ElementAlive alive_;
  std::vector<Side> sides_;
  bool listed_ = false;
};

}  // namespace nugget::impact
