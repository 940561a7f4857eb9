// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace nugget::kernel {

/// Law of *CONSTRAINED_SPR2, a self-piercing rivet between two sheets: forces out of the opening d_n and the sliding
/// d_t of the sheets at the rivet, and of the largest effective displacement h so far, which is the damage (0 to 1):
///     f_n = d_n / (h DN) F_n(h),   f_t = d_t / (h DT) F_t(h),
///     F(h) = F_max [1 - (1 - h/x)^e] for h < x,   F_max (1 - h)/(1 - x) above,   x = XIN or XIT,   e = EXPN or EXPT,
///     h = max over time of [q + (1 - q)/a] sqrt((d_n/DN)^2 + (d_t/DT)^2),
///     q = 1 - 27/4 w^2 + 27/4 w^3,   w = 2/pi atan(d_n/d_t),
///     a = ALPHA1 to ALPHA2 over h from 0 to XIT, ALPHA2 to ALPHA3 over h from there to 1.
/// So in pure tension and pure shear f = F(d/DN), F(d/DT). Unloading goes straight back to the origin; at h = 1 the
/// rivet is gone. Of closing sheets h knows nothing; they are pressed apart with the stiffness of an undamaged rivet
/// (ours). Source: A.G. Hanssen, L. Olovsson, R. Porcaro, M. Langseth, Eur. J. Mech. A/Solids 29 (2010) 484, and
/// LS-DYNA Keyword Manual, Vol. I; what is ours: docs/theory/spr2.md.
struct Spr2 {
  double normal_force = 0.0, shear_force = 0.0;        ///< FN, FT [force]
  double normal_failure = 0.0, shear_failure = 0.0;    ///< DN, DT [length]
  double normal_peak = 0.5, shear_peak = 0.5;          ///< XIN, XIT: where the force is largest, 0 to 1
  std::array<double, 3> alpha{1.0, 1.0, 1.0};          ///< ALPHA1 to ALPHA3
  double normal_exponent = 8.0, shear_exponent = 8.0;  ///< EXPN, EXPT
  double arm = 0.0;  ///< distance of the sheets' middle surfaces, (t1 + t2)/2 [length]

  /// Along the normal, along s and t across it; about the normal, about s and t: the freedoms of a discrete beam whose
  /// r axis is the sheets' normal.
  using Freedoms = std::array<double, 6>;

  /// h of displacements, with a at the damage so far.
  double effective_displacement(const Freedoms& displacement, double damage) const;
  /// Forces at the middle between the sheets. Their moments there move the shear force towards the second sheet as the
  /// damage goes from XIT to 1.
  Freedoms forces(const Freedoms& displacement, double damage) const;
  /// Undamaged, of opening and of sliding [force/length].
  Freedoms stiffness() const { return {normal_stiffness(), shear_stiffness(), shear_stiffness(), 0.0, 0.0, 0.0}; }
  double normal_stiffness() const { return normal_force * normal_exponent / (normal_peak * normal_failure); }
  double shear_stiffness() const { return shear_force * shear_exponent / (shear_peak * shear_failure); }
};

}  // namespace nugget::kernel
