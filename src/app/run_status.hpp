// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "impact/simulation/options.hpp"

namespace nugget::app {

/// How far a run is, as its folder tells those who look at it from outside.
struct RunStatus {
  std::string deck, state;  ///< `running`, `normal`, `error` or `interrupted`
  impact::Progress at;
  long updated = 0;  ///< seconds since 1970
};

/// Writes `status.out` in the folder of a run, once a second at most, until summary.json says what became of it.
class StatusFile {
 public:
  StatusFile(std::filesystem::path directory, std::string deck);
  void update(const impact::Progress& progress);
  const impact::Progress& last() const { return last_; }
  /// The run ended where it was last updated, without a summary.
  void fail() const { write("error"); }

 private:
  /// Without a word where it cannot be written: the results will say so.
  void write(const std::string& state) const;

  std::filesystem::path directory_;
  std::string deck_;
  impact::Progress last_;
  double next_ = 0.0;
};

/// What `status.out` says, or of a run that ended summary.json; nothing where there is neither.
std::optional<RunStatus> read_status(const std::filesystem::path& directory);

/// There is a summary now.
void remove_status(const std::filesystem::path& directory);

/// What `d3kil` in the folder asks for, as in LS-DYNA: sw1 to stop with a restart file, sw2 to tell time and cycle, sw3
/// to write a restart file, sw4 a state of d3plot; the file is removed. Anything else is told on standard error.
impact::SenseSwitches take_sense_switch(const std::filesystem::path& directory);

}  // namespace nugget::app
