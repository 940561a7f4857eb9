// SPDX-License-Identifier: Apache-2.0
#include "app/mode_pairs.hpp"

#include <fmt/format.h>

#include "base/index.hpp"

namespace nugget::app {

std::string pair_table(const nvh::Modes& modes, const nvh::ModeComparison& c, const std::string& other,
                       const std::optional<model::Units>& units) {
  std::string s = fmt::format("Compared with {} over {} nodes", other, c.nodes);
  if (c.renumbered > 0) s += fmt::format(", {} of them by their places, with other ids", c.renumbered);
  if (c.absent > 0) s += fmt::format("; {} nodes of this run have no node at their place in the other", c.absent);
  s += "\n\n";
  if (c.nodes == 0) return s + " no node in common: nothing can be compared\n\n";
  const std::string frequency = "frequency" + model::in_frequency(units);
  s += fmt::format(" {:>6} {:>14} {:>8} {:>14} {:>9} {:>7}\n", "mode", frequency, "other", frequency, "shift [%]",
                   "MAC");
  for (std::size_t i = 0; i < c.partner.size(); ++i) {
    const double f = modes.frequency(i);
    s += fmt::format(" {:>6} {:>14.6g}", i + 1, f);
    if (!modes.elastic(i)) {
      s += "        rigid motion\n";
      continue;
    }
    if (c.partner[i] < 0) {
      s += "        -\n";
      continue;
    }
    const std::size_t j = at(c.partner[i]);
    const double mac = c.mac[i][j], g = c.frequency[j];
    s += fmt::format(" {:>8} {:>14.6g} {:>9.3f} {:>7.4f}{}\n", j + 1, g, g > 0.0 ? 100.0 * (f / g - 1.0) : 0.0, mac,
                     mac < 0.5 ? "  not the same shape" : "");
  }
  return s + "\n the whole matrix is in mac.csv\n\n";
}

}  // namespace nugget::app
