// SPDX-License-Identifier: Apache-2.0
// What the hits of a surface contact do to its nodes, and what they add up to.
#include <algorithm>
#include <span>
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

/// Lists to which nodes the hits go, and the parts in which these are. Nodes that other ranks follow are left out.
void SurfaceContact::share_out(Block& block) const {
  block.places.resize(block.hits.size());
  for (std::size_t h = 0; h < block.hits.size(); ++h) {
    const Face& face = faces_[block.hits[h].segment];
    const Tracked& tracked = nodes_[block.hits[h].tracked];
    Places& places = block.places[h];
    int last = -1;  // most of a hit is in one part, or two
    const auto put = [&](std::size_t k, bool goes, int node) {
      const int place = goes ? forces_.place(node) : -1;
      places[k] = place;
      if (place < 0) return;
      if (forces_.left_out(place)) {
        places[k] = -1;
        return;
      }
      const int part = place / NodalForces::part_size;
      if (part == last) return;
      last = part;
      for (const int known : block.parts)
        if (known == part) return;
      block.parts.push_back(part);
    };
    // What is not held here has no node whose forces this rank adds up.
    put(0, tracked.against != 0, tracked.node);
    for (std::size_t c = 0; c < 4; ++c) put(c + 1, face.side != 0 && (c < 3 || !face.triangle()), face.node[c]);
  }
}

/// Adds to the nodes of a part what of the hits is theirs, in the order of blocks, hits, and corners.
void SurfaceContact::spread(std::size_t part, const Step& step) {
  const std::vector<int>& sources = sources_[part];
  const int begin = static_cast<int>(part) * NodalForces::part_size, end = begin + NodalForces::part_size;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const Block& block = blocks_[sources[s]];
    if (s + 2 < sources.size()) ask_for_lines(&blocks_[sources[s + 2]], sizeof(Block));
    if (s + 1 < sources.size()) {
      const Block& next = blocks_[sources[s + 1]];
      ask_for_lines(next.places.data(), next.places.size() * sizeof(Places));
      ask_for_lines(next.hits.data(), next.hits.size() * sizeof(Hit));
    }
    forces_.add_to_part(part, [&](const auto& add) {
      for (std::size_t h = 0; h < block.hits.size(); ++h) {
        const Hit& hit = block.hits[h];
        const Places& places = block.places[h];
        if (places[0] >= begin && places[0] < end) add(places[0], 1.0, hit.force, hit.friction);
        for (std::size_t c = 0; c < 4; ++c) {
          const int place = places[c + 1];
          if (place < begin || place >= end) continue;
          add(place, -hit.weight[c], hit.force, hit.friction);
          if (!law_.balances_friction) continue;
          const Face& face = faces_[hit.segment];
          const Vec3d lever = vec(step.x[nodes_[hit.tracked].node]) - interpolate(face, hit.weight, step.x);
          const auto back = [&](const Vec3d& force) {
            return couple({face.node.data(), at(face.corners())}, -cross(lever, force), step.x)[c];
          };
          add(place, 1.0, back(hit.force), back(hit.friction));
        }
      }
    });
  }
}

/// Sums up what the blocks found, and books the work of the step.
void SurfaceContact::add_forces(const Step& step, std::span<Row> force) {
  for (std::vector<int>& sources : sources_) sources.clear();
  const auto add = [this](int b) {
    for (const int part : blocks_[b].parts) sources_[part].push_back(b);
  };
  if (acts_) {
    auto next = arrived_.begin();
    for (const int b : active_blocks_) {
      for (; next != arrived_.end() && *next < b; ++next) add(*next);
      add(b);
    }
    std::for_each(next, arrived_.end(), add);
  }
  parallel_for(forces_.parts(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
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
