// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// OPT 0, and -1 and -2, which only give the value:
///   f = (max(N_rr, 0) / N_rrF)^2 + (N_rs / N_rsF)^2 + (N_rt / N_rtF)^2
///     + (M_rr / M_rrF)^2 + (M_ss / M_ssF)^2 + (M_tt / M_ttF)^2
/// A strength of 0 leaves its term out; compression does not count. Source: *MAT_100 of LS-DYNA's manual.
class ResultantSurface final : public Function {
 public:
  explicit ResultantSurface(const model::WeldLaw& law) : strength_(law.strength) {}

  Value operator()(const Load& load) override {
    const Resultants& r = load.resultants;
    const auto term = [&](std::size_t i, double resultant) {
      if (!strength_[i].given()) return 0.0;
      const double ratio = resultant / strength_[i].at(load.rate);
      return ratio * ratio;
    };
    Value f;
    f.add(FailureMode::axial, term(0, r.tension()));
    f.add(FailureMode::shear, term(1, r.shear_s) + term(2, r.shear_t));
    f.add(FailureMode::torsion, term(3, r.torsion));
    f.add(FailureMode::bending, term(4, r.moment_s) + term(5, r.moment_t));
    return f;
  }

  void archive(Archive& a) override { a.built(strength_); }

 private:
  std::array<model::RateValue, 6> strength_;
};

}  // namespace

std::unique_ptr<Function> resultant_surface(const model::WeldLaw& law) {
  return std::make_unique<ResultantSurface>(law);
}

}  // namespace nugget::weld::failure
