// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/discrete_beam.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::kernel {

DiscreteBeam::DiscreteBeam() = default;
DiscreteBeam::DiscreteBeam(const DiscreteBeam&) = default;
DiscreteBeam::DiscreteBeam(DiscreteBeam&&) noexcept = default;
DiscreteBeam& DiscreteBeam::operator=(const DiscreteBeam&) = default;
DiscreteBeam& DiscreteBeam::operator=(DiscreteBeam&&) noexcept = default;
DiscreteBeam::~DiscreteBeam() = default;

double DiscreteBeam::failure_value(const std::array<double, 6>& force,
                                   const std::array<double, 6>& displacement) const {
  double by_force = 0.0, tension = 0.0, compression = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    if (force_limit[i] > 0.0) by_force += (force[i] / force_limit[i]) * (force[i] / force_limit[i]);
    const double limit = displacement[i] > 0.0 ? tension_limit[i] : compression_limit[i];
    if (!(limit > 0.0)) continue;
    const double ratio = displacement[i] / limit;
    (displacement[i] > 0.0 ? tension : compression) += ratio * ratio;
    largest = std::max(largest, std::abs(ratio));
  }
  switch (rule) {
    case Rule::any: return std::max(by_force, largest);
    case Rule::sides: return std::max({by_force, tension, compression});
    case Rule::together: return std::max(by_force, tension + compression);
  }
  return 0.0;
}

bool DiscreteBeam::fails(const std::array<double, 6>& force, const std::array<double, 6>& displacement) const {
  return failure_value(force, displacement) >= 1.0;
}

}  // namespace nugget::kernel
