// SPDX-License-Identifier: Apache-2.0
#include "contact/nodal_forces.hpp"

#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::contact {

NodalForces::NodalForces(std::vector<int> nodes) : nodes_(std::move(nodes)) {
  index_.assign(nodes_.empty() ? 0 : nodes_.back() + 1, -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) index_[nodes_[i]] = static_cast<int>(i);
  side_.assign(nodes_.size(), 0);
  parts_.resize((nodes_.size() + part_size - 1) / part_size);
  for (Part& part : parts_)
    for (Touched* list : {&part.now, &part.before}) list->slot.assign(part_size, 0);
}

void NodalForces::each_part(const std::function<void(std::size_t)>& call) const {
  parallel_for(parts_.size(), 1, [&call](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) call(p);
  });
}

void NodalForces::next_cycle() {
  each_part([this](std::size_t p) { next_cycle(p); });
}

void NodalForces::next_cycle(std::size_t part) {
  std::swap(parts_[part].now, parts_[part].before);
  parts_[part].now.place.clear();
  parts_[part].now.sum.clear();
}

void NodalForces::add_to(std::span<Row> force) const {
  each_part([this, force](std::size_t p) { add_to(p, force); });
}

void NodalForces::add_to(std::size_t part, std::span<Row> force) const {
  const Touched& now = parts_[part].now;
  for (std::size_t i = 0; i < now.place.size(); ++i) {
    if (i + nodes_ahead < now.place.size()) __builtin_prefetch(&force[nodes_[now.place[i + nodes_ahead]]], 1);
    nugget::add(force[nodes_[now.place[i]]], vec(now.sum[i].force));
  }
}

Vec3d NodalForces::sum(std::span<const unsigned char> marked) const {
  Vec3d sum;
  for (const Part& part : parts_)
    for (std::size_t i = 0; i < part.now.place.size(); ++i) {
      const auto node = at(nodes_[part.now.place[i]]);
      if (node < marked.size() && marked[node]) sum += vec(part.now.sum[i].force);
    }
  return sum;
}

NodalForces::Work NodalForces::work(std::size_t part, double dt, std::span<const Row> v) const {
  const Touched& now = parts_[part].now;
  const Touched& before = parts_[part].before;
  Work work;
  const auto book = [&](int place, const Vec3d& force, const Vec3d& friction) {
    const Vec3d velocity = vec(v[nodes_[place]]);
    work.of_side[side_[place]] += 0.5 * dt * dot(force, velocity);
    work.friction += 0.5 * dt * dot(friction, velocity);
  };
  const Sum nothing;
  for (std::size_t i = 0; i < now.place.size(); ++i) {
    if (i + nodes_ahead < now.place.size()) __builtin_prefetch(&v[nodes_[now.place[i + nodes_ahead]]]);
    const Sum* found = before.find(now.place[i]);
    const Sum& was = found != nullptr ? *found : nothing;
    book(now.place[i], vec(now.sum[i].force) + vec(was.force), vec(now.sum[i].friction) + vec(was.friction));
  }
  for (std::size_t i = 0; i < before.place.size(); ++i)
    if (now.find(before.place[i]) == nullptr)
      book(before.place[i], vec(before.sum[i].force), vec(before.sum[i].friction));
  return work;
}

NodalForces::Work NodalForces::work(double dt, std::span<const Row> v) const {
  std::vector<Work> by_part(parts_.size());
  each_part([&](std::size_t p) { by_part[p] = work(p, dt, v); });
  Work all;
  for (const Work& part : by_part) all.add(part);
  return all;
}

void NodalForces::archive(Archive& a) {
  a(parts_);
  a.built(nodes_, index_, side_);
}

}  // namespace nugget::contact
