// SPDX-License-Identifier: Apache-2.0
#include "model/sheet_yield.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "kernel/law/own_kernels.hpp"
#include "kernel/law/shear_test.hpp"

namespace nugget::model {
namespace {

/// Of the laws with one yield stress in all directions that needs no element's size; empty of others.
Curve shear_test(const Material& material, double strain_rate, double most_strain,
                 const kernel::EndOfTest& enough = {}) {
  return std::visit(
      [&](const auto& law) -> Curve {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (std::is_same_v<Law, kernel::PlasticKinematic> || std::is_same_v<Law, kernel::PiecewiseLinear>) {
          return kernel::shear_test(law, strain_rate, most_strain, enough);
        } else if constexpr (std::is_same_v<Law, kernel::ComposedLaw>) {
          const kernel::LawKernel<Law> prepared(law);
          const bool one = prepared.axes() == nullptr && prepared.size_field() == 0;
          return one ? kernel::shear_test(law, strain_rate, most_strain, enough) : Curve{};
        } else {
          return {};
        }
      },
      material.law);
}

/// Rate at which a wave goes through the sheet [1/time]: rates that are shares of it know no unit of time.
double wave_rate(const Material& material, double thickness) {
  return std::sqrt(material.young() / material.density) / thickness;
}

constexpr double at_rest = 1e-12;        // [1/time]
constexpr double share_at_rest = 2e-19;  // of a wave: 1e-12 per second in 1 mm of steel

}  // namespace

Curve yield_at_rest(const Material& material, double thickness) {
  return shear_test(material, share_at_rest * wave_rate(material, thickness), 1.0);
}

Curve rate_factor(const Material& material, double thickness) {
  constexpr double strain = 0.02, enough = 0.06;  // shear strain to reach that plastic strain and more
  const double wave = wave_rate(material, thickness);
  const Curve slow = shear_test(material, share_at_rest * wave, enough);
  if (slow.empty()) return {};
  Curve factor{.x = {0.0}, .y = {1.0}};
  // Of 1 mm of steel 2e-7 to 2e4 per second.
  constexpr double ratio = 3.0, slowest = 28.0, fastest = 5.0;
  for (double power = slowest; power >= fastest; power -= 1.0) {
    const double rate = wave * std::pow(ratio, -power);
    const Curve fast = shear_test(material, std::sqrt(3.0) * rate, enough);  // effective over shear strain
    if (fast.empty()) break;
    factor.x.push_back(rate);
    factor.y.push_back(fast.clamped(strain) / slow.clamped(strain));
  }
  const bool counts = std::any_of(factor.y.begin(), factor.y.end(), [](double y) { return std::abs(y - 1.0) > 1e-6; });
  return counts ? factor : Curve{};
}

Strength strength_of(const Material& material) {
  constexpr double at_yield = 0.002, farthest = 4.0;
  const double young = material.young();
  double most = 0.0;
  const auto necked = [&](double plastic, double stress) {
    const double engineering = stress * std::exp(-plastic - stress / young);
    most = std::max(most, engineering);
    return plastic > at_yield && engineering < 0.9 * most;  // past a plateau after first yield, too
  };
  const Curve yield = shear_test(material, at_rest, farthest, necked);
  return yield.empty() ? Strength{} : Strength{yield.clamped(at_yield), most};
}

}  // namespace nugget::model
