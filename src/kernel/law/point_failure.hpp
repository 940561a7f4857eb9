// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "base/batch.hpp"
#include "kernel/law/cracks.hpp"
#include "kernel/law/law_components.hpp"
#include "kernel/law/point_now.hpp"
#include "kernel/law/stress_space.hpp"

namespace nugget::kernel {

/// What happened to a point in a step. A layer's strain rate through the thickness is in `rate` too.
template <class R>
struct PointStep {
  SolidTensor<R> stress;  ///< of the undamaged point at the end of the step
  SolidTensor<R> rate;    ///< strain rate; shears are engineering shears
  R plastic_strain;       ///< at the end of the step
  R plastic_increment;
  R plastic_thinning;  ///< plastic strain increment through the thickness of a layer, thinner positive
  R heating;           ///< temperature rise so far
  double dt = 0.0;
  bool layer = false;
  R flow_failed{};  ///< 1 where the flow itself says that the point fails
};

/// Damage and failure of a point of a compound law. Its history begins with the share of its stress that the point has
/// lost, 1 once it has failed; the other numbers are what its criteria need.
class PointFailure {
 public:
  /// `flow_can_fail`: the flow itself says when a point fails (PointStep::flow_failed).
  PointFailure(const LawComponents& law, bool flow_can_fail);

  bool active() const { return active_; }
  int history() const { return size_; }

  /// Share of the undamaged point's stress that is left.
  template <class R>
  static R left(const double* history) {
    return R(1.0) - load_field<R>(history, lost_field);
  }
  template <class R>
  void advance(const PointStep<R>& step, double* history) const;

  /// Where the history holds the size of the element, which is set before the first step; 0: nowhere.
  int size_field() const { return gissmo_ ? damaged_ + Gissmo::size_field : 0; }

  /// `history(i)`: the i-th number of the point's history.
  DamageNumbers damage(const std::function<double(int)>& history) const;

  bool softens() const { return damage_ || cracks_ || gissmo_ || energy_damage_; }
  /// The undamaged point's stress from that handed out, and what is left of it. A point that has nothing left has
  /// stress 0.
  template <class R>
  void restore_undamaged(LayerTensor<R>& s, const double* history) const;
  template <class R>
  void restore_undamaged(SolidTensor<R>& s, const double* history) const {
    if (has_lost<R>(history)) s = (1.0 / max(left<R>(history), R(1e-30))) * s;
  }
  template <class R>
  void weaken(LayerTensor<R>& s, const double* history) const;
  template <class R>
  void weaken(SolidTensor<R>& s, const double* history) const {
    if (has_lost<R>(history)) s = left<R>(history) * s;
  }

  /// Turns what stands in a solid's axes with the material.
  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    if (strain_ == 0) return;
    SolidTensor<R> e = load_solid<R>(history + strain_ * lanes<R>);
    store_solid(history + strain_ * lanes<R>, rotated(q, e));
  }

 private:
  static constexpr int lost_field = 0;

  /// Most points of most runs have lost nothing.
  template <class R>
  static bool has_lost(const double* history) {
    return any(load_field<R>(history, lost_field) > 0.0);
  }

  /// Limits of what is known of a stress or strain without its principal values; infinite where there is none.
  struct Bounds {
    explicit Bounds(const Erosion& erosion, const StrainLimits& limits);
    double pressure, tension, principal_stress, effective_stress;
    double high, low, effective_strain, growth, shrinkage, shear, thinning, age;
    bool of_stress, of_strain;
  };
  /// Which points may have failed: a cheap test that lets through all that have. Only for laws without damage, cracks,
  /// rules or a criterion over the rate or time.
  template <class R>
  MaskOf<R> may_fail(const PointStep<R>& step, const double* history) const;
  /// Takes the step in the history of all rules; whether one of them is used up.
  bool advance_rules(const PointNow& now, double* history, int stride) const;
  bool eroded(const PointNow& now) const;
  bool beyond_strain_limits(const PointNow& now, double thinning) const;
  int add(bool needed, int numbers);

  double failure_strain_;
  Curve failure_strain_over_rate_;
  std::optional<PlasticDamage> damage_;
  std::optional<Cracks> cracks_;
  std::vector<FailureRule> rules_;
  std::optional<Gissmo> gissmo_;
  std::optional<EnergyDamage> energy_damage_;
  std::optional<Erosion> erosion_;
  StrainLimits limits_;
  Bounds bounds_;
  int size_ = lost_field + 1;
  int cracked_, ruled_, damaged_, weakened_, thinned_, strain_, impulse_, age_;  ///< places in the history; 0: not kept
  bool flow_can_fail_, active_, by_plastic_strain_only_;
  bool bounded_;             ///< may_fail() can be asked
  bool gissmo_only_;         ///< there is no other criterion
  bool needs_plastic_flow_;  ///< a point that has not failed only can in a step with plastic strain
};

}  // namespace nugget::kernel
