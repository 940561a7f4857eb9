// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// Allowed force at an angle and a strain rate, linear between the rates of a table and held beyond them.
double allowed(const model::DirectionStrength& strength, double angle, double rate) {
  const auto& rates = strength.rate;
  const auto upper = static_cast<std::size_t>(std::upper_bound(rates.begin(), rates.end(), rate) - rates.begin());
  if (upper == 0) return strength.curve.front().clamped(angle);
  const double below = strength.curve[upper - 1].clamped(angle);
  if (upper == rates.size()) return below;
  const double share = (rate - rates[upper - 1]) / (rates[upper] - rates[upper - 1]);
  return below + share * (strength.curve[upper].clamped(angle) - below);
}

/// OPT 11: F over the force allowed in its direction, F = sqrt(N_rr^2 + N_rs^2 + N_rt^2); the direction is
/// atan(|N_rr| / sqrt(N_rs^2 + N_rt^2)) in degrees, 0 for pure shear, on LCT for N_rr >= 0 and on LCC below.
class Direction final : public Function {
 public:
  explicit Direction(const model::WeldLaw& law) : tension_(law.tension), compression_(law.compression) {}

  Value operator()(const Load& load) override {
    const Resultants& r = load.resultants;
    const bool pulls = r.axial >= 0.0;
    const model::DirectionStrength& strength = pulls ? tension_ : compression_;
    Value f;
    if (strength.curve.empty()) return f;
    const double angle = std::atan2(std::abs(r.axial), r.shear()) * 180.0 / std::numbers::pi;
    const double limit = allowed(strength, angle, load.rate);
    if (limit > 0.0)
      f.add(pulls ? FailureMode::tension : FailureMode::compression, std::hypot(r.axial, r.shear()) / limit);
    return f;
  }

  void archive(Archive& a) override { a.built(tension_, compression_); }

 private:
  model::DirectionStrength tension_, compression_;
};

}  // namespace

std::unique_ptr<Function> direction(const model::WeldLaw& law) {
  return std::make_unique<Direction>(law);
}

}  // namespace nugget::weld::failure
