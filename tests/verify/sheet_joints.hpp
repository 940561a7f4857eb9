// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "experiment.hpp"

// Joints of sheets without elements in the deck (*CONSTRAINED_INTERPOLATION_SPOTWELD, _SPR2) between two sheets of
// which one is moved as a whole.
namespace nugget::verify {

inline const Vec3d joint_spot{9.0, 11.0, 0.75};  ///< the location node, 99, of set 7 [mm]

/// Sheet 1 of 20 mm, held, and sheet 2, 1.5 mm above it: 2 x 2 shells each, the joint not over a node. `place`: where a
/// node that starts at x is at s from 0 to 1, in 1e-3 s, in mm. `joint`: the joint's cards. `length` and `mass` are
/// what 1 mm and 1 t are in the deck's units.
std::string moved_sheet(const std::string& joint, const std::function<Vec3d(const Vec3d& x, double s)>& place,
                        double length = 1.0, double mass = 1.0);

/// What the joint says of itself in a cycle.
struct JointNow {
  double s = 0.0;
  std::array<double, 8> r{};  ///< resultants: axial, shears, torsion, moments
  bool alive = true;
  double energy = 0.0;
  double shear() const;
  /// Moment `lever` from the middle.
  double moment(double lever = 0.0) const;
};

/// Runs, with the joint's state in each cycle.
std::vector<JointNow> follow_joint(Experiment& run);
/// The state closest to s.
const JointNow& at_share(const std::vector<JointNow>& seen, double s);

}  // namespace nugget::verify
