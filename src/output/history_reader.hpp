// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/card.hpp"

namespace nugget::output {

/// One quantity of one entity over the times of its file.
struct Channel {
  std::string entity;    ///< `node 17`, `weld 50002`, `wall 1`; empty where the file is of the whole model
  std::string title;     ///< of the entity, where the file has a legend
  std::string quantity;  ///< its name in binout: `axial`, `x_force`, `internal_energy`
  Dimension dimension;
  std::vector<double> values;  ///< one for each time; zero before the entity appears
};

/// A history file that a run left.
struct HistoryRecord {
  std::string file;  ///< `glstat`, `swforc`, ...
  std::vector<double> times;
  std::vector<Channel> channels;
};

/// Those that can be read, in alphabetical order: glstat, matsum, nodout, swforc, rcforc, ncforc, secforc, rwforc,
/// spcforc, rbdout (global axes), sleout, abstat, deforc, jntforc, dcfail.
std::span<const std::string_view> readable_histories();

/// Of these, what is in the folder: the branch of binout0000 with all its digits, where there is one, else the ASCII
/// file. A state that is cut off is left out. Files that are missing or hold no state are not in the result; nothing is
/// thrown.
std::vector<HistoryRecord> read_histories(const std::filesystem::path& directory,
                                          std::span<const std::string_view> files = readable_histories());

}  // namespace nugget::output
