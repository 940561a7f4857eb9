// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/real.hpp"
#include "kernel/law/piecewise_linear.hpp"
#include "kernel/law/plastic_kinematic.hpp"
#include "kernel/law/spotweld.hpp"
#include "kernel/law/stress_space.hpp"

// How the yield stress of a J2 law depends on the plastic strain and on its rate (docs/decisions/0041). A hardening
// gives
//   lowest()              a stress below which no point yields, whatever its history: most points are done with it,
//   kinematic()           the part of the plastic modulus that moves the yield surface,
//   At<R>                 one point in one step, by its history: yield stress and slope after a further plastic strain.
namespace nugget::kernel {

/// Yield stress and its slope over the plastic strain of this step, both [stress].
template <class R>
struct YieldStress {
  R value{}, slope{};
};

/// Factor 1 + (rate / C)^(1/P) on the yield stress (Cowper and Symonds).
struct CowperSymonds {
  double c = 0.0;  ///< [1/time]; 0: no rate effect
  double p = 1.0;  ///< [1]

  bool active() const { return c > 0.0; }
  template <class R>
  R factor(const R& rate) const {
    const double exponent = 1.0 / p;
    return map([&](double r) { return 1.0 + std::pow(r / c, exponent); }, rate);
  }
};

/// Linear hardening, part of it kinematic, with Cowper-Symonds rates (MAT_003).
class BilinearHardening {
 public:
  explicit BilinearHardening(const PlasticKinematic& law) : yield_(law.yield), rate_{law.rate_c, law.rate_p} {
    const double modulus = law.E * law.tangent_modulus / (law.E - law.tangent_modulus);
    isotropic_ = law.beta * modulus;
    kinematic_ = (1.0 - law.beta) * modulus;
  }

  double lowest() const { return isotropic_ < 0.0 ? 0.0 : yield_; }
  double kinematic() const { return kinematic_; }

  template <class R>
  class At {
   public:
    At(const BilinearHardening& hardening, const double* history, double dt)
        : hardening_(hardening), start_(hardening.yield_ + hardening.isotropic_ * load_field<R>(history, 0)), dt_(dt) {}
    YieldStress<R> operator()(const R& increment) const {
      const R slope = R(hardening_.isotropic_), still = start_ + slope * increment;
      if (!hardening_.rate_.active()) return {still, slope};
      const R factor = hardening_.rate_.factor((1.0 / dt_) * increment);
      return {still * factor, slope * factor + still * (factor - 1.0) / (hardening_.rate_.p * increment)};
    }

   private:
    const BilinearHardening& hardening_;
    R start_;
    double dt_;
  };

 private:
  double yield_, isotropic_ = 0.0, kinematic_ = 0.0;
  CowperSymonds rate_{};
};

/// A yield curve made ready for fast look-up. Before the first point its ordinate holds; beyond the last the last slope
/// goes on if it hardens, otherwise the last ordinate holds (a yield stress does not become negative).
class YieldCurve {
 public:
  /// One straight piece: value `y` + `slope` (e - `x`) for `x` <= e < `end`.
  struct Piece {
    double x, end, y, slope;
  };

  explicit YieldCurve(const Curve& curve);
  const Piece& at(double plastic_strain) const {
    if (plastic_strain >= pieces_.back().x || pieces_.size() == 1) return pieces_.back();
    if (!(plastic_strain >= pieces_.front().end)) return pieces_.front();
    const auto bucket = std::min(static_cast<std::size_t>(plastic_strain * buckets_per_strain_), first_.size() - 1);
    auto i = static_cast<std::size_t>(first_[bucket]);
    while (plastic_strain >= pieces_[i].end) ++i;
    return pieces_[i];
  }
  const Piece& last() const { return pieces_.back(); }
  double lowest() const;
  bool straight() const { return pieces_.size() == 1; }

 private:
  std::vector<Piece> pieces_;
  std::vector<int> first_;  // the piece in which, or before which, each of equal buckets begins
  double buckets_per_strain_ = 0.0;
};

/// Yield curves over plastic strain, with a table over rate or a factor over rate (MAT_024).
class CurveHardening {
 public:
  explicit CurveHardening(const PiecewiseLinear& law);

