// SPDX-License-Identifier: Apache-2.0
// Runs over several ranks: what of a System each computes, and what of it the others learn.
#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "model/bond.hpp"
#include "system/before_cycle.hpp"
#include "system/share.hpp"
#include "system/sums_by_rank.hpp"
#include "system/system.hpp"

namespace nugget::system {
namespace {

/// What has happened to an element in a cycle that its rank has computed.
struct ElementNews {
  enum What : int { deleted, inverted, step };
  int what = deleted;
  int group = 0;
  std::size_t element = 0;
  double value = 0.0;  ///< the step
};

}  // namespace

void System::share_out(Ranks& ranks, Partition partition, std::span<const char> followed,
                       std::span<Rows* const> of_nodes) {
  partition.take_from_first(ranks);
  share_ = std::make_unique<Share>(*this, ranks, std::move(partition), followed);
  for (Rows* rows : of_nodes) share_->forget_others(*rows);
  sums_by_rank_ = std::make_unique<SumsByRank>(*this);
  blocks_ = share_->blocks();
  computed_ = blocks_;
  std::ranges::sort(computed_);
  map.keep_to([this](int dependent) { return share_->follows(dependent); });
  if (!elements_have_started_) {
    elements_have_started_ = true;
    const auto place = [this](int node) { return ties.x[model_node[node]]; };
    for (std::size_t g = 0; g < groups.size(); ++g)
      groups[g]->start(place, [this, g](std::size_t b) { return computes_block(g, b); });
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::size_t last = groups[g]->size() - 1;
    const int group = static_cast<int>(g);
    groups[g]->holders = {
        [this, group, last](std::size_t e) { return share_->partition().of_element(group, std::min(e, last)); },
        [this, group, last](std::size_t e) { return share_->computes(group, std::min(e, last)); }};
  }
  leave_to_others();
  sums_.keep([this](int k) { return share_->adds_up(k); });
  sums_.divide(groups, blocks_, share_->border_blocks());
  deletions_seen_.assign(groups.size(), -1);
  deleted_.resize(groups.size());
}

Archive::Holders System::holders_of_nodes() const {
  if (!share_) return {};
  return {[this](std::size_t k) {
            const auto node = static_cast<int>(k);
            return share_->everyone_follows(node) ? Archive::everyone : share_->answering(node);
          },
          [this](std::size_t k) { return share_->follows(static_cast<int>(k)); }};
}

/// What others compute has come as well of groups that stay whole; and of deleted elements all know.
void System::take_share_of_what_was_read() {
  if (!share_) return;
  leave_to_others();
  deletions_seen_.assign(groups.size(), -1);
}

bool System::computes_block(std::size_t g, std::size_t b) const {
  const int rank = share_->partition().of_block(static_cast<int>(g), b, groups[g]->block_width());
  return rank == Partition::everyone || rank == share_->ranks().rank();
}

void System::leave_to_others() {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g]->leave([this, g](std::size_t b) { return computes_block(g, b); });
    for (std::size_t e = 0; e < groups[g]->size(); ++e)
      if (!share_->computes(static_cast<int>(g), e)) groups[g]->release_step(e);
  }
}

std::size_t System::elements_elsewhere() const {
  std::size_t count = 0;
  for (const auto& group : groups) count += group->elsewhere();
  return count;
}

Carried System::carried_of(const ElementGroup& group, Carried what) const {
  if (what != Carried::end) return what;
  return group.weld || model::bond_of(model, model.parts[group.part]) ? Carried::results : Carried::energies;
}

void System::note_deleted() {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const ElementGroup& group = *groups[g];
    if (group.deletions == deletions_seen_[g]) continue;
    deletions_seen_[g] = group.deletions;
    deleted_[g].resize(group.size());
    for (std::size_t e = 0; e < group.size(); ++e) deleted_[g][e] = !group.alive(e);
  }
}

void System::exchange_news() {
  for (const auto& [g, e] : steps_of_others_) groups[g]->release_step(e);
  steps_of_others_.clear();
  std::vector<ElementNews> news;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const ElementGroup& group = *groups[i];
    const auto g = static_cast<int>(i);
    const auto each = [&](std::size_t begin, std::size_t end, const auto& visit) {
      for (std::size_t e = begin; e < std::min(end, group.size()); ++e)
        if (share_->partition().of_element(g, e) == share_->ranks().rank()) visit(e);
    };
    if (group.deletions != deletions_seen_[i])
      each(0, group.size(), [&](std::size_t e) {
        if (!group.alive(e) && !deleted_[i][e]) news.push_back({ElementNews::deleted, g, e});
      });
    if (group.inverted >= 0) {
      each(0, group.size(), [&](std::size_t e) {
        if (!group.alive(e) || group.stable_step(e) > 0.0) return;
        news.push_back({ElementNews::step, g, e, group.stable_step(e)});
      });
      news.push_back({ElementNews::inverted, g, at(group.inverted)});
    }
    const std::size_t width = group.block_width();
    for (std::size_t b = 0; reported_below > 0.0 && b < group.blocks(); ++b)
      if (group.step_share * group.block_step[b] < reported_below)
        each(b * width, (b + 1) * width, [&](std::size_t e) {
          if (group.alive(e) && group.step_share * group.stable_step(e) < reported_below)
            news.push_back({ElementNews::step, g, e, group.stable_step(e)});
        });
  }
  for (const ElementNews& n : gather_lists(share_->ranks(), news)) {
    ElementGroup& group = *groups[n.group];
    const bool own = share_->computes(n.group, n.element);
    if (n.what == ElementNews::inverted) {
      const auto e = static_cast<int>(n.element);
      if (group.inverted < 0 || e < group.inverted) group.inverted = e;
    } else if (!own && n.what == ElementNews::deleted) {
      group.remove(n.element);
    } else if (!own && n.what == ElementNews::step) {
      group.take_step(n.element, n.value);
      steps_of_others_.emplace_back(n.group, n.element);
    }
  }
}

