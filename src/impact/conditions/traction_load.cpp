// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/traction_load.hpp"

#include <cmath>

#include "base/index.hpp"

namespace nugget::impact {

std::array<double, 4> loaded_areas(const std::array<Vec3d, 4>& x, const std::array<double, 4>& factor, bool triangle) {
  std::array<double, 4> areas{};
  if (triangle) {
    const double twelfth = norm(cross(x[1] - x[0], x[2] - x[0])) / 24.0, sum = factor[0] + factor[1] + factor[2];
    for (std::size_t a = 0; a < 3; ++a) areas[a] = twelfth * (sum + factor[a]);
    return areas;
  }
  // Two Gauss points a direction: exact on a flat parallelogram.
  const double g = 1.0 / std::sqrt(3.0);
  constexpr std::array<double, 4> sx{-1, 1, 1, -1}, sy{-1, -1, 1, 1};
  for (const double xi : {-g, g})
    for (const double eta : {-g, g}) {
      std::array<double, 4> shape{};
      Vec3d along, across;
      double here = 0.0;
      for (std::size_t a = 0; a < 4; ++a) {
        shape[a] = 0.25 * (1.0 + sx[a] * xi) * (1.0 + sy[a] * eta);
        along = along + 0.25 * sx[a] * (1.0 + sy[a] * eta) * x[a];
        across = across + 0.25 * sy[a] * (1.0 + sx[a] * xi) * x[a];
        here += shape[a] * factor[a];
      }
      const double loaded = here * norm(cross(along, across));
      for (std::size_t a = 0; a < 4; ++a) areas[a] += shape[a] * loaded;
    }
  return areas;
}

void ActingLoad<model::TractionLoad>::apply(system::State& state, double dt, double& work) {
  const bool acts = state.time >= load_.birth && state.time <= load_.death;
  const Curve& curve = system_.model.curves[load_.curve];
  const double traction = acts ? load_.scale * load_value(curve, state.time - load_.birth, state) : 0.0;
  for (std::size_t s = 0; s < load_.segments.size(); ++s) {
    const model::Segment& segment = load_.segments[s];
    const bool triangle = segment[3] == segment[2];
    std::array<std::size_t, 4> k{};
    std::array<Vec3d, 4> x;
    for (std::size_t a = 0; a < 4; ++a) {
      k[a] = at(system_.node_of[segment[a]]);
      x[a] = vec(state.x[k[a]]);
    }
    const std::array<double, 4> areas = loaded_areas(x, load_.factor[s], triangle);
    for (std::size_t a = 0; a < (triangle ? 3u : 4u); ++a) {
      const Vec3d force = traction * areas[a] * load_.direction;
      Vec3d& last = last_[4 * s + a];
      work += 0.5 * dt * dot(last + force, vec(state.v[k[a]]));
      add(state.f[k[a]], force);
      last = force;
    }
  }
}

void ActingLoad<model::TractionLoad>::archive(Archive& a) {
  a(last_);
  a.built(load_, system_);
}

}  // namespace nugget::impact
