// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/law/spotweld_kernel.hpp"

namespace nugget::system {

/// Share of its stress that the damage of a weld's points (DMGOPT 0 to 2) has left, the mean of `count` points;
/// `history_of(k)`: where the history of point k begins in the element's state.
template <class Field, class Start>
double point_integrity(const kernel::LawKernel<kernel::Spotweld>& law, const Field& field, int count,
                       const Start& history_of) {
  constexpr int numbers = kernel::LawKernel<kernel::Spotweld>::undamaged_stress_field;
  double sum = 0.0;
  for (int k = 0; k < count; ++k) {
    std::array<double, numbers> history;
    for (int i = 0; i < numbers; ++i) history[i] = field(history_of(k) + i);
    sum += law.integrity<double>(history.data());
  }
  return sum / count;
}

}  // namespace nugget::system
