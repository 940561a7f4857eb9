// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "base/finding.hpp"
#include "model/weld_library.hpp"

namespace nugget::weld::failure {

/// Opens a library as src/model/nugget_weld_law.h has it. Null, and an error, where it cannot be opened, lacks a
/// function, or was compiled for another version.
std::shared_ptr<const model::WeldLibrary> open_library(const std::string& path, Findings& findings);

}  // namespace nugget::weld::failure
