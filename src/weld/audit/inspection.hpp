// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/bvh.hpp"
#include "model/units.hpp"
#include "weld/audit/stacks.hpp"
#include "weld/tie/sheet_mesh.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// The view of the whole model that the checks of single welds share.
class Inspection {
 public:
  Inspection(const model::Model& model, const Ties& ties);

  const model::Model& model() const { return model_; }
  /// Node coordinates after projection [length].
  const std::vector<Vec3d>& x() const { return ties_.x; }

  /// A millimetre in units of the model; nothing if the units are not known [length].
  std::optional<double> millimetre() const;
  /// Thickness of the sheet at an end, the least of the shells there; nothing if that end is not on one, or its section
  /// was refused [length].
  std::optional<double> sheet_thickness(const Weld& weld, int end) const;
  /// Thinnest (first) and thickest of the sheets at the two ends; nothing unless both are known [length].
  std::optional<std::array<double, 2>> thicknesses(const Weld& weld) const;
  /// Side of a square with the mean area of the shells that an end is tied to [length].
  std::optional<double> element_size(const Weld& weld, int end) const;
  /// Angle between the weld's axis and the mean normal of the sheet at an end [degrees].
  std::optional<double> angle_to_normal(const Weld& weld, int end) const;
  /// Distance from an end to the free border of its sheet, if not greater than `bound` [length].
  std::optional<double> distance_to_border(const Weld& weld, int end, double bound) const;
  /// Elements across the flange that an end is tied to, if there are at most `most`; see SheetMesh::flange_width.
  std::optional<int> flange_width(const Weld& weld, int end, int most) const;
  /// Largest time step of the shell at an end: (its area over its longest side) over the wave speed of a plate, as
  /// ISDO = 0 has it [time].
  std::optional<double> sheet_step(const Weld& weld, int end) const;
  /// Mean mass of the shells that an end is tied to, of both ends together [mass].
  double sheet_mass(const Weld& weld) const;

  /// Longest over shortest edge of a weld's brick; nothing for other welds.
  std::optional<double> aspect_ratio(const Weld& weld) const;

  /// The first weld before this one between the same sheets whose centre is within `distance`, or null.
  const Weld* duplicate(const Weld& weld, double distance) const;
  /// The first weld of the stack of this weld.
  std::size_t spot(const Weld& weld) const { return stacks_.of(number(weld)); }
  /// The parts that the stack of this weld joins.
  const std::vector<Index>& stack(const Weld& weld) const { return stacks_.sheets(number(weld)); }
  struct Neighbour {
    const Weld* weld = nullptr;
    double distance = 0.0;  ///< of the centres [length]
  };
  /// The closest weld of another stack that has a sheet in common with this one, within `bound`, or null.
  Neighbour neighbour(const Weld& weld, double bound) const;

 private:
  struct Edge {
    Index from = none, to = none;
    Index part = none;
  };
  void find_borders();
  std::size_t number(const Weld& weld) const { return static_cast<std::size_t>(&weld - ties_.welds.data()); }
  /// The shells that hold an end: of each node of its face the one below, or all about the side or the node of the mesh
  /// that it stands on. So nothing depends on where a brick begins, or on the numbers of shells. Ascending.
  std::vector<Index> shells_at(const Weld& weld, int end) const;
  std::array<Vec3d, 4> corners(Index shell) const;
  double area(Index shell) const;
  std::optional<double> step_of(Index shell) const;  ///< nothing of rigid shells [time]

  const model::Model& model_;
  const Ties& ties_;
  std::optional<model::Units> units_;
  SheetMesh mesh_;
  Stacks stacks_;
  std::vector<Edge> borders_;  // edges that one shell alone has
  std::vector<Vec3d> centre_;  // of each weld
  BoxTree border_tree_, weld_tree_;
};

}  // namespace nugget::weld
