// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "base/index.hpp"
#include "base/row.hpp"
#include "base/zeroed.hpp"

namespace nugget::system {

/// By node. Over several ranks those of nodes that nobody here follows may take no room.
using Rows = ZeroedVector<Row>;

/// All that changes from step to step and belongs to nodes: plain arrays, nodes in the system's own order, then one
/// virtual node for each rigid body. Element states live in their groups, rigid-body momenta in the bodies.
struct State {
  double time = 0.0;         ///< t(n) of x and f
  double dt = 0.0;           ///< step from t(n) to t(n+1)
  double dt_previous = 0.0;  ///< step from t(n-1) to t(n)
  int period = 1;            ///< steps of length dt up to where all elements have forces again; 1 but in sub-cycling
  double interval() const { return period * dt; }  ///< their time
  /// The impulses of this step are the first of a period, whose end is the next state that is recorded.
  bool begins_period() const { return cycle == 0 || cycle % period == 1; }
  long cycle = 0;         ///< n
  bool relaxing = false;  ///< dynamic relaxation, before the run
  /// What a *SENSOR_CONTROL has come to by the last look at its switches, before the step to come.
  struct Controlled {
    bool on = true;
    double since = 0.0;  ///< when it was turned on, or off [time]; 0: at the start
    void archive(Archive& a) { a(on, since); }
  };
  std::vector<Controlled> controls;  ///< by Model::sensor_controls
  /// Whether what this control turns on and off acts; -1: nothing does so.
  bool acts(int control) const { return control < 0 || controls[control].on; }
  double turned_on(int control) const { return control < 0 ? 0.0 : controls[control].since; }
  Rows x;     ///< positions at t(n) [length]
  Rows v, w;  ///< velocities and spins at t(n-1/2), after `accelerate` at t(n+1/2)
  Rows f, m;  ///< forces and moments on the nodes at t(n): external minus internal

  void archive(Archive& a);
};

/// The weight of a force of this step in its mean over a period, whose steps are as long as the last one: the next
/// one's length says nothing of it.
inline double time_of_mean(const State& s) {
  return s.cycle == 0 ? s.dt : s.dt_previous;
}

}  // namespace nugget::system
