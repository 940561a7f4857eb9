// SPDX-License-Identifier: Apache-2.0
#include "system/subcycles.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "system/before_cycle.hpp"
#include "system/system.hpp"

namespace nugget::system {
namespace {

// What is left for resonance with what vibrates beside an element; of bricks more, which as they are assembled may
// vibrate faster than their formula knows (docs/theory/time_step.md#sub-cycling).
constexpr double period_share = 0.9, period_share_of_bricks = 0.7;

Row sum(const Row& a, double s, const Row& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z, 0.0};
}

int power_of_two(double most) {
  int period = 1;
  while (2 * period <= most) period *= 2;
  return period;
}

/// Whether elements at a node have their forces in each cycle whatever their step: nodes of rigid welds, rivets and
/// bodies with joints, whose forces and failure go by what acts on them in each cycle. Nodes that follow them, too.
std::vector<bool> looked_at_in_each_cycle(const System& system) {
  std::vector<bool> looked_at(system.all_nodes(), false);
  const auto of_body = [&](model::Index body) {
    if (body != model::none) looked_at[at(system.bodies[at(system.body_of[body])].node)] = true;
  };
  for (const model::RigidWeld& weld : system.model.rigid_welds) {
    if (weld.kind != model::RigidWeld::Kind::rivet) of_body(weld.body);
    for (const model::Index node : weld.nodes) looked_at[at(system.node_of[node])] = true;
  }
  for (const model::Joint& joint : system.model.joints) std::for_each(joint.body.begin(), joint.body.end(), of_body);
  for (const model::JointStiffness& joint : system.model.joint_stiffnesses)
    std::for_each(joint.body.begin(), joint.body.end(), of_body);
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!system.map.dependent(static_cast<int>(d))) continue;
    for (const ConstraintMap::Term& t : system.map.terms(static_cast<int>(d)))
      if (looked_at[at(t.node)]) looked_at[d] = true;
  }
  return looked_at;
}

/// Gives elements the shortest period of what else their nodes, or nodes that follow these, belong to. Where a node had
/// elements of different periods, the impulses of the slow ones would feed its fast vibrations.
void share_periods_of_nodes(const System& system, ElementPeriods& periods) {
  std::vector<std::uint8_t> of_node(system.nodes, std::numeric_limits<std::uint8_t>::max());
  const std::vector<bool> looked_at = looked_at_in_each_cycle(system);
  for (std::size_t k = 0; k < system.nodes; ++k)
    if (looked_at[k]) of_node[k] = 1;
  const auto each = [&](const auto& visit) {
    for (const auto& group : system.groups) {
      std::vector<std::uint8_t>* of = periods.of_kind(group->kind);
      for (std::size_t e = 0; e < group->size(); ++e) {
        const ElementNodes nodes = group->nodes(e);
        std::uint8_t one = 1;
        for (int a = 0; a < group->nodes_per_element; ++a)
          if (nodes[a] >= 0) visit(of ? (*of)[group->element[e]] : one, of_node[at(nodes[a])]);
      }
    }
  };
  each([](std::uint8_t& element, std::uint8_t& node) { node = std::min(node, element); });
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!system.map.dependent(static_cast<int>(d))) continue;
    for (const ConstraintMap::Term& t : system.map.terms(static_cast<int>(d)))
      if (at(t.node) < system.nodes) of_node[at(t.node)] = std::min(of_node[at(t.node)], of_node[d]);
  }
  each([](std::uint8_t& element, std::uint8_t& node) { element = std::min(node, element); });
}

}  // namespace

const std::vector<std::uint8_t>* ElementPeriods::of_kind(model::ElementKind kind) const {
  switch (kind) {
    case model::ElementKind::shell: return &shells;
    case model::ElementKind::solid: return &solids;
    case model::ElementKind::beam: return &beams;
    case model::ElementKind::discrete:
    case model::ElementKind::nothing: break;
  }
  return nullptr;
}

std::vector<std::uint8_t>* ElementPeriods::of_kind(model::ElementKind kind) {
  return const_cast<std::vector<std::uint8_t>*>(std::as_const(*this).of_kind(kind));
}

int ElementPeriods::of(model::ElementKind kind, model::Index element) const {
  const std::vector<std::uint8_t>* periods = of_kind(kind);
  return periods == nullptr || periods->empty() ? 1 : (*periods)[element];
}

