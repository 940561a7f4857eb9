// SPDX-License-Identifier: Apache-2.0
#include "impact/energy/energy.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "model/axes.hpp"
#include "system/share.hpp"

namespace nugget::impact {
namespace {

// Elements or nodes: fixed, so that sums do not depend on the number of threads.
constexpr std::size_t sums_of = system::SumsByRank::in_a_row;

Vec3d between(const Vec3d& before, const Vec3d& after, double share) {
  return before + share * (after - before);
}

/// Kinetic energy of a body's turning; `w` and `momentum` at t(n-1/2), those of `state` and `body` at t(n+1/2).
double turning(const system::RigidBody& body, const system::State& state, const Vec3d& w, const Vec3d& momentum,
               double share) {
  return 0.25 * (dot(w, between(momentum, body.angular_momentum, share)) +
                 dot(momentum, between(w, vec(state.w[body.node]), share)));
}

/// Kinetic energy and momentum of mass and rotary inertia put at one node, by unit of each.
struct Carried {
  double mass = 0.0;  ///< share of the mass that counts: none where a body's mass is given
  double by_mass = 0.0, by_inertia = 0.0;
  Vec3d momentum;
};

/// Inlined: called for each corner of each element.
[[gnu::always_inline]] inline NodalMotion motion_of(const system::System& system, const system::State& state,
                                                    std::span<const Row> v_before, std::span<const Row> w_before,
                                                    std::span<const NodalMotion> of_others, std::size_t k,
                                                    double share) {
  if (!of_others.empty() && !system.follows(k))
    return of_others[system.sums_by_rank()->place_among_travelling(static_cast<int>(k))];
  return nodal_motion(state, v_before, w_before, k, share);
}

/// What hands nodal masses to parts: kinetic energy and momentum.
struct Carrier {
  const system::System& system;
  const system::State& state;
  std::span<const Row> v_before, w_before;
  std::span<const NodalMotion> of_others;
  double share;
  const PartNodes& nodes;

  Carrier(const system::System& s, const system::State& now, std::span<const Row> v, std::span<const Row> w,
          std::span<const NodalMotion> others, const PartNodes& of_parts)
      : system(s),
        state(now),
        v_before(v),
        w_before(w),
        of_others(others),
        share(share_of_interval(now)),
        nodes(of_parts) {}

  /// A tied node's mass is, as in the equations of motion, that of the nodes which it follows.
  Carried carried_by(int node) const {
    const auto k = at(node);
    if (nodes.is_weightless(k)) return {};
    if (system.map.dependent(node) && at(system.map.terms(node).front().node) < system.nodes) {
      Carried sum;
      for (const system::ConstraintMap::Term& t : system.map.terms(node)) {
        const Carried one = carried_by(t.node);
        sum.mass += t.weight * one.mass;
        sum.by_mass += t.weight * (one.by_mass + dot(t.arm, t.arm) * one.by_inertia);
        sum.by_inertia += t.weight * one.by_inertia;
        sum.momentum += t.weight * one.momentum;
      }
      if (!system.map.rotations(node)) sum.by_inertia = by_own_spin(k);
      return sum;
    }
    const NodalMotion motion = motion_of(system, state, v_before, w_before, of_others, k, share);
    return {1.0, 0.5 * motion.linear, 0.5 * motion.angular, motion.velocity};
  }

  double by_own_spin(std::size_t k) const {
    return 0.5 * motion_of(system, state, v_before, w_before, of_others, k, share).angular;
  }

  void carry(PartEnergy& part, int node, double m, double inertia) const {
    const Carried by = carried_by(node);
    (nodes.has_no_elements(at(node)) ? part.eroded_kinetic : part.kinetic) += m * by.by_mass + inertia * by.by_inertia;
    part.momentum += m * by.momentum;
    part.mass += m * by.mass;
  }

  /// What the nodes of a piece add to its part.
  PartEnergy sum(const PartNodes::Piece& piece) const {
    PartEnergy part;
    for (const int k : nodes.alone(piece)) carry(part, k, system.own_mass[k], system.own_inertia()[k]);
    for (const PartNodes::Shared& n : nodes.shared(piece)) carry(part, n.node, n.mass, n.inertia);
    return part;
  }

