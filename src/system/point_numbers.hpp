// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/composed_law_kernel.hpp"

// Numbers in the history of a point that only some laws have.
namespace nugget::system {

/// Sets the size of its element, of laws that ask for it.
template <class Law>
void start_size(const kernel::LawKernel<Law>& law, double* history, int stride, double size) {
  if constexpr (requires { law.size_field(); })
    if (const int field = law.size_field(); field > 0) history[field * stride] = size;
}

/// Damage, of laws that have it: the mean over points, the history of point p from `place(p)` on. `field(i)`: the i-th
/// number of the element's state.
template <class Law, class Field, class Place>
kernel::DamageNumbers damage_of(const kernel::LawKernel<Law>& law, const Field& field, int points, const Place& place) {
  kernel::DamageNumbers mean{};
  if constexpr (requires { law.damage([](int) { return 0.0; }); }) {
    for (int p = 0; p < points; ++p) {
      const kernel::DamageNumbers d = law.damage([&](int i) { return field(place(p) + i); });
      for (std::size_t n = 0; n < mean.size(); ++n) mean[n] += d[n] / points;
    }
  }
  return mean;
}

}  // namespace nugget::system
