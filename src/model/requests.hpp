// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/cross_section.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// When and how one history file is written. `interval` 0: not at all.
struct Request {
  double interval = 0.0;  ///< DT [time]
  Index curve = none;     ///< LCUR: interval over time
  int binary = 0;         ///< 0 as on this machine (ASCII), 1 ASCII, 2 binout, 3 both
  bool ascii() const { return interval > 0.0 && binary != 2; }
  bool binout() const { return interval > 0.0 && binary >= 2; }
  bool asked() const { return interval > 0.0; }
};

struct NamedEntity {
  Index index = none;
  std::string heading;   ///< of the _ID form
  Index system = none;   ///< of a node: the axes of its motion (*DATABASE_HISTORY_NODE_LOCAL), or none: global
  bool turning = false;  ///< REF 1: these axes as they stand at that time; else as at time 0
};

/// The *DATABASE_... cards.
struct Requests {
  Request glstat, matsum, nodout, swforc, dcfail, rwforc, spcforc, bndout, rbdout, rcforc, secforc, elout, deforc,
      jntforc, nodfor, sleout;
  Request d3plot;  ///< interval; `binary` unused
  std::vector<NamedEntity> history_nodes, history_shells, history_solids, history_beams;
  std::vector<CrossSection> cross_sections;         ///< of secforc
  std::vector<NodalForceGroup> nodal_force_groups;  ///< of nodfor

  // *DATABASE_EXTENT_BINARY
  int layers = 3;                 ///< MAXINT
  bool strains = false;           ///< STRFLG
  bool one_state_a_file = false;  ///< IEVERP
  int beam_points = 0;            ///< BEAMIP
};

}  // namespace nugget::model
