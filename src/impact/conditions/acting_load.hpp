// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// A load of the model (model/loads.hpp) as it acts during a run. Each kind of load has a file with its specialisation:
///   ActingLoad(const Load&, const system::System&)
///   apply(State&, double dt, double& work)  adds it at state.time to state.f and state.m, and to `work` [energy] what
///                                           it has done over the step that ends there (velocities of that step in
///                                           the state, length `dt`; 0 at the start)
///   archive(Archive&)
/// and update_masses() where it acts on masses, which mass scaling and erosion change; work(), reset_work() and
/// carry(), where it books its work by node and several ranks share it out.
template <class Load>
class ActingLoad;

/// The value of a load's curve at `time`: zero outside it, and in a phase that it is not for (SIDR). A time that
/// round-off puts behind the last point (an end time by an expression) is there: the last row of a run has its loads.
double load_value(const Curve& curve, double time, const system::State& state);

}  // namespace nugget::impact
