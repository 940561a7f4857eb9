// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/prepared_compound.hpp"

namespace nugget::system {

/// How the material axes of a law's points lie at the start; null: it has none.
template <class Law>
const kernel::MaterialAxes* material_axes(const kernel::Prepared<Law>& law) {
  if constexpr (requires { law.axes(); })
    return law.axes();
  else
    return nullptr;
}

}  // namespace nugget::system
