// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "impact/connections/tie_forces.hpp"
#include "impact/connections/welds.hpp"

namespace nugget::impact {

/// Ends ties during the run: at the death time DT of their contact, and when the shell that carries the segment is
/// deleted; of a tie by area, when more than half of what the disc covers is. The node is released then: it keeps its
/// velocity and takes its mass back. With SPOTDEL = 1 a weld whose ties to one of its sheets are all lost in this way
/// is deleted.
class TieReleases {
 public:
  /// All must outlive it.
  TieReleases(system::System& system, Welds& welds, TieForces& springs);

  /// To be called in every cycle. `shell_alive`: by model shell; `shells_deleted`: some of them since the last call.
  /// True if nodes were released and masses transferred again.
  bool update(const system::State& state, std::span<const unsigned char> shell_alive, bool shells_deleted);
  const std::vector<std::string>& events() const { return events_; }  ///< a line each, for run.log

  void archive(Archive& a);

 private:
  bool end(std::size_t tie);
  void release_from_deleted_shells(const system::State& state, std::span<const unsigned char> shell_alive);
  bool keep_to_living_shells(std::size_t tie, std::span<const unsigned char> shell_alive);
  void delete_welds_without_sheet(const system::State& state);

  system::System& system_;
  Welds& welds_;
  TieForces& springs_;
  std::vector<char> ended_, lost_;        // by tie; lost: with its shell
  std::vector<std::size_t> death_times_;  // ties with a death time, the earliest last
  bool nodes_released_ = false;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
