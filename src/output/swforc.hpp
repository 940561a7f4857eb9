// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// LS-DYNA's type numbers of welds (binout: swforc/metadata/types).
enum class WeldKind { constraint = 0, generalized = 1, beam = 2, solid = 3, nonnodal = 4, assembly = 6 };

/// Resultants of one weld in its own axes.
struct SwforcRow {
  int id = 0;  ///< user id of the element, the assembly or the constraint
  WeldKind kind = WeldKind::beam;
  double axial = 0.0;                                        ///< N_rr [force]
  double shear = 0.0;                                        ///< sqrt(N_rs^2 + N_rt^2) [force]
  double length = 0.0;                                       ///< now [length]
  double resultant_moment = 0.0;                             ///< sqrt(M_ss^2 + M_tt^2) [force length]
  double torsion = 0.0;                                      ///< M_rr [force length]
  double failure = 0.0;                                      ///< value of the failure function; 1 is failure
  double failure_time = 0.0;                                 ///< 0 while the weld holds
  double force() const { return std::hypot(axial, shear); }  ///< resultant of both [force]
  /// Largest failure value so far and its time, where OPT = -2 asks for them.
  std::optional<std::pair<double, double>> peak = std::nullopt;
};

struct SwforcState {
  double time = 0.0;
  std::vector<SwforcRow> rows;   ///< the same welds in the same order in every state
  bool resultant_force = false;  ///< written beside axial and shear force; LS-DYNA has no such column
};

/// The seven columns of the failure value of constraints and beams: a number that any reader of numbers takes, with as
/// many digits as fit, `0.03100`, `1.29097`, `1.0E-05`, and `failure` of a weld that has failed. A value of 1 and more
/// of one that has not (OPT -1, -2, or OPT 6 for a while) is a number, too.
std::string failure_column(double failure, bool has_failed);

/// The file `swforc` in the layout of LS-DYNA R13, where weld beams carry torsion.
const HistoryFormat<SwforcState>& swforc();

}  // namespace nugget::output
