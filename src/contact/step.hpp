// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/row.hpp"

namespace nugget::system {
class Share;
}  // namespace nugget::system

namespace nugget::contact {

/// Over several ranks each follows nodes of its own: who follows which, and the rows behind those of a Step, into which
/// those of other nodes are put when they are asked for.
struct SharedNodes {
  const system::Share& share;
  std::span<Row> x, v;
};

/// Mass by node that contacts go by: of a node that follows others what it has of its own, not what it has handed over.
class NodalMasses {
 public:
  NodalMasses() = default;
  /// `masses`: of all nodes.
  NodalMasses(std::span<const double> masses) : mass_(masses) {}     // NOLINT(google-explicit-constructor): these
  NodalMasses(const std::vector<double>& masses) : mass_(masses) {}  // NOLINT(google-explicit-constructor)
  /// `dependent`: by node, whether it follows others; then its mass is that of `own`.
  NodalMasses(std::span<const double> masses, std::span<const unsigned char> dependent, std::span<const double> own)
      : mass_(masses), own_(own), dependent_(dependent) {}
  double operator[](int node) const {
    const auto k = static_cast<std::size_t>(node);
    return !dependent_.empty() && dependent_[k] != 0 ? own_[k] : mass_[k];
  }
  void ask_for(int node) const { __builtin_prefetch(&mass_[static_cast<std::size_t>(node)]); }

 private:
  std::span<const double> mass_, own_;
  std::span<const unsigned char> dependent_;
};

/// The step at whose end contact forces are found. Spans are by node, but `element_alive` (see Segment::element; empty:
/// all are active).
struct Step {
  double time = 0.0;  ///< at its end
  double dt = 0.0;    ///< 0 at the start: all overlaps are initial ones then
  /// The step that bounds stiffnesses: the stable one of the structure. `dt` itself may be shorter, cut to meet the end
  /// of the run; stiffnesses of m/dt^2 would jump there. 0: no bound.
  double stable_dt = 0.0;
  double longest = 0.0;    ///< the longest of these so far
  std::span<const Row> x;  ///< positions at its end [length]
  std::span<const Row> v;  ///< velocities in its middle
  NodalMasses mass;
  std::span<const unsigned char> element_alive;
  bool faces_are_whole = false;         ///< no shell and no brick is deleted
  const SharedNodes* shared = nullptr;  ///< null: one process
  bool off = false;                     ///< *SENSOR_CONTROL has turned the contact off
};

}  // namespace nugget::contact
