// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/components.hpp"

namespace nugget::impact {

Components::~Components() = default;

Components::Components(system::System& system, std::span<const Row> x, Findings& findings)
    : supports(system, findings),
      loads(system),
      damping(system),
      preloads(system, findings),
      welds(system, findings),
      rigid_welds(system, findings),
      rivets(system, findings),
      linear_constraints(system, supports, findings),
      connectors(system),
      tie_forces(system),
      tie_releases(system, welds, tie_forces),
      torn_nodes(system),
      joints(system),
      belts(system, findings),
      element_alive(system.model),
      erosion(system),
      crash_fronts(system),
      nodal_forces(system),
      accelerometers(system),
      contacts(system, x, findings),
      interiors(system, x, findings),
      walls(system, findings),
      stoppers(system, findings),
      sensors(system) {}

int Components::failed_welds() const {
  int sum = 0;
  for_each([&](const auto& component) {
    if constexpr (requires { component.failed(); }) sum += component.failed();
  });
  return sum;
}

void Components::archive(Archive& a) {
  a.section("components");
  visit_all(*this, a);
}

}  // namespace nugget::impact
