// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace nugget::model {

/// The history files that a run can write: the one list of them, in the order in which they are written. Each has its
/// card *DATABASE_NAME (reading/cards/database.cpp), its request (requests.hpp), its file impact/recording/histories/
/// NAME.cpp, which says what it holds and when, and is removed when another run begins in the same folder
/// (output/results.cpp).
// A line each.
// clang-format off
inline constexpr auto history_files = std::to_array<std::string_view>({
    "glstat",
    "matsum",
    "nodout",
    "swforc",
    "dcfail",
    "deforc",
    "disbout",
    "jntforc",
    "sbtout",
    "rwforc",
    "spcforc",
    "bndout",
    "rbdout",
    "abstat",
    "rcforc",
    "ncforc",
    "secforc",
    "nodfor",
    "elout",
    "sleout",
});
// clang-format on

/// A name of that list; one that is not in it does not compile.
struct HistoryName {
  std::size_t index = 0;
  constexpr explicit HistoryName(std::size_t place) : index(place) {}
  consteval HistoryName(const char* name) {
    while (history_files.at(index) != name) ++index;
  }
  constexpr std::string_view text() const { return history_files[index]; }
};

}  // namespace nugget::model
