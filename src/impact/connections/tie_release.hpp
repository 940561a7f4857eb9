// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "impact/connections/tie_forces.hpp"
#include "impact/connections/welds.hpp"

namespace nugget::impact {

/// Ends ties during the run: at the death time DT of their contact, and when the shell that carries the segment, or the
/// brick that has it as its face, is deleted; of a tie by area, when more than half of what the disc covers is. The
/// node is released then: it keeps its velocity and takes its mass back, also from rigid bodies, whose centre and
/// inertia are then those of what is left. With SPOTDEL = 1 a weld whose ties to one of its sheets are all lost in this
/// way is deleted.
class TieReleases {
 public:
  /// All must outlive it.
  TieReleases(system::System& system, Welds& welds, TieForces& springs);

  /// To be called in every cycle. `alive`: shells, then bricks, in the order of the model; `shells_deleted` and
  /// `any_deleted`: some of them, or of all elements, since the last call. True if nodes were released and masses
  /// transferred again.
  bool update(system::State& state, std::span<const unsigned char> alive, bool shells_deleted, bool any_deleted);
  const std::vector<std::string>& events() const { return events_; }  ///< a line each, for run.log

  void archive(Archive& a);

 private:
  /// What a tied node has given of its mass to a rigid body.
  struct Share {
    std::size_t body = 0;
    Vec3d arm;  ///< from the centre that the body had at the start, in the body's axes
    double mass = 0.0, inertia = 0.0;
  };
  void find_shares(std::size_t tie);
  void find_shares(std::size_t tie, int node, double mass, double inertia);
  /// Takes the shares of a tie out of the bodies, or with `sign` -1 puts them in.
  void take_shares(std::size_t tie, double sign, system::State& state);
  /// Brings the arms of the bodies' nodes to the centres that have moved.
  void move_arms();
  void find_bricks();
  bool end(std::size_t tie, system::State& state);
  void lose(std::size_t tie, std::string_view with, system::State& state);
  void release_from_deleted_bricks(system::State& state, std::span<const unsigned char> brick_alive);
  void release_from_deleted_shells(system::State& state, std::span<const unsigned char> shell_alive);
  bool keep_to_living_shells(std::size_t tie, std::span<const unsigned char> shell_alive, system::State& state);
  void delete_welds_without_sheet(const system::State& state);

  system::System& system_;
  Welds& welds_;
  TieForces& springs_;
  std::vector<char> ended_, lost_;                           // by tie; lost: with its shell or brick
  std::map<std::size_t, std::vector<model::Index>> bricks_;  // that have the segment of a tie as their face
  std::vector<std::size_t> death_times_;                     // ties with a death time, the earliest last
  std::vector<std::vector<Share>> shares_;                   // by tie
  std::map<int, Vec3d> arms_;        // by node of a body that has such shares, all met at the start: Share::arm
  std::vector<Vec3d> centre_moved_;  // by body, since the start, in its axes
  std::vector<Vec3d> arms_to_move_;  // by body, what of that its nodes' arms do not know yet, in global axes
  bool nodes_released_ = false;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
