// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nugget::report {

/// The runs of a deck with other values of its parameters.
struct Study {
  std::string deck, title, units;       ///< units as summary.json names them; empty: not known
  std::vector<std::string> parameters;  ///< names
  struct Run {
    std::string name;                 ///< and that of its folder
    std::vector<std::string> values;  ///< by parameter
    int exit_code = -1;               ///< -1: it was not run
  };
  std::vector<Run> runs;
  /// What is gathered of each run.
  struct Result {
    std::string name;            ///< of the column: `peak force`
    std::string quantity;        ///< what it is: `rwforc/wall 1/normal_force, of largest size`
    std::string unit;            ///< ` N`; empty of a number, and where the units are not known
    std::vector<double> values;  ///< by run; not a number where there is none
  };
  std::vector<Result> results;
};

/// A table for the terminal, a line for each run.
std::string study_lines(const Study& study);

/// study.csv, units.csv of its columns, study.html with a table, links to the reports of the runs and a plot of each
/// result over each parameter that takes several numbers, and study.svg with those plots. Throws output::WriteError.
void write_study(const std::filesystem::path& directory, const Study& study);

}  // namespace nugget::report
