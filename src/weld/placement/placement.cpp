// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "model/units.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

constexpr std::size_t fewest = 2, most = 4;

/// As for the ends of a weld beam (docs/decisions/0154), but that nothing is drawn yet.
bool on_two_layers(const SpotSheet& a, const SpotSheet& b) {
  static const double steep = std::cos(30.0 * std::numbers::pi / 180.0);
  const Vec3d line = b.point - a.point;
  const double apart = norm(line);
  const auto runs_across = [&](const Vec3d& normal) { return std::abs(dot(normal, line)) >= steep * apart; };
  return apart >= 0.25 * (a.thickness + b.thickness) && runs_across(a.normal) && runs_across(b.normal);
}

std::string name_point(const SpotPoint& p) {
  return fmt::format("the point ({:.6g}, {:.6g}, {:.6g})", p.x.x, p.x.y, p.x.z);
}

std::string name_sheets(const model::Model& model, const SpotPoint& point, const std::vector<SpotSheet>& sheets) {
  if (sheets.empty()) return "no sheet";
  std::string text;
  for (const SpotSheet& s : sheets)
    text += fmt::format("{}part {} ({:.3g} away)", text.empty() ? "" : ", ", model.parts[s.part].id,
                        norm(s.point - point.x));
  return text;
}

/// Places the points of one list.
class Placing {
 public:
  Placing(const model::Model& model, const Sheets& sheets, const PlacementOptions& options, Findings& findings)
      : model_(model), sheets_(sheets), options_(options), findings_(findings), units_(model::units_of(model)) {}

  std::optional<Spot> spot(const SpotPoint& point) const {
    std::optional<std::vector<SpotSheet>> stack = point.parts.empty() ? found_stack(point) : named_stack(point);
    if (!stack) return std::nullopt;
    Spot spot;
    spot.from = &point;
    spot.sheets = centred(std::move(*stack));
    const Vec3d axis = spot.sheets.back().point - spot.sheets.front().point;
    if (norm(axis) == 0.0)
      return warn(point, "its sheets touch each other there with their mid-surfaces", "move them apart");
    spot.axis = (1.0 / norm(axis)) * axis;
    spot.diameter = diameter(point, spot.sheets);
    if (spot.diameter == 0.0)
      return warn(point, "its diameter is not given, and the units of the model are not recognised",
                  "give the diameter in the list, or --diameter");
    return spot;
  }

 private:
  std::nullopt_t warn(const SpotPoint& point, const std::string& text, const std::string& remedy) const {
    findings_.warning(point.place, {}, name_point(point) + ": " + text + "; not placed", remedy);
    return std::nullopt;
  }

  double diameter(const SpotPoint& point, const std::vector<SpotSheet>& sheets) const {
    if (point.diameter > 0.0) return point.diameter;
    if (options_.diameter > 0.0) return options_.diameter;
    if (!units_) return 0.0;
    double thinnest = sheets.front().thickness;
    for (const SpotSheet& s : sheets) thinnest = std::min(thinnest, s.thickness);
    return 5.0 * std::sqrt(thinnest / units_->millimetre) * units_->millimetre;
  }

  static void sort_along(std::vector<SpotSheet>& sheets, const Vec3d& origin, const Vec3d& normal) {
    std::stable_sort(sheets.begin(), sheets.end(), [&](const SpotSheet& a, const SpotSheet& b) {
      return dot(a.point - origin, normal) < dot(b.point - origin, normal);
    });
  }

  std::optional<std::vector<SpotSheet>> named_stack(const SpotPoint& point) const {
    std::vector<SpotSheet> sheets;
    for (const int id : point.parts) {
      const Index part = model_.part_index(id);
      if (part == none || model_.parts[part].kind != model::ElementKind::shell)
        return warn(point, fmt::format("part {} {}", id, part == none ? "is not in the model" : "has no shells"),
                    "correct the part id");
      const std::vector<SpotSheet> all = sheets_.around(point.x, options_.search_distance);
      // A part that is named again is meant with its next layer.
      auto before = std::count_if(sheets.begin(), sheets.end(), [part](const SpotSheet& s) { return s.part == part; });
      const auto own =
          std::find_if(all.begin(), all.end(), [&](const SpotSheet& s) { return s.part == part && before-- == 0; });
      if (own == all.end()) {
        if (own == all.end() && !sheets.empty() && sheets.back().part == part)
          return warn(point, fmt::format("part {} has no further layer there", id), "name it once a layer");
        std::vector<Index> others;
        for (Index p = 0; p < static_cast<Index>(model_.parts.size()); ++p)
          if (p != part) others.push_back(p);
        return warn(point, fmt::format("part {} is {:.4g} away", id, sheets_.nearest_other(point.x, others).distance),
                    "move the point, or give --reach");
      }
      sheets.push_back(*own);
    }
    if (sheets.size() < fewest || sheets.size() > most)
      return warn(point, fmt::format("{} sheets are named, expected two to four", sheets.size()),
                  "name two to four parts");
    sort_along(sheets, point.x, sheets.front().normal);
    return sheets;
  }

