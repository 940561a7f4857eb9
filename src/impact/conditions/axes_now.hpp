// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/axes.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Axes of a coordinate system of the model at the positions of `state`: those that turn with their nodes follow them
/// (where the three come to lie on a line, the axes of time 0 stand in), all others stay.
inline Frame3d axes_now(const system::System& system, const system::State& state, model::Index coordinates) {
  const model::CoordinateSystem& s = system.model.systems[coordinates];
  Frame3d axes = s.axes;
  if (!s.turning || !s.nodes) return axes;
  const auto place = [&](model::Index n) { return vec(state.x[system.node_of[n]]); };
  model::frame_of_points(place(s.nodes->origin), place(s.nodes->on_axis), place(s.nodes->in_plane), s.nodes->axis,
                         axes);
  return axes;
}

}  // namespace nugget::impact
