// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// Energy of one contact: minus the work of its forces on the nodes of either side.
struct SleoutRow {
  int contact = 0;                        ///< user id
  double tracked = 0.0, reference = 0.0;  ///< LS-DYNA's slave and master side [energy]
  bool single_surface = false;            ///< it has no second side
  double friction = 0.0;                  ///< what of it friction has taken [energy]
};

struct SleoutState {
  double time = 0.0;
  long cycle = 0;
  std::vector<SleoutRow> rows;  ///< the same contacts in the same order in every state

  double total_tracked() const;
  double total_reference() const;
  double total_friction() const;
};

/// The file `sleout`; the legend holds the titles of *CONTACT_..._TITLE.
const HistoryFormat<SleoutState>& sleout();

}  // namespace nugget::output
