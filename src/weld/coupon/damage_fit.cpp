// SPDX-License-Identifier: Apache-2.0
#include "weld/coupon/damage_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "weld/coupon/least_squares.hpp"
#include "weld/coupon/strength_fit.hpp"

namespace nugget::weld {
namespace {

/// Residuals and their slopes over the logarithm of RS.
class WorkErrors {
 public:
  WorkErrors(const std::vector<double>& measured, const std::function<std::vector<double>(double)>& simulated)
      : measured_(measured), simulated_(simulated) {}

  std::vector<double> residuals(double log_rupture) {
    const auto [found, is_new] = known_.try_emplace(log_rupture);
    if (is_new) found->second = simulated_(std::exp(log_rupture));
    std::vector<double> residual = found->second;
    constexpr double least = 1e-3;  // a weld that is gone at its peak
    for (std::size_t i = 0; i < residual.size(); ++i)
      residual[i] = std::log(std::max(residual[i] / measured_[i], least));
    return residual;
  }
  std::vector<double> slopes(double log_rupture, const std::vector<double>& here) {
    constexpr double step = 0.1;  // far above what the states of a run round off
    std::vector<double> slope = residuals(log_rupture + step);
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = (slope[i] - here[i]) / step;
    return slope;
  }

 private:
  const std::vector<double>& measured_;
  const std::function<std::vector<double>(double)>& simulated_;
  std::map<double, std::vector<double>> known_;  ///< by ln RS: runs are dear
};

double square(const std::vector<double>& v) {
  return std::inner_product(v.begin(), v.end(), v.begin(), 0.0);
}

}  // namespace

double work_after_peak(std::span<const double> displacement, std::span<const double> force) {
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(force) - force.begin());
  double work = 0.0;
  for (std::size_t i = peak + 1; i < force.size(); ++i)
    work += 0.5 * (force[i] + force[i - 1]) * (displacement[i] - displacement[i - 1]);
  return work;
}

DamageFit fit_damage(const std::vector<double>& measured, double start,
                     const std::function<std::vector<double>(double)>& simulated) {
  DamageFit fit;
  WorkErrors errors(measured, simulated);
  const SquareSum sum{
      .residuals = [&](const std::vector<double>& x) { return errors.residuals(x[0]); },
      .derivatives = [&](const std::vector<double>& x,
                         const std::vector<double>& here) { return Columns{errors.slopes(x[0], here)}; },
      .least_change = 1e-4,
      .least_step = 1e-3,
      .evaluations = 12};
  const double log_rupture = minimized(sum, {std::log(start)})[0];

  const std::vector<double> residual = errors.residuals(log_rupture), slope = errors.slopes(log_rupture, residual);
  constexpr double little = 0.05;  // of the work, for as much of RS
  if (std::ranges::all_of(slope, [](double s) { return std::abs(s) < little; })) {
    fit.fault = "the work behind the peak does not depend on RS in any of these tests [measure one in shear]";
    return fit;
  }
  fit.rupture = std::exp(log_rupture);
  for (const double r : residual) fit.ratio.push_back(std::exp(r));
  const int freedom = static_cast<int>(measured.size()) - 1;
  if (freedom == 0) return fit;
  const double half = student_limit(freedom) * std::sqrt(square(residual) / freedom / square(slope));
  fit.low = fit.rupture * std::exp(-half);
  fit.high = fit.rupture * std::exp(half);
  return fit;
}

}  // namespace nugget::weld
