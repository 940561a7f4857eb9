// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/finding.hpp"

// *CASE: several analyses in one deck. Each takes what stands outside of every *CASE_BEGIN_n ... *CASE_END_n, and what
// stands inside of those of its subcases n. The cards stand in the master file only.
namespace nugget::deck {

/// One analysis of a deck.
struct Case {
  int id = 0;                 ///< CASEID; without any *CASE each subcase is a case of the same number
  std::string job;            ///< JOBID: what its results are called; empty: not given
  std::vector<int> subcases;  ///< SCID: numbers n of *CASE_BEGIN_n
  std::string commands;       ///< words of LS-DYNA's command line, which are not obeyed
  Place place;
};

/// The number of `CASE_BEGIN_n` or `CASE_END_n`; 0 where the keyword is another.
int subcase_begun(std::string_view keyword);
int subcase_ended(std::string_view keyword);

/// The cases of the text of a master file, in its order. `file`: its name, for findings.
std::vector<Case> cases_of(std::string_view text, const std::string& file, Findings& findings);

}  // namespace nugget::deck
