// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "base/ranks.hpp"

namespace nugget::app {

/// The ranks of an explicit run. The first one reads the command line and calls the others to the run; these read the
/// same command line, and the same deck, and compute their shares in silence.
struct RankTeam {
  Ranks* ranks = nullptr;
  int on_this_machine = 1;                  ///< how many of them
  std::function<void(int load_case)> call;  ///< on the first rank: the others begin to read for this case
  bool called = false;                      ///< on the others
  int load_case = 0;                        ///< on the others: which one
  bool broken = false;                      ///< a rank has left a run that the others are in
};

/// Null in a process of its own.
RankTeam* rank_team();
void set_rank_team(RankTeam* team);

/// Part of a rank in one run: from the call on, through an agreement that all can begin, to the end.
class JoinedRun {
 public:
  /// Does nothing without a team.
  JoinedRun(RankTeam* team, int load_case);
  JoinedRun(const JoinedRun&) = delete;
  JoinedRun& operator=(const JoinedRun&) = delete;
  /// Without an agreement the others learn that there is no run. Left by an exception behind one, the team is broken.
  ~JoinedRun();

  /// What must be the same on all ranks.
  struct Ready {
    bool willing = false;  ///< the deck is read and has no errors
    std::uint64_t deck = 0, program = 0;
    int lanes = 0;
    std::uint64_t restart_file = 0;  ///< its checksum; 0: there is none
  };
  /// Whether the run begins; all get the same answer. `why`: what differs between ranks, if that is the reason.
  bool agree(const Ready& own, std::string& why);
  /// Before that: calls `work` with the ranks where all of them are ready for it, and it is work that they do
  /// together; else with null, to be done by each alone, and then the run does not begin. In a process of its own with
  /// null as well.
  void work_together(const Ready& own, const std::function<void(Ranks*)>& work);
  /// Threads of each rank from here on: what was asked for; else this machine's cores over its ranks, as far as mpirun
  /// has not bound this one to fewer. What to say of it: empty where there are cores enough.
  std::string use_threads(int asked) const;
  /// There is no explicit run: the others wait for what else the first rank does.
  void decline();
  /// Null in a process of its own.
  Ranks* ranks() const { return team_ == nullptr ? nullptr : team_->ranks; }

 private:
  RankTeam* team_;
  bool agreed_ = false, begun_ = false, refused_ = false;
  std::string why_refused_;
  int exceptions_;
};

}  // namespace nugget::app