  /// The sheets that lie one upon the other around the closest one.
  std::optional<std::vector<SpotSheet>> found_stack(const SpotPoint& point) const {
    const double parallel = std::cos(30.0 * std::numbers::pi / 180.0);
    std::vector<SpotSheet> sheets = sheets_.around(point.x, options_.search_distance);
    if (sheets.empty()) return too_few(point, {});
    const auto distance = [&](const SpotSheet& s) { return norm(s.point - point.x); };
    const auto closer = [&](const SpotSheet& a, const SpotSheet& b) { return distance(a) < distance(b); };
    const SpotSheet first = *std::min_element(sheets.begin(), sheets.end(), closer);
    std::erase_if(sheets, [&](const SpotSheet& s) { return std::abs(dot(s.normal, first.normal)) < parallel; });
    sort_along(sheets, point.x, first.normal);
    const auto apart = [&](std::size_t i) {
      return dot(sheets[i].point - sheets[i - 1].point, first.normal) > sheets[i].thickness + sheets[i - 1].thickness;
    };
    auto begin = static_cast<std::size_t>(std::min_element(sheets.begin(), sheets.end(), closer) - sheets.begin());
    std::size_t end = begin + 1;
    while (begin > 0 && !apart(begin)) --begin;
    while (end < sheets.size() && !apart(end)) ++end;
    std::vector<SpotSheet> stack(sheets.begin() + static_cast<std::ptrdiff_t>(begin),
                                 sheets.begin() + static_cast<std::ptrdiff_t>(end));
    if (stack.size() < fewest) return too_few(point, stack);
    if (stack.size() > most)
      return warn(point, fmt::format("{} sheets: {}", stack.size(), name_sheets(model_, point, stack)),
                  "name the parts that are welded");
    return stack;
  }

  std::nullopt_t too_few(const SpotPoint& point, const std::vector<SpotSheet>& found) const {
    std::vector<Index> known;
    known.reserve(found.size());
    for (const SpotSheet& s : found) known.push_back(s.part);
    const Sheets::Near next = sheets_.nearest_other(point.x, known);
    std::string text = "found " + name_sheets(model_, point, found) + ", expected two to four sheets";
    if (next.part != none)
      text += fmt::format("; the next is part {}, {:.4g} away", model_.parts[next.part].id, next.distance);
    return warn(point, text, "move the point, or give --reach or the parts");
  }

  /// The same sheets with their points above each other: the feet of the middle of the stack.
  std::vector<SpotSheet> centred(std::vector<SpotSheet> stack) const {
    Vec3d middle;
    for (const SpotSheet& s : stack) middle += (1.0 / static_cast<double>(stack.size())) * s.point;
    for (SpotSheet& s : stack)
      if (const auto foot = sheets_.closest_of_layer(middle, s, 2.0 * norm(s.point - middle) + s.thickness)) s = *foot;
    return stack;
  }

  const model::Model& model_;
  const Sheets& sheets_;
  const PlacementOptions& options_;
  Findings& findings_;
  std::optional<model::Units> units_;
};

/// The longer of a quadrilateral's two middle lines, the longest side of a triangle; of equal ones the first.
Vec3d longer_way(const Corners& x, bool triangle) {
  const std::array<Vec3d, 3> ways{triangle ? x[1] - x[0] : 0.5 * (x[1] + x[2] - x[0] - x[3]),
                                  triangle ? x[2] - x[1] : 0.5 * (x[2] + x[3] - x[0] - x[1]),
                                  triangle ? x[0] - x[2] : Vec3d{}};
  const Vec3d* longest = &ways[0];
  constexpr double clearly = 1.0 + 1e-9;
  for (const Vec3d& way : ways)
    if (norm(way) > clearly * norm(*longest)) longest = &way;
  return *longest;
}

}  // namespace

