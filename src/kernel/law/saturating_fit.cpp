// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/saturating_fit.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::kernel {
namespace {

struct BestTerms {
  std::array<double, 2> stress{};
  double rest = 0.0;  ///< sum of the squares that are left
};

/// The best Q for two exponents, not below 0.
BestTerms best_terms(const Curve& curve, double start, double c0, double c1) {
  double a00 = 0.0, a01 = 0.0, a11 = 0.0, b0 = 0.0, b1 = 0.0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const double f = -std::expm1(-c0 * curve.x[i]), g = -std::expm1(-c1 * curve.x[i]), y = curve.y[i] - start;
    a00 += f * f, a01 += f * g, a11 += g * g;
    b0 += f * y, b1 += g * y;
  }
  const auto with = [&](double q0, double q1) {
    BestTerms terms{{q0, q1}, 0.0};
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double off = start - q0 * std::expm1(-c0 * curve.x[i]) - q1 * std::expm1(-c1 * curve.x[i]) - curve.y[i];
      terms.rest += off * off;
    }
    return terms;
  };
  const double determinant = a00 * a11 - a01 * a01;
  if (determinant > 1e-13 * a00 * a11) {
    const double q0 = (b0 * a11 - b1 * a01) / determinant, q1 = (b1 * a00 - b0 * a01) / determinant;
    if (q0 >= 0.0 && q1 >= 0.0) return with(q0, q1);
  }
  const BestTerms first = with(std::max(b0 / a00, 0.0), 0.0), second = with(0.0, std::max(b1 / a11, 0.0));
  return second.rest < first.rest ? second : first;
}

}  // namespace

SaturatingFit saturating_fit(const Curve& curve, double start) {
  double shortest = curve.x.back();
  for (const double x : curve.x)
    if (x > 0.0) shortest = std::min(shortest, x);
  const double low = std::log(0.02 / curve.x.back()), high = std::log(5.0 / shortest);
  constexpr int steps = 40;
  double best[2] = {low, high}, width = (high - low) / steps;
  BestTerms found = best_terms(curve, start, std::exp(low), std::exp(high));
  const auto attempt = [&](double u, double v) {
    const BestTerms terms = best_terms(curve, start, std::exp(u), std::exp(v));
    if (!(terms.rest < found.rest)) return false;
    found = terms;
    best[0] = u;
    best[1] = v;
    return true;
  };
  for (int i = 0; i <= steps; ++i)
    for (int k = i + 1; k <= steps; ++k) attempt(low + i * width, low + k * width);
  while (width > 1e-9) {
    const double u = best[0], v = best[1];
    bool better = false;
    for (const double du : {-width, 0.0, width})
      for (const double dv : {-width, 0.0, width}) better |= attempt(u + du, v + dv);
    if (!better) width *= 0.5;
  }
  SaturatingFit fit{found.stress, {std::exp(best[0]), std::exp(best[1])}, 0.0};
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    double y = start;
    for (int k = 0; k < 2; ++k) y -= fit.stress[k] * std::expm1(-fit.exponent[k] * curve.x[i]);
    fit.farthest = std::max(fit.farthest, std::abs(y - curve.y[i]) / curve.y[i]);
  }
  return fit;
}

}  // namespace nugget::kernel
