// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "system/system.hpp"

namespace nugget::impact {

/// Two unit vectors a and b that complete the unit vector `d` to a right-handed triad d, a, b.
inline std::array<Vec3d, 2> normals(const Vec3d& d) {
  const Vec3d least = std::abs(d.x) <= std::abs(d.y) && std::abs(d.x) <= std::abs(d.z) ? Vec3d{1, 0, 0}
                      : std::abs(d.y) <= std::abs(d.z)                                 ? Vec3d{0, 1, 0}
                                                                                       : Vec3d{0, 0, 1};
  const Vec3d a = unit(cross(d, least));
  return {a, cross(d, a)};
}

/// Directions in which the velocity, or the spin, of a node or body gets given values at one time, by impulses along
/// themselves: made orthogonal one after the other (Gram and Schmidt).
class Directions {
 public:
  /// Whether `direction` can be met: not where three stand before it, or these hold it already (a share below 0.001 of
  /// it is left). `across`: `speed` is that of what is left of it, whatever those before it ask for.
  bool add(const Vec3d& direction, double speed, bool across = false) {
    if (n_ == 3) return false;
    Vec3d rest = direction;
    for (int k = 0; k < n_; ++k) {
      const double along = dot(met_[k].unit, direction);
      rest -= along * met_[k].unit;
      if (!across) speed -= along * met_[k].speed;
    }
    const double share = norm(rest);
    if (share < 1e-3) return false;
    met_[n_++] = {direction, (1.0 / share) * rest, share, speed / share, 0.0};
    return true;
  }
  int size() const { return n_; }
  void clear() { n_ = 0; }

  /// What is left of direction k, a unit vector, and the speed along it.
  const Vec3d& unit(int k) const { return met_[k].unit; }
  double speed(int k) const { return met_[k].speed; }

  /// Gives the body the spins about them.
  void drive_spin(system::RigidBody& body, system::State& state) {
    if (n_ == 0) return;
    Frame3d basis{met_[0].unit, met_[1].unit, met_[2].unit};
    if (n_ == 1) {
      const std::array<Vec3d, 2> others = normals(basis.e1);
      basis.e2 = others[0];
      basis.e3 = others[1];
    }
    if (n_ == 2) basis.e3 = cross(basis.e1, basis.e2);
    const Vec3d before = body.angular_momentum;
    body.drive_spin(basis, (1u << n_) - 1u, {met_[0].speed, met_[1].speed, met_[2].speed}, state.dt, state);
    for (int k = 0; k < n_; ++k) met_[k].impulse = dot(met_[k].unit, body.angular_momentum - before);
  }
  /// The impulse along `unit(k)`; after `share_out` along direction k as it was given.
  double impulse(int k) const { return met_[k].impulse; }
  void set_impulse(int k, double impulse) { met_[k].impulse = impulse; }
  /// Makes of the impulses those along the directions as they were given, with the same sum.
  void share_out() {
    for (int j = n_ - 1; j >= 0; --j) {
      met_[j].impulse /= met_[j].share;
      for (int k = 0; k < j; ++k) met_[k].impulse -= met_[j].impulse * dot(met_[k].unit, met_[j].given);
    }
  }

 private:
  struct Met {
    Vec3d given, unit;
    double share = 1.0, speed = 0.0, impulse = 0.0;
  };
  std::array<Met, 3> met_;
  int n_ = 0;
};

}  // namespace nugget::impact
