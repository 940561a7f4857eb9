// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>

#include "base/finding.hpp"

namespace nugget::weld {

/// Passes on the first warnings of each kind and, at the end, says how many more there were: thousands of like warnings
/// hide the one that differs. All of them stand in welds.csv.
class Tally {
 public:
  explicit Tally(Findings& findings) : findings_(findings) {}

  /// `kind` finishes the sentence "... more welds: <kind>".
  void warning(const std::string& kind, Place place, std::string keyword, std::string text, std::string remedy) {
    Count& count = counts_[kind];
    if (++count.seen > most_of_a_kind) return;
    count.keyword = keyword;
    findings_.warning(std::move(place), std::move(keyword), std::move(text), std::move(remedy));
  }

  /// Writes down the rests.
  void close() {
    for (const auto& [kind, count] : counts_)
      if (count.seen > most_of_a_kind)
        findings_.warning({}, count.keyword, std::to_string(count.seen - most_of_a_kind) + " more: " + kind,
                          "welds.csv has a row for every weld");
    counts_.clear();
  }

 private:
  static constexpr int most_of_a_kind = 20;
  struct Count {
    int seen = 0;
    std::string keyword;
  };
  Findings& findings_;
  std::map<std::string, Count> counts_;
};

}  // namespace nugget::weld
