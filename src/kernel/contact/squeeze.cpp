// SPDX-License-Identifier: Apache-2.0
#include "kernel/contact/squeeze.hpp"

#include <limits>

#include "kernel/element/uniform_gradient.hpp"

namespace nugget::kernel {

BrickHeights::BrickHeights(const Vec3d (&x)[8]) {
  const Patterns<double> p = patterns_of(x);
  const Gradient<double> g(p);
  side_ = {p.a, p.b, p.c};
  volume_side_ = {g.a, g.b, g.c};
  volume_twist_ = {g.h[0], g.h[1], g.h[2]};
  volume_ = g.volume;
  for (int k = 0; k < 3; ++k) {
    area_[k] = 4.0 * cross(side_[(k + 1) % 3], side_[(k + 2) % 3]);
    const double area = norm(area_[k]);
    height_[k] = area > 0.0 ? volume_ / area : std::numeric_limits<double>::infinity();
  }
}

std::array<Vec3d, 8> BrickHeights::gradient(int pair) const {
  const double area = norm(area_[pair]);
  const Vec3d normal = (1.0 / area) * area_[pair];
  Patterns<double> p{
      volume_side_[0], volume_side_[1], volume_side_[2], {volume_twist_[0], volume_twist_[1], volume_twist_[2], {}}};
  // The area is 4 |u x v| of the two sides along the surface, and a corner moves an eighth of itself into each pattern.
  Vec3d* const side[3] = {&p.a, &p.b, &p.c};
  const int u = (pair + 1) % 3, v = (pair + 2) % 3;
  *side[u] -= 0.5 * height_[pair] * cross(side_[v], normal);
  *side[v] -= 0.5 * height_[pair] * cross(normal, side_[u]);
  Vec3d f[8];
  nodes_of(p, f);
  std::array<Vec3d, 8> gradient;
  for (int i = 0; i < 8; ++i) gradient[i] = (1.0 / area) * f[i];
  return gradient;
}

}  // namespace nugget::kernel