  double lowest() const { return lowest_; }
  double kinematic() const { return 0.0; }

  template <class R>
  class At {
   public:
    At(const CurveHardening& hardening, const double* history, double dt)
        : hardening_(hardening), plastic_strain_(load_field<R>(history, 0)), dt_(dt) {
      if (hardening.rate_dependent_) return;
      if (hardening.straight_) {
        const YieldCurve::Piece& line = hardening.curves_.front().last();
        x_ = R(line.x);
        y_ = R(line.y);
        slope_ = R(line.slope);
      } else {
        fetch(plastic_strain_);
      }
    }
    YieldStress<R> operator()(const R& increment) {
      if (hardening_.rate_dependent_) return viscous(increment);
      const R strain = plastic_strain_ + increment;
      if (!hardening_.straight_ && any(strain < x_ || strain >= end_)) fetch(strain);
      return {y_ + slope_ * (strain - x_), slope_};
    }

   private:
    void fetch(const R& strain) {
      for (int l = 0; l < lanes<R>; ++l) {
        const YieldCurve::Piece piece = hardening_.curves_.front().at(lane(strain, l));
        set_lane(x_, l, piece.x);
        set_lane(end_, l, piece.end);
        set_lane(y_, l, piece.y);
        set_lane(slope_, l, piece.slope);
      }
    }
    YieldStress<R> viscous(const R& increment) const {
      YieldStress<R> r;
      for (int l = 0; l < lanes<R>; ++l) {
        const YieldStress<double> y = hardening_.viscous(lane(plastic_strain_, l), lane(increment, l), dt_);
        set_lane(r.value, l, y.value);
        set_lane(r.slope, l, y.slope);
      }
      return r;
    }

    const CurveHardening& hardening_;
    R plastic_strain_;
    R x_{}, end_{}, y_{}, slope_{};
    double dt_;
  };

 private:
  /// The two neighbours of a rate in the table and the weight of the upper one.
  struct Between {
    std::size_t low, high;
    double weight, weight_slope;
  };
  Between between(double rate) const;
  YieldCurve::Piece between_curves(double plastic_strain, double rate) const;
  double rate_factor(double rate) const;
  double rate_factor_slope(double rate) const;
  YieldStress<double> viscous(double plastic_strain, double increment, double dt) const;

  std::vector<YieldCurve> curves_;
  std::vector<double> rates_;
  bool log_rates_ = false;
  CowperSymonds rate_{};
  Curve rate_scale_;
  bool rate_dependent_ = false, straight_ = false;
  double lowest_ = 0.0;
};

/// Hardening of MAT_100: EH, or curves; held at a stress of the point's history where the weld as a whole says so, and
/// from EFAIL on where the damage does.
class WeldHardening : public CurveHardening {
 public:
  /// Of a point's history: yield stress at which it is held; 0: not held [stress].
  static constexpr int held = 1;

  explicit WeldHardening(const Spotweld& law);

  double lowest() const { return can_be_held_ ? 0.0 : CurveHardening::lowest(); }

  template <class R>
  class At {
   public:
    At(const WeldHardening& hardening, const double* history, double dt)
        : curve_(hardening, history, dt), can_be_held_(hardening.can_be_held_) {
      if (!can_be_held_) return;
      const R at = load_field<R>(history, held);
      limit_ = select(at > 0.0, at, R(std::numeric_limits<double>::infinity()));
    }
    YieldStress<R> operator()(const R& increment) {
      YieldStress<R> y = curve_(increment);
      if (!can_be_held_) return y;
      const auto over = y.value > limit_;
      return {select(over, limit_, y.value), select(over, R(0.0), y.slope)};
    }

   private:
    CurveHardening::At<R> curve_;
    bool can_be_held_;
    R limit_{};
  };

 private:
  bool can_be_held_;
};

}  // namespace nugget::kernel
