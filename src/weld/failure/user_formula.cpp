// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "base/index.hpp"
#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// A *DEFINE_FUNCTION whose arguments are, as many as it has,
///     N_rr N_rs N_rt M_rr M_ss M_tt, strain rate, diameter, thickness of sheet 1, of sheet 2, plastic strain, time,
///     USRV1 to USRV22
/// and whose result is the failure value. The first six are those of *MAT_100 with OPT = 0, the others ours.
class UserFormula final : public Function {
 public:
  UserFormula(const Formula& formula, const model::WeldLaw& law, const Geometry& weld) : formula_(&formula) {
    argument_[7] = weld.diameter;
    argument_[8] = weld.thickness[0];
    argument_[9] = weld.thickness[1];
    std::copy(law.user_values.begin(), law.user_values.end(), argument_.begin() + 12);
  }

  Value operator()(const Load& load) override {
    const Resultants& r = load.resultants;
    const std::array<double, 7> now{r.axial, r.shear_s, r.shear_t, r.torsion, r.moment_s, r.moment_t, load.rate};
    std::copy(now.begin(), now.end(), argument_.begin());
    argument_[10] = load.plastic_strain;
    argument_[11] = load.time;
    Value f;
    f.add(FailureMode::user, (*formula_)(std::span(argument_).first(at(formula_->arguments()))));
    return f;
  }

  void archive(Archive& a) override { a.built(formula_, argument_); }

 private:
  const Formula* formula_;
  std::array<double, at(model::weld_function_arguments)>
      argument_{};  ///< those of the load are given anew in every cycle
};

}  // namespace

std::unique_ptr<Function> user_formula(const Formula& formula, const model::WeldLaw& law, const Geometry& weld) {
  return std::make_unique<UserFormula>(formula, law, weld);
}

}  // namespace nugget::weld::failure
