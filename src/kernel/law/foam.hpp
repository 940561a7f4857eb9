// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "base/curve.hpp"
#include "kernel/law/loading_rates.hpp"
#include "kernel/law/relaxation.hpp"
#include "kernel/law/single_points.hpp"

// Foams, laws of solids without lateral contraction: each principal direction has a stress of its own. Damping is a
// viscous stress DAMP M dt d, M modulus of the stable step, d strain rate: of the fastest vibration that is stable at
// the step it is the share DAMP of critical damping.
namespace nugget::kernel {

class LowDensityFoamPoint;
class CrushableFoamPoint;
class RateFoamPoint;

/// Highly compressible foam (MAT_057): each principal direction has the nominal stress of its own stretch, in
/// compression by a curve, in tension linear up to a cutoff. Unloading keeps HU + (1 - HU) (W / Wmax)^SHAPE of the
/// stress, W energy of the curve; Wmax - W decays with the rate BETA. Stresses that relax are added, each component of
/// the strain by itself (MAT_057: one; MAT_073: up to six).
struct LowDensityFoam {
  using Point = LowDensityFoamPoint;

  double E = 0.0;     ///< Young's modulus in tension [stress]
  double nu = 0.0;    ///< 0
  Curve compression;  ///< nominal stress over nominal strain, both positive in compression
  double cutoff = std::numeric_limits<double>::infinity();  ///< TC, greatest nominal tensile stress [stress]
  bool tension_failure = false;  ///< FAIL 1: no tensile stress once the cutoff was reached, else it stays at the cutoff
  double unloading = 1.0;        ///< HU [1]; 1: no hysteresis
  double shape = 1.0;            ///< SHAPE [1]
  double recovery = 0.0;         ///< BETA [1/time]
  double damping = 0.0;          ///< DAMP, share of critical damping [1]
  double maxwell_modulus = 0.0;  ///< ED, modulus of a stress that relaxes, a spring and a damper in series [stress]
  double decay = 0.0;            ///< BETA1, rate at which it does [1/time]
  std::vector<Overstress::MaxwellBranch> terms{};  ///< GI, BETAI of MAT_073: further ones
};

/// Crushable foam (MAT_063, MODEL 0): elastic, each principal stress at most the yield stress of the volume reached in
/// compression, the cutoff in tension. It does not recover.
struct CrushableFoam {
  using Point = CrushableFoamPoint;

  double E = 0.0;        ///< Young's modulus of loading and unloading: the last slope of the curve [stress]
  double nu = 0.0;       ///< 0
  Curve yield;           ///< yield stress over volumetric strain 1 - V / V0
  double cutoff = 0.0;   ///< TSC, greatest tensile stress [stress]
  double damping = 0.0;  ///< DAMP, share of critical damping [1]
};

/// Foam by a table of nominal stress over nominal strain for rates of loading (MAT_083). What does not load follows the
/// curve of the lowest rate, of which unloading keeps 1 - (1 - HU) [1 - (W / Wmax)^SHAPE]^EXPON, W its energy.
struct RateFoam {
  using Point = RateFoamPoint;

  /// Whose rate looks a stress up.
  enum class RateOf { most_strained, each_direction, volume };

  double E = 0.0;                          ///< Young's modulus in tension [stress]
  double nu = 0.0;                         ///< 0
  std::vector<Curve> curves;               ///< positive in compression
  std::vector<double> rates;               ///< of the curves, ascending [1/time]
  RateOf rate_of = RateOf::most_strained;  ///< RFLAG
  bool engineering_rate = false;           ///< SFLAG 1: change of length over the length at first, else over that now
  bool log_log = false;                    ///< between rates by the logarithms of rate and stress, else linear
  bool tension_by_curves = false;          ///< TFLAG 1: negative strains of the curves are tension
  double cutoff = std::numeric_limits<double>::infinity();  ///< TC, greatest nominal tensile stress [stress]
  bool tension_failure = false;                             ///< FAIL 1: no tensile stress once the cutoff was reached
  double unloading = 0.0;                                   ///< HU [1]; 0: along the curve of the lowest rate
  double shape = 1.0, exponent = 1.0;                       ///< SHAPE, EXPON [1]
  double damping = 0.0;                                     ///< DAMP, share of critical damping [1]
  double step_modulus = 0.0;                                ///< KCON, least modulus for step and damping [stress]
};

// Point by point.

class LowDensityFoamPoint {
 public:
  explicit LowDensityFoamPoint(const LowDensityFoam& law) : law_(law), relaxing_(law.terms) {
    if (law.maxwell_modulus > 0.0) relaxing_.insert(relaxing_.begin(), {law.maxwell_modulus, law.decay});
  }
  int history() const { return tensors() * SolidTensor<double>::size + 2; }
  int tensors() const { return 1 + static_cast<int>(relaxing_.size()); }  // b - 1, the stresses that relax
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  LowDensityFoam law_;
  std::vector<Overstress::MaxwellBranch> relaxing_;
};

class CrushableFoamPoint {
 public:
  explicit CrushableFoamPoint(const CrushableFoam& law) : law_(law) {}
  int history() const { return tensors() * SolidTensor<double>::size + 1; }
  int tensors() const { return law_.damping > 0.0 ? 1 : 0; }  // the viscous part of the stress
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  CrushableFoam law_;
};

class RateFoamPoint {
 public:
  explicit RateFoamPoint(const RateFoam& law);
  int history() const { return SolidTensor<double>::size + 8; }
  int tensors() const { return 1; }  // b - 1
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  double look_up(double strain, double rate) const;
  std::array<double, 3> rates_now(const Principal& axes, const SolidTensor<double>& d, double J, double dt) const;

  RateFoam law_;
  double growth_;  ///< slope by which what the rate adds to the stress grows at most [stress]
};

}  // namespace nugget::kernel
