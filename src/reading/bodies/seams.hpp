// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// For each node of a model the middle of the shells and bricks at it: on which side of a seam its sheet lies.
class AdjoiningElements {
 public:
  explicit AdjoiningElements(const Model& model);
  bool any(Index node) const { return count_[node] > 0; }
  Vec3d middle(Index node) const { return (1.0 / count_[node]) * sum_[node]; }

 private:
  std::vector<Vec3d> sum_;
  std::vector<int> count_;
};

/// The seams of a fillet or butt weld, whose nodes are known. False, and findings, where they are no weld that can be
/// built: a pair whose nodes are not in the set, a node in no pair, a tensile direction that no coordinate system
/// gives, seams that could leave two groups of nodes behind.
bool make_seams(Builder& builder, const BodyCards::Weld& card, const AdjoiningElements& around, RigidWeld& weld);

}  // namespace nugget::reading