ElementPeriods periods_by_step(const System& system, int ratio) {
  const double shortest = system.controlling().step;
  ElementPeriods periods;
  periods.shells.assign(system.model.shells.size(), 1);
  periods.solids.assign(system.model.solids.size(), 1);
  periods.beams.assign(system.model.beams.size(), 1);
  for (const auto& group : system.groups) {
    std::vector<std::uint8_t>* of = periods.of_kind(group->kind);
    const double share = group->kind == model::ElementKind::solid ? period_share_of_bricks : period_share;
    for (std::size_t e = 0; of != nullptr && e < group->size(); ++e) {
      const double step = group->step_share * group->damped_step(group->stable_step(e));
      const double most = std::min(static_cast<double>(ratio), share * step / shortest);
      (*of)[group->element[e]] = static_cast<std::uint8_t>(power_of_two(most));
    }
  }
  share_periods_of_nodes(system, periods);
  for (const weld::Weld& weld : system.ties.welds) {
    if (weld.kind == weld::Weld::Kind::rigid || weld.elements.empty()) continue;
    std::vector<std::uint8_t>* of = periods.of_kind(weld.element_kind());
    if (of == nullptr) continue;
    std::uint8_t least = (*of)[weld.elements.front()];
    for (const model::Index e : weld.elements) least = std::min(least, (*of)[e]);
    for (const model::Index e : weld.elements) (*of)[e] = least;
  }
  return periods;
}

std::map<int, System::Members> System::by_period(model::ElementKind kind, const Members& m) const {
  std::map<int, Members> sorted;
  for (std::size_t i = 0; i < m.element.size(); ++i) {
    Members& of = sorted[periods_.of(kind, m.element[i])];
    of.element.push_back(m.element[i]);
    of.node.push_back(m.node[i]);
  }
  return sorted;
}

Subcycles::Subcycles(const System& system) {
  std::map<int, std::size_t> level_of;
  for (const auto& group : system.groups) level_of[group->period] = 0;
  levels_.resize(level_of.size());
  std::size_t next = 0;
  for (auto& [period, level] : level_of) {
    level = next++;
    levels_[level].period = levels_[level].period_before = period;
  }
  std::vector<std::size_t> first_row;  // of each group, to find the group of a slot
  for (std::size_t g = 0; g < system.groups.size(); ++g)
    levels_[level_of[system.groups[g]->period]].groups.push_back(static_cast<int>(g));
  for (const auto& [g, block] : system.blocks_)
    levels_[level_of[system.groups[at(g)]->period]].blocks.emplace_back(g, block);
  std::vector<std::size_t> by_row(system.slots_.size() + system.single_slots_.size());  // level of a slot
  for (const auto& group : system.groups)
    std::fill_n(by_row.begin() + static_cast<std::ptrdiff_t>(group->first_slot), group->slot_count(),
                level_of[group->period]);
  for (std::size_t k = 0; k < system.nodes; ++k)
    for (const std::uint32_t entry : system.sums_.of_node(k)) {
      Level& level = levels_[by_row[entry >> 1]];
      if (level.nodes.empty() || level.nodes.back() != static_cast<int>(k)) {
        level.nodes.push_back(static_cast<int>(k));
        level.begin.push_back(level.entries.size());
      }
      level.entries.push_back(entry);
    }
  for (Level& level : levels_) {
    level.begin.push_back(level.entries.size());
    if (level.period == 1) continue;
    level.way.resize(level.nodes.size());
    level.turn.resize(level.nodes.size());
  }
  period_ = levels_.empty() ? 1 : levels_.back().period;  // of rigid bodies alone: no groups
  way_.resize(system.nodes);
  turn_.resize(system.nodes);
  v_.resize(system.nodes);
  w_.resize(system.nodes);
}

void Subcycles::internal_force(System& system, State& state) {
  const bool at_rest = state.dt == 0.0;
  if (at_rest || (state.cycle - 1) % period_ == 0) begin_period();
  if (!at_rest) add_step(state);
  std::fill(state.f.begin(), state.f.end(), Row{});
  std::fill(state.m.begin(), state.m.end(), Row{});
  for (Level& level : levels_) {
    if (!at_rest && state.cycle % level.period != 0) continue;
    compute(system, level, state);
    gather(system, level, level.period, state.f, state.m);
  }
}

void Subcycles::begin_period() {
  time_ = 0.0;
  std::fill(way_.begin(), way_.end(), Row{});
  std::fill(turn_.begin(), turn_.end(), Row{});
  const auto begin = [](Level& level) {
    level.time = 0.0;
    std::fill(level.way.begin(), level.way.end(), Row{});
    std::fill(level.turn.begin(), level.turn.end(), Row{});
  };
  for (Level& level : levels_) begin(level);
  begin(contacts_);
}

