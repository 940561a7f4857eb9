// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/units.hpp"
#include "report/run_data.hpp"

namespace nugget::app {

/// By what `nugget welds` ranks the welds of a run.
enum class WeldOrder { energy, margin, failure };

/// One weld of a finished run, out of welds.csv. What the file does not say is not a number.
struct RankedWeld {
  std::string id, kind, sheets, failure_mode;
  double passed = 0.0;         ///< net energy from the first sheet to the second, the largest of the run [energy]
  double taken = 0.0;          ///< work done on the weld itself [energy]
  double failure_value = 0.0;  ///< largest of the run; 0: its material has no failure function
  double at_time = 0.0;        ///< of that value [time]
  double failure_time = 0.0;   ///< not a number: it holds [time]
  double interval = 0.0;       ///< of `course` [time]
  std::vector<double> course;  ///< largest failure value in each interval from the start on
  double margin() const;       ///< 1 less the largest failure value; not a number without a failure function
};

/// The welds of a run in order: by energy those first through which most passed, by margin those nearest to failure
/// first, by failure the first to fail first, then by margin. Equal ones stand as in welds.csv.
std::vector<RankedWeld> rank_welds(const report::RunData& run, WeldOrder order);

/// A table to read, at most `most` lines of it (0: all), or comma-separated values of all.
std::string ranking_table(const std::vector<RankedWeld>& welds, WeldOrder order, std::size_t most,
                          const std::optional<model::Units>& units);
std::string ranking_csv(const std::vector<RankedWeld>& welds);

/// One weld of a modal run, out of mode_energy.csv.
struct WeldShare {
  std::string id;
  double largest = 0.0;  ///< of its shares in the strain energies of the modes
  int mode = 0;          ///< the mode in which it has it
};
/// The welds of a modal run, largest share first.
std::vector<WeldShare> rank_shares(const report::RunData& run);
std::string share_table(const std::vector<WeldShare>& welds, std::size_t most);
std::string share_csv(const std::vector<WeldShare>& welds);

}  // namespace nugget::app
