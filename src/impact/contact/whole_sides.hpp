// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "model/model.hpp"

namespace nugget::impact {

/// The surface of shells on whose sides nodes hang (*CONSTRAINED_ADAPTIVITY), in pieces that have these nodes at their
/// corners: what is one stretch of surface shares nodes throughout, and a contact knows it by these.
class WholeSides {
 public:
  /// A quadrilateral, or a triangle that repeats its third node.
  using Corners = std::array<model::Index, 4>;

  explicit WholeSides(const model::Model& model);

  /// The shell itself, or where its sides have hanging nodes the triangles between these and its corners that are least
  /// slender, in the shell's sense. `x`: by node of the model [length].
  std::vector<Corners> pieces(const Corners& shell, const std::vector<Vec3d>& x) const;

 private:
  using Side = std::pair<model::Index, model::Index>;
  static Side side(model::Index a, model::Index b) { return {std::min(a, b), std::max(a, b)}; }
  /// Appends the first end of a side and its hanging nodes, from there to the other end.
  void append(model::Index from, model::Index to, const std::vector<Vec3d>& x,
              std::vector<model::Index>& outline) const;

  std::map<Side, std::vector<model::Index>> hanging_;
};

}  // namespace nugget::impact
