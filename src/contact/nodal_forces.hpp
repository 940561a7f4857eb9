// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/index.hpp"
#include "base/row.hpp"

namespace nugget::contact {

/// The nodes of two bodies, by node; those beyond the end of a list are of neither.
struct TwoBodies {
  std::vector<unsigned char> in_a, in_b;

  /// +1 where all nodes of `first` are of the one and all of `second` of the other body, -1 the other way round; 0
  /// where neither is so, or both.
  double sign(std::span<const int> first, std::span<const int> second) const {
    const auto all = [](std::span<const int> nodes, const std::vector<unsigned char>& in) {
      return std::all_of(nodes.begin(), nodes.end(), [&in](int n) {
        const auto k = at(n);
        return k < in.size() && in[k] != 0;
      });
    };
    return (all(first, in_a) && all(second, in_b) ? 1.0 : 0.0) - (all(first, in_b) && all(second, in_a) ? 1.0 : 0.0);
  }
};

/// The forces of a contact on its nodes, in this cycle and in the one before, and the work that they do. Only nodes
/// that are touched cost anything.
class NodalForces {
 public:
  NodalForces() = default;
  /// `nodes`: all that may be touched, ascending, each once.
  explicit NodalForces(std::vector<int> nodes);
  /// From now on the work at `node` is booked on side `side` (0, where all begin, or 1).
  void set_side(int node, unsigned char side) { side_[index_[node]] = side; }

  const std::vector<int>& nodes() const { return nodes_; }

  /// What was now becomes what was before; now there are no forces.
  void next_cycle();
  void add(int node, const Vec3d& force);
  /// Some of the nodes, ascending, and what adds forces to them.
  class Part {
   public:
    /// Whether nodes from `lowest` to `highest` can be among them.
    bool meets(int lowest, int highest) const { return lowest <= last_ && highest >= first_; }
    /// Nodes of other parts are passed over.
    void add(int node, const Vec3d& force) {
      if (node >= first_ && node <= last_) forces_.add(node, force);
    }

   private:
    friend class NodalForces;
    Part(NodalForces& forces, std::size_t part);
    NodalForces& forces_;
    int first_, last_;
  };
  /// Adds forces side by side: `put` is called for each part of the nodes and adds all forces to it, every time in the
  /// same order, of which the part takes its own. So a node's sum has the same bits for any number of threads.
  void add_by_parts(const std::function<void(Part&)>& put);
  void add_to(std::span<Row> force) const;
  /// Sum over the nodes that are marked (by node; those beyond its end are not) [force].
  Vec3d sum(std::span<const unsigned char> marked) const;
  /// Work on the nodes of each side in the step `dt`: sum of 1/2 (before + now) . v dt, with the velocity `v` in the
  /// middle of the step [energy].
  std::array<double, 2> work(double dt, std::span<const Row> v) const;

  void archive(Archive& a);

 private:
  std::vector<int> nodes_;
  std::vector<int> index_;  // by node: its place in nodes_
  std::vector<unsigned char> side_;
  // By place, now and a cycle before, and which of them are not zero.
  std::vector<Row> now_, before_;
  std::vector<std::vector<int>> touched_now_, touched_before_;  // by part
  std::vector<long> stamp_;                                     // cycle in which a place was last touched
  long cycle_ = 0;
};

}  // namespace nugget::contact
