// SPDX-License-Identifier: Apache-2.0
#include "contact/interior_contact.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "kernel/contact/penalty.hpp"
#include "kernel/contact/squeeze.hpp"

namespace nugget::contact {
namespace {

kernel::BrickHeights heights(const SqueezedBrick& brick, std::span<const Row> x) {
  Vec3d corner[8];
  for (int i = 0; i < 8; ++i) corner[i] = vec(x[brick.node[i]]);
  return kernel::BrickHeights(corner);
}

std::vector<int> nodes_of(const std::vector<SqueezedBrick>& bricks) {
  std::vector<int> nodes;
  for (const SqueezedBrick& b : bricks) nodes.insert(nodes.end(), b.node.begin(), b.node.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace

InteriorContact::InteriorContact(std::vector<SqueezedBrick> bricks, std::span<const Row> x)
    : bricks_(std::move(bricks)), forces_(nodes_of(bricks_), false), squeezed_(bricks_.size(), 0) {
  for (const SqueezedBrick& brick : bricks_) {
    const kernel::BrickHeights start = heights(brick, x);
    threshold_.push_back(brick.activation * start.least());
    stiffness_.push_back(brick.modulus * std::cbrt(start.volume() * start.volume()) / start.least());
  }
}

void InteriorContact::apply(const Step& step, std::span<Row> force) {
  parallel_for(bricks_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const bool alive = step.element_alive.empty() || step.element_alive[bricks_[e].element];
      squeezed_[e] = alive && heights(bricks_[e], step.x).least() < threshold_[e];
    }
  });
  forces_.next_cycle();
  pressed_ = 0;
  for (std::size_t e = 0; e < bricks_.size(); ++e) {
    if (!squeezed_[e]) continue;
    ++pressed_;
    const SqueezedBrick& brick = bricks_[e];
    const kernel::BrickHeights now = heights(brick, step.x);
    for (int pair = 0; pair < 3; ++pair) {
      const double depth = threshold_[e] - now.height(pair);
      if (!(depth > 0.0)) continue;
      const std::array<Vec3d, 8> gradient = now.gradient(pair);
      double inverse_mass = 0.0;
      for (int i = 0; i < 8; ++i)
        if (const double mass = step.mass[brick.node[i]]; mass > 0.0)
          inverse_mass += dot(gradient[i], gradient[i]) / mass;
      // Eight bricks share a node, and all of them may be squeezed.
      const double stiffness = kernel::pair_stiffness({}, stiffness_[e], 8.0 * inverse_mass, step.stable_dt);
      for (int i = 0; i < 8; ++i) forces_.add(brick.node[i], stiffness * depth * gradient[i]);
    }
  }
  forces_.add_to(force);
  forces_.book_work(step.dt, step.v);
}

void InteriorContact::archive(Archive& a) {
  a.section("interior contact");
  a(forces_, pressed_);
  a.built(bricks_, threshold_, stiffness_, squeezed_);
}

}  // namespace nugget::contact
