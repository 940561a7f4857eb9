// SPDX-License-Identifier: Apache-2.0
#include "system/share.hpp"

#include <algorithm>
#include <iterator>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "system/followers.hpp"

namespace nugget::system {
namespace {

constexpr int longest_range = 512;  // so that threads have something to share

/// Ranges of those nodes for which `chosen` is true.
template <class Chosen>
std::vector<Share::Range> ranges_of(std::size_t nodes, const Chosen& chosen) {
  std::vector<Share::Range> ranges;
  for (int k = 0; k < static_cast<int>(nodes); ++k) {
    if (!chosen(k)) continue;
    if (!ranges.empty() && ranges.back().end == k && k - ranges.back().begin < longest_range)
      ++ranges.back().end;
    else
      ranges.push_back({k, k + 1});
  }
  return ranges;
}

}  // namespace

Share::Share(const System& system, Ranks& ranks, Partition partition, std::span<const char> for_everyone)
    : ranks_(ranks), partition_(std::move(partition)) {
  const int count = ranks.count(), own = ranks.rank();
  const FollowersOfNodes followers(system, partition_, for_everyone);
  const auto sum_travels = [&](int k) {
    const Followers of = followers[k];
    return of.all && !of.of_everyone && of.owners.size() == 1;
  };

  // Slots travel to everyone, and to single ranks.
  std::vector<Message> to_all(at(count));
  std::vector<std::vector<Message>> between(at(count), std::vector<Message>(at(count)));  // from, to
  std::vector<std::vector<char>> at_border;
  for (const auto& group : system.groups) at_border.emplace_back(group->blocks(), 0);
  each_corner(system, [&](int g, const ElementGroup& group, std::size_t e, int a, int node) {
    const int from = partition_.of_element(g, e);
    if (from == Partition::everyone || sum_travels(node)) return;
    const Followers of = followers[node];
    const auto add = [&](Message& message) {
      message.slots.push_back(group.slot(e, a));
      if (group.rotational) message.slots.push_back(group.moment_slot(e, a));
    };
    bool travels = of.all;
    if (travels) add(to_all[from]);
    for (const std::span<const int>* some : {&of.owners, &of.others})
      for (const int to : *some) {
        if (to == from || of.all || (from != own && to != own)) continue;
        add(between[from][to]);
        travels = true;
      }
    if (travels && from == own) at_border[g][e / group.block_width()] = 1;
  });
  const auto keep = [&](Message& message, int from, std::vector<int> to) {
    if (message.slots.empty()) return;
    message.from = from;
    message.to = std::move(to);
    message.data.resize(message.slots.size());
    (from == own ? out_ : in_).push_back(std::move(message));
  };
  std::vector<int> others;
  for (int r = 0; r < count; ++r)
    if (r != own) others.push_back(r);
  for (int from = 0; from < count; ++from) {
    keep(to_all[from], from, others);
    for (int to = 0; to < count; ++to)
      if (from == own || to == own) keep(between[from][to], from, {to});
  }

  sums_.resize(at(count));
  for (int k = 0; k < static_cast<int>(system.nodes); ++k) {
    if (!sum_travels(k)) continue;
    Sums& sums = sums_[followers[k].owners.front()];
    sums.nodes.push_back(k);
    sums.turns.push_back(followers[k].turns);
  }
  for (Sums& sums : sums_)
    sums.data.resize(sums.nodes.size() + at(static_cast<int>(std::count(sums.turns.begin(), sums.turns.end(), 1))));
  first_adding_.reserve(system.nodes + 1);
  for (int k = 0; k < static_cast<int>(system.nodes); ++k) {
    const Followers of = followers[k];
    first_adding_.push_back(static_cast<std::uint32_t>(adding_.size()));
    everyone_follows_.push_back(of.all);
    if (sum_travels(k)) adding_.push_back(of.owners.front());
    if (!of.all) std::ranges::merge(of.owners, of.others, std::back_inserter(adding_));
  }
  first_adding_.push_back(static_cast<std::uint32_t>(adding_.size()));
  followed_ = ranges_of(system.nodes, [&](int k) { return follows(k); });
  for (int k = static_cast<int>(system.nodes); k < static_cast<int>(system.all_nodes()); k += longest_range)
    followed_.push_back({k, std::min(static_cast<int>(system.all_nodes()), k + longest_range)});
  reported_.resize(at(count));
  for (int k = 0; k < static_cast<int>(system.nodes); ++k)
    if (!everyone_follows(k)) reported_[answering(k)].add(k);

  for (const bool border : {true, false}) {
    for (std::size_t g = 0; g < system.groups.size(); ++g) {
      const ElementGroup& group = *system.groups[g];
      for (std::size_t b = 0; b < group.blocks(); ++b) {
        const int rank = partition_.of_block(static_cast<int>(g), b, group.block_width());
        if (rank != Partition::everyone && rank != own) continue;
        if ((at_border[g][b] != 0) == border) blocks_.emplace_back(static_cast<int>(g), b);
      }
    }
    if (border) border_blocks_ = blocks_.size();
  }
}

void Share::send(const Slots& slots, const SingleSlots& single) {
  const std::size_t doubles = slots.size();
  for (Message& message : in_) ranks_.receive(message.from, std::as_writable_bytes(std::span(message.data)));
  for (Message& message : out_) {
    for (std::size_t i = 0; i < message.slots.size(); ++i) {
      const std::size_t slot = message.slots[i];
      const Vec3d v = slot < doubles ? slots[slot] : single[slot - doubles];
      message.data[i] = {v.x, v.y, v.z};
    }
    for (const int to : message.to) ranks_.send(to, std::as_bytes(std::span<const Row3>(message.data)));
  }
}

void Share::receive(Slots& slots, SingleSlots& single) {
  const std::size_t doubles = slots.size();
  ranks_.finish();
  for (const Message& message : in_) {
    for (std::size_t i = 0; i < message.slots.size(); ++i) {
      const std::size_t slot = message.slots[i];
      const Row3& v = message.data[i];
      if (slot < doubles)
        slots.set(slot, {v.x, v.y, v.z});
      else
        single.set(slot - doubles, {v.x, v.y, v.z});
    }
  }
}

void Share::exchange_sums(std::span<Row> force, std::span<Row> moment) {
  const int own = ranks_.rank();
  for (int r = 0; r < ranks_.count(); ++r)
    if (r != own && !sums_[r].nodes.empty()) ranks_.receive(r, std::as_writable_bytes(std::span(sums_[r].data)));
  Sums& mine = sums_[own];
  std::size_t place = 0;
  for (std::size_t i = 0; i < mine.nodes.size(); ++i) {
    const Row &f = force[mine.nodes[i]], &m = moment[mine.nodes[i]];
    mine.data[place++] = {f.x, f.y, f.z};
    if (mine.turns[i]) mine.data[place++] = {m.x, m.y, m.z};
  }
  if (!mine.nodes.empty())
    for (int r = 0; r < ranks_.count(); ++r)
      if (r != own) ranks_.send(r, std::as_bytes(std::span<const Row3>(mine.data)));
  ranks_.finish();
  for (int r = 0; r < ranks_.count(); ++r) {
    if (r == own) continue;
    const Sums& sums = sums_[r];
    const Row3* next = sums.data.data();
    for (std::size_t i = 0; i < sums.nodes.size(); ++i) {
      Row &f = force[sums.nodes[i]], &m = moment[sums.nodes[i]];
      f = {next->x, next->y, next->z, 0.0};
      ++next;
      m = {};
      if (sums.turns[i]) {
        m = {next->x, next->y, next->z, 0.0};
        ++next;
      }
    }
  }
}

void Share::spread(std::span<Row> of_nodes) const {
  // One rank after the other, so that nobody holds twice what all the others have.
  const int own = ranks_.rank();
  std::vector<Row> rows;
  for (int r = 0; r < ranks_.count(); ++r) {
    if (reported_[r].empty()) continue;
    rows.resize(reported_[r].size());
    if (r == own) {
      std::ranges::transform(reported_[r], rows.begin(), [&](int k) { return of_nodes[k]; });
      for (int to = 0; to < ranks_.count(); ++to)
        if (to != own) ranks_.send(to, std::as_bytes(std::span<const Row>(rows)));
    } else {
      ranks_.receive(r, std::as_writable_bytes(std::span(rows)));
    }
    ranks_.finish();
    if (r == own) continue;
    auto row = rows.begin();
    for (const int k : reported_[r]) of_nodes[k] = *row++;
  }
}

/// The first rank that stands in `adding` of all these nodes but the ignored ones.
template <class Ignored>
int Share::first_of_all(std::span<const int> nodes, int of_all, const Ignored& ignored) const {
  std::vector<int> ranks, more;
  bool any = false;
  for (const int n : nodes) {
    const std::span<const int> some = adding(n);
    if (some.empty() || ignored(n)) continue;
    more.clear();
    if (any)
      std::ranges::set_intersection(ranks, some, std::back_inserter(more));
    else
      more.assign(some.begin(), some.end());
    ranks.swap(more);
    any = true;
  }
  if (!any) return of_all;
  return ranks.empty() ? nobody : ranks.front();
}

int Share::follower_of_all(std::span<const int> nodes, int of_all) const {
  return first_of_all(nodes, of_all, [this](int n) { return everyone_follows(n); });
}

int Share::adder_of_all(std::span<const int> nodes, int of_all) const {
  return first_of_all(nodes, of_all, [](int) { return false; });
}

}  // namespace nugget::system
