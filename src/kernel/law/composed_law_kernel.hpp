// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "base/batch.hpp"
#include "kernel/law/composed_law.hpp"
#include "kernel/law/law_kernel.hpp"
#include "kernel/law/orthotropic.hpp"
#include "kernel/law/point_damage.hpp"

namespace nugget::kernel {

/// A law put together at run time. History of a point: that of its flow, which begins with the effective plastic
/// strain, then that of its failure (PointFailure): the share of its stress that it has lost, 1 once it has failed.
///
/// What depends on the composition is compiled in composed_law.cpp, for R = NativeBatch.
template <>
class LawKernel<ComposedLaw> {
 public:
  static constexpr bool has_plastic_strain = true;
  /// Foams, and rubber by a test, are stiffer under compression than in tension, or the other way round.
  static constexpr bool may_pull_otherwise = true;

  explicit LawKernel(const ComposedLaw& law);

  const ElasticConstants& elastic() const { return elastic_; }
  int layer_history() const { return history_; }
  int solid_history() const { return history_; }
  int fibre_history() const { return history_; }
  double deletion_step() const { return deletion_step_; }
  double step_share() const { return step_share_; }
  bool can_fail() const { return can_fail_; }
  double points_to_delete() const { return points_to_delete_; }
  /// Where the history of a point has material axes, how these lie at the start; null: there are none.
  const MaterialAxes* axes() const;
  /// Where the history of a point holds the size of its element, which is set before the first step: the root of a
  /// shell's area, the cube root of a solid's volume [length]; 0: nowhere.
  int size_field() const;
  /// Where the history of a point says, by 1, that its element stands beside a deleted one; 0: nowhere.
  int crash_front_field() const;
  /// Where a membrane writes into the history of a point by how fast its material turns beside its axes; 0: nowhere.
  int spin_field() const { return spin_field_; }
  /// `history(i)`: the i-th number of a point's history.
  DamageNumbers damage(const std::function<double(int)>& history) const;
  template <class R>
  MaskOf<R> failed(const double* history) const {
    return load_field<R>(history, lost_) >= R(1.0);
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const;
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const;
  /// A fibre: what its criteria ask of the strain across is Poisson's ratio of the elastic part and a half of the rest.
  template <class R>
  void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt, double* history) const;
  template <class R>
  void rotate(const Frame<R>& q, double* history) const;
  template <class R>
  R wave_modulus(const double* history) const;
  /// Whether layers may become stiffer than elastic() says, and how much stiffer one is in its plane, at least 1.
  bool layers_stiffen() const { return layers_stiffen_; }
  template <class R>
  R layer_stiffening(const double* history) const;
  /// Stiffness of a point now over that of elastic(), for hourglass control.
  template <class R>
  R stiffness_share(const double* history) const;
  /// The same law for motions so small that its stress is linear in them: the change of an equation of state's pressure
  /// from that at the start.
  LawKernel linear_at_start() const;
  /// Heats points with an equation of state by the work of bulk viscosity [energy/present volume].
  template <class R>
  void add_viscous_work(const R& work, double* history) const;

 private:
  struct Parts;
  /// One pressure instead of the flow's, and what it breaks. `start`: the stress before the step.
  template <class R>
  void set_pressure(SolidTensor<R>& s, const SolidTensor<R>& start, const SolidTensor<R>& rate, double dt,
                    double* history) const;

  ElasticConstants elastic_;
  std::shared_ptr<const Parts> parts_;
  int lost_, pressure_, history_;  ///< where in the history stand what a point has lost, and its pressure; its size
  int spin_field_;
  double points_to_delete_, deletion_step_, step_share_;
  bool can_fail_, layers_stiffen_;
};

}  // namespace nugget::kernel