void Subcycles::add_step(const State& state) {
  time_ += state.dt;
  parallel_for(way_.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      way_[k] = sum(way_[k], state.dt, state.v[k]);
      turn_[k] = sum(turn_[k], state.dt, state.w[k]);
    }
  });
}

void Subcycles::compute(System& system, Level& level, State& state) {
  double dt = state.dt;
  const bool by_mean = level.period > 1 && dt > 0.0;
  if (by_mean) {
    dt = time_ - level.time;
    parallel_for(level.nodes.size(), 2048, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::size_t k = at(level.nodes[i]);
        const auto mean = [&](const Row& now, Row& before) {
          const Row m{(now.x - before.x) / dt, (now.y - before.y) / dt, (now.z - before.z) / dt, 0.0};
          before = now;
          return m;
        };
        v_[k] = mean(way_[k], level.way[i]);
        w_[k] = mean(turn_[k], level.turn[i]);
      }
    });
    level.time = time_;
    v_.swap(state.v);
    w_.swap(state.w);
  }
  for (const int g : level.groups)
    if (auto* looks = dynamic_cast<BeforeCycle*>(system.groups[at(g)].get())) looks->before_cycle(state);
  for_each_block(level.blocks, [&](int g, std::size_t begin, std::size_t end) {
    system.groups[at(g)]->cycle(begin, end, state, dt, system.slots_, system.damping_slots);
  });
  if (!by_mean) return;
  v_.swap(state.v);
  w_.swap(state.w);
}

std::span<const Row> Subcycles::mean_velocities() {
  if (contacts_.way.empty()) contacts_.way.resize(way_.size());
  const double dt = time_ - contacts_.time;
  parallel_for(way_.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Row &now = way_[k], &before = contacts_.way[k];
      v_[k] = {(now.x - before.x) / dt, (now.y - before.y) / dt, (now.z - before.z) / dt, 0.0};
      contacts_.way[k] = now;
    }
  });
  contacts_.time = time_;
  return v_;
}

void Subcycles::gather(const System& system, const Level& level, double factor, std::span<Row> force,
                       std::span<Row> moment) {
  parallel_for(level.nodes.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Vec3d f, m;
      for (std::size_t j = level.begin[i]; j < level.begin[i + 1]; ++j) {
        const std::uint32_t entry = level.entries[j];
        f -= system.in_slot(entry >> 1);
        if (entry & 1u) m -= system.in_slot(system.sums_.moment_of(entry >> 1));
      }
      const std::size_t k = at(level.nodes[i]);
      add(force[k], factor * f);
      add(moment[k], factor * m);
    }
  });
}

void Subcycles::shorten(System& system) {
  const auto allowed = [&](const Level& level) {
    double least = std::numeric_limits<double>::infinity();
    for (const int g : level.groups) {
      const ElementGroup& group = *system.groups[at(g)];
      for (const double step : group.block_step) least = std::min(least, group.step_share * group.damped_step(step));
    }
    return least;
  };
  if (levels_.empty() || levels_.front().period != 1) return;
  period_ = 1;
  const double shortest = allowed(levels_.front());
  for (Level& level : levels_) {
    level.period_before = level.period;
    if (level.period == 1) continue;
    const double most = allowed(level) / shortest;
    while (level.period > 1 && level.period > most) level.period /= 2;
    for (const int g : level.groups) system.groups[at(g)]->period = level.period;
    period_ = std::max(period_, level.period);
  }
}

void Subcycles::correct_impulses(System& system, State& state) {
  std::vector<Row> force, moment;
  for (const Level& level : levels_) {
    if (level.period == level.period_before) continue;
    if (force.empty()) {
      force.resize(state.f.size());
      moment.resize(state.m.size());
    }
    const double wanted =
        (level.period_before * state.dt_previous + level.period * state.dt) / (state.dt_previous + state.dt);
    gather(system, level, wanted - level.period_before, force, moment);
  }
  if (force.empty()) return;
  system.map.transfer_forces(force, moment);
  for (std::size_t k = 0; k < force.size(); ++k) {
    add(state.f[k], vec(force[k]));
    add(state.m[k], vec(moment[k]));
  }
}

void Subcycles::Level::archive(Archive& a) {
  a(period);
  a.built(period_before, groups, blocks, nodes, begin, entries, time, way, turn);
}

/// Between two periods.
void Subcycles::archive(Archive& a) {
  a(levels_, period_);
  a.built(time_, way_, turn_, v_, w_, contacts_);
}

}  // namespace nugget::system
