// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "weld/tie/reference.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Aims the nodes of bricks that stand for weld beams (RPBHX of *CONTROL_SPOTWELD_BEAM) at the sheets of their ends.
/// The end faces lie across the beam: where it leans on its sheets, nodes lie off the sheet that their end is meant
/// for, and some nearer to the other one. The two ends are meant for the two different parts to which their nodes are
/// closest together; no node may then be tied to the part of the other end, and over a sheet it is in reach as the end
/// of the beam would be, with the beam's width for its thickness. Bricks whose nodes are not all `tracked` (ascending)
/// stay as they are. `x`: places of the nodes [length].
void aim_clusters(const model::Model& model, const Reference& reference, const std::vector<Weld>& welds,
                  const std::vector<Vec3d>& x, std::vector<Tracked>& tracked);

}  // namespace nugget::weld
