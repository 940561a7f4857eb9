// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/result_parcels.hpp"

#include "base/index.hpp"
#include "system/share.hpp"

namespace nugget::impact {

ResultParcels::ResultParcels(const system::System& system) : system_(system) {
  const system::Share* share = system.share();
  if (share == nullptr) return;
  Ranks& ranks = share->ranks();
  rank_ = ranks.rank();
  if (rank_ != 0) {
    to_first_.emplace(ranks, std::vector<int>{0});
    return;
  }
  from_.resize(at(ranks.count()));
  for (int r = 1; r < ranks.count(); ++r) from_[at(r)].emplace(ranks, r);
}

int ResultParcels::owner(const system::System::ElementLocation& location) const {
  if (system_.share() == nullptr || location.group < 0) return 0;
  return std::max(0, system_.share()->partition().of_element(location));
}

int ResultParcels::owner_of_node(std::size_t node) const {
  const system::Share* share = system_.share();
  const auto k = static_cast<int>(node);
  return share == nullptr || share->everyone_follows(k) ? 0 : share->answering(k);
}

void ResultParcels::close() {
  if (to_first_) to_first_->close();
}

}  // namespace nugget::impact
