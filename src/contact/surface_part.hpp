// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/ranks.hpp"
#include "contact/surface_contact.hpp"

namespace nugget::contact {

/// Part `part` of `parts` of a surface at the places `x`: as many tracked nodes as the other parts have, those of one
/// region, the segments that are within reach of these or of the bricks behind them, and all segments that share a
/// node with one of those. Overlaps of its tracked nodes are those of the whole surface, also after nodes have moved by
/// up to `room` [length]. Tracked nodes and segments stand in the order of the whole; glue's faces stay out.
SurfaceContactSetup part_of(const SurfaceContactSetup& whole, std::span<const Row> x, int part, int parts, double room);

/// The ranks among which a surface is divided while its overlaps are removed, each with its part of it.
struct DividedSurface {
  Ranks& ranks;
  double room = 0.0;  ///< how far nodes may move before it is divided anew [length]
  /// The part of this rank with the nodes at these places.
  std::function<SurfaceContactSetup(std::span<const Row>)> part;
};

}  // namespace nugget::contact
