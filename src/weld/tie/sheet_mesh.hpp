// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// How the shells of a model are connected: which shell lies across a side, where sheets end, how wide a flange is.
class SheetMesh {
 public:
  /// `x`: node coordinates [length].
  SheetMesh(const model::Model& model, const std::vector<Vec3d>& x);

  /// Shells at a node, ascending.
  std::span<const Index> at(Index node) const {
    return std::span(shells_).subspan(first_[node], first_[node + 1] - first_[node]);
  }
  /// Side k of a shell, from its corner k to the next one.
  std::array<Index, 2> side(Index shell, int k) const {
    return {model_.shells.node[shell][k], model_.shells.node[shell][(k + 1) % 4]};
  }
  /// The other shells that have this side, ascending.
  std::vector<Index> across_side(Index shell, int k) const;
  /// No other shell has this side.
  bool is_free(Index shell, int k) const { return count_across(shell, k) == 0; }

  /// Over how many elements the flange reaches that a quadrilateral lies in: from it, both ways through opposite sides,
  /// up to a free edge, a seam of three and more shells, or a fold of more than 30 degrees; the narrower of its two
  /// directions. Nothing if neither direction ends within `most` elements, or triangles stand in the way.
  std::optional<int> flange_width(Index shell, int most) const;

 private:
  struct Across {
    Index shell = none;
    int side = 0;
  };
  struct Walk {
    int elements = 0;
    bool ended = false;
  };
  int count_across(Index shell, int k) const;
  Across across(Index shell, int k) const;
  Walk walk(Index shell, int k, int most) const;
  bool folded(Index shell, int k, const Across& other) const;
  Vec3d normal_of(Index shell) const;

  const model::Model& model_;
  const std::vector<Vec3d>& x_;
  std::vector<Index> first_, shells_;  // of each node its shells, one after the other
};

}  // namespace nugget::weld