bool System::looks_at_neighbours() const {
  return std::ranges::any_of(groups, [](const auto& group) {
    const auto* looks = dynamic_cast<const BeforeCycle*>(group.get());
    return looks != nullptr && looks->looks_at_neighbours();
  });
}

bool System::follows(std::size_t node) const {
  return !share_ || share_->follows(static_cast<int>(node));
}

bool System::computes(ElementLocation location) const {
  return !share_ || share_->computes(location.group, at(location.element));
}

void System::carry_forces(ElementLocation location, Parcel& parcel) {
  const ElementGroup& group = *groups[location.group];
  const bool single = group.single_precision();
  const auto carry = [&](std::size_t slot) {
    Vec3d v = in_slot(slot);
    parcel(&v, 1);
    if (!parcel.reading()) return;
    if (single)
      single_slots_.set(slot - slots_.size(), v);
    else
      slots_.set(slot, v);
  };
  for (int a = 0; a < group.nodes_per_element; ++a) {
    carry(group.slot(at(location.element), a));
    if (group.rotational) carry(group.moment_slot(at(location.element), a));
  }
}

void System::carry(int rank, Carried what, Parcel& parcel) {
  if (what == Carried::histories) return;
  map.carry([&](int d) { return !share_->everyone_follows(d) && share_->answering(d) == rank; }, parcel);
  if (what == Carried::restart) return;
  // By masses, which all have alike, and arms.
  if (what == Carried::whole)
    for (const int k : share_->reported_by(rank)) parcel(&inertia[k], 1);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    ElementGroup& group = *groups[g];
    const std::size_t width = group.block_width(), blocks = group.blocks();
    for (std::size_t begin = 0; begin < blocks;) {
      const auto of = [&](std::size_t b) { return share_->partition().of_block(static_cast<int>(g), b, width); };
      std::size_t end = begin + 1;
      const int here = of(begin);
      while (end < blocks && of(end) == here) ++end;
      if (here == rank) {
        const Carried of_group = carried_of(group, what);
        for (std::size_t first = begin, last; first < end; first = last) {
          // Of elements whose energies the rank has summed up nothing else is asked for.
          const auto is_summed_up = [&](std::size_t b) {
            return of_group == Carried::energies && !group.weld && sums_by_rank_->has_elements(g, b * width, width);
          };
          const bool left_out = is_summed_up(first);
          for (last = first + 1; last < end && is_summed_up(last) == left_out;) ++last;
          if (!left_out) group.carry(first, last, of_group, parcel);
        }
        for (std::size_t e = begin * width; what == Carried::whole && e < std::min(group.size(), end * width); ++e)
          carry_forces({static_cast<int>(g), static_cast<int>(e)}, parcel);
      }
      begin = end;
    }
  }
}

void System::collect(Carried what, std::span<Rows* const> of_nodes,
                     const std::function<void(const Computed& of, Parcel&)>& more, bool to_all) {
  if (!share_) return;
  const auto carry_all = [&](int rank, Parcel& parcel) {
    carry(rank, what, parcel);
    for (Rows* rows : of_nodes)
      for (const int k : share_->reported_by(rank)) parcel(&(*rows)[k], 1);
    more({rank, *share_, [&](int group, std::size_t e) { return share_->partition().of_element(group, e) == rank; }},
         parcel);
  };
  Ranks& ranks = share_->ranks();
  const int own = ranks.rank();
  std::vector<int> others;
  for (int r = 0; r < ranks.count(); ++r)
    if (r != own && (to_all || r == 0)) others.push_back(r);
  for (int r = 0; r < ranks.count(); ++r) {
    if (r == own && !others.empty()) {
      Parcel parcel(ranks, others);
      carry_all(r, parcel);
      parcel.close();
    } else if (r != own && (to_all || own == 0)) {
      Parcel parcel(ranks, r);
      carry_all(r, parcel);
    }
  }
}

}  // namespace nugget::system
