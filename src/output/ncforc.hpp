// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"
#include "output/rcforc.hpp"

namespace nugget::output {

/// Contact force on one node of a side, in global axes.
struct NcforcRow {
  int node = 0;           ///< user id
  Vec3d force;            ///< [force]
  double pressure = 0.0;  ///< of its normal component, on the node's share of the surface [stress]
  Vec3d x;                ///< where the node stands [length]
};

/// One side of a contact.
struct NcforcSide {
  int contact = 0;  ///< user id
  ContactSide side = ContactSide::tracked;
  std::vector<NcforcRow> rows;
};

struct NcforcState {
  double time = 0.0;
  std::vector<NcforcSide> sides;  ///< the same sides and nodes in the same order in every state
};

/// `ncforc/slave_000007` or `ncforc/master_000007`: the branch of binout of a side.
std::string branch_of(const NcforcSide& side);

/// The file `ncforc` of these sides, whose rows do not count; a branch of binout for each. The legend holds the titles
/// of *CONTACT_..._TITLE.
HistoryFormat<NcforcState> ncforc(const std::vector<NcforcSide>& sides);

}  // namespace nugget::output
