// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/inferred_welds.hpp"

#include <algorithm>
#include <numeric>

namespace nugget::weld {
namespace {

using model::Index;
using model::none;

/// Elements without a material, joined where they share nodes.
class ElementClusters {
 public:
  template <class Elements>
  ElementClusters(const model::Model& model, const Elements& elements, const std::vector<char>& unknown)
      : root_(elements.size()), size_(elements.size(), 1), alone_(elements.size(), 1) {
    std::iota(root_.begin(), root_.end(), Index{0});
    std::vector<Index> first_at(model.nodes.size(), none);
    for (Index e = 0; e < static_cast<Index>(elements.size()); ++e) {
      if (!unknown[e]) continue;
      for (const Index n : elements.node[e]) {
        Index& first = first_at[n];
        if (first == none) first = e;
        join(first, e);
      }
    }
  }

  /// No lump with this element stands alone.
  void touch(Index element) { alone_[root(element)] = 0; }
  bool stands_alone(Index element, int most) const {
    const Index r = root(element);
    return alone_[r] != 0 && size_[r] <= most;
  }

 private:
  Index root(Index e) const {
    while (root_[e] != e) e = root_[e];
    return e;
  }
  void join(Index a, Index b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    root_[b] = a;
    size_[a] += size_[b];
  }

  std::vector<Index> root_;
  std::vector<int> size_;
  std::vector<char> alone_;
};

/// By part: whether its elements may be welds for all that the deck says.
std::vector<char> without_material(const model::Model& model, model::ElementKind kind) {
  std::vector<char> unknown(model.parts.size(), 0);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    const model::Part& part = model.parts[p];
    if (part.kind != kind || part.material != none) continue;
    const bool beam = kind == model::ElementKind::beam && part.section != none;
    const int elform = beam ? model.beam_sections[part.section].elform : 9;
    unknown[p] = elform == 9 || elform == 6;
  }
  return unknown;
}

template <class Elements>
void mark_nodes(const Elements& elements, const std::vector<char>& left_out, std::vector<char>& marked) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (e < left_out.size() && left_out[e]) continue;
    for (const Index n : elements.nodes(e)) marked[n] = 1;
  }
}

template <class Elements>
std::vector<Index> standing_alone(const model::Model& model, const Elements& elements, model::ElementKind kind,
                                  int most) {
  const std::vector<char> parts = without_material(model, kind);
  if (std::find(parts.begin(), parts.end(), char{1}) == parts.end()) return {};
  std::vector<char> unknown(elements.size(), 0), taken(model.nodes.size(), 0);
  for (std::size_t e = 0; e < elements.size(); ++e) unknown[e] = parts[elements.part[e]];
  const bool beams = kind == model::ElementKind::beam;
  mark_nodes(model.shells, {}, taken);
  mark_nodes(model.solids, beams ? std::vector<char>{} : unknown, taken);
  mark_nodes(model.beams, beams ? unknown : std::vector<char>{}, taken);

  ElementClusters clusters(model, elements, unknown);
  const auto each = [&](auto with) {
    for (Index e = 0; e < static_cast<Index>(elements.size()); ++e)
      if (unknown[e]) with(e);
  };
  each([&](Index e) {
    const auto& nodes = elements.node[e];
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index n) { return taken[n] != 0; })) clusters.touch(e);
  });
  std::vector<Index> found;
  each([&](Index e) {
    if (clusters.stands_alone(e, most)) found.push_back(e);
  });
  return found;
}

}  // namespace

std::vector<Index> inferred_beams(const model::Model& model) {
  constexpr int most_in_a_stack = 3;
  return standing_alone(model, model.beams, model::ElementKind::beam, most_in_a_stack);
}

std::vector<Index> inferred_bricks(const model::Model& model) {
  constexpr int most_in_a_stack = 3 * 16;
  return standing_alone(model, model.solids, model::ElementKind::solid, most_in_a_stack);
}

bool is_inferred(const model::Model& model, const Weld& weld) {
  return weld.part != none && model.parts[weld.part].material == none;
}

}  // namespace nugget::weld
