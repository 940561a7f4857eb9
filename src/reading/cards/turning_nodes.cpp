// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/turning_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace nugget::reading {

std::vector<char> nodes_that_turn(const Builder& builder) {
  const Model& m = builder.model;
  std::vector<char> turns(m.nodes.size(), 0);
  const auto take = [&](Index n) {
    if (n != none) turns[n] = 1;
  };
  for (std::size_t n = 0; n < turns.size(); ++n)
    if (builder.body_of_node[n] != none) turns[n] = 1;
  for (std::size_t e = 0; e < m.shells.size(); ++e)
    for (const Index n : m.shells.nodes(e)) take(n);
  for (std::size_t e = 0; e < m.beams.size(); ++e) {
    const Index section = m.beams.part[e] == none ? none : m.parts[m.beams.part[e]].section;
    if (section != none && m.beam_sections[section].elform == 3) continue;
    for (const Index n : m.beams.nodes(e)) take(n);
  }
  for (std::size_t e = 0; e < m.solids.size(); ++e) {
    const Index section = m.solids.part[e] == none ? none : m.parts[m.solids.part[e]].section;
    if (section != none && m.solid_sections[section].elform == 4)
      for (const Index n : m.solids.nodes(e)) take(n);
  }
  for (const Discrete& d : m.discretes) {
    const Index section = d.part == none ? none : m.parts[d.part].section;
    if (section != none && !m.discrete_sections[section].torsional) continue;
    for (const Index n : d.node) take(n);
  }
  for (const PointInertia& inertia : m.inertias) take(inertia.node);
  for (const Interpolation& i : m.interpolations)
    if (i.rotations) take(i.node);
  return turns;
}

void warn_of_no_rotation(Builder& builder, const deck::Entry& field, const std::vector<Index>& nodes,
                         const std::vector<char>& turns, const char* what, const char* remedy) {
  const auto stands = [&](Index n) { return turns[n] == 0; };
  const auto count = std::count_if(nodes.begin(), nodes.end(), stands);
  if (count == 0) return;
  const int first = builder.model.nodes.id[*std::find_if(nodes.begin(), nodes.end(), stands)];
  field.report(builder.findings, Severity::warning,
               fmt::format("{} of {} nodes (the first is {}) have no rotation: {}", count, nodes.size(), first, what),
               remedy);
}

}  // namespace nugget::reading
