// SPDX-License-Identifier: Apache-2.0
#include "impact/energy.hpp"

#include "base/parallel.hpp"

namespace nugget::impact {
namespace {

/// Share of the way from t(n-1/2) to t(n+1/2) at which the second velocity of the product v(n-1/2) . v stands, so that
/// the energy fits the work booked until t(n), 1/2 F . v(n-1/2) dt(n-1): 1 at a constant step, 0 at the start.
double share_of_kick(const system::State& state) {
  return 2.0 * share_before_now(state);
}

Vec3d between(const Vec3d& before, const Vec3d& after, double share) {
  return before + share * (after - before);
}

}  // namespace

double share_before_now(const system::State& state) {
  const double both = state.dt_previous + state.dt;
  return both > 0.0 ? state.dt_previous / both : 0.5;
}

double kinetic_energy(const system::System& system, const system::State& state, std::span<const Row> v_before,
                      std::span<const Row> w_before, std::span<const Vec3d> momentum_before) {
  const double share = share_of_kick(state);
  double sum = ordered_sum(system.nodes, [&](std::size_t k) {
    const Vec3d v = vec(v_before[k]), w = vec(w_before[k]);
    return 0.5 * system.mass[k] * dot(v, between(v, vec(state.v[k]), share)) +
           0.5 * system.inertia[k] * dot(w, between(w, vec(state.w[k]), share));
  });
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const system::RigidBody& body = system.bodies[b];
    const auto k = static_cast<std::size_t>(body.node);
    const Vec3d v = vec(v_before[k]), w = vec(w_before[k]), momentum = momentum_before[b];
    sum += 0.5 * body.mass * dot(v, between(v, vec(state.v[k]), share)) +
           0.25 * (dot(w, between(momentum, body.angular_momentum, share)) +
                   dot(momentum, between(w, vec(state.w[k]), share)));
  }
  return sum;
}

void element_energies(const system::System& system, const system::State& state, std::span<const Row> v_before,
                      Energy& energy, std::vector<PartEnergy>& parts) {
  energy.internal = energy.hourglass = energy.eroded = 0.0;
  parts.assign(system.model.parts.size(), {});
  const double share = share_of_kick(state);
  const auto carry = [&](PartEnergy& part, int node, double m) {
    const auto k = static_cast<std::size_t>(node);
    const Vec3d before = vec(v_before[k]), after = vec(state.v[k]);
    part.kinetic += 0.5 * m * dot(before, between(before, after, share));
    part.momentum += m * between(before, after, 0.5 * share);
    part.mass += m;
  };
  for (const auto& group : system.groups) {
    PartEnergy& part = parts[static_cast<std::size_t>(group->part)];
    for (std::size_t e = 0; e < group->size(); ++e) {
      const double internal = group->internal_energy(e), hourglass = group->hourglass_energy(e);
      if (group->alive(e)) {
        part.internal += internal;
        part.hourglass += hourglass;
        energy.internal += internal;
        energy.hourglass += hourglass;
      } else {
        part.eroded += internal + hourglass;
        energy.eroded += internal + hourglass;
      }
      const auto nodes = group->nodes(e);
      for (int a = 0; a < group->nodes_per_element; ++a)
        carry(part, nodes[static_cast<std::size_t>(a)], group->mass_scale(e) * group->nodal_mass(e, a));
    }
  }
  for (const system::System::Lump& lump : system.lumps())
    for (int a = 0; a < lump.corners; ++a)
      carry(parts[static_cast<std::size_t>(lump.part)], lump.node[static_cast<std::size_t>(a)], lump.nodal_mass(a));
}

}  // namespace nugget::impact
