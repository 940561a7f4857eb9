// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/row.hpp"
#include "model/model.hpp"
#include "system/state.hpp"

namespace nugget::system {

class System;

/// Calls `body(group, begin, end)` for ranges of the blocks, each a group and a number in it, side by side.
void for_each_block(std::span<const std::pair<int, std::size_t>> blocks,
                    const std::function<void(int, std::size_t, std::size_t)>& body);

/// Cycles between the forces of each element of the model, a power of two; empty: all have theirs in each cycle.
struct ElementPeriods {
  std::vector<std::uint8_t> shells, solids, beams;

  bool on() const { return !shells.empty() || !solids.empty() || !beams.empty(); }
  int of(model::ElementKind kind, model::Index element) const;
  /// Null for kinds that have theirs in each cycle.
  std::vector<std::uint8_t>* of_kind(model::ElementKind kind);
  const std::vector<std::uint8_t>* of_kind(model::ElementKind kind) const;
};

/// The periods of a model whose elements have been computed once, by their stable steps: every so many cycles as the
/// shortest step goes into an element's, with a margin, `ratio` at most. Elements beside one of a shorter period have
/// that too; elements of one weld have the shortest of theirs; elements at rigid welds, rivets and bodies with joints
/// have their forces in each cycle.
ElementPeriods periods_by_step(const System& system, int ratio);

/// Sub-cycling: elements with a long stable step have their forces every 2, 4, 8 ... cycles, all nodes move in each.
/// What an element does to its nodes in a period is one impulse, of its force where the period begins, as long as the
/// period (asynchronous variational integrators: Lew, Marsden, Ortiz, West 2003, here with periods that are multiples
/// of each other); between, the nodes keep the velocity that it gave them. So momentum is kept to round-off, and an
/// element strains by the way that its nodes went in its period. docs/theory/time_step.md#sub-cycling
class Subcycles {
 public:
  Subcycles() = default;
  /// By the periods of the groups of `system`, whose slots are linked.
  explicit Subcycles(const System& system);

  bool on() const { return !levels_.empty(); }
  int period() const { return period_; }
  /// Forces of those elements whose period ends with this cycle, times their periods, into state.f and state.m.
  void internal_force(System& system, State& state);
  /// By node, since the last call or since all elements had their forces.
  std::span<const Row> mean_velocities();
  /// Periods go down to what the steps of the elements allow beside those of period 1.
  void shorten(System& system);
  /// After that, and with the step from now on in `state`: forces of elements whose period has changed are corrected,
  /// so that their impulse is that of half the period before and half the one to come.
  void correct_impulses(System& system, State& state);
  void archive(Archive& a);

 private:
  /// Elements of one period.
  struct Level {
    int period = 1, period_before = 1;
    std::vector<int> groups;
    std::vector<std::pair<int, std::size_t>> blocks;  ///< group, block
    std::vector<int> nodes;                           ///< of its elements
    std::vector<std::size_t> begin;                   ///< of each node's entries, and their end
    std::vector<std::uint32_t> entries;               ///< as NodalSums::of_node has them
    double time = 0.0;                                ///< of way and turn, where its period began
    std::vector<Row> way, turn;                       ///< by node of `nodes`: those of Subcycles there
    void archive(Archive& a);
  };
  void begin_period();
  void add_step(const State& state);
  void compute(System& system, Level& level, State& state);
  /// Adds `factor` times the forces of the level's elements.
  static void gather(const System& system, const Level& level, double factor, std::span<Row> force,
                     std::span<Row> moment);

  std::vector<Level> levels_;    ///< by rising period at the start
  int period_ = 1;               ///< the longest
  double time_ = 0.0;            ///< since all elements had their forces
  std::vector<Row> way_, turn_;  ///< what nodes moved and turned since then
  Rows v_, w_;                   ///< mean velocities and spins in a period
  Level contacts_;               ///< time and ways of `mean_velocities`
};

}  // namespace nugget::system
