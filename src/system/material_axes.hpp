// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "kernel/law/axes_field.hpp"
#include "kernel/law/composed_law_kernel.hpp"

namespace nugget::system {

/// How the material axes of a law's points lie at the start; null: it has none.
template <class Law>
const kernel::MaterialAxes* material_axes(const kernel::LawKernel<Law>& law) {
  if constexpr (requires { law.axes(); })
    return law.axes();
  else
    return nullptr;
}

/// Axes a, b, c of a solid now: the mean over its points, whose histories begin at the fields `history_of(point)`.
template <class Law, class Field, class HistoryOf>
std::optional<Frame3d> solid_material_axes(const kernel::LawKernel<Law>& law, const Field& field, int points,
                                           const HistoryOf& history_of) {
  if (material_axes(law) == nullptr) return {};
  Vec3d a, b;
  for (int p = 0; p < points; ++p) {
    const int i = history_of(p) + kernel::first_axis_field;
    a += Vec3d{field(i), field(i + 1), field(i + 2)};
    b += Vec3d{field(i + 3), field(i + 4), field(i + 5)};
  }
  const Vec3d e1 = unit(a), e3 = unit(cross(a, b));
  return Frame3d{e1, cross(e3, e1), e3};
}

}  // namespace nugget::system
