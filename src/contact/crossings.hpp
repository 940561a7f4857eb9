// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "contact/surface_contact.hpp"

namespace nugget::contact {

/// An edge of a shell that goes through another shell.
struct Crossing {
  std::array<int, 2> edge{};  ///< its nodes, the lower one first
  int segment = 0;            ///< through which it goes: position in the setup

  auto operator<=>(const Crossing&) const = default;
};

/// Edges of the shells `begin` to `end` of a setup that go through other shells (of two surfaces: of the other one),
/// with the nodes at `x`: the two shells have no node or place in common, and the edge meets the other one, as two
/// triangles, clear of its ends and of the other one's border by a hundredth of the contact thickness at least. In
/// order, each pair once.
std::vector<Crossing> find_crossings(const SurfaceContactSetup& setup, std::span<const Row> x, std::size_t begin,
                                     std::size_t end);

}  // namespace nugget::contact
