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

struct BodyCards {
  struct Nodal {
    std::string title;
    deck::Row row;                 ///< PID CID NSID PNODE IPRT DRFLAG RRFLAG
    std::optional<deck::Row> spc;  ///< _SPC with CMO -1: held in axes that are found later
    unsigned fixed = 0;            ///< what that card holds
    bool given = false;            ///< with _INERTIA
    model::RigidBody::Inertia inertia;
    std::optional<deck::Row> inertia_row;  ///< its first card: the centre may be a node
    std::optional<deck::Row> axes_row;     ///< its last card: a coordinate system of the tensor
  };
  struct ExtraNodes {
    bool set = false;  ///< a node set, else one node
    deck::Row row;
  };
  struct Weld {
    model::RigidWeld weld;  ///< nodes, body and axis are found later
    deck::Row row;          ///< generalized: NSID CID ...; else N1 N2 ...
  };

  std::vector<Nodal> nodal;
  std::vector<ExtraNodes> extra_nodes;
  std::vector<deck::Row> merges;  ///< PIDL PIDC IFLAG
  std::vector<Weld> welds;
};

}  // namespace nugget::reading
