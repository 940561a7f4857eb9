// SPDX-License-Identifier: Apache-2.0
// What the hits of a surface contact do to its nodes, and what they add up to.
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "contact/couple.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"
#include "system/share.hpp"

namespace nugget::contact {

void SurfaceContact::sum_up(Block& block) const {
  for (const Hit& hit : block.hits) {
    block.resultant += faces_[hit.segment].side == 1 && pressing_ != 1 ? -hit.force : hit.force;
    block.deepest = std::max(block.deepest, hit.depth);
  }
}

/// Lists what of the hits goes to which node, by parts of these; parts in the order in which they are met. Nodes that
/// other ranks follow are left out. `shares`: room for the same in the order of the hits.
void SurfaceContact::share_out(Block& block, std::vector<Share>& shares) const {
  shares.clear();
  for (std::size_t h = 0; h < block.hits.size(); ++h) {
    const Face& face = faces_[block.hits[h].segment];
    const Tracked& tracked = nodes_[block.hits[h].tracked];
    const auto add = [&](int node, signed char corner) {
      const int place = forces_.place(node);
      if (!forces_.left_out(place)) shares.push_back({place, static_cast<int>(h), corner});
    };
    // What is not held here has no node whose forces this rank adds up.
    if (tracked.against != 0) add(tracked.node, Share::the_node);
    for (int c = 0; face.side != 0 && c < face.corners(); ++c) add(face.node[c], static_cast<signed char>(c));
  }
  const auto shares_of = [&block](const Share& share) -> Shares& {
    const int part = share.place / NodalForces::part_size;
    for (Shares& known : block.parts)
      if (known.part == part) return known;
    return block.parts.emplace_back(Shares{part, 0});
  };
  // Counted, then put behind each other.
  for (const Share& share : shares) ++shares_of(share).begin;
  int sum = 0;
  for (Shares& of_part : block.parts) sum += std::exchange(of_part.begin, sum);
  block.shares.resize(shares.size());
  for (const Share& share : shares) block.shares[shares_of(share).begin++] = share;
  int begin = 0;
  for (Shares& of_part : block.parts) begin = std::exchange(of_part.begin, begin);
}

/// Adds to the nodes of a part what of the hits is theirs.
void SurfaceContact::spread(std::size_t part, const Step& step) {
  constexpr int shares_ahead = 24;
  const std::vector<Source>& sources = sources_[part];
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const Source& source = sources[s];
    const Block& block = blocks_[source.block];
    if (s + 2 < sources.size()) __builtin_prefetch(&blocks_[sources[s + 2].block].hits);
    if (s + 1 < sources.size()) {
      const Source& next = sources[s + 1];
      ask_for_lines(&blocks_[next.block].shares[next.begin], at(next.end - next.begin) * sizeof(Share));
      ask_for_lines(blocks_[next.block].hits.data(), 4 * sizeof(Hit));
    }
    for (int i = source.begin; i < source.end; ++i) {
      const Share& share = block.shares[i];
      if (share.corner == Share::the_node && i + shares_ahead < source.end)
        ask_for_lines(&block.hits[block.shares[i + shares_ahead].hit], sizeof(Hit));
      const Hit& hit = block.hits[share.hit];
      if (share.corner == Share::the_node) {
        forces_.add_at(share.place, hit.force, hit.friction);
        continue;
      }
      const double weight = -hit.weight[share.corner];
      forces_.add_at(share.place, weight * hit.force, weight * hit.friction);
      if (!law_.balances_friction) continue;
      const Face& face = faces_[hit.segment];
      const Vec3d lever = vec(step.x[nodes_[hit.tracked].node]) - interpolate(face, hit.weight, step.x);
      const auto back = [&](const Vec3d& force) {
        return couple({face.node.data(), at(face.corners())}, -cross(lever, force), step.x)[share.corner];
      };
      forces_.add_at(share.place, back(hit.force), back(hit.friction));
    }
  }
}

/// Sums up what the blocks found, and books the work of the step.
void SurfaceContact::add_forces(const Step& step, std::span<Row> force) {
  for (std::vector<Source>& sources : sources_) sources.clear();
  const auto add = [this](int b) {
    const Block& block = blocks_[b];
    for (std::size_t i = 0; i < block.parts.size(); ++i) {
      const int end = i + 1 < block.parts.size() ? block.parts[i + 1].begin : static_cast<int>(block.shares.size());
      sources_[block.parts[i].part].push_back({b, block.parts[i].begin, end});
    }
  };
  if (acts_) {
    auto next = arrived_.begin();
    for (const int b : active_blocks_) {
      for (; next != arrived_.end() && *next < b; ++next) add(*next);
      add(b);
    }
    std::for_each(next, arrived_.end(), add);
  }
  parallel_for(forces_.parts(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      forces_.next_cycle(p);
      spread(p, step);
      forces_.add_to(p, force);
      forces_.book_work(p, step.dt, step.v);
    }
  });
}

ContactEnergies SurfaceContact::energies() const {
  ContactEnergies all;
  for (const Block& block : blocks_) all.add(block.energies);
  all.friction = forces_.friction_energy();
  return all;
}

Vec3d SurfaceContact::resultant() const {
  Vec3d sum;
  for (std::size_t b = 0; acts_ && b < blocks_.size(); ++b) sum += blocks_[b].resultant;
  return sum;
}

Vec3d SurfaceContact::resultant_of_all_ranks() const {
  if (share_ == nullptr || rank_of_block_.empty() || !acts_) return resultant();
  std::vector<Vec3d> own(blocks_.size());
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (computes(b)) own[b] = blocks_[b].resultant;
  std::vector<Vec3d> of_all(own.size() * at(share_->ranks().count()));
  share_->ranks().gather(std::as_bytes(std::span(own)), std::as_writable_bytes(std::span(of_all)));
  Vec3d sum;
  for (std::size_t b = 0; b < blocks_.size(); ++b) sum += of_all[at(rank_of_block_[b]) * own.size() + b];
  return sum;
}

int SurfaceContact::touching() const {
  int count = 0;
  each_hit([&count](const Hit&) { ++count; });
  return count;
}

double SurfaceContact::deepest() const {
  double deepest = 0.0;
  for (std::size_t b = 0; acts_ && b < blocks_.size(); ++b) deepest = std::max(deepest, blocks_[b].deepest);
  return deepest;
}

Vec3d SurfaceContact::force_on(std::span<const unsigned char> marked) const {
  if (law_.balances_friction) return forces_.sum(marked);  // the corners have more than the hits tell
  const auto is_marked = [marked](int node) { return at(node) < marked.size() && marked[node] != 0; };
  Vec3d sum;
  each_hit([&](const Hit& hit) {
    const Face& face = faces_[hit.segment];
    if (is_marked(nodes_[hit.tracked].node)) sum += hit.force;
    for (int c = 0; c < face.corners(); ++c)
      if (is_marked(face.node[c])) sum -= hit.weight[c] * hit.force;
  });
  return sum;
}

Vec3d SurfaceContact::force_between(const TwoBodies& bodies) const {
  Vec3d sum;
  each_hit([&](const Hit& hit) {
    sum += bodies.sign({&nodes_[hit.tracked].node, 1}, faces_[hit.segment].node) * hit.force;
  });
  return sum;
}

}  // namespace nugget::contact
