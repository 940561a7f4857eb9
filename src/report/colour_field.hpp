// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "base/card.hpp"
#include "base/index.hpp"
#include "output/d3plot.hpp"
#include "report/skin.hpp"
#include "report/stress.hpp"

namespace nugget::report {

/// A quantity of elements that colours them.
struct ColourField {
  std::string_view name;
  Dimension dimension;
  double (*of_layer)(const output::StressRecord&);  ///< null: thickness, which only shells have

  /// The largest of a shell's layers.
  double of_shell(std::size_t shell, const output::D3plotState& s, int layers) const {
    if (!of_layer) return s.shells[shell].thickness;
    double largest = 0.0;
    for (std::size_t i = 0; i < at(layers); ++i)
      largest = std::max(largest, of_layer(s.shell_layers[shell * at(layers) + i]));
    return largest;
  }
  /// Not a number where it has none.
  double of_solid(std::size_t solid, const output::D3plotState& s) const {
    return of_layer ? of_layer(s.solids[solid]) : std::numeric_limits<double>::quiet_NaN();
  }
  double of(const Facet& facet, const output::D3plotState& s, int layers) const {
    return facet.of_shell ? of_shell(at(facet.element), s, layers) : of_solid(at(facet.element), s);
  }
};

inline constexpr std::array<ColourField, 3> colour_fields{
    {{"plastic strain", dimension::number, [](const output::StressRecord& r) { return r.plastic_strain; }},
     {"von Mises stress", dimension::stress, [](const output::StressRecord& r) { return von_mises(r.stress); }},
     {"thickness", dimension::length, nullptr}}};

}  // namespace nugget::report
