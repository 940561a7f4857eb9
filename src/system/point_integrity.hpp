// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/element/brick_patterns.hpp"
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

/// Gives the law of a weld's point the stress that the point has, from which it goes on where its points are damaged or
/// have the stresses of a cross-section only: `stress` in the order of its history, which begins at `history`.
template <std::size_t size, class Field, class Put>
void put_undamaged(const kernel::LawKernel<kernel::Spotweld>& law, const Field& field, const Put& put, int history,
                   const std::array<double, size>& stress) {
  const double left = point_integrity(law, field, 1, [history](int) { return history; });
  const double over = left > 0.0 ? 1.0 / left : 0.0;
  for (std::size_t i = 0; i < size; ++i)
    put(history + kernel::LawKernel<kernel::Spotweld>::undamaged_stress_field + static_cast<int>(i), over * stress[i]);
}

/// The same for the point of a brick at the start, of no more damage than its plastic strain makes; `x`: its corners.
template <class Put>
void start_weld_point(const kernel::LawKernel<kernel::Spotweld>& law, const Put& put, int history,
                      const std::array<double, 6>& stress, double plastic_strain, const std::array<Vec3d, 8>& x) {
  const auto field = [&](int i) { return i == history + kernel::plastic_strain_field ? plastic_strain : 0.0; };
  if (!law.uniaxial()) return put_undamaged(law, field, put, history, stress);
  const auto& [xx, yy, zz, xy, yz, zx] = stress;
  const Frame3d weld = kernel::weld_axes(kernel::patterns_of(x));
  const Vec3d& r = weld.e1;
  const Vec3d on_section{xx * r.x + xy * r.y + zx * r.z, xy * r.x + yy * r.y + yz * r.z,
                         zx * r.x + yz * r.y + zz * r.z};
  put_undamaged(law, field, put, history,
                std::array<double, 3>{dot(r, on_section), dot(weld.e2, on_section), dot(weld.e3, on_section)});
}

}  // namespace nugget::system
