// SPDX-License-Identifier: Apache-2.0
#include "nvh/statics/loose_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/index.hpp"
#include "nvh/matrices/dense.hpp"
#include "nvh/matrices/nodal.hpp"
#include "nvh/matrices/resistance.hpp"

namespace nugget::nvh {
namespace {

using Six = std::array<double, 6>;

/// Which unknowns are joined by stiffness or are of one node, by the first one of each.
std::vector<int> connected(const Matrices& m) {
  const Symmetric& k = m.stiffness;
  std::vector<int> first(k.size());
  std::iota(first.begin(), first.end(), 0);
  const auto root = [&first](int i) {
    while (first[at(i)] != i) i = first[at(i)] = first[at(first[at(i)])];
    return i;
  };
  const auto join = [&](int i, int j) {
    const int a = root(i), b = root(j);
    first[at(std::max(a, b))] = std::min(a, b);
  };
  for (std::size_t j = 0; j < k.size(); ++j) {
    const int i = static_cast<int>(j);
    if (i > 0 && m.equations.node_of(i) == m.equations.node_of(i - 1)) join(i, i - 1);
    for (std::size_t e = 1; e < k.rows(j).size(); ++e)
      if (k.values(j)[e] != 0.0) join(i, k.rows(j)[e]);
  }
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = root(static_cast<int>(i));
  return first;
}

/// Middle and size of what is joined, by which its rigid motions are of one size.
struct Extent {
  std::size_t unknowns = 0;
  Vec3d middle{};
  double size = 0.0;
};

std::vector<Extent> extents(const Matrices& m, const std::vector<int>& body) {
  std::vector<Extent> extent(body.size());
  const auto place = [&](std::size_t i) { return m.place(at(m.equations.node_of(static_cast<int>(i)))); };
  for (std::size_t i = 0; i < body.size(); ++i) {
    Extent& e = extent[at(body[i])];
    ++e.unknowns;
    e.middle += place(i);
  }
  for (Extent& e : extent)
    if (e.unknowns > 0) e.middle = (1.0 / static_cast<double>(e.unknowns)) * e.middle;
  for (std::size_t i = 0; i < body.size(); ++i) {
    Extent& e = extent[at(body[i])];
    e.size = std::max(e.size, norm(place(i) - e.middle));
  }
  for (Extent& e : extent)
    if (e.size == 0.0) e.size = 1.0;
  return extent;
}

/// What an unknown does in the translations of its body along x, y, z, and in the turns about its middle by 1/size.
Six rigid_motions(const Matrices& m, int unknown, const Extent& body) {
  const int node = m.equations.node_of(unknown);
  SixDof own{};  // direction of the unknown
  for (int i = 0; i < 6; ++i)
    for (const Equations::Term& term : m.equations.terms(node, i))
      if (term.equation == unknown) own[at(i)] += term.factor;
  const Vec3d d = part_of(own, false), spin = part_of(own, true);
  const Vec3d turns = (1.0 / body.size) * (cross(m.place(at(node)) - body.middle, d) + spin);
  return {d.x, d.y, d.z, turns.x, turns.y, turns.z};
}

constexpr double alike = 1e-12;      // of the largest eigenvalue: what may be none
constexpr double round_off = 1e-12;  // of the terms of which a force is the sum

}  // namespace

std::vector<LooseBody> find_loose_bodies(const Matrices& m) {
  const Symmetric& k = m.stiffness;
  const std::vector<int> body = connected(m);
  const std::vector<Extent> extent = extents(m, body);
  std::vector<Six> motion(k.size());
  for (std::size_t i = 0; i < k.size(); ++i) motion[i] = rigid_motions(m, static_cast<int>(i), extent[at(body[i])]);

  // Forces K r of the six motions, and the size of their terms.
  std::vector<Six> force(k.size(), Six{});
  std::vector<double> size(k.size(), 0.0);
  const auto largest = [](const Six& r) {
    double most = 0.0;
    for (const double x : r) most = std::max(most, std::abs(x));
    return most;
  };
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    for (std::size_t w = 0; w < 6; ++w) force[row][w] += value * motion[column][w];
    size[row] += std::abs(value) * largest(motion[column]);
  };
  for (std::size_t j = 0; j < k.size(); ++j)
    for (std::size_t e = 0; e < k.rows(j).size(); ++e) {
      const std::size_t i = at(k.rows(j)[e]);
      add(i, j, k.values(j)[e]);
      if (i != j) add(j, i, k.values(j)[e]);
    }

  // Sums of squares of the forces as shares of their terms: a motion without any is an eigenvector of 0.
  std::vector<std::vector<std::size_t>> rows(k.size());
  for (std::size_t i = 0; i < k.size(); ++i)
    if (size[i] > 0.0) rows[at(body[i])].push_back(i);
  std::vector<LooseBody> found;
  for (std::size_t b = 0; b < k.size(); ++b) {
    if (rows[b].empty()) continue;
    Columns squares(6, 6);
    for (const std::size_t i : rows[b])
      for (std::size_t w = 0; w < 6; ++w)
        for (std::size_t v = 0; v <= w; ++v) squares[v][w] += force[i][w] * force[i][v] / (size[i] * size[i]);
    const std::vector<double> value = diagonalize(squares);
    LooseBody loose;
    loose.unknowns = extent[b].unknowns;
    double most = 0.0;
    for (std::size_t s = 0; s < 6 && value[s] <= alike * std::max(value[5], 1.0); ++s) {
      const auto sum = [&](const Six& of) {
        double total = 0.0;
        for (std::size_t w = 0; w < 6; ++w) total += of[w] * squares[s][w];
        return total;
      };
      if (std::ranges::any_of(rows[b], [&](std::size_t i) { return std::abs(sum(force[i])) > round_off * size[i]; }))
        continue;
      // A turn about an axis through all that is there moves nothing.
      if (std::ranges::all_of(rows[b], [&](std::size_t i) { return std::abs(sum(motion[i])) <= round_off; })) continue;
      if (loose.ways++ > 0) continue;
      for (const std::size_t i : rows[b]) {
        const int node = m.equations.node_of(static_cast<int>(i));
        const Vec3d r = m.place(at(node)) - extent[b].middle;
        const Vec3d u = Vec3d{squares[s][0], squares[s][1], squares[s][2]} +
                        (1.0 / extent[b].size) * cross(Vec3d{squares[s][3], squares[s][4], squares[s][5]}, r);
        if (norm(u) <= most * (1.0 + 1e-9)) continue;
        most = norm(u);
        loose.node = node;
        loose.along = unit(u);
      }
    }
    if (loose.ways > 0) found.push_back(loose);
  }
  return found;
}

void check_support(const Matrices& m, Findings& findings) {
  const std::vector<LooseBody> loose = find_loose_bodies(m);
  if (loose.empty()) return;
  const LooseBody& first = loose.front();
  findings.error({m.system.model.deck, 0, 0}, "*CONTROL_IMPLICIT_GENERAL",
                 fmt::format("the structure is not held: {} and what is joined to it ({} unknowns) can move as a "
                             "rigid body in {} way{}, along ({:.3g} {:.3g} {:.3g}) there{}",
                             name_of(m.system, first.node), first.unknowns, first.ways, first.ways == 1 ? "" : "s",
                             first.along.x, first.along.y, first.along.z,
                             loose.size() == 1 ? "" : fmt::format(", and so can {} more", loose.size() - 1)),
                 "hold it (*BOUNDARY_SPC_..., *MAT_RIGID), join it to what is held, or ask for its modes (NEIG)");
}

}  // namespace nugget::nvh
