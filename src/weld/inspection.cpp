// SPDX-License-Identifier: Apache-2.0
#include "weld/inspection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "weld/segment.hpp"
#include "weld/welds.hpp"

namespace nugget::weld {
namespace {

/// Sheets of 0.3 to 10 length units and of a density between that of magnesium in t/mm^3 and that of lead in g/mm^3 are
/// in millimetres; metres, centimetres and inches all fall outside one of the two.
bool in_millimetres(const model::Model& model) {
  if (model.shells.size() == 0) return false;
  const std::vector<double>& t = model.shells.thickness;
  const double mean = std::accumulate(t.begin(), t.end(), 0.0) / static_cast<double>(t.size());
  const Index material = model.parts[model.shells.part.front()].material;
  const double density = material == none ? 0.0 : model.materials[material].density;
  return mean >= 0.3 && mean <= 10.0 && density >= 1e-9 && density <= 2e-2;
}

double distance_to_line(const Vec3d& p, const Vec3d& from, const Vec3d& to) {
  const Vec3d side = to - from;
  const double length_squared = dot(side, side);
  const double along = length_squared > 0.0 ? std::clamp(dot(p - from, side) / length_squared, 0.0, 1.0) : 0.0;
  return norm(from + along * side - p);
}

}  // namespace

Inspection::Inspection(const model::Model& model, const Ties& ties)
    : model_(model), ties_(ties), millimetres_(in_millimetres(model)), shell_of_(model.nodes.size(), none) {
  for (std::size_t e = 0; e < model.shells.size(); ++e)
    for (Index n : model.shells.node[e])
      if (shell_of_[n] == none) shell_of_[n] = static_cast<Index>(e);
  find_borders();
  std::vector<Box> boxes;
  for (const Weld& weld : ties.welds) boxes.push_back({centre(weld), centre(weld)});
  weld_tree_ = BoxTree(boxes);
}

/// Edges of the sheets that occur once in the whole mesh.
void Inspection::find_borders() {
  std::vector<char> welded(model_.parts.size(), 0);
  for (const Weld& weld : ties_.welds)
    for (Index sheet : weld.sheets)
      if (sheet != none) welded[sheet] = 1;
  std::vector<Edge> edges;
  for (std::size_t e = 0; e < model_.shells.size(); ++e)
    for (int k = 0; k < 4; ++k) {
      const Index a = model_.shells.node[e][k], b = model_.shells.node[e][(k + 1) % 4];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), model_.shells.part[e]});
    }
  const auto ends = [](const Edge& edge) { return std::pair(edge.from, edge.to); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return ends(a) < ends(b); });
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && ends(edges[next]) == ends(edges[i])) ++next;
    if (next == i + 1 && welded[edges[i].part]) borders_.push_back(edges[i]);
  }
  std::vector<Box> boxes(borders_.size());
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    boxes[i].add(ties_.x[borders_[i].from]);
    boxes[i].add(ties_.x[borders_[i].to]);
  }
  border_tree_ = BoxTree(boxes);
}

Index Inspection::shell_at(const Weld& weld, int end) const {
  const Index node = weld.face[end][0];
  if (node == none) return none;
  for (const Projection& p : weld.ends)
    if (p.node == node && p.tied && p.kase != 0) return p.tie.shell;
  return shell_of_[node];
}

std::array<Vec3d, 4> Inspection::corners(Index shell) const {
  const std::array<Index, 4>& n = model_.shells.node[shell];
  return {ties_.x[n[0]], ties_.x[n[1]], ties_.x[n[2]], ties_.x[n[3]]};
}

Vec3d Inspection::centre(const Weld& weld) const {
  return 0.5 * (face_centre(weld, 0, ties_.x) + face_centre(weld, 1, ties_.x));
}

std::optional<double> Inspection::sheet_thickness(const Weld& weld, int end) const {
  const Index shell = shell_at(weld, end);
  if (shell == none) return std::nullopt;
  return model_.shells.thickness[shell];
}

std::optional<double> Inspection::element_size(const Weld& weld, int end) const {
  const Index shell = shell_at(weld, end);
  if (shell == none) return std::nullopt;
  const std::array<Vec3d, 4> k = corners(shell);
  return std::sqrt(0.5 * norm(cross(k[2] - k[0], k[3] - k[1])));
}

std::optional<double> Inspection::angle_to_normal(const Weld& weld, int end) const {
  const Index shell = shell_at(weld, end);
  const Vec3d axis = face_centre(weld, 1, ties_.x) - face_centre(weld, 0, ties_.x);
  if (shell == none || norm(axis) == 0.0) return std::nullopt;
  const Vec3d n = normal(corners(shell));
  return std::atan2(norm(cross(axis, n)), std::abs(dot(axis, n))) * 180.0 / std::numbers::pi;
}

std::optional<double> Inspection::distance_to_border(const Weld& weld, int end, double bound) const {
  const Index sheet = weld.sheets[end];
  if (sheet == none) return std::nullopt;
  const Vec3d p = face_centre(weld, end, ties_.x);
  const BoxTree::Nearest nearest = border_tree_.nearest(p, bound, [&](int i) {
    const Edge& edge = borders_[i];
    return edge.part == sheet ? distance_to_line(p, ties_.x[edge.from], ties_.x[edge.to]) : Box::infinity;
  });
  if (nearest.item < 0) return std::nullopt;
  return nearest.distance;
}

const Weld* Inspection::twin(const Weld& weld, double distance) const {
  const auto self = static_cast<int>(&weld - ties_.welds.data());
  const Vec3d here = centre(weld);
  int first = self;
  weld_tree_.overlapping(Box{here, here}.grown(distance), [&](int other) {
    if (other < first && !ties_.welds[other].deleted && norm(centre(ties_.welds[other]) - here) <= distance)
      first = other;
  });
  return first == self ? nullptr : &ties_.welds[first];
}

}  // namespace nugget::weld
