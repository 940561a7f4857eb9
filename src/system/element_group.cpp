// SPDX-License-Identifier: Apache-2.0
#include "system/element_group.hpp"

#include <algorithm>

namespace nugget::system {

double ElementGroup::wanted_mass_scale(std::size_t e) {
  const double step = stable_step(e), now = mass_scale(e);
  const auto raised = [&](double scale, double target) {
    const double own = scale == now ? step : step * std::sqrt(scale / now);
    return own < target * (1.0 - 1e-9) ? scale * (target / own) * (target / own) : scale;
  };
  double wanted = now;
  if (physical_mass_step > 0.0) {
    if (physical_mass_scale_.empty()) physical_mass_scale_.assign(size(), 1.0);
    double& physical = physical_mass_scale_[e];
    physical = raised(physical, physical_mass_step);
    wanted = std::max(now, physical);
  }
  return raised(wanted, mass_step);
}

void ElementGroup::archive(Archive& a) {
  a(deletions, inverted, block_step, step_share, physical_mass_scale_);
  a.built(kind, part, element, nodes_per_element, weld, rotational, first_slot, damping_share, damping_time,
          damping_stiffness_ratio, mass_step, physical_mass_step);
}

}  // namespace nugget::system
