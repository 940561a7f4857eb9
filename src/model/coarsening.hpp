// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/finding.hpp"
#include "base/vec3.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// *CONTROL_COARSEN and *DEFINE_BOX_COARSEN: shells that are merged, four to one, before the run.
struct CoarsenControl {
  struct Box {
    Vec3d low, high;
    bool outside = false;  ///< IFLAG 1: shells outside of it are left alone; else those inside
  };
  bool on = false;                ///< ICOARSE
  double angle = 8.0;             ///< ANGLE, between the normals of shells that are merged, at most [degrees]
  double largest = 0.0;           ///< SMAX, longest side of a merged shell; 0: no limit [length]
  std::vector<Index> kept_parts;  ///< PSID
  std::vector<Index> seeds;       ///< N1 to N8: nodes in the middle of four shells
  std::vector<Box> boxes;
  Place place;
};

/// A node on the side of a shell that is not one of its corners: it follows the side's ends (*CONSTRAINED_ADAPTIVITY).
struct HangingNode {
  Index node = none;
  std::array<Index, 2> ends{none, none};
  Place place;
};

/// Which shells become one, by user ids: what a deck is read with for the second time.
struct Coarsening {
  struct Merged {
    std::array<int, 4> shells{};  ///< the first one stays, with the part and the thickness of all
    std::array<int, 4> nodes{};   ///< its corners, in the sense and from the corner of the first one
  };
  struct Hanging {
    int node = 0;
    std::array<int, 2> ends{};
  };
  std::vector<Merged> merged;
  std::vector<Hanging> hanging;
  std::vector<int> removed_nodes;  ///< ascending
};

}  // namespace nugget::model
