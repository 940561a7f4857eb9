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

/// A quantity of elements that colours them. Not a number where an element has none.
struct ColourField {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string_view name;
  Dimension dimension;
  double (*of_layer)(const output::StressRecord&);  ///< null: thickness, which only shells have
  int histories = 0;                                ///< history variables that a file must have for it

  /// The largest of a shell's layers.
  double of_shell(std::size_t shell, const output::D3plotState& s, const output::D3plotGeometry& g) const {
    if (!of_layer) return s.shells[shell].thickness;
    if (g.shell_histories < histories) return none;
    double largest = 0.0;
    for (std::size_t i = 0; i < at(g.layers); ++i)
      largest = std::max(largest, of_layer(s.shell_layers[shell * at(g.layers) + i]));
    return largest;
  }
  double of_solid(std::size_t solid, const output::D3plotState& s, const output::D3plotGeometry& g) const {
    return of_layer && g.solid_histories >= histories ? of_layer(s.solids[solid]) : none;
  }
  double of(const Facet& facet, const output::D3plotState& s, const output::D3plotGeometry& g) const {
    return facet.of_shell ? of_shell(at(facet.element), s, g) : of_solid(at(facet.element), s, g);
  }
};

/// How far a point is to its failure, 0 to 1: the larger of the share of its stress that it has lost and of the damage
/// summed along its path, which are history variables 1 and 2 (docs/manual/d3plot.md).
inline double damage_of(const output::StressRecord& r) {
  return std::max(r.history[0], r.history[1]);
}

inline constexpr ColourField damage_field{"damage", dimension::number, damage_of, 1};

inline constexpr std::array<ColourField, 4> colour_fields{
    {{"plastic strain", dimension::number, [](const output::StressRecord& r) { return r.plastic_strain; }},
     {"von Mises stress", dimension::stress, [](const output::StressRecord& r) { return von_mises(r.stress); }},
     {"thickness", dimension::length, nullptr},
     damage_field}};

}  // namespace nugget::report
