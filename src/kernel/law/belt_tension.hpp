// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/curve.hpp"

namespace nugget::kernel {

/// Tension of a belt over its strain, or of a retractor over the length that was pulled out of it. It rises along a
/// loading curve; from where it turned back it falls along the unloading curve, which is moved along the abscissa until
/// both meet there, and rises again the same way up to that place. Never above the loading curve, never below a least
/// tension. Up to the first ordinate of the loading curve above 0 both ways go along that curve, as they do without an
/// unloading curve. The first ordinate of a curve holds before it, its last slope goes on beyond it. Source: LS-DYNA
/// theory manual, seat belts; LSTC's notes on *MAT_SEATBELT.
class BeltTension {
 public:
  struct State {
    double most = 0.0;   ///< largest abscissa so far
    double shift = 0.0;  ///< by which the unloading curve is moved
  };

  BeltTension() = default;
  /// Ordinates of both curves must not fall; those of the unloading curve must rise at its end. `unloading`: may be
  /// empty.
  BeltTension(Curve loading, Curve unloading, double least);

  State start() const;
  /// The tension [force] at `x`, which does not change the state.
  double operator()(double x, const State& state) const;
  /// The state once `x` was reached.
  void advance(double x, State& state) const;
  /// The largest slope that a belt of this state can have: of the pieces of both curves up to the largest abscissa so
  /// far, and the next of each.
  double steepest(const State& state) const;

  /// Why curves cannot be those of a belt; empty: they can.
  static const char* fault_of_loading(const Curve& curve);
  static const char* fault_of_unloading(const Curve& curve);

 private:
  void meet(State& state) const;
  Curve loading_, unloading_;
  double least_ = 0.0, first_ = 0.0;
};

}  // namespace nugget::kernel
