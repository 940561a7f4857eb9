// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "system/system.hpp"

namespace nugget::impact {

/// What the elements of each part have at their nodes: kinetic energies and momenta of parts are sums over these, of
/// which there are a quarter as many as corners of shells (docs/decisions/0166). Nodes of bodies whose mass is given
/// are left out.
class PartNodes {
 public:
  /// A node that elements of several parts have, or that has a mass besides them.
  struct Shared {
    int node = 0;
    double mass = 0.0, inertia = 0.0;  ///< of the part's elements there, mass scaling included
  };
  /// Nodes of one part in one row of nodes (system::SumsByRank), rising: those that are its alone, and shared ones.
  struct Piece {
    model::Index part = model::none;
    std::size_t row = 0, begin = 0, end = 0, first_shared = 0, end_shared = 0;
  };
  /// Who sums up the motions of the nodes of a piece.
  enum class Sums { all, own };  ///< this process those of all rows; each rank those of its own

  /// Finds the masses anew where they have changed since, and which nodes have lost all their elements.
  void update(const system::System& system, Sums sums);

  /// By part, and then by row.
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Nodes whose masses, System::own_mass and own_inertia, are those of the part's elements. None of a piece that
  /// another rank sums up.
  std::span<const int> alone(const Piece& piece) const {
    return std::span(alone_).subspan(piece.begin, piece.end - piece.begin);
  }
  std::span<const Shared> shared(const Piece& piece) const {
    return std::span(shared_).subspan(piece.first_shared, piece.end_shared - piece.first_shared);
  }
  /// Whether the mass of a node belongs to a body for which the deck gives it.
  bool is_weightless(std::size_t node) const { return !weightless_.empty() && weightless_[node] != 0; }
  /// Whether a node has lost all its elements. Those that follow others, tied ones and those of rigid bodies, move with
  /// them and count as having elements; so do those with a mass of their own.
  bool has_no_elements(std::size_t node) const { return !has_no_elements_.empty() && has_no_elements_[node] != 0; }

 private:
  void find_weightless(const system::System& system);
  void find_pieces(const system::System& system);
  void find_shared_masses(const system::System& system);
  void find_nodes_without_elements(const system::System& system);

  Sums sums_ = Sums::all;
  std::vector<Piece> pieces_;
  std::vector<int> alone_;
  std::vector<Shared> shared_;
  std::vector<char> weightless_;       ///< by node; empty if none is
  std::vector<char> has_no_elements_;  ///< by node; empty if none has lost all
  int mass_changes_ = -1, deletions_ = -1;
};

}  // namespace nugget::impact
