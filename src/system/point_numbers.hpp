// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/prepared_compound.hpp"

// Numbers in the history of a point that only some laws have.
namespace nugget::system {

/// Sets the size of its element, of laws that ask for it.
template <class Law>
void start_size(const kernel::Prepared<Law>& law, double* history, int stride, double size) {
  if constexpr (requires { law.size_field(); })
    if (const int field = law.size_field(); field > 0) history[field * stride] = size;
}

/// Damage, of laws that have it; `history(i)`: the i-th number, in the mean of several points.
template <class Law, class History>
kernel::DamageNumbers damage_of(const kernel::Prepared<Law>& law, const History& history) {
  if constexpr (requires { law.damage(history); })
    return law.damage(history);
  else
    return {};
}

}  // namespace nugget::system
