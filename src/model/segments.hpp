// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/model.hpp"

namespace nugget::model {

/// Brings a face whose neighbouring corners coincide (or whose fourth is none) into the form "a triangle repeats its
/// third node", keeping its sense. False where fewer than three different corners are left, or opposite ones coincide.
bool bring_triangle_into_form(Segment& face);

/// Corners in ascending order: the same for a face seen from both sides.
Segment sorted_corners(Segment face);

/// Faces of these solids that only one of them has, normals outward.
std::vector<Segment> exterior_faces(const Model& model, const std::vector<Index>& solids);

}  // namespace nugget::model
