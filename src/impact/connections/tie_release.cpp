// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/tie_release.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "weld/tie/tie_findings.hpp"

namespace nugget::impact {

TieReleases::TieReleases(system::System& system, Welds& welds, TieForces& springs)
    : system_(system),
      welds_(welds),
      springs_(springs),
      ended_(system.ties.ties.size(), 0),
      lost_(system.ties.ties.size(), 0) {
  const auto death = [&](std::size_t t) { return system.model.contacts[system.ties.ties[t].contact].death; };
  for (std::size_t t = 0; t < ended_.size(); ++t)
    if (death(t) < model::forever) death_times_.push_back(t);
  std::stable_sort(death_times_.begin(), death_times_.end(),
                   [&](std::size_t a, std::size_t b) { return death(a) > death(b); });
}

bool TieReleases::update(const system::State& state, std::span<const unsigned char> shell_alive, bool shells_deleted) {
  nodes_released_ = false;
  if (shells_deleted) release_from_deleted_shells(state, shell_alive);
  while (!death_times_.empty()) {
    const weld::Tie& tie = system_.ties.ties[death_times_.back()];
    const model::Contact& contact = system_.model.contacts[tie.contact];
    if (state.time < contact.death) break;
    if (end(death_times_.back()))
      events_.push_back(fmt::format("tie ended  node={} time={:12.5E} cycle={} by DT of {}",
                                    system_.model.nodes.id[tie.node], state.time, state.cycle,
                                    weld::name_contact(contact)));
    death_times_.pop_back();
  }
  if (nodes_released_) system_.transfer_dependent_mass();
  return nodes_released_;
}

/// False if it was ended before.
bool TieReleases::end(std::size_t tie) {
  if (ended_[tie]) return false;
  ended_[tie] = 1;
  if (system_.ties.ties[tie].spring) {
    springs_.release(tie);
  } else {
    system_.release(tie);
    nodes_released_ = true;
  }
  return true;
}

void TieReleases::release_from_deleted_shells(const system::State& state, std::span<const unsigned char> shell_alive) {
  bool lost = false;
  for (std::size_t t = 0; t < ended_.size(); ++t) {
    const weld::Tie& tie = system_.ties.ties[t];
    if (tie.shell == model::none || ended_[t]) continue;
    if (tie.by_area() ? keep_to_living_shells(t, shell_alive) : shell_alive[tie.shell]) continue;
    end(t);
    lost_[t] = 1;
    lost = true;
    events_.push_back(fmt::format("tie ended  node={} time={:12.5E} cycle={} with shell {}",
                                  system_.model.nodes.id[tie.node], state.time, state.cycle,
                                  system_.model.shells.id[tie.shell]));
  }
  if (lost && system_.model.control.weld_of_deleted_shell == 1) delete_welds_without_sheet(state);
}

/// Hands what deleted shells carried of a disc to those that are left of it; false where they are too few.
bool TieReleases::keep_to_living_shells(std::size_t t, std::span<const unsigned char> shell_alive) {
  constexpr double least_share = 0.5;  // of what the disc covered
  const weld::Disc& disc = system_.ties.ties[t].disc;
  const auto alive = [&](const weld::Disc::Piece& piece) { return shell_alive[piece.shell] != 0; };
  if (std::ranges::all_of(disc.pieces, alive)) return true;
  double left = 0.0;
  for (const weld::Disc::Piece& piece : disc.pieces)
    if (alive(piece)) left += piece.sum();
  if (left < least_share) return false;
  std::vector<double> weights(disc.nodes.size(), 0.0);
  for (const weld::Disc::Piece& piece : disc.pieces) {
    if (!alive(piece)) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const model::Index node = system_.model.shells.node[piece.shell][k];
      const auto place = std::lower_bound(disc.nodes.begin(), disc.nodes.end(), node);
      if (piece.weight[k] != 0.0)
        weights[static_cast<std::size_t>(place - disc.nodes.begin())] += piece.weight[k] / left;
    }
  }
  system_.set_disc_weights(t, weights);
  nodes_released_ = true;
  return true;
}

void TieReleases::delete_welds_without_sheet(const system::State& state) {
  std::vector<std::size_t> tie_of(system_.model.nodes.size(), ended_.size());
  for (std::size_t t = 0; t < ended_.size(); ++t) tie_of[system_.ties.ties[t].node] = t;
  for (std::size_t i = 0; i < system_.ties.welds.size(); ++i) {
    const weld::Weld& w = system_.ties.welds[i];
    const auto without = [&](model::Index sheet) {
      int ties = 0, lost = 0;
      for (const weld::Projection& p : w.ends) {
        const std::size_t t = tie_of[p.node];
        if (t == ended_.size() || system_.ties.ties[t].part != sheet) continue;
        ++ties;
        lost += lost_[t];
      }
      return ties > 0 && lost == ties;
    };
    if (without(w.sheets[0]) || without(w.sheets[1])) welds_.delete_without_sheet(i, state);
  }
}

void TieReleases::archive(Archive& a) {
  a(ended_, lost_, death_times_, events_);
  a.built(system_, welds_, springs_, nodes_released_);
}

}  // namespace nugget::impact
