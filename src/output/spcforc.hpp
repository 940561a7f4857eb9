// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "output/ascii.hpp"

namespace nugget::output {

/// Force or moment of a support on one node, in the support's local axes.
struct SpcforcRow {
  int node = 0;  ///< user id
  Vec3d value;   ///< [force] or [force length]
  int set = 0;   ///< id of the *BOUNDARY_SPC_..., 0 without one
};

struct SpcforcState {
  double time = 0.0;
  std::vector<SpcforcRow> forces;   ///< nodes held in translation, ascending; the same in every state
  std::vector<SpcforcRow> moments;  ///< nodes held in rotation, ascending; the same in every state
  Vec3d resultant;                  ///< sum of the forces in global axes [force]
};

/// The ASCII file `spcforc`. A node's force stands before its moment.
class Spcforc {
 public:
  Spcforc(std::filesystem::path path, const Header& header);
  void write(const SpcforcState& state);
  void archive(Archive& a) { a(file_); }

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
