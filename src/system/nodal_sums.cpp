// SPDX-License-Identifier: Apache-2.0
#include "system/nodal_sums.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "system/element_group.hpp"

namespace nugget::system {
namespace {

constexpr std::size_t nodes_ahead = 12;  ///< whose slots the memory is asked for

/// Takes what stands in slots from the sums. `entries`: see NodalSums::of_node; they are counted from `first` on.
template <class N>
void subtract(const SlotsOf<N>& slots, std::span<const std::uint32_t> entries, std::size_t first, Vec3d& f, Vec3d& m) {
  constexpr std::size_t lanes = SlotsOf<N>::lanes;
  const auto vector_at = [](const N* component) { return Vec3d{component[0], component[lanes], component[2 * lanes]}; };
  for (const std::uint32_t entry : entries) {
    const N* force = slots.data() + SlotsOf<N>::place((entry >> 1) - first);
    f -= vector_at(force);
    if (entry & 1u) m -= vector_at(force + 3 * lanes);
  }
}

/// Elements of a stretch. Of shells and bricks alike 1024 have 192 kB of slots.
std::size_t elements_of_stretch(std::size_t all) {
  constexpr std::size_t least = 128, most = 1024, for_each_thread = 16;
  return std::clamp(all / (for_each_thread * at(threads())), least, most);
}

}  // namespace

void NodalSums::link(const std::vector<std::unique_ptr<ElementGroup>>& groups, std::size_t nodes, std::size_t doubles) {
  doubles_ = doubles;
  std::vector<std::uint32_t> count(nodes + 1, 0);
  const auto each_slot = [&](auto&& visit) {
    for (const bool single : {false, true})
      for (const auto& group : groups)
        for (std::size_t e = 0; group->single_precision() == single && e < group->size(); ++e) {
          const ElementNodes node = group->nodes(e);
          for (int a = 0; a < group->nodes_per_element; ++a) visit(at(node[a]), *group, group->slot(e, a));
        }
  };
  each_slot([&](std::size_t node, const ElementGroup&, std::size_t) { ++count[node + 1]; });
  std::partial_sum(count.begin(), count.end(), count.begin());
  entry_.resize(count.back());
  start_ = std::move(count);
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  each_slot([&](std::size_t node, const ElementGroup& group, std::size_t slot) {
    entry_[next[node]++] = static_cast<std::uint32_t>(slot << 1 | (group.rotational ? 1u : 0u));
  });
  order_.resize(nodes);
  std::iota(order_.begin(), order_.end(), 0);
}

void NodalSums::keep(const std::function<bool(int)>& adds_up) {
  std::vector<std::uint32_t> kept, start{0};
  start.reserve(start_.size());
  order_.clear();
  for (std::size_t k = 0; k < nodes(); ++k) {
    if (adds_up(static_cast<int>(k))) {
      const std::span<const std::uint32_t> of = of_node(k);
      kept.insert(kept.end(), of.begin(), of.end());
      order_.push_back(static_cast<int>(k));
    }
    start.push_back(static_cast<std::uint32_t>(kept.size()));
  }
  kept.shrink_to_fit();
  order_.shrink_to_fit();
  entry_ = std::move(kept);
  start_ = std::move(start);
}

void NodalSums::divide(const std::vector<std::unique_ptr<ElementGroup>>& groups, std::span<const Block> blocks,
                       std::size_t border) {
  const auto width_of = [&](const Block& block) { return groups[at(block.first)]->block_width(); };
  std::size_t all = 0;
  for (const Block& block : blocks) all += width_of(block);
  const std::size_t enough = elements_of_stretch(all);
  stretches_.clear();
  for (std::size_t i = 0, elements = 0; i < blocks.size(); ++i) {
    elements += width_of(blocks[i]);
    if (i + 1 == border) border_ = stretches_.size() + 1;
    if (elements < enough && i + 1 != border && i + 1 != blocks.size()) continue;
    stretches_.push_back({i + 1, 0});
    elements = 0;
  }
  if (border == 0) border_ = 0;

  // The stretch that has all slots of a node, of nodes that have one.
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max(), several = none - 1;
  std::vector<std::uint32_t> stretch_of(nodes(), none), found(nodes(), 0);
  std::size_t begin = 0;
  for (std::uint32_t s = 0; s < stretches_.size(); ++s) {
    for (std::size_t i = begin; i < stretches_[s].end_block; ++i) {
      const ElementGroup& group = *groups[at(blocks[i].first)];
      const std::size_t first = blocks[i].second * width_of(blocks[i]);
      for (std::size_t e = first; e < std::min(group.size(), first + width_of(blocks[i])); ++e) {
        const ElementNodes node = group.nodes(e);
        for (int a = 0; a < group.nodes_per_element; ++a) {
          std::uint32_t& of = stretch_of[at(node[a])];
          of = of == none || of == s ? s : several;
          ++found[at(node[a])];
        }
      }
    }
    begin = stretches_[s].end_block;
  }
  const auto place = [&](int node) {
    const std::uint32_t s = stretch_of[at(node)];
    return s < several && found[at(node)] == of_node(at(node)).size() ? s : none;
  };
  std::ranges::stable_sort(order_, {}, place);
  auto next = order_.begin();
  for (std::uint32_t s = 0; s < stretches_.size(); ++s) {
    while (next != order_.end() && place(*next) == s) ++next;
    stretches_[s].end_node = static_cast<std::size_t>(next - order_.begin());
  }
  others_ = static_cast<std::size_t>(next - order_.begin());
}

void NodalSums::compute(bool before_border, const Slots& slots, const SingleSlots& single, const Sums& sums,
                        const std::function<void(std::size_t, std::size_t)>& compute) const {
  const std::size_t first = before_border ? 0 : border_, count = before_border ? border_ : stretches_.size() - border_;
  parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = first + begin; s < first + end; ++s) {
      const Stretch before = s == 0 ? Stretch{0, 0} : stretches_[s - 1];
      compute(before.end_block, stretches_[s].end_block);
      add_up(before.end_node, stretches_[s].end_node, 0, slots, single, sums);
    }
  });
}

