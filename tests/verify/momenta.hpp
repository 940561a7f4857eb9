// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiment.hpp"

// What an assembly free in space keeps.
namespace nugget::verify {

/// Momenta of everything that carries mass, and what they would be if all of it went one way.
struct Momenta {
  double mass = 0.0, kinetic = 0.0;
  Vec3d linear, angular, centre;
  double linear_scale = 0.0, angular_scale = 0.0;
};
inline Momenta momenta(const impact::Snapshot& now) {
  Momenta m;
  for (std::size_t k = 0; k < now.system.nodes; ++k) {
    const double mass = now.system.mass[k], inertia = now.system.inertia[k];
    const Vec3d x = vec(now.state.x[k]), v = now.velocity(k), w = now.spin(k);
    m.mass += mass;
    m.centre += mass * x;
    m.linear += mass * v;
    m.angular += mass * cross(x, v) + inertia * w;
    m.kinetic += 0.5 * (mass * dot(v, v) + inertia * dot(w, w));
    m.linear_scale += mass * norm(v);
    m.angular_scale += mass * norm(x) * norm(v) + inertia * norm(w);
  }
  m.centre = (1.0 / m.mass) * m.centre;
  return m;
}

/// The largest changes in every 50th cycle of a run, of momenta as a share of those at the start, of the whole energy
/// as a share of the largest initial one.
struct FreeDrift {
  double linear = 0.0, angular = 0.0, energy = 0.0;
};
inline FreeDrift free_drift(Experiment& run) {
  std::vector<Momenta> seen;
  double worst = 0.0, scale = 0.0;
  run.run([&](const impact::Snapshot& now) {
    if (now.state.cycle % 50 != 0) return;
    seen.push_back(momenta(now));
    scale = std::max(scale, now.energy.initial);
    worst = std::max(worst, std::abs(now.energy.total() - now.energy.initial));
  });
  FreeDrift drift{0.0, 0.0, worst / scale};
  for (const Momenta& m : seen) {
    drift.linear = std::max(drift.linear, norm(m.linear - seen[0].linear) / norm(seen[0].linear));
    drift.angular = std::max(drift.angular, norm(m.angular - seen[0].angular) / norm(seen[0].angular));
  }
  return drift;
}

}  // namespace nugget::verify
