// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "impact/simulation/snapshot.hpp"
#include "output/secforc.hpp"

namespace nugget::impact {

/// Forces through the model's cross sections.
class CrossSections {
 public:
  explicit CrossSections(const system::System& system);

  /// Sums over the section's nodes of what the elements on one side of them need as outer force there, which is what
  /// the structure on the other side puts on these elements; moments about the centroid of the area, or about the mean
  /// of the nodes where no element shows an area.
  output::SecforcState state(const Snapshot& now) const;

 private:
  /// The force that an element of the section has at one of its corners.
  struct Corner {
    system::System::ElementLocation location;
    int corner;
    std::size_t node;
  };
  struct Section {
    const model::CrossSection* card;
    std::vector<Corner> corners;
  };
  struct Area {
    double size = 0.0;
    Vec3d centroid;
  };
  Area area(const Section& section, const Snapshot& now) const;
  Frame3d axes(const model::CrossSection& card, const Snapshot& now) const;

  const system::System& system_;
  std::vector<Section> sections_;
};

}  // namespace nugget::impact
