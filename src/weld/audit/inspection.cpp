// SPDX-License-Identifier: Apache-2.0
#include "weld/audit/inspection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "weld/tie/segment.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

double distance_to_line(const Vec3d& p, const Vec3d& from, const Vec3d& to) {
  const Vec3d side = to - from;
  const double length_squared = dot(side, side);
  const double along = length_squared > 0.0 ? std::clamp(dot(p - from, side) / length_squared, 0.0, 1.0) : 0.0;
  return norm(from + along * side - p);
}

bool share_a_sheet(const std::vector<Index>& a, const std::vector<Index>& b) {
  return std::any_of(a.begin(), a.end(), [&](Index s) { return std::find(b.begin(), b.end(), s) != b.end(); });
}

}  // namespace

Inspection::Inspection(const model::Model& model, const Ties& ties)
    : model_(model),
      ties_(ties),
      units_(model::units_of(model)),
      mesh_(model, ties.x),
      stacks_(ties, model.nodes.size()) {
  find_borders();
  std::vector<Box> boxes;
  for (const Weld& weld : ties.welds) {
    centre_.push_back(0.5 * (face_centre(weld, 0, ties_.x) + face_centre(weld, 1, ties_.x)));
    boxes.push_back({centre_.back(), centre_.back()});
  }
  weld_tree_ = BoxTree(boxes);
}

/// Edges of the welded sheets that occur once in the whole mesh.
void Inspection::find_borders() {
  std::vector<char> welded(model_.parts.size(), 0);
  for (const Weld& weld : ties_.welds)
    for (Index sheet : weld.sheets)
      if (sheet != none) welded[sheet] = 1;
  std::vector<Box> boxes;
  for (Index e = 0; e < static_cast<Index>(model_.shells.size()); ++e) {
    if (!welded[model_.shells.part[e]]) continue;
    for (int k = 0; k < 4; ++k) {
      const auto [a, b] = mesh_.side(e, k);
      if (a == b || !mesh_.is_free(e, k)) continue;
      borders_.push_back({a, b, model_.shells.part[e]});
      boxes.emplace_back().add(ties_.x[a]);
      boxes.back().add(ties_.x[b]);
    }
  }
  border_tree_ = BoxTree(boxes);
}

std::optional<double> Inspection::millimetre() const {
  if (!units_) return std::nullopt;
  return units_->millimetre;
}

