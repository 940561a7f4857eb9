// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/model.hpp"

namespace nugget::model {

/// Brings a face whose neighbouring corners coincide (or whose fourth is none) into the form "a triangle repeats its
/// third node", keeping its sense. False where fewer than three different corners are left, or opposite ones coincide.
bool bring_triangle_into_form(Segment& face);

/// The same face seen from the other side.
inline Segment turned_over(const Segment& face) {
  return {face[1], face[0], face[3], face[2]};
}

/// Corners in ascending order: the same for a face seen from both sides.
Segment sorted_corners(Segment face);

/// Faces of a solid, normals outward: of a brick or wedge up to six, of a tetrahedron four triangles, each of which is
/// four triangles if it has ten nodes: one at each corner, which it names first, and one amid them, the last.
std::vector<Segment> faces_of(const Solids& solids, std::size_t solid);

/// Faces of these solids that only one of them has, normals outward.
std::vector<Segment> exterior_faces(const Model& model, const std::vector<Index>& solids);

/// Replaces faces of quadratic tetrahedra that are named by their three corners by their four triangles.
void split_quadratic_faces(const Model& model, std::vector<Segment>& segments);

/// What each corner of a segment takes of the force of a pressure on it: a quarter or a third. On the six-node faces of
/// quadratic tetrahedra the nodes amid the edges take a third of the face's force each and its corners nothing, which
/// the shape functions give for a flat face: a triangle at a corner gives its force to its other two nodes. Splits
/// `segments` as split_quadratic_faces does.
std::vector<CornerShares> share_pressure(const Model& model, std::vector<Segment>& segments);

}  // namespace nugget::model
