// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "weld/tie/ties.hpp"

// What a weld costs an explicit run: its time step, and the mass that a larger one takes.
namespace nugget::weld {

/// Time step, mass and stiffness of a weld as the deck gives it.
struct MassScalingCost {
  double time_step =
      std::numeric_limits<double>::infinity();  ///< infinite for a rigid weld, which limits nothing [time]
  double mass = 0.0;                            ///< [mass]
  double young = 0.0;                           ///< of the weld material; 0 for a rigid weld [stress]
  double mass_by_dt = 0.0;                      ///< that DT of the weld material will add [mass]
  /// That DT2MS will add on top, up to a step of |DT2MS TSSFAC|, of discrete beams and welds with a free end of
  /// |DT2MS|; with DT2MS > 0 and without DT what it takes away, too, below 0 [mass].
  double mass_by_dt2ms = 0.0;
};

/// `x`: node coordinates after projection. Step of a beam L / sqrt(E / rho); of a brick its volume over its largest
/// face over the speed of a plane wave (docs/theory/beam.md#mass-and-rotary-inertia-of-a-beam and
/// docs/theory/time_step.md#bricks, Q = 0); the projected length and section count.
MassScalingCost mass_scaling_cost(const model::Model& model, const std::vector<Vec3d>& x, const Weld& weld);

/// Two ways to one time step (docs/theory/time_step.md#step-of-a-weld; S. Bala, "Time-Step Scaling").
struct StepCost {
  double mass = 0.0;  ///< to be added: m ((DT / step)^2 - 1); 0 where the weld's step is large enough [mass]
  double young =
      0.0;  ///< or to be taken: E (step / DT)^2, for a beam L^2 rho / DT^2; E where it need not change [stress]
};
StepCost cost_of_step(const MassScalingCost& cost, double step);

}  // namespace nugget::weld
