// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/curve.hpp"
#include "base/finding.hpp"
#include "base/index.hpp"

namespace nugget::model {

/// *DEFINE_HAZ_PROPERTIES: how sheets are softened around welds.
struct HeatZone {
  /// What softens: the columns of its second card.
  enum Weld { bricks, beams, constrained, seam };
  /// A factor over the distance from the closest weld, or over that distance in diameters of the weld.
  struct Factor {
    Curve curve;  ///< end values hold; empty: 1
    bool by_diameter = false;
  };
  int id = 0;
  std::vector<Index> parts;
  std::array<Factor, 4> yield, strain;  ///< by Weld: on the yield stress, on the plastic strain at failure
  Place place;
};

/// *DEFINE_HAZ_TAILOR_WELDED_BLANK: a line of nodes along which sheets are welded edge to edge.
struct WeldSeam {
  int id = 0;
  std::vector<Index> nodes;
  std::vector<Index> parts;  ///< to which it counts; empty: to all that a HeatZone names
};

}  // namespace nugget::model
