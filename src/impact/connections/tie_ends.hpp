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
/// deleted. The node is let go then: it keeps its velocity and takes its mass back. With SPOTDEL = 1 a weld whose ties
/// to one of its sheets are all lost in this way is deleted.
class TieEnds {
 public:
  /// All must outlive it.
  TieEnds(system::System& system, Welds& welds, TieForces& springs);

  /// To be called in every cycle. `shell_alive`: by model shell; `shells_died`: some of them since the last call. True
  /// if nodes were let go and masses handed over anew.
  bool update(const system::State& state, std::span<const unsigned char> shell_alive, bool shells_died);
  const std::vector<std::string>& events() const { return events_; }  ///< a line each, for run.log

  void archive(Archive& a);

 private:
  bool end(std::size_t tie);
  void lose_shells(const system::State& state, std::span<const unsigned char> shell_alive);
  void delete_welds_without_sheet(const system::State& state);

  system::System& system_;
  Welds& welds_;
  TieForces& springs_;
  std::vector<char> ended_, lost_;   // by tie; lost: with its shell
  std::vector<std::size_t> mortal_;  // ties with a death time, the first to die last
  bool let_go_ = false;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
