// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "base/curve.hpp"
#include "kernel/law/cohesive.hpp"

namespace nugget::kernel {

/// Cohesive laws whose traction has one shape in all modes: a curve f of the separation over that at failure, from
/// (0, 0) by the peak 1 to (1, 0), on which f(lambda)/lambda never grows. Pressure is elastic.
///
/// `potential`, *MAT_COHESIVE_TH: lambda = |(d_n/d_I, d_t/d_II)|, and the tractions are the derivatives of
/// d_I T int f dlambda: t_n = T f/lambda d_n/d_I, t_t = T f/lambda (d_I/d_II) d_t/d_II, with d_I, d_II the separations
/// at failure. Loading and unloading go the same way until the point has failed. Source: V. Tvergaard, J.W. Hutchinson,
/// J. Mech. Phys. Solids 41 (1993), and the manual's remarks.
///
/// `power` and `benzeggagh`, *MAT_COHESIVE_GENERAL with TES 0 and 1: lambda = |d|/d_F, tractions (1 - D) k d with the
/// first stiffness of each mode and D = 1 - f/(f'(0) lambda), and d_F such that on a straight way (G_I/GIC)^X +
/// (G_II/GIIC)^X = 1, or G = GIC + (GIIC - GIC)(G_II/G)^X. Unloading is towards the origin. In pure modes that is the
/// manual's law; its mixed tractions, T f d_n/|d| and S f d_t/|d|, have a stiffness that depends on the mode and give
/// energy that nobody put in: a lap joint begins to flutter.
struct ShapedCohesion {
  enum class Mixing { none, potential, power, benzeggagh };
  Mixing mixing = Mixing::none;                        ///< none: the bond has another law
  Curve shape;                                         ///< f
  double normal_strength = 0.0, shear_strength = 0.0;  ///< T, S; of `potential` T alone counts [stress]
  double normal_end = 0.0, shear_end = 0.0;            ///< d_I, d_II: of pure modes [length]
  double normal_energy = 0.0, shear_energy = 0.0;      ///< GIC, GIIC; not of `potential` [energy/area]
  double exponent = 1.0;                               ///< X
  double pressure_factor = 1.0;                        ///< stiffness under pressure over the first in tension

  bool given() const { return mixing != Mixing::none; }
  bool reversible() const { return mixing == Mixing::potential; }
  double slope() const { return shape.y[1] / shape.x[1]; }  ///< f over lambda at first
  /// Area under f.
  double area() const {
    double sum = 0.0;
    for (std::size_t i = 1; i < shape.x.size(); ++i)
      sum += 0.5 * (shape.y[i] + shape.y[i - 1]) * (shape.x[i] - shape.x[i - 1]);
    return sum;
  }

  /// Separation at failure where the tension has this share in its square; not of `potential` [length].
  double end(double tension) const {
    const CohesiveStiffness k = first_stiffness();
    const double t = k.tension * tension, s = k.shear * (1.0 - tension);
    const double squared =  // of the separation, over f'(0)/area
        mixing == Mixing::power
            ? std::pow(std::pow(t / normal_energy, exponent) + std::pow(s / shear_energy, exponent), -1.0 / exponent)
            : (normal_energy + (shear_energy - normal_energy) * std::pow(s / (t + s), exponent)) / (t + s);
    return std::sqrt(slope() / area() * squared);
  }

  /// Stiffness of each mode at first: for waves, pressure and linear analyses [stress/length].
  CohesiveStiffness first_stiffness() const {
    if (mixing == Mixing::potential)
      return {slope() * normal_strength / normal_end, slope() * normal_strength * normal_end / (shear_end * shear_end)};
    return {slope() * normal_strength / normal_end, slope() * shear_strength / shear_end};
  }

  /// The largest stiffness of any mode and of pressure [stress/length].
  double stiffest() const {
    const CohesiveStiffness k = first_stiffness();
    return std::max({k.tension, k.shear, pressure_factor * k.tension});
  }

  /// Traction at a separation (x and y along the surface, z normal to it), and the damage from then on: 1 - f/lambda
  /// over its first value. It stays at 1 once it is there; below, `potential` takes it back.
  Vec3d traction(const Vec3d& d, double& damage) const {
    const double normal = std::max(0.0, d.z), along = std::hypot(d.x, d.y), size = std::hypot(normal, along);
    const CohesiveStiffness k = first_stiffness();
    double lambda = 0.0;
    if (mixing == Mixing::potential)
      lambda = std::hypot(normal / normal_end, along / shear_end);
    else if (size > 0.0)
      lambda = size / end(normal / size * (normal / size));
    const double now = damage_at(lambda);
    if (damage < 1.0) damage = reversible() ? now : std::max(damage, now);
    const double left = 1.0 - damage;
    return {left * k.shear * d.x, left * k.shear * d.y,
            d.z > 0.0 ? left * k.tension * d.z : pressure_factor * k.tension * d.z};
  }

 private:
  double damage_at(double lambda) const {
    if (lambda >= 1.0) return 1.0;
    return lambda > 0.0 ? std::max(0.0, 1.0 - shape.clamped(lambda) / (slope() * lambda)) : 0.0;
  }
};

}  // namespace nugget::kernel
