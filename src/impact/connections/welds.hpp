// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "impact/connections/brick_joints.hpp"
#include "impact/connections/stack_joints.hpp"
#include "impact/connections/weld_work.hpp"
#include "system/parcel.hpp"
#include "system/system.hpp"
#include "weld/failure/brick_section.hpp"
#include "weld/failure/failure.hpp"

namespace nugget::impact {

/// The welds while the model moves: takes their resultants in every cycle, asks their histories whether they fail, and
/// removes the elements of those that did. Indices are those of Ties::welds. Of several ranks the one that computes a
/// weld's elements looks at it, and passes on when it fails (docs/decisions/0119).
class Welds {
 public:
  /// The system must outlive it. Findings: what a weld lacks for the failure function that its material asks for.
  Welds(system::System& system, Findings& findings);

  /// To be called once a cycle, before nodes move: the joints of stacks and of welds of bricks.
  void open_joints(system::State& state) {
    joints_.meet(state);
    stacks_.flow(state);
    joints_.slide(state);
  }
  /// Whether joints share out motions with the forces of each cycle.
  bool joints_need_each_cycle() const { return !joints_.empty() || !stacks_.empty(); }
  /// To be called once a cycle, after the forces of the elements.
  void update(const system::State& state);

  /// Deletes weld i, if it has not failed, because the shells at one of its ends are deleted (SPOTDEL = 1).
  void delete_without_sheet(std::size_t i, const system::State& state);

  std::size_t size() const { return histories_.size(); }
  /// What happened to weld i; null where a weld has no history (deleted by SPOTSTP, rigid).
  const weld::History* history(std::size_t i) const { return histories_[i].get(); }
  /// The work of its forces on its sheets; nothing of a weld without a history.
  const WeldWork& work(std::size_t i) const { return works_[i]; }
  /// Work and failure values over time begin anew: the run begins after a dynamic relaxation.
  void reset_work();
  /// Over several ranks: finds the lengths of its own, before others hear of them.
  void measure(const system::State& state);
  /// Length of weld i now; after it has failed, of what is left between its ends [length].
  double length(std::size_t i, const system::State& state) const;
  /// Of a weld of bricks as it is loaded now, not filtered; null for others and for those without a history.
  const weld::BrickSection::Load* brick_load(std::size_t i) const { return bricks_[i] ? &bricks_[i]->load : nullptr; }
  int failed() const { return failed_; }
  const std::vector<std::string>& events() const { return events_; }  ///< failures, a line each, for run.log

  /// See Components::elements_read: joints of bricks and of stacks act wherever the nodes of their welds are moved.
  template <class Visit>
  void elements_read(const Visit& visit) const {
    for (const std::size_t i : with_joints_of_each_cycle())
      for (const system::System::ElementLocation& one : locations(i)) visit(one);
  }
  /// See Components::elements_of_one_rank.
  template <class Visit>
  void elements_of_one_rank(const Visit& visit) const {
    for (std::size_t i = 0; i < histories_.size(); ++i)
      if (histories_[i] != nullptr) visit(locations(i));
  }
  /// What results show of the welds that a rank has looked at.
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel);

  void archive(Archive& a);

 private:
  /// What a weld of bricks needs beside its history.
  struct Bricks {
    Bricks(const system::System& system, const weld::Weld& weld);
    /// Smallest Jacobian at a corner of a brick over what it was at the start.
    double least_jacobian(const system::System& system, const system::State& state) const;
    void gather(const system::System& system, const system::State& state);
    weld::BrickSection section;
    struct Corner {
      system::System::ElementLocation location;
      int corner;
      std::size_t node;  ///< of the section
    };
    std::vector<Corner> corners;  ///< of all its bricks, those at its ends
    std::vector<int> nodes;       ///< of the section, in the system's order
    std::vector<Vec3d> x, force;  ///< of the section's nodes now
    weld::BrickSection::Load load;
    double area = 0.0;                                       ///< of the cross-section now
    std::vector<std::array<double, 8>> jacobian;             ///< at the start, by brick and corner
    std::vector<system::System::ElementLocation> locations;  ///< of its bricks
    void archive(Archive& a);
  };
  /// What a weld has come to in a cycle.
  struct News {
    std::size_t weld = 0;
    weld::FailureMode mode = weld::FailureMode::intact;  ///< intact: it begins to be damaged
  };
  std::vector<std::size_t> with_joints_of_each_cycle() const;
  std::vector<system::System::ElementLocation> locations(std::size_t i) const;
  system::System::ElementLocation first_location(std::size_t i) const;
  /// Whether this process looks at weld i, which has a history.
  bool looks_at(std::size_t i) const;
  void list_own();
  /// What the welds that this process looks at come to in this cycle, in their order.
  std::vector<News> look_at_own(const system::State& state);
  /// What weld i, which holds, comes to in this cycle; its history goes on.
  void look_at(std::size_t i, const system::State& state, std::vector<News>& news);
  /// From all ranks, in the order of welds.
  std::vector<News> of_all_ranks(std::vector<News> own) const;
  weld::Resultants resultants(std::size_t i, const system::State& state);
  weld::failure::Load load(std::size_t i, const system::State& state);
  /// Calls `with(group, e)` for every element of weld i.
  template <class With>
  void each_element(std::size_t i, const With& with) const;
  void apply_damage(std::size_t i, bool begins);
  /// Why weld i has failed for a reason of its elements; intact: it is not.
  weld::FailureMode element_failure_mode(std::size_t i, const system::State& state) const;
  void remove(std::size_t i);
  void report(std::size_t i, const system::State& state);

  system::System& system_;
  std::vector<std::unique_ptr<weld::History>> histories_;
  std::vector<std::unique_ptr<Bricks>> bricks_;  ///< null for other welds
  std::vector<WeldWork> works_;
  BrickJoints joints_;
  StackJoints stacks_;
  std::vector<double> death_time_;        ///< of *DEFINE_ELEMENT_DEATH; infinite: none [time]
  std::vector<std::size_t> looked_at_;    ///< welds with a history whose elements this process computes
  const system::Share* share_ = nullptr;  ///< when `looked_at_` was listed
  std::vector<double> length_;            ///< over several ranks; not a number before `measure` [length]
  int failed_ = 0;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
