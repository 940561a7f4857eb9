// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/elimination_order.hpp"

#include <metis.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/index.hpp"

namespace nugget::nvh {
namespace {

/// Which of its node's six freedoms each equation is, or is next to.
std::vector<int> components(const Equations& equations) {
  std::vector<int> component(at(equations.size()), 0);
  std::vector<double> share(component.size(), 0.0);
  for (int node = 0; node < static_cast<int>(equations.nodes()); ++node)
    for (int i = 0; i < 6; ++i)
      for (const Equations::Term& t : equations.terms(node, i)) {
        if (equations.node_of(t.equation) != node || std::abs(t.factor) <= share[t.equation]) continue;
        share[t.equation] = std::abs(t.factor);
        component[t.equation] = i;
      }
  return component;
}

template <class Visit>
void each_coupling(const Matrices& m, const Visit& visit) {
  for (const Symmetric* matrix : {&m.stiffness, &m.mass})
    for (std::size_t j = 0; j < matrix->size(); ++j)
      for (const int i : matrix->rows(j)) visit(at(i), j);
}

/// Vertex of each equation: a node's freedoms that are coupled directly or through each other.
std::vector<idx_t> vertices(const Matrices& m, idx_t& count) {
  using SixDof = std::array<unsigned, 6>;  ///< bit j of entry i: freedom i is coupled to a freedom j, here or next door
  const std::vector<int> component = components(m.equations);
  const auto node_of = [&](std::size_t equation) { return at(m.equations.node_of(static_cast<int>(equation))); };
  std::vector<SixDof> coupled(m.equations.nodes(), SixDof{1, 2, 4, 8, 16, 32});
  each_coupling(m, [&](std::size_t i, std::size_t j) {
    for (SixDof* node : {&coupled[node_of(i)], &coupled[node_of(j)]}) {
      (*node)[component[i]] |= 1u << component[j];
      (*node)[component[j]] |= 1u << component[i];
    }
  });
  for (SixDof& c : coupled)  // what reaches each other by way of a third is one
    for (std::size_t by = 0; by < 6; ++by)
      for (unsigned& reached : c)
        if (reached >> by & 1u) reached |= c[by];

  std::vector<idx_t> vertex(component.size());
  count = 0;
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    vertex[i] = count;
    for (std::size_t k = i; k-- > 0 && node_of(k) == node_of(i);)
      if (coupled[node_of(i)][component[i]] >> component[k] & 1u) vertex[i] = vertex[k];
    count += vertex[i] == count;
  }
  return vertex;
}

}  // namespace

std::vector<int> elimination_order(const Matrices& m) {
  idx_t count = 0;
  const std::vector<idx_t> vertex = vertices(m, count);
  std::vector<std::vector<idx_t>> neighbours(at(count));
  each_coupling(m, [&](std::size_t i, std::size_t j) {
    const idx_t a = vertex[i], b = vertex[j];
    if (a == b || (!neighbours[b].empty() && neighbours[b].back() == a)) return;
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  });
  std::vector<idx_t> start{0}, list, weight(at(count), 0), order(at(count)), place(at(count));
  for (std::vector<idx_t>& n : neighbours) {
    std::sort(n.begin(), n.end());
    n.erase(std::unique(n.begin(), n.end()), n.end());
    list.insert(list.end(), n.begin(), n.end());
    start.push_back(static_cast<idx_t>(list.size()));
    std::vector<idx_t>().swap(n);
  }
  for (const idx_t v : vertex) ++weight[v];
  if (list.empty())
    for (idx_t v = 0; v < count; ++v) place[v] = v;
  else
    METIS_NodeND(&count, start.data(), list.data(), weight.data(), nullptr, order.data(), place.data());

  std::vector<int> first(at(count) + 1, 0);  // position of each vertex' first unknown, by place
  for (std::size_t v = 0; v < weight.size(); ++v) first[at(place[v]) + 1] = static_cast<int>(weight[v]);
  for (std::size_t p = 1; p < first.size(); ++p) first[p] += first[p - 1];
  std::vector<int> position(vertex.size());
  for (std::size_t i = 0; i < vertex.size(); ++i) position[i] = 1 + first[place[vertex[i]]]++;
  return position;
}

}  // namespace nugget::nvh
