// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/deck_changes.hpp"
#include "app/study_results.hpp"
#include "base/finding.hpp"

namespace nugget::app {

/// What is to be run with which values, and what is to be gathered.
struct StudyPlan {
  std::string deck;
  std::vector<ResultRequest> results;
  int channel_class = 0;             ///< CFC of the filter of results; 0: none
  std::vector<std::string> options;  ///< of `nugget run`, for each run
  struct Line {
    std::vector<std::string> cells;
    Place place;
  };
  std::vector<Line> table;  ///< its first line names parameters
};

/// Reads a plan: lines `deck: FILE` (from the plan's folder), `result: [NAME =] CHANNEL[:HOW]`, `cfc: CLASS`,
/// `options: WORDS` of nugget run, then a table. `#` and `$` begin remarks. Findings: what is missing or cannot be
/// read.
StudyPlan read_study_plan(const std::string& file, Findings& findings);

/// One run of a study.
struct Variant {
  std::string name;                 ///< of its folder
  std::vector<std::string> values;  ///< by parameter
  Place place;                      ///< its line
};

/// A column for each *PARAMETER that varies, a line for each run.
struct StudyTable {
  std::vector<std::string> parameters;
  std::vector<Variant> variants;
};

/// The plan's table against the deck. A column `run` names the runs, which are 001, 002, ... without it. An empty cell
/// leaves the deck's value. Findings: parameters that the deck does not have, cells that are no numbers, names that are
/// no names of folders or come twice.
StudyTable read_study_table(const StudyPlan& plan, const DeckChanges& deck, Findings& findings);

/// Puts the values of a run into the deck. Throws std::invalid_argument where a parameter has no one value.
void set_parameters(const StudyTable& table, const Variant& variant, DeckChanges& deck);

}  // namespace nugget::app
