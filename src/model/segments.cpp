// SPDX-License-Identifier: Apache-2.0
#include "model/segments.hpp"

#include <algorithm>
#include <map>

#include "base/index.hpp"
#include "kernel/element/quadratic_tetrahedron.hpp"

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

double distance_to(const BlastLoad& load, const Segment& segment, const std::vector<Vec3d>& x) {
  const int corners = segment[3] == segment[2] ? 3 : 4;
  Vec3d middle;
  for (std::size_t a = 0; a < at(corners); ++a) middle += (1.0 / corners) * x[segment[a]];
  return norm(load.centre - middle);
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

namespace {

constexpr std::size_t tetrahedron_face[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// The four triangles of a face of a quadratic tetrahedron.
std::array<Segment, 4> triangles_of(const std::array<Index, 10>& n, const std::size_t (&face)[3]) {
  const auto amid = [&](std::size_t i, std::size_t j) {
    for (std::size_t k = 0; k < 6; ++k) {
      const auto from = at(kernel::quadratic_tetrahedron_edge[k][0]), to = at(kernel::quadratic_tetrahedron_edge[k][1]);
      if ((from == i && to == j) || (from == j && to == i)) return n[4 + k];
    }
    return none;
  };
  const Index a = amid(face[0], face[1]), b = amid(face[1], face[2]), c = amid(face[2], face[0]);
  return {{{n[face[0]], a, c, c}, {n[face[1]], b, a, a}, {n[face[2]], c, b, b}, {a, b, c, c}}};
}

}  // namespace

std::vector<Segment> faces_of(const Solids& solids, std::size_t e) {
  static constexpr std::size_t brick_face[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                   {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::vector<Segment> faces;
  if (solids.quadratic(e)) {
    for (const auto& face : tetrahedron_face)
      for (const Segment& triangle : triangles_of(solids.ten(e), face)) faces.push_back(triangle);
    return faces;
  }
  const std::array<Index, 8>& n = solids.node[e];
  if (n[3] == n[4])  // N1 N2 N3 N4 N4 N4 N4 N4: as a collapsed brick its bottom would be all four nodes
    for (const auto& f : tetrahedron_face) faces.push_back({n[f[0]], n[f[1]], n[f[2]], n[f[2]]});
  else
    for (const auto& f : brick_face) faces.push_back({n[f[0]], n[f[1]], n[f[2]], n[f[3]]});
  std::erase_if(faces, [](Segment& face) { return !bring_triangle_into_form(face); });
  return faces;
}

namespace {

/// The triangles on faces of quadratic tetrahedra, and the faces by their three corners.
class QuadraticFaces {
 public:
  struct Triangle {
    std::array<Segment, 4> face;
    bool whole, at_corner;
    bool is_corner(Index n) const {
      return std::any_of(face.begin(), face.begin() + 3, [n](const Segment& t) { return t[0] == n; });
    }
  };
  explicit QuadraticFaces(const Solids& solids) {
    for (const std::array<Index, 10>& n : solids.ten_nodes)
      for (const auto& f : tetrahedron_face) {
        const std::array<Segment, 4> face = triangles_of(n, f);
        for (std::size_t t = 0; t < 4; ++t) known_[sorted_corners(face[t])] = {face, false, t < 3};
        known_[sorted_corners({n[f[0]], n[f[1]], n[f[2]], n[f[2]]})] = {face, true, false};
      }
  }
  const Triangle* find(const Segment& s) const {
    const auto it = s[3] == s[2] ? known_.find(sorted_corners(s)) : known_.end();
    return it == known_.end() ? nullptr : &it->second;
  }

 private:
  std::map<Segment, Triangle> known_;
};

}  // namespace

void split_quadratic_faces(const Model& model, std::vector<Segment>& segments) {
  if (model.solids.ten_nodes.empty()) return;
  const QuadraticFaces faces(model.solids);
  std::vector<Segment> split;
  for (const Segment& s : segments) {
    const QuadraticFaces::Triangle* triangle = faces.find(s);
    if (triangle == nullptr || !triangle->whole) {
      split.push_back(s);
      continue;
    }
    const auto at_corner = [&](Index n) {
      return std::find_if(triangle->face.begin(), triangle->face.end(), [n](const Segment& t) { return t[0] == n; });
    };
    // Of two neighbouring corners the first names the node between them second, the second third.
    const bool turned = (*at_corner(s[0]))[1] != (*at_corner(s[1]))[2];
    for (const Segment& t : triangle->face) split.push_back(turned ? Segment{t[0], t[2], t[1], t[1]} : t);
  }
  segments = std::move(split);
}

std::vector<CornerShares> share_pressure(const Model& model, std::vector<Segment>& segments) {
  split_quadratic_faces(model, segments);
  const QuadraticFaces faces(model.solids);
  std::vector<CornerShares> shares;
  shares.reserve(segments.size());
  for (const Segment& s : segments) {
    shares.push_back(s[3] == s[2] ? CornerShares{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.0}
                                  : CornerShares{0.25, 0.25, 0.25, 0.25});
    const QuadraticFaces::Triangle* triangle = faces.find(s);
    if (triangle == nullptr || !triangle->at_corner) continue;
    for (std::size_t a = 0; a < 3; ++a) shares.back()[a] = triangle->is_corner(s[a]) ? 0.0 : 0.5;
  }
  return shares;
}

std::vector<Segment> exterior_faces(const Model& model, const std::vector<Index>& solids) {
  struct Face {
    Segment key, face;
    std::size_t order;
  };
  std::vector<Face> faces;
  faces.reserve(6 * solids.size());
  for (const Index e : solids)
    for (const Segment& face : faces_of(model.solids, at(e)))
      faces.push_back({sorted_corners(face), face, faces.size()});
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
