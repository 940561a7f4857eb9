// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "output/ascii.hpp"

namespace nugget::output {

/// What a joint does to its second body, at the joint, global axes.
struct JntforcRow {
  int joint = 0;  ///< user id
  Vec3d force, moment;
  double energy = 0.0;  ///< stored and lost in the joint; in binout only
};

struct JntforcState {
  double time = 0.0;
  std::vector<JntforcRow> rows;  ///< the same joints in the same order in every state
};

/// The ASCII file `jntforc`; the legend holds the headings of *CONSTRAINED_JOINT_..._ID.
class Jntforc {
 public:
  Jntforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend = {});
  void write(const JntforcState& state);
  void archive(Archive& a) { a(file_); }

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
