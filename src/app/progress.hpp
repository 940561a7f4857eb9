// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "impact/simulation/options.hpp"

namespace nugget::app {

/// How much of a run is done, from 0 to 1; of one without an end, nothing.
double share_done(const impact::Progress& p);
/// Seconds of the clock until its end, if it goes on as it went; nothing at the start.
std::optional<double> seconds_left(const impact::Progress& p);
/// Time, step, cycle, energy ratio, failed welds, time left.
std::string progress_line(const impact::Progress& p);
/// 61 s as `1:01`.
std::string clock_time(double seconds);

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
