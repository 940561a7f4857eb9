// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/pressure_load.hpp"

#include "base/index.hpp"

namespace nugget::impact {
namespace {

/// Area vector of a segment, along its right-hand normal.
Vec3d area(const std::array<Vec3d, 4>& x, bool triangle) {
  return triangle ? 0.5 * cross(x[1] - x[0], x[2] - x[0]) : 0.5 * cross(x[2] - x[0], x[3] - x[1]);
}

}  // namespace

void PressedFaces::press(double pressure, system::State& state, double dt, double& work) {
  for (std::size_t s = 0; s < segments_.size(); ++s) press(s, pressure, state, dt, work);
}

void PressedFaces::press(std::size_t s, double pressure, system::State& state, double dt, double& work) {
  const model::Segment& segment = segments_[s];
  const bool triangle = segment[3] == segment[2];
  const std::size_t corners = triangle ? 3 : 4;
  std::array<std::size_t, 4> k{};
  std::array<Vec3d, 4> x;
  for (std::size_t a = 0; a < 4; ++a) {
    k[a] = at(system_.node_of[segment[a]]);
    x[a] = vec(state.x[k[a]]);
  }
  const Vec3d force = -pressure * area(x, triangle);
  for (std::size_t a = 0; a < corners; ++a) {
    const Vec3d share = shares_[s][a] * force;
    Vec3d& last = last_[4 * s + a];
    work += 0.5 * dt * dot(last + share, vec(state.v[k[a]]));
    add(state.f[k[a]], share);
    last = share;
  }
}

std::pair<Vec3d, Vec3d> PressedFaces::middle_and_area(std::size_t s, const system::State& state) const {
  const model::Segment& segment = segments_[s];
  const bool triangle = segment[3] == segment[2];
  std::array<Vec3d, 4> x;
  Vec3d middle;
  for (std::size_t a = 0; a < 4; ++a) {
    x[a] = vec(state.x[at(system_.node_of[segment[a]])]);
    if (a < 3 || !triangle) middle += (triangle ? 1.0 / 3.0 : 0.25) * x[a];
  }
  return {middle, area(x, triangle)};
}

void PressedFaces::archive(Archive& a) {
  a(last_);
  a.built(segments_, shares_, system_);
}

void ActingLoad<model::PressureLoad>::apply(system::State& state, double dt, double& work) {
  const double time = state.time - load_.arrival - (load_.from_switch ? state.turned_on(load_.control) : 0.0);
  const Curve& curve = system_.model.curves[load_.curve];
  const bool acts = time >= 0.0 && state.acts(load_.control);
  faces_.press(acts ? load_.scale * load_value(curve, time, state) : 0.0, state, dt, work);
}

void ActingLoad<model::PressureLoad>::archive(Archive& a) {
  a(faces_);
  a.built(load_, system_);
}

}  // namespace nugget::impact
