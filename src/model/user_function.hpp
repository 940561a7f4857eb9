// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/finding.hpp"
#include "base/formula.hpp"

namespace nugget::model {

/// *DEFINE_FUNCTION.
struct UserFunction {
  int id = 0;
  std::string title;
  Formula formula;
  Place place;
};

}  // namespace nugget::model