  /// Of a node the mean of the tensor counts, of a body's node all of it.
  void carry(PartEnergy& part, const model::PointInertia& point) const {
    const int node = system.node_of[point.node];
    const double mean = (point.inertia[0] + point.inertia[3] + point.inertia[5]) / 3.0;
    carry(part, node, point.mass, mean);
    if (nodes.is_weightless(at(node)) || !system.map.dependent(node)) return;
    const auto body = at(system.map.terms(node).front().node);
    if (body < system.nodes) return;
    system::Inertia tensor = point.inertia;
    for (const std::size_t i : {0u, 3u, 5u}) tensor[i] -= mean;
    const Frame3d& axes = system.bodies[body - system.nodes].axes;
    const Vec3d w = axes.local(vec(w_before[body])), after = axes.local(vec(state.w[body]));
    const Vec3d x{tensor[0], tensor[1], tensor[2]}, y{tensor[1], tensor[3], tensor[4]},
        z{tensor[2], tensor[4], tensor[5]};
    const Vec3d mixed = between(w, after, share);
    part.kinetic += 0.5 * dot(w, Vec3d{dot(x, mixed), dot(y, mixed), dot(z, mixed)});
  }
};

/// What some elements of a group add to its part.
struct GroupSum {
  const system::ElementGroup* group;
  std::size_t begin, end;
  int rank = 0;  ///< that makes it; below 0: nobody can alone
  system::ElementGroup::Energies found;
};

/// Of all groups, in order.
std::vector<GroupSum> rows_of_elements(const system::System& system) {
  std::vector<GroupSum> rows;
  const system::SumsByRank* by_rank = system.sums_by_rank();
  for (std::size_t g = 0; g < system.groups.size(); ++g)
    for (std::size_t begin = 0, size = system.groups[g]->size(); begin < size; begin += sums_of)
      rows.push_back({system.groups[g].get(),
                      begin,
                      std::min(size, begin + sums_of),
                      by_rank != nullptr ? by_rank->of_elements(g, begin / sums_of) : 0,
                      {}});
  return rows;
}

double energy_of(const system::System& system, const NodalMotion& motion, std::size_t k) {
  return 0.5 * system.mass[k] * motion.linear + 0.5 * system.inertia[k] * motion.angular;
}

}  // namespace

PartEnergy& PartEnergy::operator+=(const PartEnergy& other) {
  internal += other.internal;
  kinetic += other.kinetic;
  hourglass += other.hourglass;
  bulk_viscosity += other.bulk_viscosity;
  eroded += other.eroded;
  eroded_kinetic += other.eroded_kinetic;
  mass += other.mass;
  momentum += other.momentum;
  return *this;
}

double share_of_interval(const system::State& state) {
  return 2.0 * share_before_now(state);
}

double share_before_now(const system::State& state) {
  const double both = state.dt_previous + state.dt;
  return both > 0.0 ? state.dt_previous / both : 0.5;
}

double sum_over_nodes(const system::System& system, std::span<const double> of_others,
                      const std::function<double(std::size_t begin, std::size_t end)>& row) {
  std::vector<double> part(of_others.begin(), of_others.end());
  part.resize((system.nodes + sums_of - 1) / sums_of);
  parallel_for(part.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (of_others.empty() || system.sums_by_rank()->of_nodes(i) <= 0)
        part[i] = row(i * sums_of, std::min(system.nodes, (i + 1) * sums_of));
  });
  double total = 0.0;
  for (const double p : part) total += p;
  return total;
}

SumsOfRanks sums_for_first(const system::System& system, const system::State& state, std::span<const Row> v_before,
                           std::span<const Row> w_before, const PartNodes& nodes,
                           const std::function<double(std::size_t begin, std::size_t end)>& step_change) {
  const system::SumsByRank& by_rank = *system.sums_by_rank();
  const int own = system.share()->ranks().rank();
  SumsOfRanks sums;
  std::vector<GroupSum> of_elements = rows_of_elements(system);
  sums.elements.resize(of_elements.size());
  sums.pieces.resize(nodes.pieces().size());
  sums.kinetic.resize(by_rank.rows_of_nodes());
  sums.step_change.resize(by_rank.rows_of_nodes());
  if (own == 0) return sums;
  const auto each_own = [own](std::size_t count, const auto& rank_of, const auto& make) {
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (rank_of(i) == own) make(i);
    });
  };
  each_own(
      of_elements.size(), [&](std::size_t i) { return of_elements[i].rank; },
      [&](std::size_t i) {
        const GroupSum& s = of_elements[i];
        sums.elements[i] = s.group->energies(s.begin, s.end);
      });
  const Carrier carrier(system, state, v_before, w_before, {}, nodes);
  each_own(
      sums.pieces.size(), [&](std::size_t i) { return by_rank.of_nodes(nodes.pieces()[i].row); },
      [&](std::size_t i) { sums.pieces[i] = carrier.sum(nodes.pieces()[i]); });
  each_own(
      sums.kinetic.size(), [&](std::size_t i) { return by_rank.of_nodes(i); },
      [&](std::size_t i) {
        const std::size_t begin = i * sums_of, end = std::min(system.nodes, begin + sums_of);
        sums.kinetic[i] = sum_of_row(begin, end, [&](std::size_t k) {
          return energy_of(system, nodal_motion(state, v_before, w_before, k, carrier.share), k);
        });
        sums.step_change[i] = step_change(begin, end);
      });
  return sums;
}

