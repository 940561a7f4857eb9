// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/row.hpp"
#include "base/vec3.hpp"

namespace nugget::system {

/// The one sparse linear map v = T q of all constraints. A row says how a dependent node moves with independent ones,
///     v_d = sum_k w_k (v_k + omega_k x a_k),      omega_d = sum_k w_k omega_k  (where rotations are coupled),
/// with weights w_k that add up to 1 and arms a_k carried around by the independent node. A tied weld node has the four
/// nodes of its segment (weights N_i, no arms); a node of a rigid body has one term, the body's virtual node, with
/// weight 1. `follow` applies T to velocities, `collect` applies its transpose to forces (virtual power: f . T q = T^t
/// f . q).
class ConstraintMap {
 public:
  struct Term {
    int node;
    double weight;
    Vec3d arm;
  };

  /// Adds a row. Chains (a term's node is itself dependent) are resolved by `close`.
  void add(int dependent, bool rotations, std::span<const Term> terms);
  /// Replaces dependent nodes in terms by what they depend on, and merges equal nodes. `nodes`: number of nodes,
  /// virtual ones included. Returns the dependent nodes of rows that depend on themselves in a circle (an input error).
  std::vector<int> close(int nodes);

  bool dependent(int node) const { return row_of_[static_cast<std::size_t>(node)] >= 0; }
  /// The terms of a dependent node's row.
  std::span<const Term> terms(int node) const;
  std::span<Term> terms(int node);
  bool rotations(int node) const {
    return rows_[static_cast<std::size_t>(row_of_[static_cast<std::size_t>(node)])].rotations;
  }
  std::size_t size() const { return rows_.size(); }

  /// v, w := T (v, w) for the step dt; arms are turned to their place at the end of the step, so that x + dt v keeps a
  /// rigid body rigid (the velocity is the chord of the arc).
  void follow(double dt, std::span<Row> v, std::span<Row> w);
  /// f, m of dependent nodes go to the independent ones, and are zero afterwards.
  void collect(std::span<Row> f, std::span<Row> m) const;

 private:
  struct RowHead {
    int dependent;
    bool rotations;
    int begin, end;
  };
  std::vector<RowHead> rows_;
  std::vector<Term> terms_;
  std::vector<int> row_of_;
};

/// Rodrigues' formula: `a` turned by the rotation vector `phi`.
Vec3d turned(const Vec3d& a, const Vec3d& phi);

}  // namespace nugget::system
