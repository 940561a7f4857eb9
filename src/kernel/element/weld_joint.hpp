// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "base/curve.hpp"
#include "base/vec3.hpp"
#include "kernel/law/yield_curve.hpp"

namespace nugget::kernel {

/// What is known of the sheet at one end of a weld.
struct JointEnd {
  double E = 0.0, nu = 0.0;  ///< of the sheet [stress], [1]
  double thickness = 0.0;    ///< t of the sheet [length]
  double diameter = 0.0;     ///< d of the nugget [length]
  double reach = 0.0;        ///< r = a_eff / (d/2): how far the forces of the end reach by its tie [1]
  Curve yield;               ///< yield stress of the sheet over its plastic strain, at rest [stress]; empty: elastic
  Curve rate_factor;         ///< on it, over the plastic strain rate [1/time]; empty: none
};

/// The joint of a weld, in series with its beam or its bricks: the deformation around the nugget that sheets lack whose
/// elements are too large to show it. Elastic flexibilities and one yield surface with hardening by plastic work, the
/// same for all loads,
///     (<N>/N0)^2 + (V/V0)^2 + (M/M0)^2 <= 1,    N0, V0, M0 functions of that work w,
/// N the normal force (of tension only), V the shear, M the bending moment at the weld's middle; flow is normal to it.
/// The surface is convex; its pure loads are those of docs/theory/ties.md#joint. The twist is not a joint's matter.
class WeldJoint {
 public:
  /// Normal, shear along s and t, moments about s and t: of forces, or of what they do work on.
  static constexpr int size = 5;
  using Freedoms = std::array<double, size>;
  /// Of a joint that has moved by `moved` in all and done plastic work `work`.
  struct State {
    Freedoms elastic{};  ///< its elastic part [length, angle]
    double work = 0.0;   ///< over the factor of the rate: that of the same motion at rest [energy]
    double rate = 0.0;   ///< plastic strain rate of the ring around the nugget, smoothed [1/time]
    Freedoms flow{};     ///< plastic motion in the step to come, where it comes from outside [length, angle]
  };
  /// Forces that a step would lead to if nothing flowed, and how much less each is for a unit of flow.
  struct Trial {
    Freedoms force{}, stiffness{};
  };

  static constexpr double never = 1e30;  ///< a limit of what does not flow: the mesh shows it, or the sheet is elastic
  explicit WeldJoint(std::span<const JointEnd> ends);

  /// What flows under a load alone, over the plastic work: N0, V0, M0 [force, moment over energy].
  struct PureLoads {
    Curve normal, shear, moment;
  };
  static PureLoads pure_loads(std::span<const JointEnd> ends);

  /// Elastic, of each freedom on its own.
  const Freedoms& flexibility() const { return flexibility_; }
  double in_plane() const { return flexibility_[1]; }  ///< [length/force]
  double bending() const { return flexibility_[3]; }   ///< [1/moment]
  bool flows() const { return flows_; }
  /// From now on State::flow says how much it flows: the weld is one of a stack (StackJoint).
  void flow_from_outside() { from_outside_ = true; }
  bool flows_from_outside() const { return from_outside_; }
  /// N0, V0 and M0 after a plastic work, at rest [force, moment].
  std::array<double, 3> limits(double work) const;

  /// Advances the joint of a weld that has the forces `force` and the elastic stiffness `stiffness` by `moved`, what
  /// both together move in a step, and returns what of it the weld itself gets. Exact for an elastic weld (implicit, to
  /// round-off); for one that yields, or is less stiff than said, the forces of both meet in the cycles after.
  Freedoms advance(State& state, const Freedoms& moved, const Freedoms& stiffness, const Freedoms& force,
                   double dt) const;
  Trial trial(const State& state, const Freedoms& moved, const Freedoms& stiffness, const Freedoms& force) const;

 private:
  /// The square root of the left side of the yield condition for the forces that are left of the trial after a further
  /// plastic work.
  double used(const Trial& trial, double work, double more) const;
  double plastic_work(const Trial& trial, double work) const;

  Freedoms flexibility_{};
  bool flows_ = false, from_outside_ = false;
  double work_of_strain_ = 0.0;         ///< plastic work of a unit strain of the ring, at first yield [energy]
  Curve rate_factor_;                   ///< of the weaker end
  YieldCurve normal_, shear_, moment_;  ///< N0, V0, M0 over the plastic work
};

/// What the joint of a weld would meet in a step if nothing flowed, in the weld's axes r, s, t in the middle of the
/// step.
struct WeldTrial {
  WeldJoint::Trial trial;
  Frame3d axes;
  bool holds = false;  ///< the weld has not failed
};

/// Shear that an end carries when it is not bent by it, since two welds pull it the same way from both its faces, over
/// the plastic work; [force] over [energy].
Curve unbent_shear_over_work(const JointEnd& end);
/// Plastic work of a unit strain of the ring around the nugget, at first yield [energy].
double work_of_strain(const JointEnd& end);

}  // namespace nugget::kernel
