// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace nugget::kernel {

inline constexpr int most_fibres = 144;

/// Points of a cross-section: places s, t [length] and areas [length^2].
struct FibreRule {
  int count = 0;
  std::array<double, most_fibres> s{}, t{}, area{};
};

/// A cross-section of points and what they do not say: where its middle is, and how stiff it is in torsion.
struct SectionPoints {
  FibreRule fibres;                       ///< places seen from the nodes
  double torsion_share = 1.0;             ///< torsion constant over the points' polar moment [1]
  double offset_s = 0.0, offset_t = 0.0;  ///< centroid, seen from the nodes [length]
};

}  // namespace nugget::kernel
