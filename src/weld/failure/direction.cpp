// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// OPT 11: F over the force allowed in its direction, F = sqrt(N_rr^2 + N_rs^2 + N_rt^2); the direction is
/// atan(|N_rr| / sqrt(N_rs^2 + N_rt^2)) in degrees, 0 for pure shear, on LCT for N_rr >= 0 and on LCC below.
class Direction final : public Function {
 public:
  explicit Direction(const model::WeldLaw& law) : tension_(law.tension), compression_(law.compression) {}

  Value operator()(const Load& load) override {
    const Resultants& r = load.resultants;
    const bool pulls = r.axial >= 0.0;
    const CurveTable& strength = pulls ? tension_ : compression_;
    Value f;
    if (!strength.given()) return f;
    const double angle = std::atan2(std::abs(r.axial), r.shear()) * 180.0 / std::numbers::pi;
    const double limit = strength.at(load.rate, angle);
    if (limit > 0.0)
      f.add(pulls ? FailureMode::tension : FailureMode::compression, std::hypot(r.axial, r.shear()) / limit);
    return f;
  }

  void archive(Archive& a) override { a.built(tension_, compression_); }

 private:
  CurveTable tension_, compression_;
};

}  // namespace

std::unique_ptr<Function> direction(const model::WeldLaw& law) {
  return std::make_unique<Direction>(law);
}

}  // namespace nugget::weld::failure
