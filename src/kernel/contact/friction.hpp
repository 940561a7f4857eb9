// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/vec3.hpp"

namespace nugget::kernel {

/// Friction after Coulomb, with a coefficient that falls from the static to the dynamic one and a bound on the shear
/// stress: mu = FD + (FS - FD) exp(-DC |v|), force <= mu |normal force|, force <= VC area (LS-DYNA keyword manual,
/// *CONTACT, card 2).
struct Friction {
  double static_coefficient = 0.0, dynamic_coefficient = 0.0;  ///< FS, FD [1]
  double decay = 0.0;                                          ///< DC [time/length]
  double shear_strength = 0.0;                                 ///< VC; 0: no bound [stress]

  bool any() const { return static_coefficient > 0.0 || dynamic_coefficient > 0.0; }
  /// Largest friction force of a pair [force].
  double bound(double normal_force, double slip_speed, double area) const {
    const double coefficient =
        dynamic_coefficient + (static_coefficient - dynamic_coefficient) * std::exp(-decay * slip_speed);
    const double coulomb = coefficient * normal_force;
    return shear_strength > 0.0 ? std::min(coulomb, shear_strength * area) : coulomb;
  }
};

/// Friction of two surfaces that differ. Ours: half of each; the keyword manual names no rule.
inline Friction mean(const Friction& a, const Friction& b) {
  return {0.5 * (a.static_coefficient + b.static_coefficient), 0.5 * (a.dynamic_coefficient + b.dynamic_coefficient),
          0.5 * (a.decay + b.decay), 0.5 * (a.shear_strength + b.shear_strength)};
}

/// Friction of surfaces of several kinds: by their parts.
class FrictionTable {
 public:
  FrictionTable() = default;
  explicit FrictionTable(const Friction& everywhere) : of_pairs_{everywhere} {}
  /// `of_pairs`: by the first kind, then the second.
  FrictionTable(int kinds, std::vector<Friction> of_pairs) : kinds_(kinds), of_pairs_(std::move(of_pairs)) {}

  bool any() const {
    return std::any_of(of_pairs_.begin(), of_pairs_.end(), [](const Friction& f) { return f.any(); });
  }
  const Friction& between(int a, int b) const { return of_pairs_[a * kinds_ + b]; }

 private:
  int kinds_ = 1;
  std::vector<Friction> of_pairs_{Friction{}};
};

/// Force on a node that slides over a surface: a spring that had the force `before` is drawn out by `slip`, and slips
/// at `bound`.
inline Vec3d sliding_spring(const Vec3d& before, double stiffness, const Vec3d& slip, double bound) {
  const Vec3d trial = before - stiffness * slip;
  const double size = norm(trial);
  return size > bound ? (bound / size) * trial : trial;
}

}  // namespace nugget::kernel
