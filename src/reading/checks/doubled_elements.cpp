// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "reading/builder/passes.hpp"

namespace nugget::reading {
namespace {

/// The nodes of an element in the order of their indices, its part, and what else tells it from others.
std::vector<Index> key_of_element(std::span<const Index> nodes, Index part, Index other) {
  std::vector<Index> key(nodes.begin(), nodes.end());
  std::ranges::sort(key);
  key.push_back(part);
  key.push_back(other);
  return key;
}

/// Warns of elements that have the key of another one. `key`, `id`, `place`: of the element with an index.
template <class Key, class Id, class PlaceOf>
void report_doubled(Builder& b, std::size_t count, std::string_view keyword, std::string_view what, const Key& key,
                    const Id& id, const PlaceOf& place) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(count);
  for (std::size_t e = 0; e < count; ++e) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const Index i : key(e)) hash = (hash ^ static_cast<std::uint32_t>(i)) * 0x100000001b3U;
    order.emplace_back(hash, e);
  }
  std::ranges::sort(order);
  std::size_t doubled = 0;
  std::pair<std::size_t, std::size_t> first{count, count};
  for (std::size_t i = 1; i < count; ++i) {
    const auto [one, other] = std::pair{order[i - 1], order[i]};
    if (one.first != other.first || key(one.second) != key(other.second)) continue;
    ++doubled;
    first = std::min(first, {other.second, one.second});
  }
  if (doubled == 0) return;
  b.findings.warning(
      place(first.first), std::string(keyword),
      fmt::format("{} {} has the part and the nodes of {} {}{}: both count", what, id(first.first), what,
                  id(first.second), doubled > 1 ? fmt::format(", and {} more are such", doubled - 1) : ""),
      "remove one of them; layers that are meant have parts of their own");
}

}  // namespace

void report_doubled_elements(Builder& b) {
  const Model& m = b.model;
  const auto report = [&](const auto& list, std::string_view keyword, std::string_view what, const auto& key) {
    report_doubled(
        b, list.size(), keyword, what, key, [&](std::size_t e) { return list.id[e]; },
        [&](std::size_t e) -> Place { return list.place[e]; });
  };
  report(m.shells, "*ELEMENT_SHELL", "shell",
         [&](std::size_t e) { return key_of_element(m.shells.node[e], m.shells.part[e], none); });
  report(m.solids, "*ELEMENT_SOLID", "solid",
         [&](std::size_t e) { return key_of_element(m.solids.nodes(e), m.solids.part[e], none); });
  report(m.beams, "*ELEMENT_BEAM", "beam",
         [&](std::size_t e) { return key_of_element(m.beams.node[e], m.beams.part[e], m.beams.orientation[e]); });
  const std::vector<Discrete>& springs = m.discretes;
  report_doubled(
      b, springs.size(), "*ELEMENT_DISCRETE", "spring",
      [&](std::size_t e) { return key_of_element(springs[e].node, springs[e].part, springs[e].orientation); },
      [&](std::size_t e) { return springs[e].id; }, [&](std::size_t e) -> Place { return springs[e].place; });
  const std::vector<Belt>& belts = m.belts.elements;
  report_doubled(
      b, belts.size(), "*ELEMENT_SEATBELT", "seat belt",
      [&](std::size_t e) { return key_of_element(belts[e].node, belts[e].part, belts[e].retractor); },
      [&](std::size_t e) { return belts[e].id; }, [&](std::size_t e) -> Place { return belts[e].place; });
}

}  // namespace nugget::reading
