// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/tie_release.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "weld/tie/disc.hpp"
#include "weld/tie/tie_findings.hpp"

namespace nugget::impact {

TieReleases::TieReleases(system::System& system, Welds& welds, TieForces& springs)
    : system_(system),
      welds_(welds),
      springs_(springs),
      ended_(system.ties.ties.size(), 0),
      lost_(system.ties.ties.size(), 0),
      shares_(system.bodies.empty() ? 0 : system.ties.ties.size()),
      centre_moved_(system.bodies.size()),
      arms_to_move_(system.bodies.size()) {
  for (std::size_t t = 0; t < shares_.size(); ++t) find_shares(t);
  find_bricks();
  const auto death = [&](std::size_t t) { return system.model.contacts[system.ties.ties[t].contact].death; };
  for (std::size_t t = 0; t < ended_.size(); ++t)
    if (death(t) < model::forever) death_times_.push_back(t);
  std::stable_sort(death_times_.begin(), death_times_.end(),
                   [&](std::size_t a, std::size_t b) { return death(a) > death(b); });
}

void TieReleases::find_bricks() {
  const model::Model& model = system_.model;
  std::multimap<model::Index, std::size_t> ties_at;  // by the first node of their segment
  for (std::size_t t = 0; t < ended_.size(); ++t) {
    const weld::Tie& tie = system_.ties.ties[t];
    if (tie.shell == model::none && tie.part != model::none && model.parts[tie.part].kind == model::ElementKind::solid)
      ties_at.emplace(tie.segment[0], t);
  }
  for (std::size_t e = 0; !ties_at.empty() && e < model.solids.size(); ++e) {
    const auto nodes = model.solids.nodes(e);
    const auto has = [&](model::Index n) { return std::ranges::find(nodes, n) != nodes.end(); };
    for (const model::Index corner : std::set(nodes.begin(), nodes.end()))
      for (auto [at_corner, last] = ties_at.equal_range(corner); at_corner != last; ++at_corner)
        if (std::ranges::all_of(system_.ties.ties[at_corner->second].segment, has))
          bricks_[at_corner->second].push_back(static_cast<model::Index>(e));
  }
}

void TieReleases::find_shares(std::size_t tie) {
  shares_[tie].clear();
  const int node = system_.node_of[system_.ties.ties[tie].node];
  if (system_.ties.ties[tie].spring || !system_.map.dependent(node)) return;
  find_shares(tie, node, system_.own_mass[at(node)], system_.own_inertia()[at(node)]);
}

/// As ConstraintMap::transfer_mass hands mass on, from node to node until it comes to a body.
void TieReleases::find_shares(std::size_t tie, int node, double mass, double inertia) {
  const double turning = system_.map.rotations(node) ? inertia : 0.0;
  for (const system::ConstraintMap::Term& term : std::as_const(system_.map).terms(node)) {
    if (at(term.node) >= system_.nodes) {
      const std::size_t body = at(term.node) - system_.nodes;
      const auto [arm, is_new] = arms_.try_emplace(node);
      if (is_new) arm->second = system_.ties.x.at(at(system_.model_node[at(node)])) - system_.bodies[body].center0;
      shares_[tie].push_back({body, arm->second, mass, inertia});
    } else if (system_.map.dependent(term.node)) {
      find_shares(tie, term.node, term.weight * mass, term.weight * (turning + mass * dot(term.arm, term.arm)));
    }
  }
}

void TieReleases::take_shares(std::size_t tie, double sign, system::State& state) {
  if (shares_.empty()) return;
  for (const Share& share : shares_[tie]) {
    system::RigidBody& body = system_.bodies[share.body];
    const double mass = sign * share.mass, left = body.mass - mass;
    // *PART_INERTIA says what a body weighs, whatever is tied to it.
    if (system_.model.rigid_bodies[at(body.source)].given || !(left > 0.0)) continue;
    const Vec3d arm = share.arm - centre_moved_[share.body], shift = (-mass / left) * arm;
    system::add_point(body.inertia, -mass, -sign * share.inertia, arm);
    system::add_point(body.inertia, -left, 0.0, shift);  // about the centre of what is left
    body.mass = left;
    const auto c = at(body.node);
    const Vec3d moved = body.axes.global(shift), spin = vec(state.w[c]);
    add(state.x[c], moved);
    add(state.v[c], cross(spin, moved));
    body.angular_momentum = body.momentum(spin, body.axes);
    centre_moved_[share.body] += shift;
    arms_to_move_[share.body] += moved;
  }
}

void TieReleases::move_arms() {
  const auto zero = [](const Vec3d& a) { return a.x == 0.0 && a.y == 0.0 && a.z == 0.0; };
  if (std::ranges::all_of(arms_to_move_, zero)) return;
  for (std::size_t k = 0; k < system_.all_nodes(); ++k) {
    if (!system_.map.dependent(static_cast<int>(k))) continue;
    for (system::ConstraintMap::Term& term : system_.map.terms(static_cast<int>(k)))
      if (at(term.node) >= system_.nodes && at(term.node) - system_.nodes < arms_to_move_.size())
        term.arm -= arms_to_move_[at(term.node) - system_.nodes];
  }
  std::ranges::fill(arms_to_move_, Vec3d{});
}

bool TieReleases::update(system::State& state, std::span<const unsigned char> alive, bool shells_deleted,
                         bool any_deleted) {
  nodes_released_ = false;
  if (shells_deleted) release_from_deleted_shells(state, alive);
  if (any_deleted && !bricks_.empty()) release_from_deleted_bricks(state, alive.subspan(system_.model.shells.size()));
  while (!death_times_.empty()) {
    const weld::Tie& tie = system_.ties.ties[death_times_.back()];
    const model::Contact& contact = system_.model.contacts[tie.contact];
    if (state.time < contact.death) break;
    if (end(death_times_.back(), state))
      events_.push_back(fmt::format("tie ended  node={} time={:12.5E} cycle={} by DT of {}",
                                    system_.model.nodes.id[tie.node], state.time, state.cycle,
                                    weld::name_contact(contact)));
    death_times_.pop_back();
  }
  if (nodes_released_) {
    move_arms();
    system_.transfer_dependent_mass();
  }
  return nodes_released_;
}

/// False if it was ended before.
bool TieReleases::end(std::size_t tie, system::State& state) {
  if (ended_[tie]) return false;
  ended_[tie] = 1;
  if (system_.ties.ties[tie].spring) {
    springs_.release(tie);
  } else {
    take_shares(tie, 1.0, state);
    system_.release(tie);
    nodes_released_ = true;
  }
  return true;
}

/// A tie ends with what carried it.
void TieReleases::lose(std::size_t tie, std::string_view with, system::State& state) {
  end(tie, state);
  lost_[tie] = 1;
  events_.push_back(fmt::format("tie ended  node={} time={:12.5E} cycle={} with {}",
                                system_.model.nodes.id[system_.ties.ties[tie].node], state.time, state.cycle, with));
}

void TieReleases::release_from_deleted_bricks(system::State& state, std::span<const unsigned char> brick_alive) {
  const model::Model& model = system_.model;
  const auto is_left = [brick_alive](model::Index brick) { return brick_alive[brick] != 0; };
  bool lost = false;
  for (const auto& [t, bricks] : bricks_) {
    if (ended_[t] || std::ranges::any_of(bricks, is_left)) continue;
    lose(t, fmt::format("brick {}", model.solids.id[bricks.front()]), state);
    lost = true;
  }
  if (lost && model.control.weld_of_deleted_shell == 1) delete_welds_without_sheet(state);
}

void TieReleases::release_from_deleted_shells(system::State& state, std::span<const unsigned char> shell_alive) {
  bool lost = false;
  for (std::size_t t = 0; t < ended_.size(); ++t) {
    const weld::Tie& tie = system_.ties.ties[t];
    if (tie.shell == model::none || ended_[t]) continue;
    if (tie.by_area() ? keep_to_living_shells(t, shell_alive, state) : shell_alive[tie.shell]) continue;
    lose(t, fmt::format("shell {}", system_.model.shells.id[tie.shell]), state);
    lost = true;
  }
  if (lost && system_.model.control.weld_of_deleted_shell == 1) delete_welds_without_sheet(state);
}

/// Hands what deleted shells carried of a disc to those that are left of it; false where they are too few.
bool TieReleases::keep_to_living_shells(std::size_t t, std::span<const unsigned char> shell_alive,
                                        system::State& state) {
  const weld::Disc& disc = system_.ties.ties[t].disc;
  const auto absent = [&](model::Index shell) { return shell_alive[shell] == 0; };
  if (std::ranges::none_of(disc.pieces, absent, &weld::Disc::Piece::shell)) return true;
  const std::vector<double> weights = weld::weights_without(system_.model, disc, absent);
  if (weights.empty()) return false;
  take_shares(t, 1.0, state);
  system_.set_disc_weights(t, weights);
  if (!shares_.empty()) find_shares(t);
  take_shares(t, -1.0, state);
  nodes_released_ = true;
  return true;
}

void TieReleases::delete_welds_without_sheet(const system::State& state) {
  std::vector<std::size_t> tie_of(system_.model.nodes.size(), ended_.size());
  for (std::size_t t = 0; t < ended_.size(); ++t) tie_of[system_.ties.ties[t].node] = t;
  for (std::size_t i = 0; i < system_.ties.welds.size(); ++i) {
    const weld::Weld& w = system_.ties.welds[i];
    // By end: both may be on two layers of one part.
    const auto without = [&](std::size_t end) {
      int ties = 0, lost = 0;
      for (const model::Index node : w.face[end]) {
        const std::size_t t = tie_of[node];
        if (t == ended_.size() || system_.ties.ties[t].part != w.sheets[end]) continue;
        ++ties;
        lost += lost_[t];
      }
      return ties > 0 && lost == ties;
    };
    if (without(0) || without(1)) welds_.delete_without_sheet(i, state);
  }
}

void TieReleases::archive(Archive& a) {
  a(ended_, lost_, death_times_, events_, shares_, centre_moved_);
  a.built(system_, welds_, springs_, bricks_, arms_, nodes_released_, arms_to_move_);
}

}  // namespace nugget::impact
