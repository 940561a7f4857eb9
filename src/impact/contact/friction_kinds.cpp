// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/friction_kinds.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/index.hpp"

namespace nugget::impact {
namespace {

using kernel::Friction;

/// Times the factors of the contact.
Friction scaled(const Friction& own, const Friction& factor) {
  return {factor.static_coefficient * own.static_coefficient, factor.dynamic_coefficient * own.dynamic_coefficient,
          own.decay, factor.shear_strength * own.shear_strength};
}

/// Gives parts with equal keys the same kind; the first part of each kind.
template <class Key>
std::vector<std::size_t> sort_into_kinds(const std::vector<Key>& key_of_part, std::vector<int>& of_part) {
  std::map<Key, int> kinds;
  std::vector<std::size_t> first;
  for (std::size_t p = 0; p < key_of_part.size(); ++p) {
    const auto [kind, is_new] = kinds.try_emplace(key_of_part[p], static_cast<int>(first.size()));
    if (is_new) first.push_back(p);
    of_part[p] = kind->second;
  }
  return first;
}

template <class Between>
kernel::FrictionTable table_of(const std::vector<std::size_t>& first, const Between& between) {
  std::vector<Friction> of_pairs;
  for (const std::size_t a : first)
    for (const std::size_t b : first) of_pairs.push_back(between(a, b));
  return {static_cast<int>(first.size()), std::move(of_pairs)};
}

}  // namespace

FrictionKinds::FrictionKinds(const model::Model& model, const model::Contact& card) : of_part(model.parts.size(), 0) {
  if (card.friction_by_part) {
    std::vector<std::array<double, 4>> key;
    const auto of = [&](std::size_t p) {
      const Friction& own = model.parts[p].friction;
      return scaled(own.any() ? own : model.control.part_friction, card.friction);
    };
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
      const Friction f = of(p);
      key.push_back({f.static_coefficient, f.dynamic_coefficient, f.decay, f.shear_strength});
    }
    table = table_of(sort_into_kinds(key, of_part),
                     [&](std::size_t a, std::size_t b) { return kernel::mean(of(a), of(b)); });
    return;
  }
  if (card.friction_table == model::none) {
    table = kernel::FrictionTable(card.friction);
    return;
  }
  // Parts on the same sides of the same pairs have the same friction.
  const model::PartFriction& given = model.part_friction[card.friction_table];
  std::vector<std::vector<std::size_t>> sides(model.parts.size());
  for (std::size_t i = 0; i < given.pairs.size(); ++i) {
    for (const model::Index p : given.pairs[i].one) sides[p].push_back(2 * i);
    for (const model::Index p : given.pairs[i].other) sides[p].push_back(2 * i + 1);
  }
  const std::size_t count = sort_into_kinds(sides, of_part).size();
  std::vector<Friction> of_pairs(count * count, scaled(given.otherwise, card.friction));
  const auto kinds_of = [&](const std::vector<model::Index>& parts) {
    std::vector<std::size_t> kinds;
    for (const model::Index p : parts) kinds.push_back(at(of_part[p]));
    std::sort(kinds.begin(), kinds.end());
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    return kinds;
  };
  // The last of several pairs holds.
  for (const model::PartFriction::Pair& pair : given.pairs) {
    const Friction friction = scaled(pair.friction, card.friction);
    const std::vector<std::size_t> others = kinds_of(pair.other);
    for (const std::size_t a : kinds_of(pair.one))
      for (const std::size_t b : others) of_pairs[a * count + b] = of_pairs[b * count + a] = friction;
  }
  table = {static_cast<int>(count), std::move(of_pairs)};
}

}  // namespace nugget::impact
