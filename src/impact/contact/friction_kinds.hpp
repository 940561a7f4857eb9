// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kernel/contact/friction.hpp"
#include "model/model.hpp"

namespace nugget::impact {

/// Which parts have the same friction in a contact, and the friction between such kinds: one of all parts, or by part
/// (FS = -1), or of pairs of parts (FS = -2, *DEFINE_FRICTION).
struct FrictionKinds {
  FrictionKinds(const model::Model& model, const model::Contact& card);

  std::vector<int> of_part;  ///< by part
  kernel::FrictionTable table;
};

}  // namespace nugget::impact
