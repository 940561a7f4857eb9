// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/bvh.hpp"
#include "weld/placement/spot_list.hpp"
#include "weld/tie/segment.hpp"
#include "weld/tie/ties.hpp"

// Where a list of spots meets the sheets of a model.
namespace nugget::weld {

/// One sheet that a spot goes through.
struct SpotSheet {
  Index part = none;
  Vec3d point;             ///< on the surface through the sheet's nodes [length]
  Vec3d normal;            ///< of the segment there
  double thickness = 0.0;  ///< [length]
  Vec3d along;             ///< of the shell there: its longer middle line, a triangle's longest side [length]
};

/// A spot that found its sheets.
struct Spot {
  const SpotPoint* from = nullptr;
  std::vector<SpotSheet> sheets;  ///< two to four, in the order of the stack
  Vec3d axis;                     ///< unit vector from the first to the last
  double diameter = 0.0;          ///< [length]
};

/// The sheets of a model, ready to be searched.
class Sheets {
 public:
  explicit Sheets(const model::Model& model);

  /// The closest point of a part's shells within `bound`; nothing where the part ends before it.
  std::optional<SpotSheet> closest(const Vec3d& x, Index part, double bound) const;
  /// The same of the layer that a place on it is on, where `x` is above or below that place.
  std::optional<SpotSheet> closest_of_layer(const Vec3d& x, const SpotSheet& place, double bound) const;
  /// Of each layer of each part the closest point below or above `x` within `search_distance` of it (0: three
  /// thicknesses of the sheet), by part, the closest first. Two points of one part are on two layers where they are
  /// half the mean thickness apart and more, and the line between them is within 30 degrees of the normals of both.
  std::vector<SpotSheet> around(const Vec3d& x, double search_distance) const;
  struct Near {
    Index part = none;  ///< none: there is no sheet at all
    double distance = 0.0;
  };
  /// The closest sheet that is not among `known`, at whatever distance.
  Near nearest_other(const Vec3d& x, const std::vector<Index>& known) const;

 private:
  Foot foot(Index shell, const Vec3d& x) const;
  SpotSheet sheet(Index shell, const Foot& foot) const;
  Corners corners(Index shell) const;
  std::optional<SpotSheet> at(const BoxTree::Nearest& nearest, const Vec3d& x) const;

  const model::Model& model_;
  double thickest_ = 0.0;
  BoxTree tree_;
};

struct PlacementOptions {
  double search_distance = 0.0;  ///< how far a sheet may be from a point; 0: three of its thicknesses [length]
  double diameter = 0.0;         ///< where the list gives none; 0: 5 sqrt(t) of the thinnest sheet, in mm [length]
};

/// Finds the sheets of each point: the named parts, or the stack of sheets around the closest one. Two sheets of a
/// stack are no further apart than twice the half sum of their thicknesses, and their normals within 30 degrees. A
/// point that finds fewer than two sheets or more than four, or not those that it names, is a warning with distances
/// and is left out; if none is left that is an error.
std::vector<Spot> place(const model::Model& model, const Sheets& sheets, const std::vector<SpotPoint>& points,
                        const PlacementOptions& options, Findings& findings);

}  // namespace nugget::weld
