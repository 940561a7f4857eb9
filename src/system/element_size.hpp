// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/prepared_compound.hpp"

namespace nugget::system {

/// Sets the size of its element in the history of a point, of laws that ask for it.
template <class Law>
void start_size(const kernel::Prepared<Law>& law, double* history, int stride, double size) {
  if constexpr (requires { law.size_field(); })
    if (const int field = law.size_field(); field > 0) history[field * stride] = size;
}

}  // namespace nugget::system