double kinetic_energy(const system::System& system, const system::State& state, std::span<const Row> v_before,
                      std::span<const Row> w_before, std::span<const Vec3d> momentum_before,
                      std::span<const NodalMotion> of_others, const SumsOfRanks& sums) {
  const double share = share_of_interval(state);
  double sum = sum_over_nodes(system, sums.kinetic, [&](std::size_t begin, std::size_t end) {
    return sum_of_row(begin, end, [&](std::size_t k) {
      return energy_of(system, motion_of(system, state, v_before, w_before, of_others, k, share), k);
    });
  });
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const system::RigidBody& body = system.bodies[b];
    const auto k = at(body.node);
    const Vec3d v = vec(v_before[k]);
    sum += 0.5 * body.mass * dot(v, between(v, vec(state.v[k]), share)) +
           turning(body, state, vec(w_before[k]), momentum_before[b], share);
  }
  return sum;
}

void element_energies(const system::System& system, const system::State& state, std::span<const Row> v_before,
                      std::span<const Row> w_before, std::span<const Vec3d> momentum_before, const PartNodes& nodes,
                      Energy& energy, std::vector<PartEnergy>& parts, std::span<const NodalMotion> of_others,
                      const SumsOfRanks& of_ranks) {
  energy.internal = energy.hourglass = energy.bulk_viscosity = energy.eroded = energy.eroded_kinetic = 0.0;
  energy.lumped = {};
  parts.assign(system.model.parts.size(), {});
  const Carrier carrier(system, state, v_before, w_before, of_others, nodes);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const system::RigidBody& body = system.bodies[b];
    const model::RigidBody& source = system.model.rigid_bodies[body.source];
    if (!source.given) continue;
    const Vec3d v = vec(v_before[body.node]), after = vec(state.v[body.node]);
    const double kinetic = 0.5 * body.mass * dot(v, between(v, after, carrier.share)) +
                           turning(body, state, vec(w_before[body.node]), momentum_before[b], carrier.share);
    PartEnergy& part = source.parts.empty() ? energy.lumped : parts[source.parts.front()];
    part.kinetic += kinetic;
    part.mass += body.mass;
    part.momentum += body.mass * between(v, after, 0.5 * carrier.share);
  }
  std::vector<GroupSum> sums = rows_of_elements(system);
  parallel_for(sums.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      GroupSum& s = sums[i];
      s.found = !of_ranks.elements.empty() && s.rank > 0 ? of_ranks.elements[i] : s.group->energies(s.begin, s.end);
    }
  });
  for (const GroupSum& s : sums) {
    PartEnergy& part = parts[s.group->part];
    part.internal += s.found.internal;
    part.hourglass += s.found.hourglass;
    part.bulk_viscosity += s.found.bulk_viscosity;
    part.eroded += s.found.deleted;
    energy.internal += s.found.internal;
    energy.hourglass += s.found.hourglass;
    energy.bulk_viscosity += s.found.bulk_viscosity;
    energy.eroded += s.found.deleted;
  }
  const std::vector<PartNodes::Piece>& pieces = nodes.pieces();
  std::vector<PartEnergy> motions(pieces.size());
  parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool by_others = !of_ranks.pieces.empty() && system.sums_by_rank()->of_nodes(pieces[i].row) > 0;
      motions[i] = by_others ? of_ranks.pieces[i] : carrier.sum(pieces[i]);
    }
  });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    parts[pieces[i].part] += motions[i];
    energy.eroded_kinetic += motions[i].eroded_kinetic;
  }
  for (const system::System::MassOnlyElement& mass_only : system.mass_only_elements())
    for (int a = 0; a < mass_only.corners; ++a)
      carrier.carry(parts[mass_only.part], mass_only.node[a], mass_only.nodal_mass(a), mass_only.nodal_inertia);
  PartEnergy points;
  for (const model::PointMass& m : system.model.masses) carrier.carry(points, system.node_of[m.node], m.mass, 0.0);
  for (const model::PointInertia& p : system.model.inertias) carrier.carry(points, p);
  energy.lumped += points;
}

Vec3d mean_velocity(const Energy& energy, const std::vector<PartEnergy>& parts) {
  PartEnergy all = energy.lumped;
  for (const PartEnergy& part : parts) all += part;
  return all.mass > 0.0 ? (1.0 / all.mass) * all.momentum : Vec3d{};
}

}  // namespace nugget::impact