void NodalSums::add_up_others(const Slots& slots, const SingleSlots& single, const Sums& sums) const {
  parallel_for(order_.size() - others_, 512, [&](std::size_t begin, std::size_t end) {
    add_up(others_ + begin, others_ + end, nodes_ahead, slots, single, sums);
  });
}

void NodalSums::add_up(const Slots& slots, const SingleSlots& single, const Sums& sums) const {
  parallel_for(order_.size(), 512,
               [&](std::size_t begin, std::size_t end) { add_up(begin, end, nodes_ahead, slots, single, sums); });
}

void NodalSums::add_up(std::size_t begin, std::size_t end, std::size_t ahead, const Slots& slots,
                       const SingleSlots& single, const Sums& sums) const {
  const std::size_t in_slots = slots.size();
  for (std::size_t i = begin; i < end; ++i) {
    if (ahead != 0) {
      // The slots of a node lie in as many elements: not asked for ahead, every one is waited for.
      for (const std::uint32_t entry : of_node(at(order_[std::min(i + ahead, end - 1)])))
        for (std::size_t c = 0; c < (entry & 1u ? 6 : 3); ++c) {
          const std::size_t slot = entry >> 1;
          if (slot < in_slots)
            __builtin_prefetch(slots.data() + Slots::place(slot) + c * Slots::lanes);
          else
            __builtin_prefetch(single.data() + SingleSlots::place(slot - in_slots) + c * SingleSlots::lanes);
        }
    }
    const int k = order_[i];
    Vec3d f, m;
    const std::span<const std::uint32_t> entries = of_node(at(k));
    if (in_slots == doubles_) {
      std::size_t singles = entries.size();  // behind those of doubles, and added up first
      while (!single.empty() && singles > 0 && entries[singles - 1] >> 1 >= doubles_) --singles;
      subtract(single, entries.subspan(singles), doubles_, f, m);
      subtract(slots, entries.first(singles), 0, f, m);
    } else {
      for (const std::uint32_t entry : entries) {
        f -= slots[entry >> 1];
        if (entry & 1u) m -= slots[moment_of(entry >> 1)];
      }
    }
    set(sums.force[k], f);
    set(sums.moment[k], m);
  }
}

}  // namespace nugget::system
