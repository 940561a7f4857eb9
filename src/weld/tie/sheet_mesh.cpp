// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/sheet_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "weld/tie/segment.hpp"

namespace nugget::weld {
namespace {

/// The side of a shell with these two nodes, or -1.
int side_with(const std::array<Index, 4>& node, Index a, Index b) {
  for (int k = 0; k < 4; ++k) {
    const Index p = node[k], q = node[(k + 1) % 4];
    if ((p == a && q == b) || (p == b && q == a)) return k;
  }
  return -1;
}

}  // namespace

SheetMesh::SheetMesh(const model::Model& model, const std::vector<Vec3d>& x)
    : model_(model), x_(x), first_(model.nodes.size() + 1, 0) {
  const model::Shells& shells = model.shells;
  const auto corners = [&](std::size_t e) { return shells.triangle(e) ? 3 : 4; };
  for (std::size_t e = 0; e < shells.size(); ++e)
    for (int k = 0; k < corners(e); ++k) ++first_[shells.node[e][k] + 1];
  for (std::size_t n = 0; n < model.nodes.size(); ++n) first_[n + 1] += first_[n];
  shells_.resize(first_.back());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < shells.size(); ++e)
    for (int k = 0; k < corners(e); ++k) shells_[next[shells.node[e][k]]++] = static_cast<Index>(e);
}

std::vector<Index> SheetMesh::across_side(Index shell, int k) const {
  const auto [a, b] = side(shell, k);
  std::vector<Index> found;
  for (const Index other : at(a))
    if (other != shell && side_with(model_.shells.node[other], a, b) >= 0) found.push_back(other);
  return found;
}

int SheetMesh::count_across(Index shell, int k) const {
  const auto [a, b] = side(shell, k);
  int count = 0;
  for (const Index other : at(a))
    if (other != shell && side_with(model_.shells.node[other], a, b) >= 0) ++count;
  return count;
}

SheetMesh::Across SheetMesh::across(Index shell, int k) const {
  const auto [a, b] = side(shell, k);
  Across found;
  for (const Index other : at(a)) {
    if (other == shell) continue;
    const int s = side_with(model_.shells.node[other], a, b);
    if (s < 0) continue;
    if (found.shell != none) return {};
    found = {other, s};
  }
  return found;
}

Vec3d SheetMesh::normal_of(Index shell) const {
  const std::array<Index, 4>& n = model_.shells.node[shell];
  return normal({x_[n[0]], x_[n[1]], x_[n[2]], x_[n[3]]});
}

bool SheetMesh::folded(Index shell, int k, const Across& other) const {
  static const double flat = std::cos(30.0 * std::numbers::pi / 180.0);
  // Neighbours numbered in the same sense run through their common side in opposite ones.
  const double sense = side(shell, k)[0] == side(other.shell, other.side)[1] ? 1.0 : -1.0;
  return sense * dot(normal_of(shell), normal_of(other.shell)) < flat;
}

SheetMesh::Walk SheetMesh::walk(Index shell, int k, int most) const {
  Walk walk;
  while (walk.elements < most) {
    const Across next = across(shell, k);
    if (next.shell == none || folded(shell, k, next)) return {walk.elements, true};
    if (model_.shells.triangle(next.shell)) return walk;
    ++walk.elements;
    shell = next.shell;
    k = (next.side + 2) % 4;
  }
  return walk;
}

std::optional<int> SheetMesh::flange_width(Index shell, int most) const {
  if (model_.shells.triangle(shell)) return std::nullopt;
  std::optional<int> width;
  for (int k = 0; k < 2; ++k) {
    const Walk one = walk(shell, k, most), other = walk(shell, k + 2, most);
    const int elements = 1 + one.elements + other.elements;
    if (one.ended && other.ended && elements <= most) width = std::min(width.value_or(elements), elements);
  }
  return width;
}

}  // namespace nugget::weld
