// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/curve.hpp"

// Laws of single degrees of freedom, force over displacement or moment over angle: what discrete beams (ELFORM 6) and
// *ELEMENT_DISCRETE have. Plain doubles: curves have no SIMD form, and such elements are few.
namespace nugget::kernel {

/// A piecewise linear force over displacement or over rate; the end slopes go on beyond the ends. A curve that starts
/// at 0 or to the right of it holds for both signs: f(-d) = -f(d).
class ForceCurve {
 public:
  ForceCurve() = default;
  explicit ForceCurve(const Curve& curve);

  bool empty() const { return x_.empty(); }
  double operator()(double d) const;
  /// As a factor: an even function where the curve starts at 0 or to the right of it, its end values beyond its ends.
  double factor(double d) const;
  double slope(double d) const;  ///< of the piece that holds d; at a point the mean of both its pieces [force/length]
  double steepest() const;       ///< largest slope in size [force/length]
  double steepest_rise() const;  ///< largest rising slope; 0: it never rises
  double steepest_fall() const;  ///< largest falling slope, as a positive number; 0: it never falls
  double lowest() const;         ///< smallest ordinate
  double largest() const;        ///< largest ordinate in size

  /// As a yield force over plastic displacement: what holds for tension and, turned over, for compression. Both are the
  /// whole curve where it starts at 0 or to the right of it.
  ForceCurve tension_side() const;
  ForceCurve compression_side() const;
  /// The yield force at a plastic displacement q >= 0; never negative.
  double yield(double q) const;
  /// The q' >= q at which yield(q') + k (q' - q) = trial: where a force that was elastic up to `trial` comes to rest.
  /// k must exceed the steepest fall.
  double plastic_displacement(double q, double trial, double k) const;

 private:
  double piece(double d) const;

  std::vector<double> x_, y_, slope_;
  bool mirrored_ = false;
};

/// One degree of freedom of a discrete beam, or a spring. Its force is
///     F = F0 + f r(v) [1 + C1 v + C2 sgn(v) ln max(1, |v|/DLE)] + D v + g(d) h(v)
/// where f follows the displacement d as `kind` says and v is the rate of d. Sources: LS-DYNA Keyword Manual (MAT_066,
/// 067, 074, 119, S01-S08); Altair Radioss, LS-DYNA input interface, MAT_068, 119, 121, 196.
struct DiscreteSpring {
  DiscreteSpring();
  DiscreteSpring(const DiscreteSpring&);
  DiscreteSpring(DiscreteSpring&&) noexcept;
  DiscreteSpring& operator=(const DiscreteSpring&);
  DiscreteSpring& operator=(DiscreteSpring&&) noexcept;
  ~DiscreteSpring();

  enum class Kind {
    none,          ///< f = 0
    linear,        ///< f = K d
    elastic,       ///< f = load(d)
    two_curves,    ///< load(d) where |d| grows, unload(d) where it falls
    hysteresis,    ///< slope K between the load curve and the unload curve
    elastoplastic  ///< slope K up to the yield force load(q), q the accumulated plastic displacement
  };
  Kind kind = Kind::none;
  double stiffness = 0.0;                                ///< K [force/length]
  double damping = 0.0;                                  ///< D [force time/length]
  double preload = 0.0;                                  ///< F0 [force]
  double start = 0.0;                                    ///< displacement at time 0 [length]
  double linear_rate = 0.0, log_rate = 0.0, rate = 1.0;  ///< C1 [time/length], C2 [1], DLE [length/time]
  ForceCurve load, unload;                               ///< elastoplastic: yield force in tension, in compression
  ForceCurve damper, damper_scale;                       ///< h over v; g over d, 1 where it is empty
  ForceCurve rate_scale;                                 ///< r over v, 1 where it is empty

  struct State {
    double displacement = 0.0;
    double force = 0.0;    ///< f alone
    double plastic = 0.0;  ///< q
  };
  /// Advances the state by the displacement `increment` at `velocity`; returns F.
  double advance(State& state, double increment, double velocity) const;
  /// Slope of f at the start, for linear analyses [force/length].
  double initial_stiffness() const { return stiffness_at(start); }
  /// The same at another displacement. Where the force has yielded by then it is that of unloading.
  double stiffness_at(double displacement) const;
  /// F at the start, at rest [force].
  double force_at_start() const;
  /// Slope of the damping forces at the start [force time/length].
  double initial_viscosity() const;
  /// Bounds for the time step: largest stiffness, largest viscosity at a force `f`.
  double greatest_stiffness() const;
  double greatest_viscosity(double f) const;
};

}  // namespace nugget::kernel
