// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "impact/conditions/supports.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The longest stable step of bricks, and of shells that may vibrate faster than the formula of their step knows (free
/// ones, thick ones off the mid-surface, thick triangles, slanted ones with ISDO 2), as they are assembled, with all
/// elements that share nodes with them, ties and rigid bodies followed
/// (docs/theory/time_step.md#elements-as-they-are-assembled). V / A_max over the speed of a plane wave is longer than
/// that where bricks have free sides.
///
/// Central differences with viscous forces of the velocity half a step before are stable while no eigenvalue of
/// M^-1 (dt^2 K + 2 dt C) exceeds 4. The largest one comes from the method of Lanczos (J. Res. Nat. Bur. Standards 45,
/// 1950) without a matrix: K and C act through the elements' own kernels, where they are now, free of stress and
/// elastic; M has all masses. What supports hold during the whole run stands still. Contact, springs of ties and joints
/// are left out: their stiffness follows the step. Other shells, beams and tetrahedra away from these are left out,
/// too: their own steps are bounds. Start, order of sums and number of iterations are fixed: the same bits for any
/// number of threads.
class AssembledStep {
 public:
  /// Chooses the elements by the places `x` and lets their groups keep their reference state: before there is any
  /// stress.
  AssembledStep(system::System& system, const Supports& supports, std::span<const Row> x);

  /// No bricks and no such shells.
  bool empty() const { return blocks_.empty(); }
  /// More than a tenth of all shells, so that a look costs some 300 to 400 of their cycles.
  bool sheets() const { return sheets_; }

  struct Limit {
    double step = 0.0;  ///< the longest stable one [time]; infinite where nothing can vibrate
    /// The element with most of the energy of the vibration that grows first; group -1 where `dt` is well below.
    int group = -1;
    std::size_t element = 0;
  };
  /// `dt`: the step that is asked about. Where that is well below it, the limit is right within a few percent only.
  Limit limit(const system::State& state, double dt) const;

 private:
  class Vibration;
  struct Block {
    int group;
    std::size_t block;
    std::size_t first_row;  ///< of the block's slots, among those of all chosen blocks
  };
  void choose_blocks(std::span<const Row> x);
  void link_slots();

  const system::System& system_;
  const Supports& supports_;
  std::vector<Block> blocks_;
  std::vector<int> independent_;  ///< nodes and bodies that the chosen elements move with
  std::vector<int> nodes_;        ///< of the chosen elements; slots of node i: gather_[gather_start_[i]] and so on
  std::vector<std::size_t> gather_start_, gather_;  ///< shifted left by one; the lowest bit: a moment row follows
  std::size_t rows_ = 0;
  bool sheets_ = false;
};

}  // namespace nugget::impact
