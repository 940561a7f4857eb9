// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "model/cross_section.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// When and how one history file is written. `interval` 0: not at all.
struct Request {
  /// IOOPT: how `curve` gives the next time from one at which there was a record.
  enum class Rule {
    from_last,  ///< 1: the curve's value at that time later
    to_next,    ///< 2: the curve's value at the next time later than it
    at_points   ///< 3: at each abscissa of the curve
  };
  double interval = 0.0;  ///< DT [time]
  Index curve = none;     ///< LCUR: interval over time
  Rule rule = Rule::from_last;
  int binary = 0;                ///< 0 as on this machine (ASCII), 1 ASCII, 2 binout, 3 both
  bool resultant_force = false;  ///< OPTION1 = 1 of swforc: that of each weld beside axial and shear force
  bool ascii() const { return interval > 0.0 && binary != 2; }
  bool binout() const { return interval > 0.0 && binary >= 2; }
  bool asked() const { return interval > 0.0; }
};

struct NamedEntity {
  Index index = none;
  std::string heading;    ///< of the _ID form
  Index system = none;    ///< of a node: the axes of its motion (*DATABASE_HISTORY_NODE_LOCAL), or none: global
  bool turning = false;   ///< REF 1 and 2: these axes as they stand at that time; else as at time 0
  bool relative = false;  ///< REF 2: the motion as seen from these axes, their origin included
};

struct HistoryName;  // history_files.hpp

/// The *DATABASE_... cards.
struct Requests {
  /// Of a history file: `requests["glstat"]`. One that no card asks for is not asked.
  Request& operator[](HistoryName file);
  const Request& operator[](HistoryName file) const;
  std::map<std::string, Request, std::less<>> histories;  ///< by name of the file
  Request d3plot;                                         ///< interval; `binary` unused
  std::vector<NamedEntity> history_nodes, history_shells, history_solids, history_beams;
  std::vector<NamedEntity> history_thick_shells;    ///< indices of solids
  std::vector<CrossSection> cross_sections;         ///< of secforc
  std::vector<NodalForceGroup> nodal_force_groups;  ///< of nodfor

  // *DATABASE_EXTENT_BINARY
  int layers = 3;                                ///< MAXINT
  bool strains = false;                          ///< STRFLG
  int solid_histories = 0, shell_histories = 0;  ///< NEIPH, NEIPS
  bool one_state_a_file = false;                 ///< IEVERP
  int beam_points = 0;                           ///< BEAMIP
  bool material_axes = false;  ///< CMPFLG: stresses and strains where a material has axes a, b, c in these

  /// EOCS of *CONTROL_OUTPUT: axes of shells in elout.
  enum class ShellAxes {
    standard,  ///< the element's own, or the material's where `material_axes` asks for them
    element,
    global
  };
  ShellAxes shell_axes = ShellAxes::standard;
};

}  // namespace nugget::model
