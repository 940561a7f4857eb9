// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "weld/failure/connection.hpp"
#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// MAT_100_DA:
///   f = (s_n / S_N)^EXSN + (s_b / S_B)^EXSB + (tau / S_S)^EXSS
///   s_n = max(N_rr, 0) / A, s_b = sqrt(M_ss^2 + M_tt^2) / Z, tau = SCLMRR |M_rr| / 2Z + sqrt(N_rs^2 + N_rt^2) / A
/// with the section of a disc of area A and strengths at the strain rate, smoothed by RFILTF. A strength of 0 leaves
/// its term out. Source: docs/theory/failure.md#connections.
class ConnectionStress final : public Function {
 public:
  ConnectionStress(const model::ConnectionProperties& properties, const ConnectionRecord& record, double rate_filter,
                   const Geometry& weld)
      : properties_(properties), record_(record), rate_filter_(rate_filter), weld_(weld) {}

  Value operator()(const Load& load) override {
    rate_ = rate_filter_ * rate_ + (1.0 - rate_filter_) * load.rate;
    Value f;
    f.rate = rate_;
    f.solid_area = properties_.area_change == 0 && load.area > 0.0 ? load.area : weld_.area;
    f.area = connection_area(properties_.area_rule, f.solid_area, weld_.thinner());
    const double modulus = f.area * std::sqrt(4.0 * f.area / std::numbers::pi) / 8.0;  // Z
    const Resultants& r = load.resultants;
    const double torsion = record_.torsion_factor * std::abs(r.torsion) / (2.0 * modulus);
    const std::array<double, 3> term{
        term_of(r.tension() / f.area, record_.normal, record_.normal_exponent),
        term_of(r.moment() / modulus, record_.bending, record_.bending_exponent),
        term_of(torsion + r.shear() / f.area, record_.shear, record_.shear_exponent),
    };
    f.add(FailureMode::axial, term[0]);
    f.add(FailureMode::bending, term[1]);
    f.add(FailureMode::shear, term[2]);
    f.load = over_surface(term);
    return f;
  }

  void archive(Archive& a) override {
    a(rate_);
    a.built(properties_, record_, rate_filter_, weld_);
  }

 private:
  double term_of(double stress, const model::RateValue& strength, double exponent) const {
    return strength.given() && stress > 0.0 ? std::pow(stress / strength.at(rate_), exponent) : 0.0;
  }

  /// The factor s with f(load / s) = 1. g(x) = sum t_i exp(-n_i x) - 1 falls and is convex, so that Newton from below
  /// its root x = ln s does not pass it.
  double over_surface(const std::array<double, 3>& term) const {
    const std::array<double, 3> exponent{record_.normal_exponent, record_.bending_exponent, record_.shear_exponent};
    double x = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i)
      if (term[i] > 0.0) x = std::max(x, std::log(term[i]) / exponent[i]);
    if (!std::isfinite(x)) return 0.0;  // not loaded
    for (int step = 0; step < 100; ++step) {
      double sum = 0.0, slope = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double part = term[i] * std::exp(-exponent[i] * x);
        sum += part;
        slope += exponent[i] * part;
      }
      if (sum - 1.0 <= 1e-12) break;
      x += (sum - 1.0) / slope;
    }
    return std::exp(x);
  }

  const model::ConnectionProperties& properties_;
  ConnectionRecord record_;
  double rate_filter_;
  Geometry weld_;
  double rate_ = 0.0;
};

}  // namespace

std::unique_ptr<Function> connection_stress(const model::ConnectionProperties& properties,
                                            const ConnectionRecord& record, double rate_filter, const Geometry& weld) {
  return std::make_unique<ConnectionStress>(properties, record, rate_filter, weld);
}

}  // namespace nugget::weld::failure
