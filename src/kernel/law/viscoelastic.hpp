// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "kernel/law/law_cards.hpp"
#include "kernel/law/relaxation.hpp"
#include "kernel/law/single_points.hpp"

namespace nugget::kernel {

class ViscoelasticPoint;
class GeneralViscoelasticPoint;

/// Linear viscoelastic shear, elastic volume (MAT_006, MAT_061), a law of solids: shear modulus GI + (G0 - GI)
/// exp(-BETA t).
struct Viscoelastic {
  using Point = ViscoelasticPoint;

  double E = 0.0;                    ///< instantaneous Young's modulus, from BULK and G0 [stress]
  double nu = 0.0;                   ///< instantaneous Poisson's ratio [1]
  double bulk = 0.0;                 ///< [stress]
  double instantaneous_shear = 0.0;  ///< G0 [stress]
  double long_term_shear = 0.0;      ///< GI [stress]
  double decay = 0.0;                ///< BETA [1/time]

  /// Sets E and nu.
  void complete() {
    E = 9.0 * bulk * instantaneous_shear / (3.0 * bulk + instantaneous_shear);
    nu = (3.0 * bulk - 2.0 * instantaneous_shear) / (6.0 * bulk + 2.0 * instantaneous_shear);
  }

  static LawCards<Viscoelastic> cards() {
    using Law = Viscoelastic;
    return {
        .name = "MAT_VISCOELASTIC",
        .aliases = {"MAT_006"},
        .cards = {{{&Law::bulk, real("bulk", dimension::stress, required, above_zero(), "bulk modulus")},
                   {&Law::instantaneous_shear,
                    real("g0", dimension::stress, required, above_zero(), "shear modulus at once")},
                   {&Law::long_term_shear, real("gi", dimension::stress, 0, at_least(0), "shear modulus in the end")},
                   {&Law::decay, real("beta", dimension::rate, 0, at_least(0), "decay: GI + (G0 - GI) exp(-BETA t)")}}},
        .complete = [](Law& law) { law.complete(); },
        .demands = {{[](const Law& law) { return !(law.nu < 0.0); }, &Law::bulk,
                     "G0 and BULK make a negative Poisson's ratio", "3 BULK must be above 2 G0"}}};
  }
};

/// Shear by a Prony series, elastic volume (MAT_076), a law of solids and layers: shear modulus sum of G_i
/// exp(-beta_i t), volume by the logarithm of the ratio of volumes.
struct GeneralViscoelastic {
  using Point = GeneralViscoelasticPoint;

  double E = 0.0;           ///< instantaneous Young's modulus, from BULK and the sum of G_i [stress]
  double nu = 0.0;          ///< instantaneous Poisson's ratio [1]
  double bulk = 0.0;        ///< [stress]
  Overstress overstress{};  ///< its branches
};

class ViscoelasticPoint {
 public:
  explicit ViscoelasticPoint(const Viscoelastic& law) : law_(law) {}
  int history() const { return SolidTensor<double>::size; }  // the part of the stress that decays
  int tensors() const { return 1; }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  Viscoelastic law_;
};

/// History: a tensor for each branch, and the logarithm of the volume.
class GeneralViscoelasticPoint {
 public:
  static constexpr bool in_layers = true;
  explicit GeneralViscoelasticPoint(const GeneralViscoelastic& law);
  int history() const { return branches_.history() + 1; }
  int tensors() const { return branches_.tensors(); }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double bulk_, plane_modulus_;
  OverstressBranches branches_;
};

}  // namespace nugget::kernel
