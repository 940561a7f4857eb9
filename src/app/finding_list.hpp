// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/finding.hpp"

namespace nugget::app {

/// Findings as lines for people. Of more than `most_alike` that differ by their numbers only the first few stand there,
/// and one line more that counts the rest and says where the next ones are: `... and 96 more of this kind, at lines 26,
/// 31, ...`. Where a file is missing, of the errors that something is not defined the first stands there, and one line
/// that counts the others. findings.json has each.
std::vector<std::string> list_findings(const std::vector<Finding>& findings);

inline constexpr std::size_t most_alike = 20;

}  // namespace nugget::app
