// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "system/mobility.hpp"
#include "system/spring_group.hpp"
#include "system/system.hpp"

namespace nugget::system {
namespace {

/// What a spring does to one node that follows no other: its elongation for unit motions of the node (three
/// translations, three rotations), and the accelerations by a unit of its force.
struct Pull {
  SpringGroup* group;
  std::size_t spring;
  bool direct;  ///< the node is one of the spring's own
  std::array<double, 6> row{}, acceleration{};
  double inverse_mass = 0.0;  ///< row . acceleration; of a spring without a line the largest of all lines
  bool has_line = true;
};
using Pulls = std::vector<Pull>;

struct Rates {
  double inverse_mass = 0.0, stiffness_rate = 0.0, viscosity_rate = 0.0;
};

std::vector<ConstraintMap::Block> blocks_of(const System& system, int node) {
  if (system.map.dependent(node)) return system.map.blocks(node);
  std::vector<ConstraintMap::Block> own(1, {node, {}});
  for (std::size_t i = 0; i < 6; ++i) own.front().of[i][i] = 1.0;
  return own;
}

std::array<double, 6> accelerations(const System& system, int node, const std::array<double, 6>& load) {
  std::array<double, 6> a{};
  if (at(node) < system.nodes) {
    const double mass = system.mass[node], inertia = system.inertia[node];
    for (std::size_t i = 0; i < 6; ++i) {
      const double resists = i < 3 ? mass : inertia;
      if (resists > 0.0) a[i] = load[i] * (1.0 / resists);
    }
    return a;
  }
  const RigidBody& body = system.bodies[at(node) - system.nodes];
  const Mobility::Matrix inverse = inverse_inertia(body);
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = body.mass > 0.0 ? load[i] / body.mass : 0.0;
    for (std::size_t j = 0; j < 3; ++j) a[3 + i] += inverse[i][j] * load[3 + j];
  }
  return a;
}

double product(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}

/// Adds what one node of a spring does; `towards`: 1 where its motion along the line stretches the spring, else -1.
void add_end(const System& system, SpringGroup& group, std::size_t e, int node, double towards,
             std::map<int, Pulls>& at_node) {
  const std::size_t first = group.torsional() ? 3 : 0;
  const Vec3d line = group.line(e);
  const std::array<double, 3> n{towards * line.x, towards * line.y, towards * line.z};
  for (const ConstraintMap::Block& b : blocks_of(system, node)) {
    Pulls& pulls = at_node[b.node];
    const bool again = !pulls.empty() && pulls.back().group == &group && pulls.back().spring == e;
    if (!again) pulls.push_back({&group, e, !system.map.dependent(node)});
    Pull& pull = pulls.back();
    pull.direct = pull.direct && !again;
    pull.has_line = norm(line) > 0.0;
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t i = 0; i < 3; ++i) pull.row[j] += n[i] * b.of[first + i][j];
    pull.acceleration = accelerations(system, b.node, pull.row);
    pull.inverse_mass = product(pull.acceleration, pull.row);
    if (pull.has_line) continue;
    // A line that turns may come to lie in any direction.
    const Mobility m = mobility(system, node);
    pull.inverse_mass = std::max(pull.inverse_mass, Mobility::largest(group.torsional() ? m.rotation : m.translation));
  }
}

/// Pulls of all springs, by the node that follows no other.
std::map<int, Pulls> pulls_of(const System& system) {
  std::map<int, Pulls> at_node;
  for (const auto& group : system.groups) {
    auto* springs = dynamic_cast<SpringGroup*>(group.get());
    if (springs == nullptr) continue;
    for (std::size_t e = 0; e < springs->size(); ++e)
      for (int a = 0; a < springs->nodes_per_element; ++a)
        add_end(system, *springs, e, springs->nodes(e)[a], a == 0 ? -1.0 : 1.0, at_node);
  }
  return at_node;
}

/// How fast a unit of the force of `other` changes the rate at which `own` grows, in size.
double coupling(const Pull& own, const Pull& other) {
  const bool same_kind = own.group->torsional() == other.group->torsional();
  if (own.direct && other.direct)
    return same_kind ? own.inverse_mass * std::abs(dot(own.group->line(own.spring), other.group->line(other.spring)))
                     : 0.0;
  if (!own.has_line || !other.has_line) return std::sqrt(own.inverse_mass * other.inverse_mass);
  return std::abs(product(own.row, other.acceleration));
}

/// What all springs at one node do to the rates of each.
void add_rates(const Pulls& pulls, std::map<std::pair<SpringGroup*, std::size_t>, Rates>& sums) {
  for (const Pull& own : pulls) {
    Rates& sum = sums[{own.group, own.spring}];
    sum.inverse_mass += own.inverse_mass;
    for (const Pull& other : pulls) {
      const bool same = &own == &other;
      const double share = same ? own.inverse_mass : coupling(own, other);
      sum.stiffness_rate += share * other.group->greatest_stiffness(other.spring);
      if (!same) sum.viscosity_rate += share * other.group->greatest_viscosity(other.spring, 0.0);
    }
  }
}

/// The same where they are so many that pairs would take long: each pulls at most as if all had its line.
void add_rates_of_many(const Pulls& pulls, std::map<std::pair<SpringGroup*, std::size_t>, Rates>& sums) {
  double stiffness = 0.0, viscosity = 0.0;
  for (const Pull& p : pulls) {
    stiffness += std::sqrt(p.inverse_mass) * p.group->greatest_stiffness(p.spring);
    viscosity += std::sqrt(p.inverse_mass) * p.group->greatest_viscosity(p.spring, 0.0);
  }
  for (const Pull& own : pulls) {
    Rates& sum = sums[{own.group, own.spring}];
    const double share = std::sqrt(own.inverse_mass);
    sum.inverse_mass += own.inverse_mass;
    sum.stiffness_rate += share * stiffness;
    sum.viscosity_rate += share * viscosity - own.inverse_mass * own.group->greatest_viscosity(own.spring, 0.0);
  }
}

}  // namespace

void bound_springs(System& system) {
  constexpr std::size_t many = 1000;
  std::map<std::pair<SpringGroup*, std::size_t>, Rates> sums;
  for (const auto& [node, pulls] : pulls_of(system))
    pulls.size() > many ? add_rates_of_many(pulls, sums) : add_rates(pulls, sums);
  for (const auto& [key, sum] : sums)
    key.first->set_bound(key.second, sum.inverse_mass, sum.stiffness_rate, sum.viscosity_rate);
}

}  // namespace nugget::system
