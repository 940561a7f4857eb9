// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/row.hpp"
#include "base/vec3.hpp"
#include "system/parcel.hpp"

namespace nugget::system {

/// The one sparse linear map v = T q of all constraints. A row says how a dependent node moves with other nodes,
///     v_d = sum_k w_k (v_k + omega_k x a_k),      omega_d = sum_k w_k omega_k  (where rotations are coupled),
/// with weights w_k that add up to 1 and arms a_k carried around by the nodes that they belong to. A tied weld node has
/// the four nodes of its segment (weights N_i); a node of a rigid body has one term, the body's virtual node, with
/// weight 1. Nodes that a row names may be dependent themselves: rows are worked through in the order of their
/// dependence. `apply_to_velocities` applies T to velocities, `transfer_forces` its transpose to forces (virtual power:
/// f . T q = T^t f . q).
///
/// Where nodes carry no rotation that could hold a moment, the dependent node's spin comes from the translations of the
/// corners c of its segment (docs/theory/ties.md#twist). With r_c the arms from their centre,
///     whole:  omega_d = J^-1 sum_c r_c x v_c,  J = sum_c (|r_c|^2 1 - r_c r_c^t),  and v_d gets omega_d x a besides;
///     twist:  only the component along the segment's normal n, on a flat segment sum_c n . (r_c x v_c) / sum_c
///     |r_c|^2;
///             the other two as above.
/// Transposed, a moment becomes forces (J^-1 M) x r_c on the corners, with sum_c f_c = 0 and sum_c r_c x f_c = M: a
/// twist M_n of a flat segment gives M_n n x r_c / sum_c |r_c|^2.
class ConstraintMap {
 public:
  struct Term {
    int node;
    double weight;
    Vec3d arm;
  };
  /// A node whose translation turns a dependent node.
  struct Corner {
    int node;
    double weight;  ///< in sums over corners; of a segment 1
    Vec3d arm;      ///< `add`: the node's place; afterwards from the corners' centre
  };
  enum class Turn { twist, whole };

  /// Adds a row whose spin comes from its terms' nodes.
  void add(int dependent, bool rotations, std::span<const Term> terms);
  /// Adds a row turned by the corners of a segment (in order; three or four for a twist). `arm`: from the point that
  /// the weights interpolate to the dependent node, carried by its own spin; zero for a twist, whose terms have arms.
  void add(int dependent, bool rotations, std::span<const Term> terms, Turn turn, std::span<const Corner> corners,
           const Vec3d& arm = {});
  /// To be called once when all rows are there: puts them in order. `nodes`: number of nodes, virtual ones included.
  /// Returns the dependent nodes of rows that depend on themselves in a circle (an input error).
  std::vector<int> sort_rows(int nodes);
  /// Gives a row of turn `whole` with a corner for each term other weights, adding up to 1, while the model moves: the
  /// dependent node stays where it is, its arm begins at the new centre.
  void set_weights(int dependent, std::span<const double> weights);
  /// Moves a dependent node that follows by a spin of corners against what it follows; its arm ends where it stands.
  void slide(int dependent, const Vec3d& by) { rows_[row_of_[dependent]].arm += by; }
  /// Releases a dependent node; from then on it is independent.
  void remove(int node);

  bool dependent(int node) const { return row_of_[node] >= 0; }
  /// The terms of a dependent node's row; their nodes may be dependent.
  std::span<const Term> terms(int node) const;
  std::span<Term> terms(int node);
  /// Calls `visit(dependent, other)` with each dependent node and each node that its row names.
  template <class Visit>
  void each_row(const Visit& visit) const {
    for (const RowHead& row : rows_) {
      if (row.removed) continue;
      for (int i = row.begin; i < row.end; ++i) visit(row.dependent, terms_[i].node);
      for (int i = row.first_corner; i < row.end_corner; ++i) visit(row.dependent, corners_[i].node);
    }
  }
  /// From now on applies only the rows of dependent nodes for which `followed` is true: other processes apply the rest.
  void keep_to(const std::function<bool(int dependent)>& followed);
  /// Takes that back: a copy of the map is to apply all rows, with places and arms that have come from others.
  void follow_all();
  /// Arms of the rows of dependent nodes for which `chosen` is true, to or from another process.
  void carry(const std::function<bool(int dependent)>& chosen, Parcel& parcel);
  bool rotations(int node) const { return rows_[row_of_[node]].rotations; }
  std::size_t size() const { return rows_.size(); }

  /// v, w := T (v, w) for the step dt; arms are turned to their place at the end of the step, so that x + dt v keeps a
  /// rigid body rigid (the velocity is the chord of the arc). Corners' arms count as they are in the middle of the
  /// step.
  void apply_to_velocities(double dt, std::span<Row> v, std::span<Row> w);
  /// f, m of dependent nodes go to the independent ones, and are zero afterwards.
  void transfer_forces(std::span<Row> f, std::span<Row> m) const;
  /// Mass and rotary inertia of dependent nodes go to the nodes of their terms by their weights (inertia with what the
  /// arm adds), and are zero afterwards, but for rows on nodes from `bodies` on: these dependent nodes keep theirs,
  /// from which the body's own follow.
  void transfer_mass(std::span<double> mass, std::span<double> inertia, int bodies) const;

  /// How a dependent node moves with independent ones only, (v, omega)_d = sum of 6 x 6 blocks, row by row, times
  /// (v, omega)_k: T as the dynamics of small motions (T^t K T) wants it. Ascending by node.
  struct Block {
    int node;
    std::array<std::array<double, 6>, 6> of{};
  };
  std::vector<Block> blocks(int dependent) const;
  void archive(Archive& a);

 private:
  struct RowHead {
    int dependent;
    bool rotations;
    int begin, end;                        // terms
    int first_corner = 0, end_corner = 0;  // none: its spin comes from the terms' nodes
    Turn turn = Turn::twist;
    Vec3d arm{};
    bool removed = false;
  };
  struct Spin;
  Spin spin(const RowHead& row, std::span<const Corner> corners) const;
  std::span<const Corner> corners(const RowHead& row) const;
  void apply_to_velocities(RowHead& row, double dt, std::span<Row> v, std::span<Row> w);
  void transfer_forces(const RowHead& row, std::span<Row> f, std::span<Row> m) const;

  std::vector<RowHead> rows_;
  std::vector<Term> terms_;
  std::vector<Corner> corners_;
  std::vector<int> row_of_;
  std::vector<int> applied_;         // rows that this process applies, in order: all of them, but after keep_to
  std::vector<std::size_t> levels_;  // of these: those of a level depend on nodes of lower levels only; where each ends
  std::vector<std::size_t> all_levels_;  // of all rows
};

/// Rodrigues' formula: `a` turned by the rotation vector `phi`.
Vec3d turned(const Vec3d& a, const Vec3d& phi);

}  // namespace nugget::system
