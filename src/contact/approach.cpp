// SPDX-License-Identifier: Apache-2.0
#include "contact/approach.hpp"

#include <utility>

namespace nugget::contact {

void Approach::start(std::vector<int> nodes, std::span<const Row> x) {
  nodes_ = std::move(nodes);
  start_.clear();
  for (int n : nodes_) start_.push_back(x[n]);
  last_ = start_;
  since_start_ = 0.0;
}

void Approach::update(std::span<const Row> x) {
  if (nodes_.empty()) return;
  Box since_start, step;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Vec3d at = vec(x[nodes_[i]]);
    since_start.add(at - vec(start_[i]));
    step.add(at - vec(last_[i]));
    last_[i] = x[nodes_[i]];
  }
  since_start_ = norm(since_start.high - since_start.low);
  travelled_ += norm(step.high - step.low);
}

void Approach::archive(Archive& a) {
  a(nodes_, start_, last_, since_start_, travelled_);
}

}  // namespace nugget::contact
