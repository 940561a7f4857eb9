// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "model/nugget_weld_law.h"

namespace nugget::model {

/// A shared library with the user's own failure function, open as long as this is there.
struct WeldLibrary {
  std::string path;
  decltype(&nugget_weld_law) value = nullptr;
  decltype(&nugget_weld_law_memory) memory = nullptr;  ///< null: it needs none
  std::shared_ptr<void> handle;
};

}  // namespace nugget::model
