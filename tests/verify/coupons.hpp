// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/vec3.hpp"

namespace nugget::verify {

/// One of the coupons: two sheets of 1.5 mm, parts 1 and 2, one weld beam of 6 mm, part 3, over the
/// centre of an element at the origin. The grip of part 1 is held, that of part 2 moves along `pull`.
class Coupon {
 public:
  static constexpr double thickness = 1.5;
  // `cells`: elements across the sheets.
  static Coupon lap_shear(int cells);
  static Coupon coach_peel(int cells);
  static Coupon cross_tension(int cells);

  int pull() const { return pull_; }                          ///< degree of freedom, 1 or 3
  const std::vector<int>& driven() const { return driven_; }  ///< nodes of the moving grip
  const std::vector<int>& held() const { return held_; }

  /// Nodes, shells, the weld beam, *BOUNDARY_SPC_NODE of both grips.
  std::string text() const;

 private:
  explicit Coupon(int pull) : pull_(pull) {}
  /// A sheet swept over the points of `path`, each moved along the vectors of `across`.
  template <class Grip>
  void sheet(int part, const std::vector<Vec3d>& path, const std::vector<Vec3d>& across, const Grip& grip);

  int pull_;
  std::string nodes_, shells_;
  std::vector<int> held_, driven_;
  int last_shell_ = 0;
};

}  // namespace nugget::verify
