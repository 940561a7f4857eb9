// SPDX-License-Identifier: Apache-2.0
#include "report/skin.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace nugget::report {
namespace {

constexpr std::array<std::array<std::size_t, 4>, 6> faces_of_brick{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};  // seen from outside

/// Of a tetrahedron, whose fourth node stands for the fifth to eighth too.
constexpr std::array<std::array<std::size_t, 4>, 4> faces_of_tetrahedron{
    {{0, 2, 1, 1}, {0, 1, 3, 3}, {1, 2, 3, 3}, {2, 0, 3, 3}}};

bool is_tetrahedron(const std::array<int, 8>& nodes) {
  return std::all_of(nodes.begin() + 4, nodes.end(), [&](int node) { return node == nodes[3]; });
}

/// A face with its nodes in ascending order, by which two bricks find each other.
struct Face {
  std::array<int, 4> key{};
  std::array<int, 4> nodes{};
  int solid = 0;
};

/// The nodes of a face without repetition, a triangle's third one twice. False where it has no area, as in wedges and
/// tetrahedra.
bool make_face(const std::array<int, 8>& nodes, const std::array<std::size_t, 4>& corners, Face& face) {
  std::size_t count = 0;
  for (const std::size_t corner : corners) {
    const auto end = face.nodes.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::find(face.nodes.begin(), end, nodes[corner]) == end) face.nodes[count++] = nodes[corner];
  }
  if (count < 3) return false;
  if (count == 3) face.nodes[3] = face.nodes[2];
  face.key = face.nodes;
  std::sort(face.key.begin(), face.key.end());
  return true;
}

std::vector<Face> sorted_faces(const output::D3plotGeometry& g) {
  std::vector<Face> faces;
  faces.reserve(6 * g.solids.size());
  for (std::size_t e = 0; e < g.solids.size(); ++e) {
    const std::array<int, 8>& nodes = g.solids[e].nodes;
    const auto add = [&](const std::array<std::size_t, 4>& corners) {
      Face face;
      face.solid = static_cast<int>(e);
      if (make_face(nodes, corners, face)) faces.push_back(face);
    };
    if (is_tetrahedron(nodes))
      std::for_each(faces_of_tetrahedron.begin(), faces_of_tetrahedron.end(), add);
    else
      std::for_each(faces_of_brick.begin(), faces_of_brick.end(), add);
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return a.key != b.key ? a.key < b.key : a.solid < b.solid; });
  return faces;
}

}  // namespace

std::vector<Facet> facets(const output::D3plotGeometry& g, const std::vector<int>& shell_end,
                          const std::vector<int>& solid_end, int states) {
  std::vector<Facet> seen;
  for (std::size_t e = 0; e < g.shells.size(); ++e)
    seen.push_back({g.shells[e].nodes, g.shells[e].part, static_cast<int>(e), true, 0, shell_end[e]});
  const std::vector<Face> faces = sorted_faces(g);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Face& face = faces[i];
    const Face* behind = nullptr;
    if (i > 0 && faces[i - 1].key == face.key) behind = &faces[i - 1];
    if (i + 1 < faces.size() && faces[i + 1].key == face.key) behind = &faces[i + 1];
    const int from = behind ? solid_end[at(behind->solid)] : 0, until = solid_end[at(face.solid)];
    if (from < std::min(until, states))
      seen.push_back({face.nodes, g.solids[at(face.solid)].part, face.solid, false, from, until});
  }
  return seen;
}

}  // namespace nugget::report
