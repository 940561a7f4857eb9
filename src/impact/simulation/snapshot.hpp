// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "impact/energy/energy.hpp"
#include "impact/simulation/components.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Everything known at one time t(n), for those who write results. Velocities at t(n) lie between `before` and state's,
/// in proportion to time: exact under a constant acceleration, at the start and where the step changes as well. The
/// velocities of dependent nodes (tied, of rigid bodies) follow those of the others at both times.
struct Snapshot {
  const system::System& system;
  const system::State& state;
  const Components& components;
  std::span<const Row> v_before, w_before;  ///< at t(n-1/2); those in state stand at t(n+1/2)
  /// Those from which on accelerations count: the same, but in sub-cycling at the first half step of the last period.
  std::span<const Row> v_period, w_period;
  const Energy& energy;
  const std::vector<PartEnergy>& parts;
  const system::System::Controlling& controlling;
  const system::System::Masses& masses;
  /// Of the requests' history nodes, then of the rigid bodies: their spins, added up over time.
  std::span<const Vec3d> history_rotation;

  Vec3d velocity(std::size_t node) const { return at_now(vec(v_before[node]), vec(state.v[node])); }
  Vec3d spin(std::size_t node) const { return at_now(vec(w_before[node]), vec(state.w[node])); }
  Vec3d acceleration(std::size_t node) const {
    return (1.0 / acceleration_time()) * (vec(state.v[node]) - vec(v_period[node]));
  }
  Vec3d rotary_acceleration(std::size_t node) const {
    return (1.0 / acceleration_time()) * (vec(state.w[node]) - vec(w_period[node]));
  }
  /// Time between t(n-1/2) and t(n+1/2); half a step at the start.
  double velocity_interval() const { return 0.5 * (state.dt + state.dt_previous); }

 private:
  /// Of the velocities that an acceleration compares: that, but in sub-cycling a period, at the start half of one.
  double acceleration_time() const {
    return 0.5 * (state.cycle == 0 ? state.interval() : state.period * (state.dt + state.dt_previous));
  }
  Vec3d at_now(const Vec3d& before, const Vec3d& after) const {
    return before + share_before_now(state) * (after - before);
  }
};

/// Over several ranks all follow the nodes of histories while they are few, so that nothing has to be sent for them; of
/// more the rank that answers for a node gives its motion.
inline bool history_nodes_are_shared_out(const model::Model& model) {
  constexpr std::size_t few = 1024;
  return model.requests.history_nodes.size() > few;
}

/// Somebody who looks at the run from time to time. Reads, never writes.
class Recorder {
 public:
  virtual ~Recorder() = default;
  /// True if the state that is about to be complete at state.time has to be written, knowing the next step state.dt.
  virtual bool due(const system::State& state) = 0;
  /// Of a state that is due: whether its energies or masses are looked at. They are those of an earlier one else.
  virtual bool energies_due(const system::State&) { return true; }
  /// `last`: the run ends here, whatever is due.
  virtual void write(const Snapshot& now, bool last) = 0;
  /// The earliest marks of time of what is to be written, which is due where the next step would pass them.
  struct Marks {
    double any = std::numeric_limits<double>::infinity();
    double of_elements = any;  ///< of what looks at states or forces of elements, not only at sums and nodes
    double of_energies = any;  ///< see energies_due
    bool elements = false;     ///< whether there is anything that looks at elements: it does so at the end
  };
  virtual Marks next_marks() const { return {}; }
  /// Results as large as the model, in which all ranks have a share.
  struct Shared {
    bool states = false;  ///< of d3plot
    bool rows = false;    ///< of elout
    bool nodes = false;   ///< of nodout, where these are shared out
    bool any() const { return states || rows || nodes; }
  };
  /// On the first rank: what `write` will write of them.
  virtual Shared shared_due(const system::State&, bool /*last*/) { return {}; }
  /// On another rank, while the first one writes: its share of them.
  virtual void give(const Snapshot&, Shared) {}
  /// A state of d3plot is wanted that is not due.
  virtual void ask_for_state() {}
  /// Waits until all that was written stands in its files; the run has ended.
  virtual void finish() {}
  virtual void archive(Archive&) {}
};

}  // namespace nugget::impact
