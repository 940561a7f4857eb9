// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"

// RPBHX of *CONTROL_SPOTWELD_BEAM: clusters of bricks in place of weld beams.
namespace nugget::reading {

using namespace model;

/// Cross-section of a cluster in its s-t plane about the weld's axis; one layer of bricks over the length.
struct ClusterTemplate {
  std::vector<std::array<double, 2>> nodes;  ///< s, t [length]
  std::vector<std::array<int, 4>> quads;     ///< positions in `nodes`, counter-clockwise
};

/// The cross-section of 1, 4 or 8 bricks with `area` (docs/theory/weld.md#bricks-in-place-of-a-beam, the project's
/// own): 1 a square; 4 a regular octagon of four quads that meet in its centre; 8 an O-grid, two quads inside and six
/// around them.
ClusterTemplate cluster_template(int bricks, double area);

/// The model with its weld beams replaced as Control::weld_beams asks; the same model where it asks for nothing. A
/// cluster has the area of its beam and takes its id; nodes and bricks get the next free ids. Parts whose beams are
/// replaced become solid parts: ELFORM 1, and where they name no hourglass control type 6 with QM = 1. Beams of them
/// that stay get a part of their own. What names the beams' nodes or parts in contacts and sets names the new ones too.
/// Everything is said in findings; a beam of no length is an error.
Model with_brick_clusters(Model model, Findings& findings);

}  // namespace nugget::reading
