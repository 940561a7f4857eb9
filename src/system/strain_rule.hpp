// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace nugget::system {

/// Which strains of a group's elements are added up for results (STRFLG).
struct StrainRule {
  /// Numbers of an element, xy half the angle:
  ///   shells        xx yy xy yz zx in its frame at the lower face, then at the upper face
  ///   solids        xx yy zz xy yz zx in global axes at its centre
  ///   thick_shells  those of a solid, then the same at the lower and at the upper face
  enum class Of { nothing, shells, solids, thick_shells };
  Of of = Of::nothing;
  double lower = 0.0, upper = 0.0;  ///< natural coordinates of the outermost integration points, here the faces
  bool follows_bubbles = false;     ///< of triangles that bend within as well (ELFORM 17)
  std::vector<double> offset;       ///< of a shell's middle from its nodes [length], by element of the group

  std::size_t numbers() const { return of == Of::nothing ? 0 : of == Of::shells ? 10 : of == Of::solids ? 6 : 18; }
};

}  // namespace nugget::system
