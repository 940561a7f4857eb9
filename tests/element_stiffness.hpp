// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "base/vec3.hpp"

namespace nugget {

/// A step so short that it moves nothing, and a power of two: a force divided by it is the exact derivative
/// (docs/decisions/0017).
inline constexpr double no_step = 0x1p-100;

/// Stiffness of an element, row by row: force in each freedom over displacement in each. `rest` holds the places of its
/// nodes; cycle(motion, step) gives the forces of a new element after a step, without viscosity, which does not go
/// with the step. Freedoms: of nodes with spins six, else three.
template <class Motion, class Cycle>
std::vector<double> element_stiffness(Motion rest, Cycle&& cycle) {
  constexpr bool turns = requires {
    rest.w;
  };
  constexpr std::size_t per_node = turns ? 6 : 3;
  const std::size_t corners = std::size(rest.x), size = per_node * corners;
  double Vec3d::*const axis[3] = {&Vec3d::x, &Vec3d::y, &Vec3d::z};
  std::fill(std::begin(rest.v), std::end(rest.v), Vec3d{});
  if constexpr (turns) std::fill(std::begin(rest.w), std::end(rest.w), Vec3d{});
  std::vector<double> k(size * size);
  for (std::size_t j = 0; j < size; ++j) {
    Motion motion = rest;
    Vec3d* moved = &motion.v[j / per_node];
    if constexpr (turns)
      if (j % 6 > 2) moved = &motion.w[j / 6];
    moved->*axis[j % 3] = 1.0;
    const auto out = cycle(motion, no_step);
    for (std::size_t i = 0; i < size; ++i) {
      const Vec3d* force = &out.f[i / per_node];
      if constexpr (turns)
        if (i % 6 > 2) force = &out.m[i / 6];
      k[size * i + j] = force->*axis[i % 3] / no_step;
    }
  }
  return k;
}

}  // namespace nugget
