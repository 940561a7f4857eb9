// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "kernel/law/own_kernels.hpp"
#include "system/batch_group.hpp"
#include "system/order.hpp"
#include "system/system.hpp"

// What the files that make element groups share: one for shells, bricks and beams each, since every pair of element and
// law is compiled there.
namespace nugget::system {

/// Elements sorted by part, within a part along a Morton curve.
template <class Elements>
std::vector<std::vector<model::Index>> by_part(const Elements& elements, std::size_t parts,
                                               const std::vector<Vec3d>& x) {
  std::vector<Vec3d> centre(elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (model::Index k : elements.node[e]) centre[e] += (1.0 / static_cast<double>(elements.node[e].size())) * x[k];
  std::vector<std::vector<model::Index>> sorted(parts);
  for (int e : morton_order(centre)) sorted[elements.part[e]].push_back(e);
  return sorted;
}

/// Calls `with` for the laws that shells and bricks have kernels for; false for the others (rigid, null, welds).
template <class With>
bool with_law(const model::Law& law, const With& with) {
  return std::visit(
      [&]<class Law>(const Law& l) {
        constexpr bool computed =
            std::is_same_v<Law, kernel::Elastic> || std::is_same_v<Law, kernel::PlasticKinematic> ||
            std::is_same_v<Law, kernel::PiecewiseLinear> || std::is_same_v<Law, kernel::ComposedLaw>;
        if constexpr (computed) with(l);
        return computed;
      },
      law);
}

template <class Elements>
System::Members System::members(const Elements& elements, const std::vector<model::Index>& chosen) const {
  Members m;
  m.element = chosen;
  for (model::Index e : chosen) {
    ElementNodes node{};
    for (std::size_t a = 0; a < elements.node[e].size(); ++a) node[a] = node_of[elements.node[e][a]];
    m.node.push_back(node);
  }
  return m;
}

template <class Element>
void System::add_group(const Element& element, model::ElementKind kind, std::size_t part, const Members& m,
                       std::vector<ElementLocation>& locations) {
  const auto add = [&](auto group, int period) {
    group->period = period;
    groups.push_back(std::move(group));
  };
  const auto of = static_cast<model::Index>(part);
  for (const auto& [period, chosen] : by_period(kind, m)) {
    bool single = false;
    if constexpr (requires { requires Element::single_precision; }) {
      single = model.control.single_precision;
      if (single)
        add(std::make_unique<BatchGroup<Element, float>>(element, kind, of, chosen.element, chosen.node, start_,
                                                         !elements_have_started_),
            period);
    }
    if (!single)
      add(std::make_unique<BatchGroup<Element>>(element, kind, of, chosen.element, chosen.node, start_,
                                                !elements_have_started_),
          period);
    for (std::size_t e = 0; e < chosen.element.size(); ++e)
      locations[chosen.element[e]] = {static_cast<int>(groups.size()) - 1, static_cast<int>(e)};
  }
}

}  // namespace nugget::system
