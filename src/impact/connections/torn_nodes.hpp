// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Nodes at one place that move as one until the mesh tears there (*CONSTRAINED_TIED_NODES_FAILURE; model::TiedNodes).
/// In each cycle the elements around such a place have a failure variable each: the mean of their points' effective
/// plastic strain, or with GISSMO damage D. Where their mean, by volume, reaches EPPF, the nodes of those elements that
/// have reached it themselves are free, with their velocity, and their mass of their own; the others stay tied, if they
/// are more than one. Deleted elements do not count. What holds nodes together is a row of the constraint map, exact
/// and without a stiffness.
class TornNodes {
 public:
  /// The system must outlive it.
  explicit TornNodes(system::System& system);

  /// To be called in every cycle, when elements have their stresses. True if nodes were released and masses transferred
  /// again.
  bool update(const system::State& state);

  const std::vector<std::string>& events() const { return events_; }  ///< a line for each place that tears, for run.log

  void archive(Archive& a);

 private:
  struct Element {
    system::System::ElementLocation location;
    double volume;
    bool by_damage;
  };
  struct Place {
    std::vector<int> nodes;                        ///< system nodes that are still tied, the one that leads first
    std::vector<std::vector<std::size_t>> around;  ///< by such a node: in elements_
    void archive(Archive& a);
  };
  double value_of(const Element& element, const system::State& state) const;
  void find_values(const system::State& state);
  std::vector<std::size_t> places_beyond() const;
  void gather_values(const std::vector<std::size_t>& places);
  bool tear(std::size_t place, const system::State& state);

  system::System& system_;
  std::vector<Element> elements_;
  std::vector<Place> places_;
  std::vector<double> value_;  ///< by element, in this cycle; below 0: deleted, or not known here
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
