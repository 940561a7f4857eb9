// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include "impact/conditions/accelerometers.hpp"
#include "impact/conditions/damping.hpp"
#include "impact/conditions/loads.hpp"
#include "impact/conditions/nodal_force_groups.hpp"
#include "impact/conditions/preloads.hpp"
#include "impact/conditions/stoppers.hpp"
#include "impact/conditions/supports.hpp"
#include "impact/connections/belts.hpp"
#include "impact/connections/connectors.hpp"
#include "impact/connections/joints.hpp"
#include "impact/connections/linear_constraints.hpp"
#include "impact/connections/rigid_welds.hpp"
#include "impact/connections/rivets.hpp"
#include "impact/connections/tie_forces.hpp"
#include "impact/connections/tie_release.hpp"
#include "impact/connections/torn_nodes.hpp"
#include "impact/connections/welds.hpp"
#include "impact/contact/contacts.hpp"
#include "impact/contact/element_alive.hpp"
#include "impact/contact/interiors.hpp"
#include "impact/contact/walls.hpp"
#include "impact/simulation/crash_fronts.hpp"
#include "impact/simulation/erosion.hpp"
#include "impact/simulation/sensors.hpp"

namespace nugget::impact {

/// What acts on the structure during a run, and what watches it. To add one: a member, its line in the constructor and
/// in `for_each`, and its place in Simulation::step() and start(). What a component can do beyond that is found by
/// name: `add_energy(Energy&)`, `reset_work()`, `events()` (lines of run.log), `failed()` (welds). All of them go into
/// restart files.
struct Components {
  Supports supports;
  Loads loads;
  Damping damping;
  Preloads preloads;
  Welds welds;
  RigidWelds rigid_welds;
  Rivets rivets;
  LinearConstraints linear_constraints;
  Connectors connectors;
  TieForces tie_forces;
  TieReleases tie_releases;  ///< of `welds` and `tie_forces`
  TornNodes torn_nodes;
  Joints joints;
  Belts belts;
  ElementAlive element_alive;
  Erosion erosion;
  CrashFronts crash_fronts;
  NodalForceGroups nodal_forces;
  Accelerometers accelerometers;
  Contacts contacts;
  Interiors interiors;
  Walls walls;
  Stoppers stoppers;
  Sensors sensors;

  /// Faults of the input become findings. `x`: places at the start [length].
  Components(system::System& system, std::span<const Row> x, Findings& findings);
  Components(const Components&) = delete;
  Components& operator=(const Components&) = delete;
  ~Components();

  /// Calls `visit` with each component; sums of energies are added up in this order.
  template <class Visit>
  void for_each(Visit&& visit) {
    visit_all(*this, visit);
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    visit_all(*this, visit);
  }

  /// Calls `visit` with the element groups' places whose states some component looks at between results: over several
  /// ranks all of them compute these. What a component looks at is found by name, `elements_read(visit)`.
  void elements_read(const std::function<void(system::System::ElementLocation)>& visit) const {
    for_each([&](const auto& component) {
      if constexpr (requires { component.elements_read(visit); }) component.elements_read(visit);
    });
  }
  /// Calls `visit` with lists of elements that some component looks at together: one rank computes them, and the
  /// component passes on what it finds. Found by name, `elements_of_one_rank(visit)`.
  void elements_of_one_rank(const std::function<void(std::vector<system::System::ElementLocation>)>& visit) const {
    for_each([&](const auto& component) {
      if constexpr (requires { component.elements_of_one_rank(visit); }) component.elements_of_one_rank(visit);
    });
  }
  /// Welds of every kind that have failed so far.
  int failed_welds() const;
  void archive(Archive& a);

 private:
  template <class Self, class Visit>
  static void visit_all(Self& c, Visit& visit) {
    const auto all = [&](auto&... component) { (visit(component), ...); };
    all(c.supports, c.loads, c.damping, c.preloads, c.welds, c.rigid_welds, c.rivets, c.linear_constraints,
        c.connectors, c.tie_forces, c.tie_releases, c.torn_nodes, c.joints, c.belts, c.element_alive, c.erosion,
        c.crash_fronts, c.nodal_forces, c.accelerometers, c.contacts, c.interiors, c.walls, c.stoppers, c.sensors);
  }
};

}  // namespace nugget::impact
