// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/node_motion.hpp"

#include "base/index.hpp"

namespace nugget::impact {

NodeMotion node_motion(const Snapshot& now, std::size_t node) {
  const system::System& system = now.system;
  if (system.map.dependent(static_cast<int>(node))) {
    const auto terms = system.map.terms(static_cast<int>(node));
    if (terms.size() == 1 && at(terms.front().node) >= system.nodes) {
      const std::size_t c = at(terms.front().node);
      const Vec3d r = vec(now.state.x[node]) - vec(now.state.x[c]), w = now.spin(c), alpha = now.rotary_acceleration(c);
      return {now.velocity(c) + cross(w, r), now.acceleration(c) + cross(alpha, r) + cross(w, cross(w, r)), w, alpha};
    }
  }
  return {now.velocity(node), now.acceleration(node), now.spin(node), now.rotary_acceleration(node)};
}

}  // namespace nugget::impact
