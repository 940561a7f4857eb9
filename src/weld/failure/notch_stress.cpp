// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

using std::numbers::pi;

/// OPT 3 and 4, after S. Zhang (Int. J. Fracture 1997, 1999), of shear F, bending M and tension N on a nugget of
/// diameter d in sheets of thickness t, with the factors a1 a2 a3.
///   OPT 3: notch stress at the radius rho =
///          a1 4 F / (pi d t) (1 + (sqrt 3 + sqrt 19) / (8 sqrt pi) sqrt(t / rho))
///        + a2 6 M / (pi d t^2) (1 + 2 / sqrt(3 pi) sqrt(t / rho))
///        + a3 4 N / (pi d^2) (1 + 5 / (3 sqrt(2 pi)) d / t sqrt(t / rho))
///   OPT 4: K_eq = sqrt(K_I^2 + K_II^2),  K_II = a1 2 F / (pi d sqrt t),
///          K_I = a1 sqrt 3 F / (2 pi d sqrt t) + a2 2 sqrt 3 M / (pi d t sqrt t) + a3 5 sqrt 2 N / (3 pi d sqrt t)
/// each over FVAL. Both are linear in the load: coefficients are made once.
class NotchStress final : public Function {
 public:
  NotchStress(const model::WeldLaw& law, double d, double t) {
    const auto& a = law.alpha;
    const double over = 1.0 / law.limit, root_t = std::sqrt(t);
    if (law.option == 3) {
      const double sharp = std::sqrt(t / law.notch_radius);
      shear_ =
          over * a[0] * 4.0 / (pi * d * t) * (1.0 + (std::sqrt(3.0) + std::sqrt(19.0)) / (8.0 * std::sqrt(pi)) * sharp);
      bending_ = over * a[1] * 6.0 / (pi * d * t * t) * (1.0 + 2.0 / std::sqrt(3.0 * pi) * sharp);
      tension_ = over * a[2] * 4.0 / (pi * d * d) * (1.0 + 5.0 / (3.0 * std::sqrt(2.0 * pi)) * d / t * sharp);
    } else {
      shear_ = over * a[0] * std::sqrt(3.0) / (2.0 * pi * d * root_t);
      bending_ = over * a[1] * 2.0 * std::sqrt(3.0) / (pi * d * t * root_t);
      tension_ = over * a[2] * 5.0 * std::sqrt(2.0) / (3.0 * pi * d * root_t);
      sliding_ = over * a[0] * 2.0 / (pi * d * root_t);
    }
  }

  Value operator()(const Load& load) override {
    const double f = shear_ * load.resultants.shear(), m = bending_ * load.resultants.moment(),
                 n = tension_ * load.resultants.tension();
    const double opening = f + m + n, sliding = sliding_ * load.resultants.shear();
    const double whole = std::hypot(opening, sliding);
    // The square's parts, so that they add up to the value: of OPT 3, where nothing slides, simply f, m and n.
    const double scale = whole > 0.0 ? opening / whole : 0.0, slide = whole > 0.0 ? sliding * sliding / whole : 0.0;
    Value value;
    value.add(FailureMode::axial, scale * n);
    value.add(FailureMode::shear, scale * f + slide);
    value.add(FailureMode::bending, scale * m);
    return value;
  }

  void archive(Archive& a) override { a.built(shear_, bending_, tension_, sliding_); }

 private:
  double shear_ = 0.0, bending_ = 0.0, tension_ = 0.0, sliding_ = 0.0;
};

}  // namespace

std::unique_ptr<Function> notch_stress(const model::WeldLaw& law, double diameter, double thickness) {
  return std::make_unique<NotchStress>(law, diameter, thickness);
}

}  // namespace nugget::weld::failure
