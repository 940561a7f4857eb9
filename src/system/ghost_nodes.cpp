// SPDX-License-Identifier: Apache-2.0
#include "system/ghost_nodes.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "system/exchange.hpp"
#include "system/share.hpp"

namespace nugget::system {

void GhostNodes::ask_for(const Share& share, std::vector<int> nodes) {
  wanted_.assign(at(share.ranks().count()), {});
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (const int node : nodes)
    if (!share.follows(node)) wanted_[share.answering(node)].push_back(node);
  exchange(share.ranks(), wanted_, given_);
  arrived_.resize(wanted_.size());
  leaving_.resize(given_.size());
  for (std::size_t r = 0; r < wanted_.size(); ++r) {
    arrived_[r].resize(2 * wanted_[r].size());
    leaving_[r].resize(2 * given_[r].size());
  }
}

void GhostNodes::fetch(const Share& share, std::span<Row> x, std::span<Row> v) {
  Ranks& ranks = share.ranks();
  for (int r = 0; r < static_cast<int>(wanted_.size()); ++r)
    if (!wanted_[r].empty()) ranks.receive(r, std::as_writable_bytes(std::span(arrived_[r])));
  for (int r = 0; r < static_cast<int>(given_.size()); ++r) {
    if (given_[r].empty()) continue;
    Three* next = leaving_[r].data();
    for (const int node : given_[r])
      for (const Row* row : {&x[node], &v[node]}) *next++ = {row->x, row->y, row->z};
    ranks.send(r, std::as_bytes(std::span<const Three>(leaving_[r])));
  }
  ranks.finish();
  for (std::size_t r = 0; r < wanted_.size(); ++r) {
    const Three* next = arrived_[r].data();
    for (const int node : wanted_[r])
      for (Row* row : {&x[node], &v[node]}) {
        *row = {next->x, next->y, next->z, 0.0};
        ++next;
      }
  }
}

std::size_t GhostNodes::size() const {
  std::size_t count = 0;
  for (const std::vector<int>& from : wanted_) count += from.size();
  return count;
}

}  // namespace nugget::system
