// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "model/parts.hpp"
#include "model/rigid_weld.hpp"

// The cards of *CONSTRAINED_... that make rigid bodies or change them, as read, until Phase::bodies.
namespace nugget::reading {

struct NodalBodyCard {
  int pid = 0, cid = 0, nsid = 0, pnode = 0, iprt = 0;
};
struct ExtraNodesCard {
  int pid = 0, nodes = 0, iflag = 0;  ///< `nodes`: one node, or a set
};
struct MergeCard {
  int pidl = 0, pidc = 0, iflag = 0;
};

struct BodyCards {
  struct Nodal {
    std::string title;
    deck::RowOf<NodalBodyCard> row;
    std::optional<deck::Row> spc;  ///< _SPC with CMO -1: held in axes that are found later
    unsigned fixed = 0;            ///< what that card holds
    bool given = false;            ///< with _INERTIA
    model::RigidBody::Inertia inertia;
    deck::Entry center_node;          ///< with _INERTIA: the node at its centre, if any
    std::optional<deck::Entry> axes;  ///< a coordinate system of the tensor
  };
  struct ExtraNodes {
    bool set = false;  ///< a node set, else one node
    deck::RowOf<ExtraNodesCard> row;
  };
  struct Weld {
    model::RigidWeld weld;      ///< nodes, body and axis are found later
    deck::Entry first, second;  ///< generalized: the node set and the coordinate system; else the two nodes
  };

  std::vector<Nodal> nodal;
  std::vector<ExtraNodes> extra_nodes;
  std::vector<deck::RowOf<MergeCard>> merges;
  std::vector<Weld> welds;
};

}  // namespace nugget::reading
