// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <type_traits>

#include "base/batch.hpp"
#include "base/vec3.hpp"

namespace nugget::system {

/// The steps by which the stiffness of an element is found: to both sides, of which the mean counts, where its law may
/// pull with another slope than it pushes (docs/decisions/0145).
template <class Element>
constexpr auto signs_of_steps() {
  if constexpr (requires(const Element& kernel) {
                  requires std::remove_cvref_t<decltype(kernel.law)>::may_pull_otherwise;
                })
    return std::array{1.0, -1.0};
  else
    return std::array{1.0};
}

/// Adds a share of a lane of `f` to three rows of a column of the square matrix k.
template <class R>
void add_to_column(std::span<double> k, int size, int row, int column, const Vec3<R>& f, int lane, double share) {
  for (const R* c : {&f.x, &f.y, &f.z}) k[row++ * size + column] += share * nugget::lane(*c, lane);
}

/// An element for motions so small that its forces are linear in them: its law without the pressure that an equation of
/// state has at the start (`linear_at_start()`), where it has one; else itself.
template <class Element>
Element for_small_motions(Element kernel) {
  if constexpr (requires { kernel.law.linear_at_start(); }) kernel.law = kernel.law.linear_at_start();
  return kernel;
}

/// An element without its viscous forces, where it has such (`inviscid()`); else itself.
template <class Element>
Element without_viscosity(const Element& kernel) {
  if constexpr (requires { kernel.inviscid(); })
    return kernel.inviscid();
  else
    return kernel;
}

}  // namespace nugget::system