std::vector<Index> Inspection::shells_at(const Weld& weld, int end) const {
  constexpr double on_it = 1e-6;  // share of a tie below which a corner of the segment has no part in it
  std::vector<Index> found;
  for (const Index node : weld.face[end]) {
    const auto tied = std::find_if(weld.ends.begin(), weld.ends.end(), [node](const Projection& p) {
      return p.node == node && p.tied && p.projection_case != 0;
    });
    std::vector<Index> carriers{node};
    Index part = weld.sheets[end];
    if (tied != weld.ends.end()) {
      if (tied->tie.shell == none) continue;
      part = tied->tie.part;
      carriers.clear();
      for (std::size_t k = 0; k < 4; ++k)
        if (tied->tie.weight[k] > on_it) carriers.push_back(tied->tie.segment[k]);
      found.push_back(tied->tie.shell);
    }
    if (carriers.empty()) continue;
    for (const Index shell : mesh_.at(carriers.front())) {
      const auto& corner = model_.shells.node[shell];
      const auto has = [&](Index n) { return std::find(corner.begin(), corner.end(), n) != corner.end(); };
      if ((part == none || model_.shells.part[shell] == part) && std::all_of(carriers.begin(), carriers.end(), has))
        found.push_back(shell);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::array<Vec3d, 4> Inspection::corners(Index shell) const {
  const std::array<Index, 4>& n = model_.shells.node[shell];
  return {ties_.x[n[0]], ties_.x[n[1]], ties_.x[n[2]], ties_.x[n[3]]};
}

double Inspection::area(Index shell) const {
  const std::array<Vec3d, 4> k = corners(shell);
  return 0.5 * norm(cross(k[2] - k[0], k[3] - k[1]));
}

std::optional<double> Inspection::sheet_thickness(const Weld& weld, int end) const {
  // 0 or not a number where its section was refused: then there is nothing to measure by.
  std::optional<double> least;
  for (const Index shell : shells_at(weld, end))
    if (const double t = model_.shells.thickness[shell]; t > 0.0) least = std::min(least.value_or(t), t);
  return least;
}

std::optional<std::array<double, 2>> Inspection::thicknesses(const Weld& weld) const {
  const auto t1 = sheet_thickness(weld, 0), t2 = sheet_thickness(weld, 1);
  if (!t1 || !t2) return std::nullopt;
  return std::array<double, 2>{std::min(*t1, *t2), std::max(*t1, *t2)};
}

std::optional<double> Inspection::element_size(const Weld& weld, int end) const {
  const std::vector<Index> shells = shells_at(weld, end);
  if (shells.empty()) return std::nullopt;
  double sum = 0.0;
  for (const Index shell : shells) sum += area(shell);
  return std::sqrt(sum / static_cast<double>(shells.size()));
}

std::optional<double> Inspection::angle_to_normal(const Weld& weld, int end) const {
  const Vec3d axis = face_centre(weld, 1, ties_.x) - face_centre(weld, 0, ties_.x);
  Vec3d mean;
  for (const Index shell : shells_at(weld, end)) {
    const Vec3d n = normal(corners(shell));
    mean += dot(n, axis) < 0.0 ? -1.0 * n : n;
  }
  if (norm(mean) == 0.0 || norm(axis) == 0.0) return std::nullopt;
  return std::atan2(norm(cross(axis, mean)), std::abs(dot(axis, mean))) * 180.0 / std::numbers::pi;
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

std::optional<int> Inspection::flange_width(const Weld& weld, int end, int most) const {
  std::optional<int> least;
  for (const Index shell : shells_at(weld, end))
    if (const auto width = mesh_.flange_width(shell, most)) least = std::min(least.value_or(*width), *width);
  return least;
}

std::optional<double> Inspection::sheet_step(const Weld& weld, int end) const {
  std::optional<double> least;
  for (const Index shell : shells_at(weld, end))
    if (const auto step = step_of(shell)) least = std::min(least.value_or(*step), *step);
  return least;
}

std::optional<double> Inspection::step_of(Index shell) const {
  const model::Part& part = model_.parts[model_.shells.part[shell]];
  if (part.material == none || part.rigid_body != none) return std::nullopt;
  const model::Material& material = model_.materials[part.material];
  const std::array<Vec3d, 4> k = corners(shell);
  const bool triangle = model_.shells.triangle(shell);
  double longest = 0.0;
  for (int i = 0; i < 4; ++i) longest = std::max(longest, norm(k[(i + 1) % 4] - k[i]));
  const double nu = material.poisson();
  const double speed = std::sqrt(material.young() / ((1.0 - nu * nu) * material.density));
  return (triangle ? 2.0 : 1.0) * area(shell) / longest / speed;
}

double Inspection::sheet_mass(const Weld& weld) const {
  double mass = 0.0;
  for (int end = 0; end < 2; ++end) {
    const std::vector<Index> shells = shells_at(weld, end);
    for (const Index shell : shells) {
      const model::Part& part = model_.parts[model_.shells.part[shell]];
      if (part.material == none) continue;
      mass += model_.materials[part.material].density * model_.shells.thickness[shell] * area(shell) /
              static_cast<double>(shells.size());
    }
  }
  return mass;
}

std::optional<double> Inspection::aspect_ratio(const Weld& weld) const {
  if (!weld.of_bricks()) return std::nullopt;
  double longest = 0.0, shortest = Box::infinity;
  for (Index e : weld.elements)
    for (const auto& pair : opposite_faces(model_.solids.node[e]))
      for (const auto& face : pair)
        for (std::size_t k = 0; k < 4; ++k) {
          const double edge = norm(ties_.x[face[(k + 1) % 4]] - ties_.x[face[k]]);
          longest = std::max(longest, edge);
          if (edge > 0.0) shortest = std::min(shortest, edge);
        }
  return longest / shortest;
}

const Weld* Inspection::duplicate(const Weld& weld, double distance) const {
  const auto self = static_cast<int>(number(weld));
  const Vec3d here = centre_[self];
  const auto same_sheets = [&](const Weld& other) {
    return other.sheets == weld.sheets || (other.sheets[0] == weld.sheets[1] && other.sheets[1] == weld.sheets[0]);
  };
  int first = self;
  weld_tree_.overlapping(Box{here, here}.grown(distance), [&](int other) {
    if (other < first && !ties_.welds[other].deleted && same_sheets(ties_.welds[other]) &&
        norm(centre_[other] - here) <= distance)
      first = other;
  });
  return first == self ? nullptr : &ties_.welds[first];
}

Inspection::Neighbour Inspection::neighbour(const Weld& weld, double bound) const {
  const std::size_t self = number(weld);
  const Vec3d here = centre_[self];
  const BoxTree::Nearest nearest = weld_tree_.nearest(here, bound, [&](int other) {
    const bool apart = stacks_.of(other) != stacks_.of(self) && !ties_.welds[other].deleted;
    return apart && share_a_sheet(stacks_.sheets(other), stacks_.sheets(self)) ? norm(centre_[other] - here)
                                                                               : Box::infinity;
  });
  if (nearest.item < 0) return {};
  return {&ties_.welds[nearest.item], nearest.distance};
}

}  // namespace nugget::weld
