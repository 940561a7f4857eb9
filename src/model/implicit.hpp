// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace nugget::model {

/// *CONTROL_IMPLICIT_...: what linear analysis the deck asks for instead of an explicit run.
struct Implicit {
  bool active = false;          ///< IMFLAG = 1
  bool after_run = false;       ///< IMFLAG = 6: modes of the state in which the explicit run ends
  bool geometric = false;       ///< IGS = 1
  int modes = 0;                ///< NEIG; below 0: so many, of the structure under its loads at ENDTIM
  double centre = 0.0;          ///< CENTER [cycles/time]
  std::optional<double> low;    ///< LFTEND where LFLAG = 1 [cycles/time]
  std::optional<double> high;   ///< RHTEND where RFLAG = 1 [cycles/time]
  bool modal_stresses = false;  ///< MSTRES = 1
  int solid_form = 0;           ///< ISOLID: formulation of all bricks but welds; 0: that of their sections
};

}  // namespace nugget::model
