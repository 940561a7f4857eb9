// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "impact/simulation/options.hpp"

namespace nugget::app {

/// Shows how far a run is, on standard error: on a terminal one line that is drawn again and again, otherwise a line
/// every few seconds.
class ProgressDisplay {
 public:
  ProgressDisplay();
  void operator()(const impact::Progress& p);
  /// Ends the line on a terminal.
  void finish();

 private:
  void print_relaxation(const impact::Progress& p);

  bool terminal_;
  bool drawn_ = false;
  double next_line_ = 0.0;
};

}  // namespace nugget::app
