// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/tie_ends.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"
#include "weld/tie/tie_findings.hpp"

namespace nugget::impact {

TieEnds::TieEnds(system::System& system, Welds& welds, TieForces& springs)
    : system_(system),
      welds_(welds),
      springs_(springs),
      ended_(system.ties.ties.size(), 0),
      lost_(system.ties.ties.size(), 0) {
  const auto death = [&](std::size_t t) { return system.model.contacts[at(system.ties.ties[t].contact)].death; };
  for (std::size_t t = 0; t < ended_.size(); ++t)
    if (death(t) < model::forever) mortal_.push_back(t);
  std::stable_sort(mortal_.begin(), mortal_.end(), [&](std::size_t a, std::size_t b) { return death(a) > death(b); });
}

bool TieEnds::update(const system::State& state, std::span<const unsigned char> shell_alive, bool shells_died) {
  let_go_ = false;
  if (shells_died) lose_shells(state, shell_alive);
  while (!mortal_.empty()) {
    const weld::Tie& tie = system_.ties.ties[mortal_.back()];
    const model::Contact& contact = system_.model.contacts[at(tie.contact)];
    if (state.time < contact.death) break;
    if (end(mortal_.back()))
      events_.push_back(fmt::format("tie ended  node={} time={:12.5E} cycle={} by DT of {}",
                                    system_.model.nodes.id[at(tie.node)], state.time, state.cycle,
                                    weld::name_contact(contact)));
    mortal_.pop_back();
  }
  if (let_go_) system_.hand_over_mass();
  return let_go_;
}

/// False if it was ended before.
bool TieEnds::end(std::size_t tie) {
  if (ended_[tie]) return false;
  ended_[tie] = 1;
  if (system_.ties.ties[tie].spring) {
    springs_.release(tie);
  } else {
    system_.release(tie);
    let_go_ = true;
  }
  return true;
}

void TieEnds::lose_shells(const system::State& state, std::span<const unsigned char> shell_alive) {
  bool lost = false;
  for (std::size_t t = 0; t < ended_.size(); ++t) {
    const weld::Tie& tie = system_.ties.ties[t];
    if (tie.shell == model::none || shell_alive[at(tie.shell)] || !end(t)) continue;
    lost_[t] = 1;
    lost = true;
    events_.push_back(fmt::format("tie ended  node={} time={:12.5E} cycle={} with shell {}",
                                  system_.model.nodes.id[at(tie.node)], state.time, state.cycle,
                                  system_.model.shells.id[at(tie.shell)]));
  }
  if (lost && system_.model.control.weld_of_deleted_shell == 1) delete_welds_without_sheet(state);
}

void TieEnds::delete_welds_without_sheet(const system::State& state) {
  std::vector<std::size_t> tie_of(system_.model.nodes.size(), ended_.size());
  for (std::size_t t = 0; t < ended_.size(); ++t) tie_of[at(system_.ties.ties[t].node)] = t;
  for (std::size_t i = 0; i < system_.ties.welds.size(); ++i) {
    const weld::Weld& w = system_.ties.welds[i];
    const auto without = [&](model::Index sheet) {
      int ties = 0, lost = 0;
      for (const weld::Projection& p : w.ends) {
        const std::size_t t = tie_of[at(p.node)];
        if (t == ended_.size() || system_.ties.ties[t].part != sheet) continue;
        ++ties;
        lost += lost_[t];
      }
      return ties > 0 && lost == ties;
    };
    if (without(w.sheets[0]) || without(w.sheets[1])) welds_.lose_sheet(i, state);
  }
}

}  // namespace nugget::impact
