// SPDX-License-Identifier: Apache-2.0
#include "contact/nodal_forces.hpp"

#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::contact {
namespace {

constexpr std::size_t part_size = 1024;

}  // namespace

NodalForces::NodalForces(std::vector<int> nodes) : nodes_(std::move(nodes)) {
  index_.assign(nodes_.empty() ? 0 : nodes_.back() + 1, -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) index_[nodes_[i]] = static_cast<int>(i);
  side_.assign(nodes_.size(), 0);
  now_.resize(nodes_.size());
  before_.resize(nodes_.size());
  stamp_.assign(nodes_.size(), 0);
  touched_now_.resize((nodes_.size() + part_size - 1) / part_size);
  touched_before_.resize(touched_now_.size());
}

void NodalForces::next_cycle() {
  std::swap(now_, before_);
  std::swap(touched_now_, touched_before_);
  parallel_for(touched_now_.size(), 1, [this](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      for (int place : touched_now_[p]) now_[place] = Row{};
      touched_now_[p].clear();
    }
  });
  ++cycle_;
}

void NodalForces::add(int node, const Vec3d& force) {
  const int place = index_[node];
  if (stamp_[place] != cycle_) {
    stamp_[place] = cycle_;
    touched_now_[place / part_size].push_back(place);
  }
  nugget::add(now_[place], force);
}

NodalForces::Part::Part(NodalForces& forces, std::size_t part)
    : forces_(forces),
      first_(forces.nodes_[part * part_size]),
      last_(forces.nodes_[std::min(forces.nodes_.size(), (part + 1) * part_size) - 1]) {}

void NodalForces::add_by_parts(const std::function<void(Part&)>& put) {
  parallel_for(touched_now_.size(), 1, [this, &put](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      Part part(*this, p);
      put(part);
    }
  });
}

void NodalForces::add_to(std::span<Row> force) const {
  parallel_for(touched_now_.size(), 1, [this, force](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      for (int place : touched_now_[p]) nugget::add(force[nodes_[place]], vec(now_[place]));
  });
}

Vec3d NodalForces::sum(std::span<const unsigned char> marked) const {
  Vec3d sum;
  for (const std::vector<int>& touched : touched_now_)
    for (int place : touched) {
      const auto node = at(nodes_[place]);
      if (node < marked.size() && marked[node]) sum += vec(now_[place]);
    }
  return sum;
}

std::array<double, 2> NodalForces::work(double dt, std::span<const Row> v) const {
  std::vector<std::array<double, 2>> by_part(touched_now_.size(), {0.0, 0.0});
  parallel_for(by_part.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const auto book = [&](int place, const Vec3d& force) {
        by_part[p][side_[place]] += 0.5 * dt * dot(force, vec(v[nodes_[place]]));
      };
      for (int place : touched_now_[p]) book(place, vec(now_[place]) + vec(before_[place]));
      for (int place : touched_before_[p])
        if (stamp_[place] != cycle_) book(place, vec(before_[place]));
    }
  });
  std::array<double, 2> work{};
  for (const std::array<double, 2>& part : by_part)
    for (std::size_t side = 0; side < 2; ++side) work[side] += part[side];
  return work;
}

void NodalForces::archive(Archive& a) {
  a(now_, before_, touched_now_, touched_before_, stamp_, cycle_);
  a.built(nodes_, index_, side_);
}

}  // namespace nugget::contact
