// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/curve.hpp"
#include "kernel/law/stress_space.hpp"

namespace nugget::kernel {

/// Damage of ductile metals over any path of stress (GISSMO: F. Neukamm, M. Feucht, A. Haufe, Considering damage
/// history in crashworthiness simulations, 7th European LS-DYNA Conference 2009; *MAT_ADD_DAMAGE_GISSMO of the keyword
/// manual). Damage D and instability F grow with the plastic strain p,
///   dD = n / ef D^(1 - 1/n) dp,   dF = n / ec F^(1 - 1/n) dp,
/// ef and ec those of the moment's stress. A point carries its whole stress until F is 1, then
///   1 - ((D - Dc) / (1 - Dc))^m
/// of it, Dc the damage at which F became 1; it has failed when D is 1.
///
/// D^(1/n) is the sum of dp / ef whatever the path, so that is what is summed, without an error of the step.
struct Gissmo {
  CurveTable fracture;           ///< LCSDG: ef over triaxiality; of a table one curve for each Lode parameter [1]
  CurveTable instability{};      ///< ECRIT: ec in the same way; not given: `threshold` holds instead [1]
  double threshold = 0.0;        ///< DCRIT: damage from which on stress is lost [1]
  double growth = 1.0;           ///< DMGEXP: n
  CurveTable fading{};           ///< FADEXP: m over element size [length]; of a table one curve for each triaxiality
  CurveTable mesh{};             ///< LCREGD: factor on ef, in the same way; not given: 1
  double shear = 0.0;            ///< SHRF: share of the effect of `mesh` that is missing at triaxiality 0 and below
  double biaxial = 0.0;          ///< BIAXF: the same at 2/3 and above
  double shear_end = 1.0 / 3.0;  ///< RGTR1: triaxiality up to which some is missing
  double biaxial_start = 1.0 / 3.0;  ///< RGTR2: triaxiality from which on some is missing
  Curve rate{};                      ///< LCSRS: factor on ef over the plastic strain rate; empty: 1
  bool log_rates = false;            ///< its abscissae are natural logarithms
  bool rate_of_instability = false;  ///< the factor is on ec too
  Curve heat{};                      ///< LCH of MAT_224: factor on ef over the temperature rise; empty: 1
  bool weakens = true;               ///< DTYP: false: damage is summed and has no effect

  // History of a point: size of its element, D^(1/n), F^(1/n), Dc (0 until F is 1).
  static constexpr int size_field = 0, damage_field = 1, instability_field = 2, onset_field = 3, history = 4;

  /// D and F of a point whose history holds these roots, at most 1.
  double grown(double root) const;

  /// Adds a step's plastic strain to the points that carry; the share of its stress that each has lost, 1 once it has
  /// failed. `stress`: that of the undamaged points; `heating`: their temperature rise so far; `h`: their histories.
  template <class R>
  R advance(const SolidTensor<R>& stress, const R& increment, const R& heating, MaskOf<R> carries, double dt,
            double* h) const;

 private:
  /// ef and ec of a point.
  struct Ends {
    double fracture, instability;
  };
  Ends ends(double triaxiality, double lode, double size, double plastic_rate, double heating) const;
  double mesh_factor(double triaxiality, double size) const;
  double rate_factor(double plastic_rate) const;
};

}  // namespace nugget::kernel
