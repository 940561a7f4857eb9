// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// Failure function of one weld by *DEFINE_CONNECTION_PROPERTIES and what goes into it.
struct DcfailRow {
  int id = 0;            ///< user id of the brick or the assembly
  int connection = 0;    ///< CON_ID
  double failure = 0.0;  ///< sum of the three terms; 1 is failure
  double normal = 0.0, bending = 0.0, shear = 0.0;
  double area = 0.0;                                    ///< with which stresses are formed [area]
  double solid_area = 0.0;                              ///< of the bricks [area]
  double strain_rate = 0.0;                             ///< effective, smoothed [1/time]
  double axial_force = 0.0, shear_force = 0.0;          ///< [force]
  double torsional_moment = 0.0, bending_moment = 0.0;  ///< [force length]
};

struct DcfailState {
  double time = 0.0;
  std::vector<DcfailRow> rows;  ///< the same welds in the same order in every state
};

/// The file `dcfail`.
const HistoryFormat<DcfailState>& dcfail();

}  // namespace nugget::output
