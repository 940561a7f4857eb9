// SPDX-License-Identifier: Apache-2.0
#include "contact/nodal_forces.hpp"

#include <utility>

namespace nugget::contact {

NodalForces::NodalForces(std::vector<int> nodes) : nodes_(std::move(nodes)) {
  index_.assign(nodes_.empty() ? 0 : nodes_.back() + 1, -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) index_[nodes_[i]] = static_cast<int>(i);
  side_.assign(nodes_.size(), 0);
  now_.resize(nodes_.size());
  before_.resize(nodes_.size());
  stamp_.assign(nodes_.size(), 0);
  touched_now_.reserve(nodes_.size());
  touched_before_.reserve(nodes_.size());
}

void NodalForces::next_cycle() {
  std::swap(now_, before_);
  std::swap(touched_now_, touched_before_);
  for (int place : touched_now_) now_[place] = Row{};
  touched_now_.clear();
  ++cycle_;
}

void NodalForces::add(int node, const Vec3d& force) {
  const int place = index_[node];
  if (stamp_[place] != cycle_) {
    stamp_[place] = cycle_;
    touched_now_.push_back(place);
  }
  nugget::add(now_[place], force);
}

void NodalForces::add_to(std::span<Row> force) const {
  for (int place : touched_now_) nugget::add(force[nodes_[place]], vec(now_[place]));
}

Vec3d NodalForces::sum(std::span<const unsigned char> marked) const {
  Vec3d sum;
  for (int place : touched_now_) {
    const auto node = static_cast<std::size_t>(nodes_[place]);
    if (node < marked.size() && marked[node]) sum += vec(now_[place]);
  }
  return sum;
}

std::array<double, 2> NodalForces::work(double dt, std::span<const Row> v) const {
  std::array<double, 2> work{};
  const auto book = [&](int place, const Vec3d& force) {
    work[side_[place]] += 0.5 * dt * dot(force, vec(v[nodes_[place]]));
  };
  for (int place : touched_now_) book(place, vec(now_[place]) + vec(before_[place]));
  for (int place : touched_before_)
    if (stamp_[place] != cycle_) book(place, vec(before_[place]));
  return work;
}

}  // namespace nugget::contact
