// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// Warns of keywords without a line, of controls that stand twice and differ, and of loads, masses, contacts and the
/// like that stand twice with the same lines, so that both count. The lines are compared as they are written: those
/// with parameters, and of other transformations, are others.
class RepeatedCards {
 public:
  void look_at(const deck::Block& block, const Keyword& row, Findings& findings);

 private:
  void warn_of_second(const deck::Block& block, Findings& findings);
  void warn_of_same(const deck::Block& block, const Keyword& row, Findings& findings);

  std::unordered_map<std::string, const deck::Block*> last_;  ///< by keyword: of controls and requests
  std::unordered_map<std::uint64_t, Place> first_;            ///< by the hash of what adds up
};

/// Warns of a keyword that has been read without a word and without a line.
void warn_of_nothing(const deck::Block& block, const Keyword& row, Findings& findings);

}  // namespace nugget::reading
