// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/honeycomb.hpp"
#include "kernel/law/orthotropic_point.hpp"

namespace nugget::kernel {

/// History of a point: plastic strain (0), which stays 0, material axes, relative volume less 1, six strains and the
/// viscous stress of the last step. The last two are in the material axes and do not turn.
template <>
class LawKernel<Honeycomb> {
 public:
  explicit LawKernel(const Honeycomb& law);

  static constexpr int volume_field = first_axis_field + 6, strain_field = volume_field + 1,
                       viscous_field = strain_field + 6;
  int layer_history() const { return 1; }
  int solid_history() const { return viscous_field + 6; }
  const MaterialAxes& axes() const { return law_.axes; }
  bool has_strain_limits() const { return law_.tensile_failure > 0.0 || law_.shear_failure > 0.0; }

  /// The stiffer of the uncrushed and the compacted state, whichever there is, and with the viscosity: the step is safe
  /// in any of them.
  template <class R>
  R wave_modulus(const double*) const {
    return R(wave_modulus_);
  }
  /// Largest modulus of the normal stresses now, over that of the compacted state.
  template <class R>
  R stiffness_share(const double* history) const {
    return R(soft_share_) + (1.0 - soft_share_) * compaction(load_field<R>(history, volume_field));
  }
  /// Whether a strain is beyond TSEF or SSEF.
  template <class R>
  MaskOf<R> beyond_strain_limits(const double* history) const {
    auto beyond = R(0.0) > R(1.0);
    for (int i = 0; i < 6; ++i) {
      const R strain = load_field<R>(history, strain_field + i);
      const double most = i < 3 ? law_.tensile_failure : law_.shear_failure;
      if (most > 0.0) beyond = beyond || (i < 3 ? strain : abs(strain)) >= R(most);
    }
    return beyond;
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>&, const LayerTensor<R>&, double, double*) const {
    return {};
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const;
  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    turn_solid_axes(q, history);
  }

 private:
  template <class R>
  R compaction(const R& grown) const {
    return min(max((-1.0 / (1.0 - law_.compacted_volume)) * grown, R(0.0)), R(1.0));
  }
  /// Limits of the six stresses.
  template <class R>
  std::array<R, 6> limits(const R& crushed, const std::array<R, 6>& strain) const;
  template <class R>
  SolidTensor<R> compacted(const SolidTensor<R>& s, const SolidTensor<R>& e) const;

  Honeycomb law_;
  ElasticConstants compacted_;
  std::array<int, 6> same_;  ///< the first component with the same curve
  double soft_share_, wave_modulus_;
};

}  // namespace nugget::kernel
