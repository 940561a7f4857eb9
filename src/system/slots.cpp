// SPDX-License-Identifier: Apache-2.0
// Slots of the elements' nodal forces: where each element has its own, and how nodes take the sums of theirs.
#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "system/before_cycle.hpp"
#include "system/share.hpp"
#include "system/system.hpp"

namespace nugget::system {
namespace {

/// Calls `body` for ranges of nodes, side by side.
void for_ranges(const std::vector<Share::Range>& ranges, const std::function<void(std::size_t, std::size_t)>& body) {
  parallel_for(ranges.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(at(ranges[i].begin), at(ranges[i].end));
  });
}

/// Calls `body(group, begin, end)` for runs of blocks of one group, one behind the other.
template <class Body>
void each_run(std::span<const std::pair<int, std::size_t>> blocks, const Body& body) {
  for (std::size_t begin = 0; begin < blocks.size();) {
    const auto [g, block] = blocks[begin];
    std::size_t run = begin + 1;
    while (run < blocks.size() && blocks[run].first == g && blocks[run].second == block + (run - begin)) ++run;
    body(g, block, block + (run - begin));
    begin = run;
  }
}

}  // namespace

void System::link_slots() {
  std::size_t doubles = 0, singles = 0;
  for (auto& group : groups) {
    (group->single_precision() ? singles : doubles) += group->slot_count();
    for (std::size_t b = 0; b < group->blocks(); ++b) blocks_.emplace_back(static_cast<int>(&group - groups.data()), b);
    group->block_step.assign(group->blocks(), std::numeric_limits<double>::infinity());
  }
  slots_.resize(doubles);
  single_slots_.resize(singles);
  std::size_t next = 0, next_single = 0;
  for (auto& group : groups) {
    if (group->single_precision()) {
      group->first_slot = doubles + next_single;
      group->single_slots = single_slots_.data() + SingleSlots::place(next_single);
      next_single += group->slot_count();
    } else {
      group->first_slot = next;
      next += group->slot_count();
    }
  }
  sums_.link(groups, nodes, doubles);
  sums_.divide(groups, blocks_, 0);
}

Vec3d System::nodal_force(ElementLocation location, int a) const {
  return in_slot(groups[location.group]->slot(at(location.element), a));
}

Vec3d System::nodal_moment(ElementLocation location, int a) const {
  const ElementGroup& group = *groups[location.group];
  return group.rotational ? in_slot(group.moment_slot(at(location.element), a)) : Vec3d{};
}

void System::internal_force(State& state) {
  start_elements();
  if (subcycles_.on()) {
    subcycles_.internal_force(*this, state);
    return;
  }
  for (const auto& group : groups)
    if (auto* looks = dynamic_cast<BeforeCycle*>(group.get())) looks->before_cycle(state);
  const NodalSums::Sums sums{state.f, state.m};
  const auto compute = [&](bool before_border) {
    sums_.compute(before_border, slots_, single_slots_, sums, [&](std::size_t begin, std::size_t end) {
      each_run(std::span(blocks_).subspan(begin, end - begin), [&](int g, std::size_t first, std::size_t last) {
        groups[g]->cycle(first, last, state, state.dt, slots_, damping_slots);
      });
    });
  };
  if (!share_) {
    compute(false);
  } else {
    note_deleted();
    compute(true);
    share_->send(slots_, single_slots_);
    compute(false);
    share_->receive(slots_, single_slots_);
    exchange_news();
  }
  sums_.add_up_others(slots_, single_slots_, sums);
  clear_virtual(state.f, state.m);
}

void System::exchange_sums(State& state) {
  if (share_) share_->exchange_sums(state.f, state.m);
}

void for_each_block(std::span<const std::pair<int, std::size_t>> blocks,
                    const std::function<void(int, std::size_t, std::size_t)>& body) {
  parallel_for(blocks.size(), 16,
               [&](std::size_t begin, std::size_t end) { each_run(blocks.subspan(begin, end - begin), body); });
}

void System::for_each_node(std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) const {
  if (!share_) return parallel_for(all_nodes(), grain, body);
  for_ranges(share_->followed(), body);
}

void System::gather_damping(std::span<Row> force, std::span<Row> moment) {
  SingleSlots none;
  if (share_) {
    share_->send(damping_slots, none);
    share_->receive(damping_slots, none);
  }
  sums_.add_up(damping_slots, none, {force, moment});
  clear_virtual(force, moment);
  if (share_) share_->exchange_sums(force, moment);
}

void System::clear_virtual(std::span<Row> force, std::span<Row> moment) const {
  for (std::size_t k = nodes; k < all_nodes(); ++k) force[k] = moment[k] = Row{};
}

}  // namespace nugget::system
