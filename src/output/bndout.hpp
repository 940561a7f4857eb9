// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "output/ascii.hpp"

namespace nugget::output {

/// What a prescribed motion does to one node.
struct BndoutNode {
  int node = 0;         ///< user id
  Vec3d force;          ///< global axes [force]
  double energy = 0.0;  ///< work done so far [force length]
  int set = 0;          ///< node set of the card, 0 without one
};

/// What a prescribed motion does to one rigid part.
struct BndoutBody {
  int part = 0;  ///< user id
  Vec3d force, moment;
  double energy = 0.0;
};

struct BndoutState {
  double time = 0.0;
  std::vector<BndoutNode> nodes;   ///< the same in every state
  std::vector<BndoutBody> bodies;  ///< the same in every state
};

/// Sum of forces and energies of a table of bndout.
struct BndoutTotal {
  Vec3d force;
  double energy = 0.0;
};
BndoutTotal total(std::span<const BndoutNode> nodes);
BndoutTotal total(std::span<const BndoutBody> bodies);

/// The ASCII file `bndout`, section of the prescribed motions.
class Bndout {
 public:
  Bndout(std::filesystem::path path, const Header& header);
  void write(const BndoutState& state);
  void archive(Archive& a) { a(file_); }

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
