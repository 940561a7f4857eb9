// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/curve.hpp"
#include "kernel/law/loading_rates.hpp"
#include "kernel/law/relaxation.hpp"
#include "kernel/law/single_points.hpp"

// Rubber and foam by test curves, a law of solids and layers.
namespace nugget::kernel {

class TabulatedRubberPoint;

/// Rubber or foam by tests of a bar (MAT_181; S. Kolling, P.A. Du Bois, D.J. Benson, W.W. Feng, Comput. Mech. 40,
/// 2007): Ogden's energy with a function f in place of the powers. Rubber, l_i principal stretches less the change of
/// volume:
///   sigma_i = [f(l_i) - mean f] / J + K (J - 1) / J,
/// foam of Poisson's ratio nu, l_i principal stretches (R. Hill's energy):
///   sigma_i = [f(l_i) - f(J^-n)] / J,  n = nu / (1 - 2 nu).
/// A bar that is pulled then has the true stress times J of f(l) - f(l^-m), m = 1/2 and nu. That is l s(l - 1), s the
/// nominal stress of the test over the nominal strain, with f(l) = sum over x >= 0 of l_x s(l_x - 1), l_x = l^((-m)^x).
/// With several rates f is that of the rate at which the direction is loaded that is strained most. Below the greatest
/// energy so far the stress (of rubber its deviator) keeps a share of that of loading.
struct TabulatedRubber {
  using Point = TabulatedRubberPoint;

  /// When the rate counts (TENSION); else the curve of the lowest rate holds.
  enum class RateCounts { loading = -1, compressive_loading = 0, always = 1 };

  double E = 0.0, nu = 0.0;   ///< of small strains, by the slope of the first test at 0 [stress], [1]
  double bulk = 0.0;          ///< K of rubber [stress]
  std::vector<Curve> tests;   ///< nominal stress over nominal strain, with tension and compression; one a rate
  std::vector<double> rates;  ///< of the tests, ascending [1/time]
  double contraction = 0.5;   ///< m: 1/2 of rubber, below it Poisson's ratio of a foam [1]
  double damping = 0.0;       ///< MU: viscous deviatoric stress, as a share of critical damping in each element [1]
  Overstress overstress{};
  double kept = 1.0, shape = 1.0;  ///< HU, SHAPE: the share is HU + (1 - HU) (W / Wmax)^SHAPE, W the energy [1]
  Curve unloading{};               ///< LCUNLD, as a test: the share is its stress over that of the first; empty: none
  RateCounts rate_counts = RateCounts::loading;
  bool engineering_rate = false;  ///< RTYPE 1: change of length over the length at first, else over that now
  double window = 0.0;            ///< AVGOPT below 0: rates are means over this time; 0: over twelve steps [time]

  bool is_foam() const { return contraction < 0.5; }
};

/// f of a test as a table over ln l, linear between its values; beyond it its end slopes go on.
class TestFunction {
 public:
  TestFunction(const Curve& test, double contraction);
  struct Value {
    double f, slope;  ///< [stress], over ln l
  };
  Value at(double log_stretch) const;
  double integral(double log_stretch) const;  ///< of f over ln l, from 0 [stress]

 private:
  /// Which interval of the table, and how far in it.
  struct Place {
    std::size_t interval;
    double part;
  };
  Place place(double log_stretch) const;

  double zero_ = 0.0;               ///< where in the table ln l is 0
  std::vector<double> f_, energy_;  ///< f, and its integral from ln l = 0 on
};

/// Point by point. History: b - 1, the stresses of the overstress; the greatest energy so far, where that counts; the
/// rate that counts, and what it adds to f of each direction and of the volume, where there are several.
class TabulatedRubberPoint {
 public:
  static constexpr bool in_layers = true;
  explicit TabulatedRubberPoint(const TabulatedRubber& law);
  int history() const {
    return SolidTensor<double>::size + overstress_.history() + (by_rate() ? 6 : unloads() ? 1 : 0);
  }
  int tensors() const { return 1 + overstress_.tensors(); }
  PointUpdate update(const SolidTensor<double>& s, const SolidTensor<double>& d, double dt, std::span<double> h) const;

 private:
  static constexpr std::size_t most_energy_field = 0, rate_field = 1, by_rate_field = 2;
  bool by_rate() const { return law_.tests.size() > 1; }
  bool unloads() const { return law_.kept < 1.0 || !law_.unloading.empty(); }

  /// Of what f is taken: of each direction, and (of foam) of the volume.
  using Arguments = std::array<double, 4>;
  Arguments arguments(const Principal& b_less_one) const;
  double log_volume(const Principal& b_less_one) const;
  double energy(const Arguments& log_stretch) const;
  double share_kept(const Arguments& log_stretch, double& most_energy) const;
  /// The rate that counts, of that at which the direction strained most is strained further.
  double counting(double loading, bool compressed) const;
  /// Renews what the rate adds to f; returns the slope by which that grows at most [stress].
  double add_rate(const Principal& b_less_one, const Arguments& log_stretch, const SolidTensor<double>& d, double dt,
                  std::span<double> own) const;
  PointUpdate stress(const Principal& b_less_one, const Arguments& log_stretch, const Arguments& by_rate) const;

  TabulatedRubber law_;
  std::vector<TestFunction> f_;     ///< one a rate
  std::array<Curve, 2> unloading_;  ///< share over W / Wmax, of compression and tension
  double volume_power_ = 0.0;       ///< n of foam
  double steepest_ = 0.0;           ///< slope of any f at 0 [stress]
  OverstressBranches overstress_;
  double damped_modulus_;
};

}  // namespace nugget::kernel
