// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "output/d3plot.hpp"

// How many words stand where in a d3plot: what its writer and its reader share.
namespace nugget::output {

inline constexpr std::size_t d3plot_word = 4;  // bytes
inline constexpr float d3plot_end_of_states = -999999.0F;
inline constexpr int d3plot_layer_words = 7;  ///< six stresses and the plastic strain

inline bool holds_modes(const D3plotGeometry& g) {
  return g.family == D3plotGeometry::Family::d3eigv;
}

/// Words of one record of each kind.
inline int solid_words(const D3plotGeometry& g) {
  return d3plot_layer_words + g.solid_histories + (g.strains ? 6 : 0);
}
inline int words_of_layers(const D3plotGeometry& g) {
  return g.layers * (d3plot_layer_words + g.shell_histories);
}
/// One more than LSTC's document says: files of R11 have it, without strains 22 words for three layers.
inline int thick_shell_words(const D3plotGeometry& g) {
  return words_of_layers(g) + (g.strains ? 12 : 0) + 1;
}
inline std::size_t count_thick_shells(const D3plotGeometry& g) {
  return static_cast<std::size_t>(std::count(g.thick.begin(), g.thick.end(), char{1}));
}
/// Of a node: place, and but for modes velocity and acceleration.
inline int nodal_words(const D3plotGeometry& g) {
  return holds_modes(g) ? 3 : 9;
}
inline int beam_words(const D3plotGeometry& g) {
  return 6 + 5 * g.beam_points;
}
inline int shell_words(const D3plotGeometry& g) {
  return g.shell_stresses ? words_of_layers(g) + 8 + 4 + (g.strains ? 12 : 0) : 4;
}
inline int global_words(const D3plotGeometry& g) {
  return 6 + 7 * (static_cast<int>(g.parts.size()) + g.nodal_rigid_bodies) + g.rigid_walls;
}
/// Of a whole state, its time included.
inline std::size_t state_words(const D3plotGeometry& g) {
  const auto words = [](std::size_t elements, int of_one) {
    return elements * static_cast<std::size_t>(of_one + 1);  // and its deletion flag
  };
  return 1 + static_cast<std::size_t>(global_words(g)) + static_cast<std::size_t>(nodal_words(g)) * g.node_ids.size() +
         words(g.solids.size() - count_thick_shells(g), solid_words(g)) +
         words(count_thick_shells(g), thick_shell_words(g)) + words(g.beams.size(), beam_words(g)) +
         words(g.shells.size(), shell_words(g));
}

}  // namespace nugget::output
