// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/bvh.hpp"
#include "weld/ties.hpp"

namespace nugget::weld {

/// The view of the whole model that the checks of single welds share.
class Inspection {
 public:
  Inspection(const model::Model& model, const Ties& ties);

  const model::Model& model() const { return model_; }

  /// Thicknesses and densities are those of sheet metal in millimetres.
  bool millimetres() const { return millimetres_; }
  /// Thickness of the sheet at an end; nothing if that end is not on one [length].
  std::optional<double> sheet_thickness(const Weld& weld, int end) const;
  /// Side of a square with the area of the shell that an end is tied to [length].
  std::optional<double> element_size(const Weld& weld, int end) const;
  /// Angle between the weld's axis and the normal of the sheet at an end [degrees].
  std::optional<double> angle_to_normal(const Weld& weld, int end) const;
  /// Distance from an end to the free border of its sheet, if not greater than `bound` [length].
  std::optional<double> distance_to_border(const Weld& weld, int end, double bound) const;
  /// The first weld before this one whose centre is within `distance`, or null.
  const Weld* twin(const Weld& weld, double distance) const;

 private:
  struct Edge {
    Index from = none, to = none;
    Index part = none;
  };
  void find_borders();
  Index shell_at(const Weld& weld, int end) const;
  std::array<Vec3d, 4> corners(Index shell) const;
  Vec3d centre(const Weld& weld) const;

  const model::Model& model_;
  const Ties& ties_;
  bool millimetres_ = false;
  std::vector<Index> shell_of_;  // of each node: the first shell at it
  std::vector<Edge> borders_;    // edges that one shell alone has
  BoxTree border_tree_, weld_tree_;
};

}  // namespace nugget::weld