Sheets::Sheets(const model::Model& model) : model_(model) {
  std::vector<Box> boxes(model.shells.size());
  for (std::size_t e = 0; e < boxes.size(); ++e) {
    for (const Index n : model.shells.node[e]) boxes[e].add(model.nodes.x[n]);
    thickest_ = std::max(thickest_, model.shells.thickness[e]);
  }
  tree_ = BoxTree(boxes);
}

Corners Sheets::corners(Index shell) const {
  const std::array<Index, 4>& n = model_.shells.node[shell];
  const std::vector<Vec3d>& x = model_.nodes.x;
  return {x[n[0]], x[n[1]], x[n[2]], x[n[3]]};
}

Foot Sheets::foot(Index shell, const Vec3d& x) const {
  return project(corners(shell), model_.shells.triangle(shell), x);
}

SpotSheet Sheets::sheet(Index shell, const Foot& foot) const {
  const Corners x = corners(shell);
  return {model_.shells.part[shell], foot.point, normal(x), model_.shells.thickness[shell],
          longer_way(x, model_.shells.triangle(shell))};
}

std::optional<SpotSheet> Sheets::at(const BoxTree::Nearest& nearest, const Vec3d& x) const {
  if (nearest.item < 0) return std::nullopt;
  const Foot at = foot(nearest.item, x);
  if (!at.over) return std::nullopt;
  return sheet(nearest.item, at);
}

std::optional<SpotSheet> Sheets::closest(const Vec3d& x, Index part, double bound) const {
  const auto distance = [&](int e) { return model_.shells.part[e] == part ? foot(e, x).distance : Box::infinity; };
  return at(tree_.nearest(x, bound, distance), x);
}

std::optional<SpotSheet> Sheets::closest_of_layer(const Vec3d& x, const SpotSheet& place, double bound) const {
  const auto distance = [&](int e) {
    if (model_.shells.part[e] != place.part) return Box::infinity;
    const Foot own = foot(e, x);
    return on_two_layers(place, sheet(e, own)) ? Box::infinity : own.distance;
  };
  return at(tree_.nearest(x, bound, distance), x);
}

std::vector<SpotSheet> Sheets::around(const Vec3d& x, double search_distance) const {
  std::map<Index, std::vector<std::pair<double, Index>>> of_parts;  // distance and shell
  tree_.overlapping(Box{x, x}.grown(search_distance > 0.0 ? search_distance : 3.0 * thickest_), [&](int e) {
    const double bound = search_distance > 0.0 ? search_distance : 3.0 * model_.shells.thickness[e];
    const Foot at = foot(e, x);
    if (at.over && at.gap <= bound) of_parts[model_.shells.part[e]].emplace_back(at.gap, e);
  });
  std::vector<SpotSheet> sheets;
  for (auto& [part, shells] : of_parts) {
    std::sort(shells.begin(), shells.end());
    const std::size_t first = sheets.size();
    for (const auto& [gap, shell] : shells) {
      const SpotSheet found = sheet(shell, foot(shell, x));
      const bool new_layer = std::all_of(sheets.begin() + static_cast<std::ptrdiff_t>(first), sheets.end(),
                                         [&](const SpotSheet& known) { return on_two_layers(known, found); });
      if (new_layer) sheets.push_back(found);
    }
  }
  return sheets;
}

Sheets::Near Sheets::nearest_other(const Vec3d& x, const std::vector<Index>& known) const {
  const BoxTree::Nearest nearest = tree_.nearest(x, Box::infinity, [&](int e) {
    const bool other = std::find(known.begin(), known.end(), model_.shells.part[e]) == known.end();
    return other ? foot(e, x).distance : Box::infinity;
  });
  if (nearest.item < 0) return {};
  return {model_.shells.part[nearest.item], nearest.distance};
}

std::vector<Spot> place(const model::Model& model, const Sheets& sheets, const std::vector<SpotPoint>& points,
                        const PlacementOptions& options, Findings& findings) {
  const Placing placing(model, sheets, options, findings);
  std::vector<Spot> spots;
  for (const SpotPoint& point : points)
    if (std::optional<Spot> spot = placing.spot(point)) spots.push_back(std::move(*spot));
  if (spots.empty() && !points.empty())
    findings.error({points.front().place.file, 0, 0}, {}, "no point of the list found its sheets",
                   "see whether list and model have the same units and the same origin");
  return spots;
}

}  // namespace nugget::weld
