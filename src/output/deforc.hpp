// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "output/ascii.hpp"

namespace nugget::output {

/// Force of a spring or damper on its first node; of a torsional one the moment, and the twist instead of the
/// elongation.
struct DeforcRow {
  int spring = 0;  ///< user id
  bool torsional = false;
  Vec3d force;                ///< global axes
  double resultant = 0.0;     ///< positive in tension
  double displacement = 0.0;  ///< change in length
};

struct DeforcState {
  double time = 0.0;
  std::vector<DeforcRow> rows;  ///< the same springs in the same order in every state
};

/// The ASCII file `deforc`.
class Deforc {
 public:
  Deforc(std::filesystem::path path, const Header& header);
  void write(const DeforcState& state);
  void archive(Archive& a) { a(file_); }

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
