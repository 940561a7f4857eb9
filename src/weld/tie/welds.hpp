// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Whether the elements of `part` are of spot-weld material (MAT_100).
bool of_weld_material(const model::Model& model, Index part);

/// What the material says of a weld as a whole; the weld must be of spot-weld material.
const model::WeldLaw& law_of(const model::Model& model, const Weld& weld);

/// Whether DT2MS scales the weld's mass to |DT2MS TSSFAC|, the step of the run (S. Bala's talk). So it does where
/// sheets hold all its nodes. A weld with a free end has no more mass there than its own: at that step it would run at
/// its very limit, where its energy grows, and is scaled to |DT2MS|, as other elements are. True without DT2MS.
bool scaled_to_the_step_of_the_run(const model::Model& model, const Weld& weld);

/// `beam weld 17`.
std::string name_weld(const Weld& weld);
/// The keyword that defines a weld, with its star.
std::string keyword_of(const Weld& weld);

/// All welds of a model, in the order of Ties::welds, not yet tied: identity, elements; ends and diameter of beams and
/// rigid welds (those of bricks: find_end_faces).
std::vector<Weld> find_welds(const model::Model& model);

/// Length along the axis and, for bricks, the diameter of the circle with its mean cross-section.
struct WeldSize {
  double length = 0.0, diameter = 0.0;
};
WeldSize measure(const Weld& weld, const std::vector<Vec3d>& x);

/// The nodes of an end by the numbering of its elements alone, before anything is tied.
std::vector<Index> nodes_as_numbered(const model::Model& model, const Weld& weld, std::size_t end);

/// Mean position of the nodes of an end face.
Vec3d face_centre(const Weld& weld, int end, const std::vector<Vec3d>& x);

/// The three pairs of opposite faces of brick `element`, the pair of its numbering first; corners of both faces of a
/// pair run in the sense of the axis from the first face to the second.
std::array<std::array<Facet, 2>, 3> opposite_faces(const std::array<Index, 8>& brick);

}  // namespace nugget::weld
