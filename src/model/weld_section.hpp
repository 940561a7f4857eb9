// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace nugget::model {

/// A round weld section cut into quadrilaterals, for welds made of bricks.
struct WeldSection {
  std::vector<std::array<double, 2>> point;  ///< s and t, the weld's axis in the origin [length]
  std::vector<std::array<int, 4>> quad;      ///< points of each, counter-clockwise seen against the axis
};

/// Templates of 1, 4, 8 or 16 quadrilaterals with this area [length^2]
/// (docs/theory/weld.md#bricks-in-place-of-a-beam): a square; an octagon in four that meet in its centre; a rectangle
/// in two with six around it up to a hexagon; one in six with ten around it up to a decagon. Any other count gives an
/// empty section.
WeldSection weld_section(int quads, double area);

}  // namespace nugget::model
