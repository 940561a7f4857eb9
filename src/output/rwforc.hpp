// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "output/ascii.hpp"

namespace nugget::output {

/// Force of one rigid wall on the model [force].
struct RwforcRow {
  int wall = 0;         ///< ID of *RIGIDWALL_..._ID, or the place in the deck from 1
  double normal = 0.0;  ///< along the wall's normal
  Vec3d force;          ///< global axes
};

struct RwforcState {
  double time = 0.0;
  std::vector<RwforcRow> rows;  ///< the same walls in the same order in every state
};

/// The ASCII file `rwforc`; the legend holds the headings of *RIGIDWALL_..._ID.
class Rwforc {
 public:
  Rwforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend = {});
  void write(const RwforcState& state);
  void archive(Archive& a) { a(file_); }

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
