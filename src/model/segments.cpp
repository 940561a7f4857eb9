// SPDX-License-Identifier: Apache-2.0
#include "model/segments.hpp"

#include <algorithm>

namespace nugget::model {

bool bring_triangle_into_form(Segment& n) {
  if (n[3] == none) n[3] = n[2];
  int pairs = 0;
  for (std::size_t i = 0; i < 4; ++i) pairs += n[i] == n[(i + 1) % 4];
  if (pairs == 0) return n[0] != n[2] && n[1] != n[3];
  if (pairs > 1) return false;
  for (int turns = 0; turns < 4 && n[2] != n[3]; ++turns) std::rotate(n.begin(), n.begin() + 1, n.end());
  return n[0] != n[2];
}

Segment sorted_corners(Segment face) {
  std::sort(face.begin(), face.end());
  // Which corner a triangle repeats is no property of the face.
  for (std::size_t i = 1; i < 3; ++i)
    if (face[i - 1] == face[i]) {
      face[i] = face[3];
      std::sort(face.begin(), face.end());
    }
  return face;
}

std::vector<Segment> exterior_faces(const Model& model, const std::vector<Index>& solids) {
  static constexpr std::size_t corners[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  struct Face {
    Segment key, face;
    std::size_t order;
  };
  std::vector<Face> faces;
  faces.reserve(6 * solids.size());
  for (const Index e : solids)
    for (const auto& c : corners) {
      const auto& n = model.solids.node[static_cast<std::size_t>(e)];
      Segment face{n[c[0]], n[c[1]], n[c[2]], n[c[3]]};
      if (bring_triangle_into_form(face)) faces.push_back({sorted_corners(face), face, faces.size()});
    }
  std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.key < b.key; });
  std::vector<Face> single;
  for (std::size_t i = 0, next; i < faces.size(); i = next) {
    for (next = i + 1; next < faces.size() && faces[next].key == faces[i].key;) ++next;
    if (next == i + 1) single.push_back(faces[i]);
  }
  std::sort(single.begin(), single.end(), [](const Face& a, const Face& b) { return a.order < b.order; });
  std::vector<Segment> out;
  out.reserve(single.size());
  for (const Face& f : single) out.push_back(f.face);
  return out;
}

}  // namespace nugget::model
