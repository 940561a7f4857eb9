// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "contact/interior_contact.hpp"
#include "contact/penalty_contact.hpp"
#include "contact/rigid_wall.hpp"
#include "impact/conditions/accelerometers.hpp"
#include "impact/conditions/loads.hpp"
#include "impact/conditions/nodal_force_groups.hpp"
#include "impact/conditions/supports.hpp"
#include "impact/connections/joints.hpp"
#include "impact/connections/rigid_welds.hpp"
#include "impact/connections/rivets.hpp"
#include "impact/connections/tie_forces.hpp"
#include "impact/connections/welds.hpp"
#include "impact/simulation/energy.hpp"
#include "impact/simulation/strains.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Everything known at one time t(n), for those who write results. Velocities at t(n) lie between `before` and state's,
/// in proportion to time: exact under a constant acceleration, at the start and where the step changes as well. The
/// velocities of dependent nodes (tied, of rigid bodies) follow those of the others at both times.
struct Snapshot {
  const system::System& system;
  const system::State& state;
  std::span<const Row> v_before, w_before;  ///< at t(n-1/2); those in state stand at t(n+1/2)
  const Energy& energy;
  const std::vector<PartEnergy>& parts;
  const system::System::Controlling& controlling;
  const system::System::Masses& masses;
  const Supports& supports;
  const Loads& loads;
  std::span<const contact::RigidWall> walls;
  std::span<const contact::PenaltyContact> contacts;
  std::span<const contact::InteriorContact> interiors;
  const TieForces& tie_forces;
  const Welds& welds;
  const RigidWelds& rigid_welds;
  const Rivets& rivets;
  const Joints& joints;
  const Strains& strains;
  const NodalForceGroups& nodal_forces;
  /// Of the requests' history nodes, then of the rigid bodies: their spins, added up over time.
  std::span<const Vec3d> history_rotation;
  const Accelerometers& accelerometers;

  Vec3d velocity(std::size_t node) const { return at_now(vec(v_before[node]), vec(state.v[node])); }
  Vec3d spin(std::size_t node) const { return at_now(vec(w_before[node]), vec(state.w[node])); }
  Vec3d acceleration(std::size_t node) const {
    return (1.0 / velocity_interval()) * (vec(state.v[node]) - vec(v_before[node]));
  }
  Vec3d rotary_acceleration(std::size_t node) const {
    return (1.0 / velocity_interval()) * (vec(state.w[node]) - vec(w_before[node]));
  }
  /// Time between t(n-1/2) and t(n+1/2); half a step at the start.
  double velocity_interval() const { return 0.5 * (state.dt + state.dt_previous); }

 private:
  Vec3d at_now(const Vec3d& before, const Vec3d& after) const {
    return before + share_before_now(state) * (after - before);
  }
};

/// Somebody who looks at the run from time to time. Reads, never writes.
class Recorder {
 public:
  virtual ~Recorder() = default;
  /// True if the state that is about to be complete at state.time has to be written, knowing the next step state.dt.
  virtual bool due(const system::State& state) = 0;
  /// `last`: the run ends here, whatever is due.
  virtual void write(const Snapshot& now, bool last) = 0;
  virtual void archive(Archive&) {}
};

}  // namespace nugget::impact
