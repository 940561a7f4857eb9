// SPDX-License-Identifier: Apache-2.0
#include "system/ghost_nodes.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "system/share.hpp"

namespace nugget::system {

void GhostNodes::ask_for(const Share& share, std::vector<int> nodes) {
  Ranks& ranks = share.ranks();
  const int count = ranks.count(), own = ranks.rank();
  wanted_.assign(at(count), {});
  given_.assign(at(count), {});
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (const int node : nodes)
    if (!share.follows(node)) wanted_[share.answering(node)].nodes.push_back(node);

  std::vector<int> sizes(at(count)), of_all(at(count) * at(count));
  for (int r = 0; r < count; ++r) sizes[r] = static_cast<int>(wanted_[r].nodes.size());
  ranks.gather(std::as_bytes(std::span(sizes)), std::as_writable_bytes(std::span(of_all)));
  for (int r = 0; r < count; ++r) {
    given_[r].nodes.resize(at(of_all[at(r) * at(count) + at(own)]));
    if (!given_[r].nodes.empty()) ranks.receive(r, std::as_writable_bytes(std::span(given_[r].nodes)));
    if (!wanted_[r].nodes.empty()) ranks.send(r, std::as_bytes(std::span<const int>(wanted_[r].nodes)));
  }
  ranks.finish();
  for (std::vector<Between>* list : {&wanted_, &given_})
    for (Between& between : *list) between.data.resize(2 * between.nodes.size());
}

void GhostNodes::fetch(const Share& share, std::span<Row> x, std::span<Row> v) {
  Ranks& ranks = share.ranks();
  for (int r = 0; r < static_cast<int>(wanted_.size()); ++r)
    if (!wanted_[r].nodes.empty()) ranks.receive(r, std::as_writable_bytes(std::span(wanted_[r].data)));
  for (int r = 0; r < static_cast<int>(given_.size()); ++r) {
    Between& to = given_[r];
    if (to.nodes.empty()) continue;
    for (std::size_t i = 0; i < to.nodes.size(); ++i) {
      const Row &place = x[to.nodes[i]], &velocity = v[to.nodes[i]];
      to.data[2 * i] = {place.x, place.y, place.z};
      to.data[2 * i + 1] = {velocity.x, velocity.y, velocity.z};
    }
    ranks.send(r, std::as_bytes(std::span<const Three>(to.data)));
  }
  ranks.finish();
  for (const Between& from : wanted_)
    for (std::size_t i = 0; i < from.nodes.size(); ++i) {
      const Three &place = from.data[2 * i], &velocity = from.data[2 * i + 1];
      x[from.nodes[i]] = {place.x, place.y, place.z, 0.0};
      v[from.nodes[i]] = {velocity.x, velocity.y, velocity.z, 0.0};
    }
}

std::size_t GhostNodes::size() const {
  std::size_t count = 0;
  for (const Between& from : wanted_) count += from.nodes.size();
  return count;
}

}  // namespace nugget::system
