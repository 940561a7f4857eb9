// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/resistance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/index.hpp"
#include "nvh/matrices/dense.hpp"

namespace nugget::nvh {
namespace {

/// The part of K between the unknowns of one node, and its eigenvectors.
struct OwnBlock {
  int first = 0, count = 0;
  std::array<std::array<double, 3>, 3> k{};
  std::array<double, 3> value{};
  std::array<std::array<double, 3>, 3> vector{};  ///< of each eigenvalue
  int unresisted = 0;                             ///< of the lowest eigenvalues
};

/// Whether the determinant is small beside the product of the diagonal: cheap, and most nodes go no further.
bool may_be_singular(const OwnBlock& b) {
  const auto& k = b.k;
  double product = 1.0;
  for (int i = 0; i < b.count; ++i) product *= k[at(i)][at(i)];
  const double determinant = b.count == 2 ? k[0][0] * k[1][1] - k[0][1] * k[1][0]
                                          : k[0][0] * (k[1][1] * k[2][2] - k[1][2] * k[2][1]) -
                                                k[0][1] * (k[1][0] * k[2][2] - k[1][2] * k[2][0]) +
                                                k[0][2] * (k[1][0] * k[2][1] - k[1][1] * k[2][0]);
  return !(determinant > 1e-10 * product);
}

/// Finds its eigenvalues, and how many of the lowest are round-off.
void diagonalize_block(OwnBlock& b) {
  Columns a(at(b.count), at(b.count));
  for (std::size_t j = 0; j < a.count; ++j)
    for (std::size_t i = 0; i < a.rows; ++i) a[j][i] = b.k[i][j];
  const std::vector<double> value = diagonalize(a);
  for (std::size_t j = 0; j < a.count; ++j) {
    b.value[j] = value[j];
    for (std::size_t i = 0; i < a.rows; ++i) b.vector[j][i] = a[j][i];
    b.unresisted += std::abs(value[j]) <= 1e-13 * value.back();
  }
}

/// Blocks of two and three unknowns that nothing resists in some direction, as far as these alone show.
std::vector<OwnBlock> singular_blocks(const Equations& equations, const Symmetric& k) {
  std::vector<OwnBlock> found;
  for (int first = 0; first < equations.size();) {
    OwnBlock b{first, 1, {}, {}, {}, 0};
    while (first + b.count < equations.size() && b.count < 3 &&
           equations.node_of(first + b.count) == equations.node_of(first) &&
           equations.is_rotation(first + b.count) == equations.is_rotation(first))
      ++b.count;
    first += b.count;
    if (b.count == 1) continue;
    for (int j = 0; j < b.count; ++j) {
      const auto column = at(b.first + j);
      for (std::size_t e = 0; e < k.rows(column).size() && k.rows(column)[e] < b.first + b.count; ++e) {
        const std::size_t i = at(k.rows(column)[e] - b.first);
        b.k[i][at(j)] = b.k[at(j)][i] = k.values(column)[e];
      }
    }
    if (!may_be_singular(b)) continue;
    diagonalize_block(b);
    if (b.unresisted > 0 && b.unresisted < b.count) found.push_back(b);
  }
  return found;
}

/// Forgets blocks whose directions other nodes resist, which a matrix with a preload may have: the whole column counts.
void keep_unresisted(const Symmetric& k, std::vector<OwnBlock>& blocks) {
  std::vector<int> block_of(k.size(), -1);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    std::fill_n(block_of.begin() + blocks[b].first, blocks[b].count, static_cast<int>(b));
  std::vector<std::map<int, std::array<double, 3>>> column(blocks.size());  // rows elsewhere, by direction
  const auto add = [&](int own, int other, double value) {
    const int b = block_of[at(own)];
    if (b < 0 || block_of[at(other)] == b) return;
    const OwnBlock& block = blocks[at(b)];
    std::array<double, 3>& sum = column[at(b)][other];
    for (std::size_t d = 0; d < at(block.unresisted); ++d) sum[d] += value * block.vector[d][at(own - block.first)];
  };
  for (std::size_t j = 0; j < k.size(); ++j)
    for (std::size_t e = 1; e < k.rows(j).size(); ++e) {
      const int i = k.rows(j)[e];
      add(static_cast<int>(j), i, k.values(j)[e]);
      add(i, static_cast<int>(j), k.values(j)[e]);
    }
  std::size_t next = 0;
  std::erase_if(blocks, [&](const OwnBlock& b) {
    const auto& rows = column[next++];
    const double most = b.value[at(b.count - 1)];
    return std::ranges::any_of(rows, [&](const auto& row) {
      const double limit = 1e-11 * std::sqrt(most * std::max(most, std::abs(k.diagonal(at(row.first)))));
      return std::ranges::any_of(row.second, [&](double v) { return std::abs(v) > limit; });
    });
  });
}

}  // namespace

std::vector<char> unresisted(const Symmetric& k) {
  std::vector<char> loose(k.size(), 1);
  for (std::size_t j = 0; j < k.size(); ++j)
    for (std::size_t i = 0; i < k.rows(j).size(); ++i)
      if (k.values(j)[i] != 0.0) loose[j] = loose[k.rows(j)[i]] = 0;
  return loose;
}

std::vector<Equations::Turned> unresisted_askew(const Equations& equations, const Symmetric& k) {
  std::vector<OwnBlock> blocks = singular_blocks(equations, k);
  if (!blocks.empty()) keep_unresisted(k, blocks);
  std::vector<Equations::Turned> turned;
  for (const OwnBlock& b : blocks) {
    Equations::Turned t{b.first, b.count, b.count - b.unresisted, {}};
    for (int d = 0; d < b.count; ++d)
      for (int i = 0; i < b.count; ++i) t.basis[at(i * b.count + d)] = b.vector[at(b.count - 1 - d)][at(i)];
    turned.push_back(t);
  }
  return turned;
}

std::vector<UnresistedLoad> unresisted_loads(const Matrices& m, Nodal load) {
  const Equations& equations = m.equations;
  transfer_forces(m.system, load);
  double most_force = 0.0, most_moment = 0.0;
  for (const SixDof& f : load) {
    most_force = std::max(most_force, norm(part_of(f, false)));
    most_moment = std::max(most_moment, norm(part_of(f, true)));
  }
  std::vector<UnresistedLoad> found;
  if (!(most_force > 0.0) && !(most_moment > 0.0)) return found;
  std::map<int, std::vector<Vec3d>> held[2];  // directions of nodes that supports take
  for (const Equations::Support& s : equations.supports())
    if (dot(s.taken, s.taken) > 0.0) held[s.rotation][s.node].push_back(s.taken);
  for (std::size_t k = 0; k < load.size(); ++k)
    for (const bool rotation : {false, true}) {
      const Vec3d f = part_of(load[k], rotation);
      const int node = static_cast<int>(k), first = rotation ? 3 : 0;
      if (!(norm(f) > 1e-9 * (rotation ? most_moment : most_force))) continue;
      std::map<int, Vec3d> moves;  // by unknown
      bool others = false;         // a linear equation gives its motion by that of other nodes
      for (int i = 0; i < 3; ++i)
        for (const Equations::Term& t : equations.terms(node, first + i)) {
          others = others || equations.node_of(t.equation) != node;
          Vec3d& d = moves[t.equation];
          (i == 0 ? d.x : i == 1 ? d.y : d.z) += t.factor;
        }
      if (others) continue;
      Vec3d rest = f;
      for (const auto& [equation, d] : moves) rest -= dot(d, rest) * d;
      const auto supports = held[rotation].find(node);
      const bool is_held = supports != held[rotation].end();
      if (is_held)
        for (const Vec3d& d : supports->second) rest -= dot(d, rest) * d;
      if (norm(rest) > 1e-9 * norm(f)) found.push_back({node, rotation, moves.empty() && !is_held, unit(rest)});
    }
  return found;
}

std::string name_of(const system::System& system, int node) {
  if (at(node) < system.nodes) return fmt::format("node {}", system.model.nodes.id[system.model_node[at(node)]]);
  const std::size_t body = at(node) - system.nodes;
  return body < system.bodies.size() ? fmt::format("rigid body {}", system.bodies[body].id) : "a tie";
}

}  // namespace nugget::nvh
