// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/curve.hpp"
#include "kernel/law/axes_field.hpp"
#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/law_kernel.hpp"

namespace nugget::kernel {

/// Honeycomb (MAT_026, and MAT_126 with a curve for each stress): in the material axes each of the six stresses goes by
/// its own strain, with a modulus between that of the uncrushed core and that of the compacted metal,
///   M = M_u + beta (M_c - M_u),  beta = (1 - V) / (1 - VF) between 0 and 1,
/// V the relative volume, M_c = E or E / (2 (1 + PR)), and is held between -s and s, s by a curve. Where V <= VF the
/// material is elastic and perfectly plastic (von Mises). Sources: LS-DYNA keyword manual II and theory manual,
/// material 26.
struct Honeycomb {
  /// What the curves of the largest stress are over.
  enum class Over {
    volume,              ///< 1 - V of all components
    strain,              ///< the component's own logarithmic strain, compression positive; of shears gamma, either sign
    engineering_strain,  ///< the component's own change of length over the length at first; of shears gamma
  };

  double E = 0.0, nu = 0.0;         ///< of the compacted material [stress], [1]
  double yield = 0.0;               ///< SIGY of the compacted material [stress]
  double compacted_volume = 0.0;    ///< VF [1]
  std::array<double, 6> modulus{};  ///< EAAU EBBU ECCU GABU GBCU GCAU of the uncrushed core [stress]
  std::array<Curve, 6> limit;       ///< largest stress aa bb cc ab bc ca [stress]; never below 0
  Over over = Over::volume;
  Curve rate_factor{};     ///< LCSR: factor on the limits over the norm of the deviatoric strain rate; empty: none
  double viscosity = 0.0;  ///< MU: viscous stress MU M dt d of each component [1]
  double tensile_failure = 0.0;  ///< TSEF, strain along a, b or c at which a point fails [1]; 0: none
  double shear_failure = 0.0;    ///< SSEF, the same of gamma ab, bc or ca [1]; 0: none
  MaterialAxes axes;
};

/// History of a point: material axes, relative volume less 1, six strains and the
/// viscous stress of the last step. The last two are in the material axes and do not turn.
template <>
class LawKernel<Honeycomb> {
 public:
  static constexpr bool has_plastic_strain = false;

  explicit LawKernel(const Honeycomb& law);

  static constexpr int volume_field = first_axis_field + 6, strain_field = volume_field + 1,
                       viscous_field = strain_field + 6;
  int solid_history() const { return viscous_field + 6; }
  const MaterialAxes& axes() const { return law_.axes; }
  bool can_fail() const { return law_.tensile_failure > 0.0 || law_.shear_failure > 0.0; }

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
  MaskOf<R> failed(const double* history) const {
    auto beyond = R(0.0) > R(1.0);
    for (int i = 0; i < 6; ++i) {
      const R strain = load_field<R>(history, strain_field + i);
      const double most = i < 3 ? law_.tensile_failure : law_.shear_failure;
      if (most > 0.0) beyond = beyond || (i < 3 ? strain : abs(strain)) >= R(most);
    }
    return beyond;
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
