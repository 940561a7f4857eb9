// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/study_page.hpp"

namespace nugget::app {

/// A number of a run that a plan asks for, `[NAME =] CHANNEL[:HOW]`: a channel as of `nugget plot`, its
/// value of largest size (peak), its largest (max), smallest (min), last or mean one.
struct ResultRequest {
  enum class How { peak, max, min, last, mean };
  std::string name, channel;
  How how = How::peak;
};

/// Nothing where it cannot be read, with the reason.
std::optional<ResultRequest> read_result_request(const std::string& text, std::string& why);

/// Gathers the results of the runs that ended normally, in folders of their names in `directory`: of an impact internal
/// energy at the end, energy ratio, welds that failed and the time of the first; of modes the first five elastic
/// frequencies; then what was asked for. `channel_class`: CFC of the filter, or 0. Gives what could not be read, in
/// sentences.
std::vector<std::string> gather_results(const std::string& directory, const std::vector<ResultRequest>& requests,
                                        int channel_class, report::Study& study);

}  // namespace nugget::app
