// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

enum class ContactSide { tracked = 0, reference = 1 };  ///< LS-DYNA's slave and master (binout: rcforc/metadata/side)

/// Resultant force on one side of a contact, in global axes.
struct RcforcRow {
  int contact = 0;  ///< user id
  ContactSide side = ContactSide::tracked;
  Vec3d force;        ///< [force]
  double mass = 0.0;  ///< of the nodes on this side [mass]; recorders leave it 0
};

struct RcforcState {
  double time = 0.0;
  std::vector<RcforcRow> rows;  ///< the same sides in the same order in every state
};

/// The file `rcforc`; the legend holds the titles of *CONTACT_..._TITLE.
const HistoryFormat<RcforcState>& rcforc();

}  // namespace nugget::output
