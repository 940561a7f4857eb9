// SPDX-License-Identifier: Apache-2.0
#include "contact/nodal_forces.hpp"

#include <algorithm>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::contact {

NodalForces::NodalForces(std::vector<int> nodes, bool friction)
    : nodes_(std::move(nodes)), work_(nodes_.size()), friction_work_(friction ? nodes_.size() : 0) {
  index_.assign(nodes_.empty() ? 0 : nodes_.back() + 1, -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) index_[nodes_[i]] = static_cast<int>(i);
  side_.assign(nodes_.size(), 0);
  parts_.resize((nodes_.size() + part_size - 1) / part_size);
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
    nugget::add(force[nodes_[now.place[i]]], now.sum[i].force);
  }
}

Vec3d NodalForces::sum(std::span<const unsigned char> marked) const {
  Vec3d sum;
  std::vector<int> order;
  for (const Part& part : parts_) {
    // In the order of places, which is the same after a restart.
    order = part.now.place;
    std::sort(order.begin(), order.end());
    for (const int place : order) {
      const auto node = at(nodes_[place]);
      if (node < marked.size() && marked[node]) sum += part.now.find(place)->force;
    }
  }
  return sum;
}

void NodalForces::book_work(std::size_t part, double dt, std::span<const Row> v) {
  const Touched& now = parts_[part].now;
  const Touched& before = parts_[part].before;
  const bool friction = !friction_work_.empty();
  const auto book = [&](int place, const Vec3d& force, const Vec3d& rubs) {
    if (left_out(place)) return;
    const Vec3d velocity = vec(v[nodes_[place]]);
    work_[place] += 0.5 * dt * dot(force, velocity);
    if (friction) friction_work_[place] += 0.5 * dt * dot(rubs, velocity);
  };
  const Sum nothing;
  for (std::size_t i = 0; i < now.place.size(); ++i) {
    if (i + nodes_ahead < now.place.size()) {
      const int soon = now.place[i + nodes_ahead];
      __builtin_prefetch(&v[nodes_[soon]]);
      __builtin_prefetch(&work_[soon], 1);
    }
    const Sum* found = before.find(now.place[i]);
    const Sum& was = found != nullptr ? *found : nothing;
    book(now.place[i], now.sum[i].force + was.force, now.sum[i].friction + was.friction);
  }
  for (std::size_t i = 0; i < before.place.size(); ++i)
    if (now.find(before.place[i]) == nullptr) book(before.place[i], before.sum[i].force, before.sum[i].friction);
}

void NodalForces::book_work(double dt, std::span<const Row> v) {
  each_part([&](std::size_t p) { book_work(p, dt, v); });
}

std::array<double, 2> NodalForces::energy_of_sides() const {
  std::array<double, 2> energy{};
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Given part = given(p);
    for (std::size_t side = 0; side < 2; ++side) energy[side] += part.of_sides[side];
  }
  return energy;
}

NodalForces::Given NodalForces::given(std::size_t part) const {
  if (const auto known = of_others_.find(part); known != of_others_.end()) return known->second;
  Given given;
  const std::size_t end = std::min(work_.size(), (part + 1) * part_size);
  for (std::size_t i = part * part_size; i < end; ++i) {
    given.of_sides[side_[i]] -= work_[i];
    if (!friction_work_.empty()) given.friction -= friction_work_[i];
  }
  return given;
}

double NodalForces::friction_energy() const {
  double energy = 0.0;
  for (std::size_t p = 0; !friction_work_.empty() && p < parts_.size(); ++p) energy += given(p).friction;
  return energy;
}

void NodalForces::carry(int place, system::Parcel& parcel) {
  parcel(&work_[place], 1);
  if (!friction_work_.empty()) parcel(&friction_work_[place], 1);
  if (parcel.reading()) of_others_.erase(at(place) / part_size);
}

void NodalForces::carry_sum(std::size_t part, system::Parcel& parcel) {
  Given sum;
  if (!parcel.reading()) sum = given(part);
  parcel(&sum, 1);
  if (parcel.reading()) of_others_[part] = sum;
}

/// In the order of places: ranks have come to them in orders of their own.
void NodalForces::archive(Archive& a, const std::function<int(std::size_t)>& giver) {
  const Archive::Holders holders{giver, [this](std::size_t place) { return !left_out(static_cast<int>(place)); }};
  a.parts(work_, holders);
  a.parts(friction_work_, holders);
  for (Part& part : parts_)
    if (a.reading()) part.now.forget();
  a.each_part(nodes_.size(), part_size, holders, [&](std::size_t i, bool here) {
    const int place = static_cast<int>(i);
    Touched& now = parts_[i / part_size].now;
    const Sum* found = here && !a.reading() ? now.find(place) : nullptr;
    Sum sum = found != nullptr ? *found : Sum{};
    char touched = found != nullptr;
    a(touched);
    if (touched == 0) return;
    a(sum);
    if (here && a.reading()) now.at(place) = sum;
  });
  a.built(nodes_, index_, side_, parts_, left_out_, of_others_);
}

}  // namespace nugget::contact
