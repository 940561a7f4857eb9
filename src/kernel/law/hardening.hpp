// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "base/columns.hpp"
#include "base/real.hpp"
#include "kernel/law/law_kernel.hpp"
#include "kernel/law/piecewise_linear.hpp"
#include "kernel/law/plastic_kinematic.hpp"
#include "kernel/law/rate_effects.hpp"
#include "kernel/law/rate_table.hpp"
#include "kernel/law/spotweld.hpp"
#include "kernel/law/stress_space.hpp"
#include "kernel/law/yield_curve.hpp"

// How the yield stress of a J2 law depends on the plastic strain and on its rate (docs/decisions/0041). A hardening
// gives
//   lowest()              a stress below which no point yields, whatever its history: most points are done with it,
//   kinematic()           the part of the plastic modulus that moves the yield surface,
//   At<R>                 one point in one step, by its history: yield stress and slope at rest after a further plastic
//                         strain; `limited`: whether it has a limit() that no rate exceeds,
//   with_unknown<R>(at, dt, f)   f with the unknown of plastic_return.hpp by which the point returns.
namespace nugget::kernel {

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
    static constexpr bool limited = false;
    template <class History>
    At(const BilinearHardening& hardening, const History& history)
        : slope_(hardening.isotropic_),
          start_(hardening.yield_ + hardening.isotropic_ * load_field<R>(history, plastic_strain_field)) {}
    YieldStress<R> operator()(const R& increment) const { return {start_ + slope_ * increment, slope_}; }

   private:
    R slope_, start_;
  };
  template <class R, class Function>
  [[gnu::always_inline]] inline auto with_unknown(At<R>& yield, double dt, Function&& f) const {
    return kernel::with_unknown<R>(yield, rate_, dt, f);
  }

 private:
  double yield_, isotropic_ = 0.0, kinematic_ = 0.0;
  CowperSymonds rate_{};
};

/// A yield curve over plastic strain, with Cowper-Symonds rates, or a table of them over the rate (MAT_024).
class CurveHardening {
 public:
  explicit CurveHardening(const PiecewiseLinear& law);

  /// Curves over the rate; one: no rate effect.
  struct Rates {
    std::vector<double> values;
    std::vector<Curve> curves;
  };

  double lowest() const { return lowest_; }
  double kinematic() const { return 0.0; }
  /// The curves over the rate; not active(): there is one.
  const RateTable& table() const { return table_; }

  template <class R>
  class At {
   public:
    static constexpr bool limited = false;
    template <class History>
    At(const CurveHardening& hardening, const History& history)
        : hardening_(hardening), plastic_strain_(load_field<R>(history, plastic_strain_field)) {
      if (hardening.table_.active()) {
        const typename RateRows<R>::Row row = rows_.find(hardening.table_, plastic_strain_);
        x_ = row.begin;
        end_ = row.end;
        y_ = row.y;
        slope_ = row.slope;
      } else if (hardening.straight_) {
        const YieldCurve::Piece& line = hardening.curve_.last();
        x_ = R(line.x);
        y_ = R(line.y);
        slope_ = R(line.slope);
      } else {
        fetch(plastic_strain_);
      }
    }
    const R& plastic_strain() const { return plastic_strain_; }
    /// Of the table, at plastic_strain(), and where they begin and end.
    const RateRows<R>& rows() const { return rows_; }
    const R& begin() const { return x_; }
    const R& end() const { return end_; }
    YieldStress<R> operator()(const R& increment) {
      const R strain = plastic_strain_ + increment;
      if (!hardening_.straight_ && any(strain < x_ || strain >= end_)) fetch(strain);
      return {y_ + slope_ * (strain - x_), slope_};
    }

   private:
    void fetch(const R& strain) {
      const YieldCurve::Piece* piece[lanes<R>];
      for (int l = 0; l < lanes<R>; ++l) piece[l] = &hardening_.curve_.at(lane(strain, l));
      const Columns<R> c = columns<R>([&](int l) { return &piece[l]->x; });
      x_ = c[0];
      end_ = c[1];
      y_ = c[2];
      slope_ = c[3];
    }

    const CurveHardening& hardening_;
    R plastic_strain_;
    R x_{}, end_{}, y_{}, slope_{};
    RateRows<R> rows_;
  };
  template <class R, class Yield, class Function>
  [[gnu::always_inline]] inline auto with_unknown(Yield& yield, double dt, Function&& f) const {
    if (!table_.active()) return kernel::with_unknown<R>(yield, rate_, dt, f);
    ByTable<R, Yield> unknown(yield, table_, dt);
    return f(unknown);
  }

 private:
  CurveHardening(const PiecewiseLinear& law, const Rates& rates);

  YieldCurve curve_;  // at rest
  RateTable table_;
  CowperSymonds rate_;
  bool straight_ = false;
  double lowest_ = 0.0;
};

/// Hardening of MAT_100: EH, or curves; frozen at a stress of the point's history where the weld as a whole says so,
/// and from EFAIL on where the damage does.
class WeldHardening : public CurveHardening {
 public:
  /// Of a point's history: yield stress at which it is frozen; 0: not frozen [stress].
  static constexpr int frozen_yield_field = plastic_strain_field + 1;

  explicit WeldHardening(const Spotweld& law);

  double lowest() const { return can_be_frozen_ ? 0.0 : CurveHardening::lowest(); }

  template <class R>
  class At {
   public:
    static constexpr bool limited = true;
    At(const WeldHardening& hardening, const Number<R>* history)
        : curve_(hardening, history), can_be_frozen_(hardening.can_be_frozen_) {
      if (!can_be_frozen_) return;
      const R at = load_field<R>(history, frozen_yield_field);
      limit_ = select(at > 0.0, at, R(std::numeric_limits<double>::infinity()));
    }
    const R& plastic_strain() const { return curve_.plastic_strain(); }
    const RateRows<R>& rows() const { return curve_.rows(); }
    const R& begin() const { return curve_.begin(); }
    const R& end() const { return curve_.end(); }
    const R& limit() const { return limit_; }
    YieldStress<R> operator()(const R& increment) {
      const YieldStress<R> y = curve_(increment);
      if (!can_be_frozen_) return y;
      const auto over = y.value > limit_;
      return {select(over, limit_, y.value), select(over, R(0.0), y.slope)};
    }

   private:
    CurveHardening::At<R> curve_;
    bool can_be_frozen_;
    R limit_{std::numeric_limits<double>::infinity()};
  };

 private:
  bool can_be_frozen_;
};

}  // namespace nugget::kernel
