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

}  // namespace

void System::link_slots() {
  std::size_t rows = 0, single_rows = 0;
  for (auto& group : groups) {
    (group->single_precision() ? single_rows : rows) += group->slot_rows();
    for (std::size_t b = 0; b < group->blocks(); ++b) blocks_.emplace_back(static_cast<int>(&group - groups.data()), b);
    group->block_step.assign(group->blocks(), std::numeric_limits<double>::infinity());
  }
  slots_.resize(rows);
  single_slots_.resize(single_rows);
  std::size_t next_row = 0, next_single = 0;
  for (auto& group : groups) {
    if (group->single_precision()) {
      group->first_slot = rows + next_single;
      group->single_slots = std::span(single_slots_).subspan(next_single, group->slot_rows());
      next_single += group->slot_rows();
    } else {
      group->first_slot = next_row;
      next_row += group->slot_rows();
    }
  }

  std::vector<std::uint32_t> count(nodes + 1, 0);
  const auto each_slot = [&](auto&& visit) {
    for (const bool single : {false, true})  // gather_slots takes those of a node in this order
      for (const auto& group : groups)
        for (std::size_t e = 0; group->single_precision() == single && e < group->size(); ++e) {
          const ElementNodes node = group->nodes(e);
          for (int a = 0; a < group->nodes_per_element; ++a) visit(at(node[a]), *group, group->slot_row(e, a));
        }
  };
  each_slot([&](std::size_t node, const ElementGroup&, std::size_t) { ++count[node + 1]; });
  for (std::size_t k = 0; k < nodes; ++k) count[k + 1] += count[k];
  gather_.resize(count.back());
  gather_start_ = std::move(count);
  std::vector<std::uint32_t> next(gather_start_.begin(), gather_start_.end() - 1);
  each_slot([&](std::size_t node, const ElementGroup& group, std::size_t row) {
    gather_[next[node]++] = static_cast<std::uint32_t>(row << 1 | (group.rotational ? 1u : 0u));
  });
}

Vec3d System::nodal_force(ElementLocation location, int a) const {
  return slot(groups[location.group]->slot_row(at(location.element), a));
}

Vec3d System::nodal_moment(ElementLocation location, int a) const {
  const ElementGroup& group = *groups[location.group];
  return group.rotational ? slot(group.slot_row(at(location.element), a) + 1) : Vec3d{};
}

void System::internal_force(State& state) {
  start_elements();
  if (subcycles_.on()) {
    subcycles_.internal_force(*this, state);
    return;
  }
  for (const auto& group : groups)
    if (auto* looks = dynamic_cast<BeforeCycle*>(group.get())) looks->before_cycle(state);
  const auto cycle = [&](int g, std::size_t begin, std::size_t end) {
    groups[g]->cycle(begin, end, state, state.dt, slots_, damping_slots);
  };
  if (!share_) {
    for_each_block(cycle);
    add_up_slots(slots_, single_slots_, state.f, state.m);
    return;
  }
  note_deleted();
  const std::size_t border = share_->border_blocks();
  const std::span all(blocks_);
  system::for_each_block(all.first(border), cycle);
  share_->send(slots_, single_slots_);
  system::for_each_block(all.subspan(border), cycle);
  share_->receive(slots_, single_slots_);
  exchange_news();
  add_up_slots(slots_, single_slots_, state.f, state.m);
}

void System::exchange_sums(State& state) {
  if (share_) share_->exchange_sums(state.f, state.m);
}

void for_each_block(std::span<const std::pair<int, std::size_t>> blocks,
                    const std::function<void(int, std::size_t, std::size_t)>& body) {
  parallel_for(blocks.size(), 16, [&](std::size_t begin, std::size_t end) {
    while (begin < end) {
      const auto [g, block] = blocks[begin];
      std::size_t run = begin + 1;
      while (run < end && blocks[run].first == g && blocks[run].second == block + (run - begin)) ++run;
      body(g, block, block + (run - begin));
      begin = run;
    }
  });
}

void System::for_each_node(std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) const {
  if (!share_) return parallel_for(all_nodes(), grain, body);
  for_ranges(share_->followed(), body);
}

void System::gather_slots(std::span<Row> slots, std::span<SingleRow> single, std::span<Row> force,
                          std::span<Row> moment) {
  if (share_) {
    share_->send(slots, single);
    share_->receive(slots, single);
  }
  add_up_slots(slots, single, force, moment);
  if (share_) share_->exchange_sums(force, moment);
}

void System::add_up_slots(std::span<const Row> slots, std::span<const SingleRow> single, std::span<Row> force,
                          std::span<Row> moment) const {
  constexpr std::size_t slots_ahead = 64;
  const auto gather = [&](auto with_single) {
    constexpr bool has_single = decltype(with_single)::value;
    const auto some = [=, this](std::size_t begin, std::size_t end) {
      const std::uint32_t *entry = gather_.data(), *start = gather_start_.data();
      const std::size_t last_entry = gather_.size() - 1;
      // Adds up entries [i, stop) to f and m; all of them stand in `rows`, which are counted from `first` on.
      const auto add_up = [=](auto rows, std::size_t first, std::size_t i, std::size_t stop, FourReals& f,
                              FourReals& m) {
        for (; i < stop; ++i) {
          // The slots of a node lie in as many elements: not asked for ahead, every one is waited for.
          const std::size_t ahead = (entry[std::min(i + slots_ahead, last_entry)] >> 1) - first;
          __builtin_prefetch(&rows[!has_single || ahead < rows.size() ? ahead : 0]);
          const auto* slot = &rows[(entry[i] >> 1) - first];
          f -= four(slot[0]);
          if (entry[i] & 1u) m -= four(slot[1]);
        }
      };
      for (std::size_t k = begin; k < end; ++k) {
        FourReals f{}, m{};
        std::size_t split = start[k + 1];
        if constexpr (has_single) {
          split = start[k];
          while (split < start[k + 1] && entry[split] >> 1 < slots.size()) ++split;
          add_up(single, slots.size(), split, start[k + 1], f, m);
        }
        add_up(slots, 0, start[k], split, f, m);
        set(force[k], f);
        set(moment[k], m);
      }
    };
    if (share_)
      for_ranges(share_->summed(), some);
    else
      parallel_for(nodes, 512, some);
  };
  if (single.empty())
    gather(std::false_type{});
  else
    gather(std::true_type{});
  for (std::size_t k = nodes; k < all_nodes(); ++k) force[k] = moment[k] = Row{};
}

}  // namespace nugget::system
