// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

using std::numbers::pi;

/// OPT 5, structural stresses after A. Rupp, K. Stoerzel, V. Grubisic (SAE 950711, 1995), over FVAL: the largest of
///   around the nugget in sheet 1:  -(s(F_s) cos a + s(F_t) sin a) + s(N) + s(M_s) sin a - s(M_t) cos a,
///       s(F) = F / (pi d t_1), s(N) = 1.744 max(N, 0) / t_1^2, s(M) = 1.872 M / (d t_1^2)
///   in sheet 2, which sees the weld from its other end: with t_2, and s(M) of the other sign
///   in the nugget, first principal stress of
///       normal s(N) + s(M_s) sin a - s(M_t) cos a, shear t(F_s) sin^2 a + t(F_t) cos^2 a,
///       t(F) = 16 F / (3 pi d^2), s(N) = 4 max(N, 0) / (pi d^2), s(M) = 32 M / (pi d^3)
/// over all angles a. A sheet of thickness 0 is left out. The stress of the sheets does not depend on which end is the
/// first, or on how the axes s and t lie (decision 0172).
class StructuralStress final : public Function {
 public:
  StructuralStress(double diameter, std::array<double, 2> thickness, double limit)
      : d_(diameter), thickness_(thickness), over_(1.0 / limit) {}

  Value operator()(const Load& load) override {
    const Resultants& r = load.resultants;
    Value f;
    f.add(FailureMode::sheet_1, over_ * sheet_stress(r, thickness_[0], 1.0));
    f.add(FailureMode::sheet_2, over_ * sheet_stress(r, thickness_[1], -1.0));
    f.add(FailureMode::nugget, over_ * nugget_stress(r));
    f.value = std::max({f.term[0].value, f.term[1].value, f.term[2].value});
    return f;
  }

  void archive(Archive& a) override { a.built(d_, thickness_, over_); }

 private:
  /// A mean and a wave over the angle: the largest value is the mean and the amplitude. `end` is 1 for sheet 1 and -1
  /// for sheet 2, which gets force and moment with the other sign and sees its normal and one axis across turned round:
  /// the force along s then changes its sign against the moment about t, and so do the other two.
  double sheet_stress(const Resultants& r, double t, double end) const {
    if (t <= 0.0) return 0.0;
    const double force = 1.0 / (pi * d_ * t), bend = end * 1.872 / (d_ * t * t);
    return 1.744 * r.tension() / (t * t) +
           std::hypot(force * r.shear_s + bend * r.moment_t, force * r.shear_t - bend * r.moment_s);
  }

  /// As published: with shear along both axes, or its sign turned, it depends on how the axes lie.
  double nugget_stress(const Resultants& r) const {
    const double pull = 4.0 * r.tension() / (pi * d_ * d_), bend = 32.0 / (pi * d_ * d_ * d_);
    const double shear = 16.0 / (3.0 * pi * d_ * d_);
    const auto principal = [&](double angle) {
      const double c = std::cos(angle), s = std::sin(angle);
      const double normal = pull + bend * (r.moment_s * s - r.moment_t * c);
      return 0.5 * normal + std::hypot(0.5 * normal, shear * (r.shear_s * s * s + r.shear_t * c * c));
    };
    // the best of 24 directions, refined between its neighbours
    constexpr int directions = 24;
    constexpr double apart = 2.0 * pi / directions;
    double best = 0.0, at = 0.0;
    for (int i = 0; i < directions; ++i)
      if (const double p = principal(i * apart); p > best) {
        best = p;
        at = i * apart;
      }
    for (double reach = 0.5 * apart; reach > 1e-4; reach *= 0.5)
      for (const double angle : {at - reach, at + reach})
        if (const double p = principal(angle); p > best) {
          best = p;
          at = angle;
        }
    return best;
  }

  double d_;
  std::array<double, 2> thickness_;
  double over_;
};

}  // namespace

std::unique_ptr<Function> structural_stress(double diameter, std::array<double, 2> thickness, double limit) {
  return std::make_unique<StructuralStress>(diameter, thickness, limit);
}

}  // namespace nugget::weld::failure
